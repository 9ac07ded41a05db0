//! Fig. 3: the ratio of the intervals of every two consecutive impacts tends to `η²` (Eq. 73).

use serde::Serialize;

use super::{Error, Figure, observed};
use crate::studies::chart::{self, Axis, Draw, LineChart, Mark, Panel, Table, csv_text};

/// Fig. 3a.
pub(super) const A: Figure =
    Figure { name: "fig_3a", measure: || measure(1.01, 5.0, 0.92), charts: &[("fig_3a.svg", draw)] };
/// Fig. 3b.
pub(super) const B: Figure =
    Figure { name: "fig_3b", measure: || measure(1.03, 2.0, 0.86), charts: &[("fig_3b.svg", draw)] };

/// How many ratios are shown.
const RATIOS: usize = 120;

/// The ratio at one impact.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    /// The amplitude.
    a: f64,
    /// The frequency ratio.
    omega: f64,
    /// The restitution.
    eta: f64,
    /// How many impacts have occurred.
    n: usize,
    /// `i_n`, the sign of the flight that follows.
    sign: i8,
    /// `Δτ_n`.
    interval: f64,
    /// `Δτ_(n+2)/Δτ_n`.
    ratio: f64,
    /// `η²`, what it tends to.
    limit: f64,
}

fn measure(a: f64, omega: f64, eta: f64) -> Result<String, Error> {
    let impacts = observed(a, omega, eta, RATIOS + 3)?.history.impacts;
    // The flight after impact n ends with impact n + 1, the first one listed ends flight 0.
    let flights = impacts.iter().zip(impacts.iter().skip(2)).enumerate();
    let rows = flights.map(|(n, (flight, next))| Row {
        a,
        omega,
        eta,
        n,
        sign: if n % 2 == 0 { -1 } else { 1 },
        interval: flight.interval,
        ratio: next.interval / flight.interval,
        limit: eta * eta,
    });
    Ok(csv_text(&rows.collect::<Vec<_>>())?)
}

fn draw(table: &Table) -> Result<String, chart::Error> {
    let of =
        |column: &str| Ok::<_, chart::Error>(table.numbers(column)?.into_iter().flatten().next().unwrap_or(f64::NAN));
    let (a, omega, eta, limit) = (of("a")?, of("omega")?, of("eta")?, of("limit")?);
    let mut series = table.series("sign", "n", "ratio")?;
    for one in &mut series {
        let sign = if one.name == "-1" { "i_{0}" } else { "−i_{0}" };
        *one =
            crate::studies::chart::Series::new(format!("i_{{n}} = {sign}"), one.points.clone()).with_draw(Draw::Both);
    }
    LineChart {
        title: format!("Ratio of intervals, a = {a}, ω = {omega}, η = {eta}"),
        caption: "The ratio of every two consecutive intervals of the same sign varies at first and tends to η² from \
                  either side."
            .into(),
        x: Axis::linear("n").with_range(-2.0, 122.0),
        y: Axis::linear("Δτ_{n+2}/Δτ_{n}"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series).with_marks(vec![Mark::level(limit, "η²")])],
    }
    .svg()
}
