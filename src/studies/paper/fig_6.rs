//! Fig. 6: the critical amplitude over the frequency and the restitution, beside the fit of Eq. 76.

use serde::Serialize;

use super::{Error, Figure};
use crate::{
    measure::critical::{eq76, interpolated},
    studies::{
        chart::{self, Axis, Cell, Draw, HeatMap, HeatPanel, LineChart, Panel, Series, Table, csv_text},
        diagnose::spread,
    },
};

pub(super) const FIGURE: Figure =
    Figure { name: "fig_6", measure, charts: &[("fig_6.svg", lines), ("fig_6_map.svg", map)] };

/// The critical amplitude at one place.
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
}

fn measure() -> Result<String, Error> {
    let mut rows = Vec::new();
    for eta in spread(0.5, 0.98, 24).map(|eta| (eta * 100.0).round() / 100.0) {
        for omega in spread(0.5, 8.0, 60) {
            rows.push(Row { omega, eta, a_cr: 1.0 + interpolated(omega, eta)?, eq76: eq76(omega, eta) });
        }
    }
    Ok(csv_text(&rows)?)
}

fn lines(table: &Table) -> Result<String, chart::Error> {
    const ETAS: [&str; 6] = ["0.5", "0.6", "0.7", "0.8", "0.9", "0.98"];
    let (mut exact, mut fits) = (Vec::new(), Vec::new());
    for (slot, eta) in ETAS.into_iter().enumerate() {
        let rows = table.filter("eta", eta)?;
        let line = Series::new(format!("η = {eta}"), rows.points("omega", "a_cr")?);
        exact.push(line.with_draw(Draw::Line).with_slot(slot));
        let few = rows.points("omega", "eq76")?.into_iter().step_by(4).collect();
        fits.push(Series::new(format!("Eq. 76, η = {eta}"), few).with_draw(Draw::Markers).with_slot(slot));
    }
    LineChart {
        title: "Critical amplitude over frequency and restitution".into(),
        caption:
            "Lines are a_{cr}, markers of the same colour the fit (Eq. 76). Below its line complete chattering occurs: a_{cr} rises as η falls, and depends on ω below ω of about \
                  2, the less the nearer η is to 1; the fit is within 0.012."
                .into(),
        x: Axis::linear("ω").with_range(0.0, 8.25),
        y: Axis::linear("a_{cr}"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", exact.into_iter().chain(fits).collect())],
    }
    .svg()
}

fn map(table: &Table) -> Result<String, chart::Error> {
    let cells = table.cells("omega", "eta", "a_cr")?.into_iter();
    let above_one = cells.map(|cell| Cell { value: cell.value.map(|a_cr| a_cr - 1.0), ..cell });
    HeatMap {
        title: "Critical amplitude over frequency and restitution".into(),
        caption: "a_{cr} depends on η far more than on ω, and for η above 0.75 on ω only where the excitation is slow."
            .into(),
        x: Axis::linear("ω"),
        y: Axis::linear("η"),
        colour: Axis::linear("a_{cr} − 1"),
        columns: 1,
        missing: Vec::new(),
        panels: vec![HeatPanel::new("", above_one.collect())],
    }
    .svg()
}
