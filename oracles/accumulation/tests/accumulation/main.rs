//! The local Zeno series against values of other programs, exact sums and its own functional equation.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Check values are written with the digits that they came with.

mod declines;
mod error;
mod values;

use accumulation::{Accumulation, Series};
use contract::{Body, Closure, Departure, Estimate, Ground, Motion, Sinusoid, Stretch};

/// A departure from the base after an impact.
fn impact(side: f64, time: f64, velocity: f64) -> Departure {
    Departure { ground: Ground::Shaking, time, side, rotation: 0.0, velocity }
}

/// `a sin(ωτ + phase)` for ever, added up.
fn sines(terms: &[(f64, f64, f64)]) -> Motion {
    let term = |&(amplitude, omega, phase): &(f64, f64, f64)| Sinusoid { amplitude, omega, phase };
    let stretch = Stretch { until: f64::INFINITY, terms: terms.iter().map(term).collect() };
    Motion::sinusoids(vec![stretch]).unwrap()
}

/// The series of order `order` of Eq. 4, or of Eq. 2 for a block with a slenderness.
fn series(order: usize, eta: f64, alpha: Option<f64>, motion: &Motion) -> Series {
    Accumulation::default().with_order(order).unwrap().series(&Body::new(eta, alpha).unwrap(), motion)
}

fn left(order: usize, eta: f64, motion: &Motion, departure: &Departure) -> Estimate {
    series(order, eta, None, motion).time_left(departure).unwrap()
}
