//! What the local series says is left of a bout, impact by impact, against what is: by how much it is off to orders 1, 2, 4 and 8.

use accumulation::{Accumulation, Series};
use contract::{Arrival, Body, Decline, Departure, Invalid, Motion, Ricker, Sinusoid, Stretch};
use serde::Serialize;

use crate::{
    motion::response::{Bout, OnMotion, Request, Response, Termination},
    panel,
    studies::chart::{self, Axis, Chart, LineChart, Mark, Panel, Table},
};

/// The chart, and its table.
pub const CHARTS: [Chart; 1] = [Chart { name: "remaining_time.svg", table: "remaining_time.csv", draw }];

/// The orders that are shown.
const ORDERS: [usize; 4] = [1, 2, 4, 8];
/// The order with which the last impact is closed, and which is asked whether it is to be trusted.
const BEST: usize = 12;
/// Below this share of the first impact's nothing more is seen.
const LEAST: f64 = 1e-8;
/// Errors below this are of doubles.
const FLOOR: f64 = 1e-15;

/// What an order says at one impact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The motion of the ground.
    pub motion: &'static str,
    /// How many terms of the series are summed.
    pub order: usize,
    /// The number of the impact.
    pub impact: usize,
    /// What is left after it, `τ`.
    pub left: f64,
    /// What the terms sum up to.
    pub predicted: f64,
    /// How far off that is, relative.
    pub error: f64,
    /// Whether the series is trusted here: its terms fall.
    pub trusted: bool,
}

/// Why there are no rows.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A number is out of range.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// A method declines.
    #[error("{0}")]
    Declined(Decline),
}

impl From<Decline> for Error {
    fn from(decline: Decline) -> Self {
        Self::Declined(decline)
    }
}

/// The rows: a sinusoid, a wavelet that is antisymmetric, and two sinusoids.
///
/// # Errors
/// Never, as far as the motions are in range.
pub fn rows() -> Result<Vec<Row>, Error> {
    let sine = |amplitude, omega, phase| Sinusoid { amplitude, omega, phase };
    let sum = |terms| Motion::sinusoids(vec![Stretch { until: 12.0, terms }]);
    let wavelet = Ricker { amplitude: 1.03, omega: 4.0, center: 2.5, antisymmetric: true };
    let motions = [
        ("sinusoid, a = 1.03, ω = 2, η = 0.92", sum(vec![sine(1.03, 2.0, 0.0)])?, 0.92),
        ("antisymmetric Ricker, a = 1.03, ω = 4, η = 0.92", Motion::ricker(wavelet)?, 0.92),
        (
            "two sinusoids, a = 1.7 and 1.02, ω = 0.4 and 2.5, η = 0.6",
            sum(vec![sine(1.7, 0.4, -0.2), sine(1.02, 2.5, 0.0)])?,
            0.6,
        ),
    ];
    let mut rows = Vec::new();
    for (name, motion, eta) in motions {
        rows.extend(of_motion(name, motion, eta)?);
    }
    Ok(rows)
}

fn of_motion(name: &'static str, motion: Motion, eta: f64) -> Result<Vec<Row>, Error> {
    let body = Body::new(eta, None)?;
    let request = OnMotion {
        body,
        motion: motion.clone().into(),
        rounding: 0.0,
        start: (0.0, 0.0),
        until: 12.0,
        lies_at: None,
        termination: Termination::Exact,
        most_impacts: Request::MOST_IMPACTS,
    };
    let stepper = panel::stepper_on(&body, &motion);
    let response = Response::once_on_motion(stepper.as_ref(), &request)?;
    let Some(bout) = response.bouts.first() else { return Ok(Vec::new()) };
    let impacts = impacts(bout, eta);
    let best = Accumulation::default().with_order(BEST)?.series(&body, &motion);
    let eighth = Accumulation::default().series(&body, &motion);
    let mut left = match impacts.last() {
        Some((last, _)) => sum(&best, last, BEST)?,
        None => return Ok(Vec::new()),
    };
    let mut found = Vec::new();
    for (place, (departure, next)) in impacts.iter().enumerate().rev() {
        // Added up from the end, so that nothing is a difference of times.
        left += next;
        let Ok(terms) = eighth.terms(departure) else { continue };
        let trusted = terms.first_that_does_not_fall().is_none();
        for order in ORDERS {
            let predicted: f64 = terms.as_slice().iter().take(order).rev().sum();
            let error = (predicted / left - 1.0).abs();
            found.push(Row { motion: name, order, impact: place + 1, left, predicted, error, trusted });
        }
    }
    let first = found.iter().map(|row| row.left).fold(0.0, f64::max);
    found.retain(|row| row.left > LEAST * first);
    found.sort_by_key(|row| (row.order, row.impact));
    Ok(found)
}

/// The departures after the impacts, each with how long the flight lasts that follows; 0 after the last.
fn impacts(bout: &Bout, eta: f64) -> Vec<(Departure, f64)> {
    let landed = bout.flights.iter().filter_map(|flight| {
        let Arrival::Impact { speed, interval } = flight.arrival else { return None };
        let side = -flight.departure.side * bout.lobe.mirror;
        let time = bout.lobe.start + flight.end;
        Some((Departure { time, side, rotation: 0.0, velocity: eta * speed, ..flight.departure }, interval))
    });
    let landed: Vec<_> = landed.collect();
    let later = landed.iter().skip(1).map(|(_, interval)| *interval).chain([0.0]);
    landed.iter().map(|(departure, _)| *departure).zip(later).collect()
}

fn sum(series: &Series, departure: &Departure, order: usize) -> Result<f64, Decline> {
    Ok(series.terms(departure)?.as_slice().iter().take(order).rev().sum())
}

/// Draws the chart from its table.
///
/// # Errors
/// When the table is not one of [`rows`].
pub fn draw(table: &Table) -> Result<String, chart::Error> {
    let panel = |(motion, rows): (String, Table)| {
        let trusted = rows.filter("trusted", "true")?.numbers("left")?;
        let from = trusted.into_iter().flatten().fold(0.0, f64::max);
        let mut series = rows.series("order", "left", "error")?;
        for series in &mut series {
            series.name = format!("order {}", series.name);
        }
        let series = series.into_iter().map(|series| series.with_least(FLOOR)).collect();
        Ok(Panel::new(motion, series).with_marks(vec![Mark::at(from, "trusted below")]))
    };
    LineChart {
        title: "What the local series says is left, from one impact alone".into(),
        caption: "A point an impact. To order n the error falls as the n-th power of what is left; the series is trusted where each of its terms is less \
                  than a tenth of the one before. To the right of it is the initiation, where the pull is weak and more impacts have to be followed."
            .into(),
        x: Axis::log("time that is left, τ"),
        y: Axis::log("relative error of the prediction").with_range(FLOOR, 10.0),
        columns: 3,
        missing: String::new(),
        panels: table.groups("motion")?.into_iter().map(panel).collect::<Result<_, chart::Error>>()?,
    }
    .svg()
}
