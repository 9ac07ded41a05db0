//! Fig. 10: below the critical amplitude both schemes of Section 5.2 bring the block to rest.

use super::{
    Error, Figure,
    history::{self, CHATTERING, ETA, FINE, OMEGA, PART, WHOLE, duration, initiations, lines, response, rows, table},
    missing,
};
use crate::studies::chart::{self, Table};

pub(super) const FIGURE: Figure =
    Figure { name: "fig_10", measure, charts: &[("fig_10.svg", whole), ("fig_10_insert.svg", insert)] };

const A: f64 = 1.03;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, FINE)?;
    let rest = response.bouts.first().ok_or_else(|| missing("the rocking of Fig. 10"))?.end();
    let mut parts = Vec::new();
    for scheme in [CHATTERING, FINE] {
        parts.push(rows("whole", A, scheme, (0.0, duration()), WHOLE)?);
        parts.push(rows("insert", A, scheme, (0.95 * rest, 1.01 * rest), PART)?);
    }
    table(parts)
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    let title = format!("Both schemes below a_{{cr}}: a = {A}, ω = {OMEGA}, η = {ETA}");
    let caption =
        "At this scale the two lie on each other: the block comes to rest before the second initiation by either.";
    history::chart(&title, caption, lines(table, "whole", "phi")?, initiations())
}

fn insert(table: &Table) -> Result<String, chart::Error> {
    let title = "Insert: the block comes to rest";
    let caption = "The chattering threshold ends the motion some impacts early, the small velocity threshold close to where \
                  they accumulate.";
    history::chart(title, caption, lines(table, "insert", "phi")?, Vec::new())
}
