//! Fig. 5: the chattering time over half a period against the amplitude, by both methods of the paper.

use std::f64::consts::PI;

use rayon::prelude::*;
use serde::Serialize;

use super::{Error, Figure, half_period, missing};
use crate::{
    measure::zeno,
    panel,
    studies::{
        chart::{self, Axis, Draw, LineChart, Mark, Panel, Table, csv_text},
        diagnose::truth::{critical_epsilon, proven},
    },
};
use contract::Case;

pub(super) const FIGURE: Figure = Figure { name: "fig_5", measure, charts: &[("fig_5.svg", draw)] };

/// The paper gives no frequency; this is that of its Figs 2, 4 and 9.
const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
/// After how many impacts Eq. 75 closes the sum.
const IMPACTS: usize = 200;
/// How many amplitudes there are.
const STEPS: usize = 100;

/// The chattering time by one method at one amplitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    /// The frequency ratio.
    omega: f64,
    /// The restitution.
    eta: f64,
    /// Which method.
    method: &'static str,
    /// The amplitude.
    a: f64,
    /// `τ_ch/(T/2)`.
    half_period_fraction: f64,
    /// Its relative error, against the enclosure; nothing at the very ends.
    error: Option<f64>,
}

fn measure() -> Result<String, Error> {
    let critical = critical_epsilon(OMEGA, ETA)?;
    let paper = asymptotic::coefficients(ETA).ok_or_else(|| missing("Eq. 65"))?;
    let rows = (1..=STEPS).into_par_iter().map(|k| {
        // Closer towards both ends, where the curve is upright.
        let share = 0.5 - 0.5 * (PI * k as f64 / STEPS as f64).cos();
        let epsilon = critical * share;
        let truth = proven(epsilon, OMEGA, ETA);
        let row = |method, value: f64| Row {
            omega: OMEGA,
            eta: ETA,
            method,
            a: 1.0 + epsilon,
            half_period_fraction: value / half_period(OMEGA),
            error: truth.map(|truth| (value / truth - 1.0).abs()),
        };
        Ok([
            row("semi-analytical (Eq. 75)", eq75(epsilon)?),
            row("asymptotic (Eq. 65)", paper.chattering_time(epsilon, OMEGA)),
        ])
    });
    let mut rows = rows.collect::<Result<Vec<_>, Error>>()?.concat();
    rows.sort_by_key(|row| row.method.starts_with("asymptotic"));
    Ok(csv_text(&rows)?)
}

/// Eq. 75 with the intervals by the closed form.
fn eq75(epsilon: f64) -> Result<f64, Error> {
    let case = Case::from_epsilon(epsilon, OMEGA, ETA)?.with_max_impacts(IMPACTS + 2)?;
    let history = panel::stepper().history(&case)?;
    zeno::eq75(&history, ETA).ok_or_else(|| missing("Eq. 75"))
}

fn draw(table: &Table) -> Result<String, chart::Error> {
    let mut series = table.series("method", "a", "half_period_fraction")?;
    for one in &mut series {
        one.draw = Draw::Line;
    }
    let critical = table.numbers("a")?.into_iter().flatten().fold(1.0, f64::max);
    LineChart {
        title: format!("Chattering time against amplitude, η = {ETA}"),
        caption: format!(
            "τ_{{ch}} reaches T/2 at a_{{cr}} = {critical:.4}, upright there as at a = 1; the asymptotics follow it from \
             a = 1 on but miss the rise to a_{{cr}} (ω = {OMEGA}, Eq. 75 after {IMPACTS} impacts)."
        ),
        x: Axis::linear("a").with_range(1.0, 1.04),
        y: Axis::linear("τ_{ch}/(T/2)").with_range(0.0, 1.1),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series).with_marks(vec![Mark::at(critical, "a_{cr}"), Mark::level(1.0, "T/2")])],
    }
    .svg()
}
