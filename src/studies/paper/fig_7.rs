//! Fig. 7: the critical amplitude over the frequency at `η = 0.92`.

use serde::Serialize;

use super::{Error, Figure};
use crate::{
    measure::critical::{eq76, eq77, interpolated},
    studies::{
        chart::{self, Axis, Draw, LineChart, Panel, Series, Table, csv_text},
        diagnose::spread,
    },
};

pub(super) const FIGURE: Figure = Figure { name: "fig_7", measure, charts: &[("fig_7.svg", draw)] };

const ETA: f64 = 0.92;

/// The critical amplitude at one frequency.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    /// The frequency ratio.
    omega: f64,
    /// The restitution.
    eta: f64,
    /// `a_cr`, by the interpolant, which is good to 1e-14.
    a_cr: f64,
    /// What Eq. 76 gives.
    eq76: f64,
    /// What Eq. 77 gives.
    eq77: f64,
}

fn measure() -> Result<String, Error> {
    let rows = spread(0.5, 8.0, 150).map(|omega| {
        let a_cr = 1.0 + interpolated(omega, ETA)?;
        Ok(Row { omega, eta: ETA, a_cr, eq76: eq76(omega, ETA), eq77: eq77(ETA) })
    });
    Ok(csv_text(&rows.collect::<Result<Vec<_>, Error>>()?)?)
}

fn draw(table: &Table) -> Result<String, chart::Error> {
    let line = |name: &str, column: &str| {
        Ok::<_, chart::Error>(Series::new(name, table.points("omega", column)?).with_draw(Draw::Line))
    };
    LineChart {
        title: format!("Critical amplitude over frequency, η = {ETA}"),
        caption:
            "From ω = 0.5 to 8 a_{cr} rises by 0.5 % of itself, nearly all of it below ω = 2; that is a seventh of \
                  a_{cr} − 1, its distance to the threshold."
                .into(),
        x: Axis::linear("ω").with_range(0.0, 8.25),
        y: Axis::linear("a_{cr}").with_range(1.03, 1.042),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", vec![line("a_{cr}", "a_cr")?, line("Eq. 76", "eq76")?, line("Eq. 77", "eq77")?])],
    }
    .svg()
}
