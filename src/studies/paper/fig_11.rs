//! Fig. 11: above the critical amplitude a velocity threshold that is too large changes the response.

use super::{
    Error, Figure, half_period,
    history::{self, CHATTERING, COARSE, ETA, FINE, OMEGA, PART, WHOLE, duration, lines, response, rows, table},
    missing,
};
use crate::studies::chart::{self, Mark, Table};

pub(super) const FIGURE: Figure =
    Figure { name: "fig_11", measure, charts: &[("fig_11.svg", whole), ("fig_11_insert.svg", insert)] };

const A: f64 = 1.05;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, COARSE)?;
    let rest = response.bouts.first().ok_or_else(|| missing("the rocking of Fig. 11"))?.end();
    let again = half_period(OMEGA);
    let mut parts = Vec::new();
    for scheme in [CHATTERING, FINE, COARSE] {
        parts.push(rows("whole", A, scheme, (0.0, duration()), WHOLE)?);
        parts.push(rows("insert", A, scheme, (0.8 * rest, again + 0.3 * (again - rest)), PART)?);
    }
    table(parts)
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    let title = format!("The schemes above a_{{cr}}: a = {A}, ω = {OMEGA}, η = {ETA}");
    let caption = "The chattering is incomplete; the large velocity threshold puts the block to rest all the same, and what \
                  follows is another response.";
    history::chart(
        &title,
        caption,
        lines(table, "whole", "phi")?,
        vec![Mark::at(0.0, "1st initiation"), Mark::at(half_period(OMEGA), "T/2")],
    )
}

fn insert(table: &Table) -> Result<String, chart::Error> {
    let title = "Insert: rest that should not be";
    let caption = "With the large threshold the block rests until the next lobe sets it off from rest; without it \
                   the block is still rocking then.";
    history::chart(title, caption, lines(table, "insert", "phi")?, vec![Mark::at(half_period(OMEGA), "T/2")])
}
