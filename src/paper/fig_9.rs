//! Fig. 9: the response by the scheme with the chattering threshold, and the excitation.

use super::{
    Error, Figure, half_period,
    history::{CHATTERING, ETA, OMEGA, duration, lines, response, rows, table},
    missing,
};
use crate::chart::{self, Axis, LineChart, Mark, Panel, Table};

pub(super) const FIGURE: Figure = Figure {
    name: "fig_9",
    measure,
    charts: &[("fig_9a.svg", whole), ("fig_9a_insert.svg", insert), ("fig_9b.svg", excitation)],
};

const A: f64 = 1.03;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, CHATTERING.1)?;
    let rest = response.bouts.first().ok_or_else(|| missing("the rocking of Fig. 9"))?.end();
    table(vec![
        rows("whole", A, CHATTERING, (0.0, duration()))?,
        rows("insert", A, CHATTERING, (0.9 * rest, 1.02 * rest))?,
    ])
}

/// The initiations: where a lobe reaches the threshold.
fn initiations() -> Vec<Mark> {
    vec![Mark::at(0.0, "1st initiation"), Mark::at(half_period(OMEGA), "2nd initiation")]
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    LineChart {
        title: format!("Response to a = {A}, ω = {OMEGA}, η = {ETA} over 2.5 T"),
        caption:
            "In each half period the block chatters into rest and is set off again by the next lobe, to the other side."
                .into(),
        x: Axis::linear("τ"),
        y: Axis::linear("φ = θ/α"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", lines(table, "whole", "phi")?).with_marks(initiations())],
    }
    .svg()
}

fn insert(table: &Table) -> Result<String, chart::Error> {
    LineChart {
        title: "Insert: the block comes to rest".into(),
        caption:
            "The scheme calls the block at rest at the first impact after the τ_{ch} of Eq. 65, a little before the \
                  impacts accumulate."
                .into(),
        x: Axis::linear("τ"),
        y: Axis::linear("φ = θ/α"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", lines(table, "insert", "phi")?)],
    }
    .svg()
}

fn excitation(table: &Table) -> Result<String, chart::Error> {
    let mut series = lines(table, "whole", "excitation")?;
    for one in &mut series {
        one.name = "a sin(ωτ + ψ)".into();
    }
    let mut marks = initiations();
    marks.extend([Mark::level(1.0, "1"), Mark::level(-1.0, "−1")]);
    LineChart {
        title: format!("Excitation, a = {A}, ω = {OMEGA}"),
        caption: "The ground goes on moving while the block rests.".into(),
        x: Axis::linear("τ"),
        y: Axis::linear("ü_{g}/(gα)").with_range(-1.5, 1.5),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series).with_marks(marks)],
    }
    .svg()
}
