//! Fig. 4: the excitation, and where rocking is initiated.

use serde::Serialize;

use super::{Error, Figure, half_period, phase};
use crate::studies::{
    chart::{self, Axis, Draw, LineChart, Mark, Panel, Series, Table, csv_text},
    diagnose::spread,
};

pub(super) const FIGURE: Figure = Figure { name: "fig_4", measure, charts: &[("fig_4.svg", draw)] };

const A: f64 = 1.03;
const OMEGA: f64 = 2.0;
/// How many points there are.
const POINTS: usize = 251;

/// The excitation at one time.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    /// The time since the first initiation, at which the excitation begins.
    tau: f64,
    /// `ü_g/(g α) = a sin(ωτ + ψ)`.
    ground_acceleration: f64,
    /// `1` or `2` at the first or second initiation, nothing elsewhere.
    initiation: Option<u8>,
}

fn measure() -> Result<String, Error> {
    let psi = phase(A);
    let even = spread(0.0, 5.0 * half_period(OMEGA), POINTS).skip(1).map(|tau| (tau, None));
    // At the threshold of either sign, growing: at the phases ψ and ψ + π.
    let initiations = [(0.0, Some(1)), (half_period(OMEGA), Some(2))];
    let mut times: Vec<(f64, Option<u8>)> = even.chain(initiations).collect();
    times.sort_by(|one, other| one.0.total_cmp(&other.0));
    let row = |(tau, initiation)| Row { tau, ground_acceleration: A * (OMEGA * tau + psi).sin(), initiation };
    Ok(csv_text(&times.into_iter().map(row).collect::<Vec<_>>())?)
}

fn draw(table: &Table) -> Result<String, chart::Error> {
    let excitation = Series::new("a sin(ωτ + ψ)", table.points("tau", "ground_acceleration")?).with_draw(Draw::Line);
    let mut marks = Vec::new();
    let mut series = vec![excitation];
    for (number, name) in [("1", "1st initiation"), ("2", "2nd initiation")] {
        let points = table.filter("initiation", number)?.points("tau", "ground_acceleration")?;
        marks.extend(points.iter().map(|point| Mark::at(point.x, name)));
        series.push(Series::new(name, points).with_draw(Draw::Markers));
    }
    let title = format!("Excitation of a = {A}, ω = {OMEGA} over 2.5 T");
    let caption = "Rocking is initiated where the ground acceleration reaches the threshold ±1 (dashed), so the block has half a \
                   period between the first and the second initiation to come to rest.";
    chart(&title, caption, series, marks)
}

/// A chart of the excitation, with the thresholds.
pub(super) fn chart(
    title: &str,
    caption: &str,
    series: Vec<Series>,
    mut marks: Vec<Mark>,
) -> Result<String, chart::Error> {
    marks.extend([Mark::level(1.0, "1"), Mark::level(-1.0, "−1")]);
    LineChart {
        title: title.into(),
        caption: caption.into(),
        x: Axis::linear("τ"),
        y: Axis::linear("ü_{g}/(gα)").with_range(-1.5, 1.5),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series).with_marks(marks)],
    }
    .svg()
}
