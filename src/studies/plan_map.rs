//! The map of how much model a scene needs: which method answers, over the slenderness and the amplitude, at three tolerances.

use contract::{Case, Invalid, Normalisation, Slenderness};
use rayon::prelude::*;
use serde::Serialize;

use crate::{
    measure::critical,
    plan::{Plan, Question},
    studies::{
        chart::{self, Axis, Chart, Draw, LineChart, Mark, Panel, Point, Series, Table},
        diagnose::spread,
    },
};

/// The chart of the map, and its table.
pub const CHARTS: [Chart; 1] = [Chart { name: "plan_map.svg", table: "plan_map.csv", draw }];

/// The restitution and the frequency ratio of the paper's figures.
const ETA: f64 = 0.92;
const OMEGA: f64 = 2.0;
const TOLERANCES: [f64; 3] = [1e-2, 1e-5, 1e-8];
const STEPS: usize = 26;

/// One question and what answered it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The relative tolerance.
    pub tolerance: f64,
    /// The slenderness angle in radians.
    pub alpha: f64,
    /// `(a - 1)/(a_cr - 1)`, of the slender block.
    pub share: f64,
    /// The method whose answer was accurate enough.
    pub method: String,
    /// What that was predicted to cost, in microseconds.
    pub cost: f64,
    /// The relative error estimated after the fact; empty where there is no chattering time.
    pub uncertainty: Option<f64>,
}

/// The rows of the map.
///
/// # Errors
/// Never, as far as its cases are in range.
pub fn rows() -> Result<Vec<Row>, Invalid> {
    let critical = critical::interpolated(OMEGA, ETA)?;
    let mut places = Vec::new();
    for tolerance in TOLERANCES {
        for log_alpha in spread(0.02_f64.ln(), 0.5_f64.ln(), STEPS) {
            places.extend(spread(-0.05, 1.25, STEPS).map(|share| (tolerance, log_alpha.exp(), share)));
        }
    }
    let row = |(tolerance, alpha, share): (f64, f64, f64)| {
        let slenderness = Slenderness::new(alpha, Normalisation::Threshold)?;
        let case = Case::from_epsilon(share * critical, OMEGA, ETA)?.with_slenderness(slenderness);
        let plan = Plan::new(Question::new(case, tolerance));
        let answer = plan.answer();
        let method = answer.method();
        let of_method = plan.candidates.iter().find(|candidate| Some(candidate.method) == method);
        Ok(Row {
            tolerance,
            alpha,
            share,
            method: method.map_or_else(|| "none".to_owned(), |method| method.to_string()),
            cost: of_method.map_or(0.0, |candidate| candidate.cost),
            uncertainty: answer.chattering_time().map(|time| time.uncertainty / time.value),
        })
    };
    places.into_par_iter().map(row).collect()
}

/// Draws the map from its table.
///
/// # Errors
/// When the table is not one of [`rows`].
pub fn draw(table: &Table) -> Result<String, chart::Error> {
    const NAMES: [(&str, &str); 6] = [
        ("nothing", "nothing: it never rocks"),
        ("critical-amplitude", "a_{cr} alone: it does not rest"),
        ("closed-form", "slender block, closed form"),
        ("closed-form/corrected", "slender block, corrected by α²"),
        ("taylor", "the block as it is (Eq. 2)"),
        ("enclosure", "proven bounds"),
    ];
    let panels = table.groups("tolerance")?.into_iter().map(|(tolerance, rows)| {
        let series = NAMES.into_iter().map(|(method, name)| {
            let of = rows.filter("method", method)?;
            let places = of.numbers("share")?.into_iter().zip(of.numbers("alpha")?);
            let points = places.filter_map(|(x, y)| Some(Point { x: x?, y: Some(y?) })).collect();
            Ok(Series::new(name, points).with_draw(Draw::Markers))
        });
        let mut series = series.collect::<Result<Vec<_>, chart::Error>>()?;
        series.retain(|series| !series.points.is_empty());
        let tolerance = tolerance.parse::<f64>().map_or(tolerance.to_owned(), |tolerance| {
            format!("10^{{{}}}", tolerance.log10().round()).replace('-', "−")
        });
        Ok(Panel::new(format!("tolerance {tolerance}"), series).with_marks(vec![Mark::at(1.0, "a_{cr}")]))
    });
    LineChart {
        title: format!("How much model a scene needs (η = {ETA}, ω = {OMEGA})"),
        caption: "Below the threshold and beyond a_{cr} nothing is simulated; in between the slender block will do to 1 % almost everywhere, and the \
                  more digits are asked of the stockier a block, the more the equation of the block as it is is needed, first near a_{cr}."
            .into(),
        x: Axis::linear("(a − 1)/(a_{cr} − 1)").with_range(-0.08, 1.28),
        y: Axis::log("α"),
        columns: 3,
        missing: String::new(),
        panels: panels.collect::<Result<_, chart::Error>>()?,
    }
    .svg()
}
