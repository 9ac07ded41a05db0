//! Fig. 9: the response by the scheme with the chattering threshold, and the excitation.

use super::{
    Error, Figure, fig_4,
    history::{self, CHATTERING, ETA, OMEGA, PART, WHOLE, duration, initiations, lines, response, rows, table},
    missing,
};
use crate::studies::chart::{self, Table};

pub(super) const FIGURE: Figure = Figure {
    name: "fig_9",
    measure,
    charts: &[("fig_9a.svg", whole), ("fig_9a_insert.svg", insert), ("fig_9b.svg", excitation)],
};

const A: f64 = 1.03;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, CHATTERING)?;
    let rest = response.bouts.first().ok_or_else(|| missing("the rocking of Fig. 9"))?.end();
    table(vec![
        rows("whole", A, CHATTERING, (0.0, duration()), WHOLE)?,
        rows("insert", A, CHATTERING, (0.9 * rest, 1.02 * rest), PART)?,
    ])
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    let title = format!("Response to a = {A}, ω = {OMEGA}, η = {ETA} over 2.5 T");
    let caption =
        "In each half period the block chatters into rest and is set off again by the next lobe, to the other side.";
    history::chart(&title, caption, lines(table, "whole", "phi")?, initiations())
}

fn insert(table: &Table) -> Result<String, chart::Error> {
    let title = "Insert: the block comes to rest";
    let caption = "The scheme calls the block at rest at the first impact after the τ_{ch} of Eq. 65, a little before the \
                  impacts accumulate.";
    history::chart(title, caption, lines(table, "insert", "phi")?, Vec::new())
}

fn excitation(table: &Table) -> Result<String, chart::Error> {
    let mut series = lines(table, "whole", "ground_acceleration")?;
    for one in &mut series {
        one.name = "a sin(ωτ + ψ)".into();
    }
    let title = format!("Excitation, a = {A}, ω = {OMEGA}");
    fig_4::chart(&title, "The ground goes on moving while the block rests.", series, initiations())
}
