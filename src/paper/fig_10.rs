//! Fig. 10: below the critical amplitude both schemes of Section 5.2 bring the block to rest.

use super::{
    Error, Figure, half_period,
    history::{CHATTERING, ETA, FINE, OMEGA, duration, lines, response, rows, table},
    missing,
};
use crate::chart::{self, Axis, LineChart, Mark, Panel, Table};

pub(super) const FIGURE: Figure =
    Figure { name: "fig_10", measure, charts: &[("fig_10.svg", whole), ("fig_10_insert.svg", insert)] };

const A: f64 = 1.03;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, FINE.1)?;
    let rest = response.bouts.first().ok_or_else(|| missing("the rocking of Fig. 10"))?.end();
    let mut parts = Vec::new();
    for scheme in [CHATTERING, FINE] {
        parts.push(rows("whole", A, scheme, (0.0, duration()))?);
        parts.push(rows("insert", A, scheme, (0.95 * rest, 1.01 * rest))?);
    }
    table(parts)
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    LineChart {
        title: format!("Both schemes below a_{{cr}}: a = {A}, ω = {OMEGA}, η = {ETA}"),
        caption:
            "At this scale the two can't be told apart: the block comes to rest before the second initiation by either."
                .into(),
        x: Axis::linear("τ"),
        y: Axis::linear("φ = θ/α"),
        columns: 1,
        missing: String::new(),
        panels: vec![
            Panel::new("", lines(table, "whole", "phi")?)
                .with_marks(vec![Mark::at(0.0, "1st initiation"), Mark::at(half_period(OMEGA), "2nd initiation")]),
        ],
    }
    .svg()
}

fn insert(table: &Table) -> Result<String, chart::Error> {
    LineChart {
        title: "Insert: the block comes to rest".into(),
        caption:
            "The chattering threshold ends the motion some impacts early, the small velocity threshold close to where \
                  they accumulate."
                .into(),
        x: Axis::linear("τ"),
        y: Axis::linear("φ = θ/α"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", lines(table, "insert", "phi")?)],
    }
    .svg()
}
