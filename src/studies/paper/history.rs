//! Response histories as tables, and the lines of their charts: Figs 2, 9, 10 and 11.

use contract::Case;
use serde::Serialize;

use super::{Error, half_period};
use crate::{
    motion::response::{Request, Response, Termination, Window},
    panel,
    studies::{
        chart::{self, Axis, Draw, LineChart, Mark, Panel, Series, Table, csv_text},
        chattering_threshold::{Condition, chattering_threshold},
    },
};

/// The frequency ratio of all four figures.
pub(super) const OMEGA: f64 = 2.0;
/// Their restitution.
pub(super) const ETA: f64 = 0.92;
/// How many steps a chart of the whole motion is wide: one is a pixel, as a flight is a few of them.
pub(super) const WHOLE: usize = 600;
/// The same of a part of it.
pub(super) const PART: usize = 300;

/// A way to end chattering, and what it is called.
pub(super) type Scheme = (&'static str, fn(&Case) -> Termination);

/// Where the impacts accumulate.
pub(super) const EXACT: Scheme = ("φ", |_| Termination::Exact);
/// Scheme (a) of Fig. 8.
pub(super) const CHATTERING: Scheme = ("chattering threshold", |case| chattering_threshold(case, Condition::Eq76));
/// Scheme (b) of Fig. 8 with the smaller threshold of Figs 10 and 11.
pub(super) const FINE: Scheme = ("VelTol/(pα) = 5×10⁻¹⁰", |_| Termination::VelocityThreshold(5e-10));
/// The same with the larger threshold of Fig. 11.
pub(super) const COARSE: Scheme = ("VelTol/(pα) = 5×10⁻²", |_| Termination::VelocityThreshold(5e-2));

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
    ground_acceleration: Option<f64>,
}

/// 2.5 periods, which the excitation lasts.
pub(super) fn duration() -> f64 {
    5.0 * half_period(OMEGA)
}

/// The response to the excitation of amplitude `a`, and what was asked for.
pub(super) fn response(a: f64, scheme: Scheme) -> Result<(Response, Request), Error> {
    let request = Request::new(Case::from_amplitude(a, OMEGA, ETA)?, Some(duration()), duration())?;
    let request = Request { termination: scheme.1(&request.case), ..request };
    Ok((Response::new(panel::stepper().as_ref(), &request)?, request))
}

/// The rows of one part: the response from one time to another.
pub(super) fn rows(
    part: &'static str,
    a: f64,
    scheme: Scheme,
    window: (f64, f64),
    steps: usize,
) -> Result<Vec<Row>, Error> {
    let (response, request) = response(a, scheme)?;
    let window = Window { from: window.0, to: window.1, steps };
    let samples = response.samples(panel::stepper().as_ref(), &request, &window)?;
    let row = |sample: crate::motion::response::Sample| Row {
        part,
        scheme: scheme.0,
        n: None,
        tau: sample.tau,
        phi: sample.phi,
        ground_acceleration: Some(sample.ground_acceleration),
    };
    Ok(samples.into_iter().map(row).collect())
}

/// A row that marks a time: an impact, or with no number where they accumulate.
pub(super) fn mark(part: &'static str, n: Option<usize>, tau: f64) -> Row {
    Row { part, scheme: "", n, tau, phi: 0.0, ground_acceleration: None }
}

/// The text of a table.
pub(super) fn table(parts: Vec<Vec<Row>>) -> Result<String, Error> {
    Ok(csv_text(&parts.concat())?)
}

/// A line for each scheme in one part of a figure. Where there are several the first is broad, so that one that coincides does not hide it.
pub(super) fn lines(table: &Table, part: &str, y: &str) -> Result<Vec<Series>, chart::Error> {
    let series = table.filter("part", part)?.series("scheme", "tau", y)?;
    let several = series.len() > 1;
    let of =
        |(index, one): (usize, Series)| one.with_draw(if several && index == 0 { Draw::Broad } else { Draw::Line });
    Ok(series.into_iter().enumerate().map(of).collect())
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
