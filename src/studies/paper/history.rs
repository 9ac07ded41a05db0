//! Response histories as tables, and the lines of their charts: Figs 2, 9, 10 and 11.

use contract::Case;
use serde::Serialize;

use super::{Error, half_period};
use crate::{
    motion::response::{Condition, Request, Response, Termination, Window},
    panel,
    studies::chart::{self, Axis, Draw, LineChart, Mark, Panel, Series, Table, csv_text},
};

/// The frequency ratio of all four figures.
pub(super) const OMEGA: f64 = 2.0;
/// Their restitution.
pub(super) const ETA: f64 = 0.92;
/// How many steps a chart is wide: one is less than three pixels.
const STEPS: usize = 200;

/// Scheme (a) of Fig. 8.
pub(super) const CHATTERING: (&str, Termination) =
    ("chattering threshold", Termination::ChatteringThreshold(Condition::Eq76));
/// Scheme (b) of Fig. 8 with the smaller threshold of Figs 10 and 11.
pub(super) const FINE: (&str, Termination) = ("VelTol/(pα) = 5×10⁻¹⁰", Termination::VelocityThreshold(5e-10));
/// The same with the larger threshold of Fig. 11.
pub(super) const COARSE: (&str, Termination) = ("VelTol/(pα) = 5×10⁻²", Termination::VelocityThreshold(5e-2));

/// A response at one time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Row {
    /// The part of the figure.
    part: &'static str,
    /// How chattering is ended.
    scheme: &'static str,
    /// The number of the impact, in a row that marks one.
    n: Option<usize>,
    /// The time since the first initiation.
    tau: f64,
    /// `φ = θ/α`.
    phi: f64,
    /// `ü_g/(g α)`; nothing in a row that marks a time.
    excitation: Option<f64>,
}

/// 2.5 periods, which the excitation lasts.
pub(super) fn duration() -> f64 {
    5.0 * half_period(OMEGA)
}

/// The response to the excitation of amplitude `a`, and what was asked for.
pub(super) fn response(a: f64, termination: Termination) -> Result<(Response, Request), Error> {
    let request = Request::new(Case::from_amplitude(a, OMEGA, ETA)?, Some(duration()), duration())?;
    let request = Request { termination, ..request };
    Ok((Response::new(panel::stepper().as_ref(), &request)?, request))
}

/// The rows of one part: the response from one time to another.
pub(super) fn rows(
    part: &'static str,
    a: f64,
    scheme: (&'static str, Termination),
    window: (f64, f64),
) -> Result<Vec<Row>, Error> {
    let (response, request) = response(a, scheme.1)?;
    let window = Window { from: window.0, to: window.1, steps: STEPS };
    let samples = response.samples(panel::stepper().as_ref(), &request, &window)?;
    let row = |sample: crate::motion::response::Sample| Row {
        part,
        scheme: scheme.0,
        n: None,
        tau: to_digits(sample.tau, 9),
        phi: to_digits(sample.phi, 6),
        excitation: Some(to_digits(sample.ground_acceleration, 6)),
    };
    Ok(samples.into_iter().map(row).collect())
}

/// A number with so many significant digits: more could not be seen, and would make the files twice as long.
fn to_digits(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}

/// A row that marks a time: an impact, or with no number where they accumulate.
pub(super) fn mark(part: &'static str, n: Option<usize>, tau: f64) -> Row {
    Row { part, scheme: "", n, tau, phi: 0.0, excitation: None }
}

/// The text of a table.
pub(super) fn table(parts: Vec<Vec<Row>>) -> Result<String, Error> {
    Ok(csv_text(&parts.concat())?)
}

/// A line for each scheme in one part of a figure.
pub(super) fn lines(table: &Table, part: &str, y: &str) -> Result<Vec<Series>, chart::Error> {
    let series = table.filter("part", part)?.series("scheme", "tau", y)?;
    Ok(series.into_iter().map(|one| one.with_draw(Draw::Line)).collect())
}

/// A chart of rotations against time.
pub(super) fn chart(title: &str, caption: &str, lines: Vec<Series>, marks: Vec<Mark>) -> Result<String, chart::Error> {
    LineChart {
        title: title.into(),
        caption: caption.into(),
        x: Axis::linear("τ"),
        y: Axis::linear("φ = θ/α"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", lines).with_marks(marks)],
    }
    .svg()
}

/// The two initiations that the paper names: where the first two lobes reach the threshold.
pub(super) fn initiations() -> Vec<Mark> {
    vec![Mark::at(0.0, "1st initiation"), Mark::at(half_period(OMEGA), "2nd initiation")]
}
