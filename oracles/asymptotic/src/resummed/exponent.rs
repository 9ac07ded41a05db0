use std::f64::consts::PI;
use std::ops::RangeInclusive;

use contract::Estimate;
use twofloat::TwoFloat;

use crate::expansion::PRECISION;
use crate::flight::Block;
use crate::linear::solve;
use crate::march::{Search, march};
use crate::number::Number;

/// The exponent `β` of the approach to the critical amplitude, from the coefficients of the series and the critical amplitude; `None` where
/// they do not tell.
///
/// Neither the closed formula for `β` nor the period of the factor that is periodic in the logarithm is used. What is left of the half period,
/// `y = 1 - τ_ch/(T/2)`, is summed at places short of the critical amplitude, where the coefficients give it to many digits. There `y` is a power of the
/// distance `δ = 1 - ε/ε_c`, corrected by powers of it and of `δ`; turned round,
///
/// `ln δ = b + (1/β) ln y + Σ b_s y^s`, with `s = j + l/β`, `j + l > 0`,
///
/// and the difference of that between places a factor of 4 apart is linear in `1/β` and the first few `b_s`. (The periodic factor is
/// strong in the coefficients but hardly shows in their sums on the real axis, and a factor of 4 is nearly a whole period of it for `η = 0.5`.)
///
/// Its settings were chosen at `ω = 2`, with the formula's value in view. For `η` from 0.5 to 0.97 the error is below 5e-4 for `ω = 2`, and in the tests
/// for 4, 6 and 8; it was up to 6e-4 for `ω = 1`, and up to 1.4e-3 for `ω = 0.5` and `η` up to 0.6, where the claim says so.
pub fn exponent_of_coefficients(omega: f64, eta: f64, critical_epsilon: f64) -> Option<Estimate> {
    let approach = Approached::new(omega, eta, critical_epsilon)?;
    // The powers take the exponent that was found before.
    let mut exponent = START;
    let mut found = None;
    for _ in 0..ROUNDS {
        let estimate = approach.exponent(exponent)?;
        exponent = estimate.value;
        found = Some(estimate);
    }
    found
}

/// In units of the critical `ε` the coefficients hardly fall, and any number of them can be had. These take seconds at `η = 0.97`.
const TERMS: usize = 300;
/// The places: the coefficients that are not known take part in what is left at the first of them with `e^-4`.
const PLACES: RangeInclusive<f64> = 4.0 / TERMS as f64..=0.5;
const RATIO: f64 = 4.0;
/// Numbers of powers, with the one of `1/β`. With fewer the answers are not yet near each other, with more they part again.
const POWERS: RangeInclusive<usize> = 5..=10;
/// Not 1/2, where the powers of `y` and of `δ` would be the same.
const START: f64 = 0.55;
const ROUNDS: usize = 5;
/// Where the answers of three numbers of powers agree they were still off by up to 4e-4 at `ω = 2` (`diagnose`, `exponents.csv`).
const FLOOR: f64 = 5e-4;

/// `ω τ_ch/ε_c^(1/2)` in powers of `ε/ε_c`.
struct Approached {
    coefficients: Vec<f64>,
    root: f64,
}

impl Approached {
    fn new(omega: f64, eta: f64, critical_epsilon: f64) -> Option<Self> {
        let block = Block::<TwoFloat>::new(omega, eta).in_units_of(critical_epsilon);
        let (_, limit) = march(&block, TERMS, 0, Search::Until(PRECISION));
        let known: Vec<f64> = limit?.value.0.into_iter().map(Number::rounded).collect();
        Some(Self { coefficients: continued(known)?, root: critical_epsilon.sqrt() })
    }

    /// `1 - τ_ch/(T/2)` at the distance `δ`.
    fn left(&self, to_go: f64) -> f64 {
        let x = 1.0 - to_go;
        let sum = self.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient);
        1.0 - self.root * x.sqrt() * sum / PI
    }

    /// With that number of powers which agrees best with one less and one more.
    fn exponent(&self, known: f64) -> Option<Estimate> {
        let values = POWERS.map(|count| self.with_powers(count, known)).collect::<Option<Vec<_>>>()?;
        let estimates = values.windows(3).filter_map(|three| match three {
            [fewer, value, more] => {
                let change = (fewer - value).abs().max((more - value).abs());
                Some(Estimate { value: *value, uncertainty: FLOOR + change })
            }
            _ => None,
        });
        estimates.min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty))
    }

    fn with_powers(&self, count: usize, known: f64) -> Option<f64> {
        let powers = powers(count, known);
        // As many places as unknowns, where Chebyshev's polynomial of ln δ vanishes.
        let (first, last) = (PLACES.start().ln(), (PLACES.end() / RATIO).ln());
        let rows = (0..count).map(|k| {
            let node = (PI * (k as f64 + 0.5) / count as f64).cos();
            let to_go = (0.5 * (first + last) + 0.5 * (last - first) * node).exp();
            let (near, far) = (self.left(to_go), self.left(RATIO * to_go));
            let corrections = powers.iter().map(|power| far.powf(*power) - near.powf(*power));
            std::iter::once((far / near).ln()).chain(corrections).chain([RATIO.ln()]).collect()
        });
        solve(rows.collect())?.first().map(|inverse| 1.0 / inverse)
    }
}

/// The lowest powers `j + l/β`, without the 0 of the constant.
fn powers(count: usize, exponent: f64) -> Vec<f64> {
    let all = (0..count).flat_map(|j| (0..count).map(move |l| j as f64 + l as f64 / exponent));
    let mut all: Vec<f64> = all.collect();
    all.sort_by(f64::total_cmp);
    all.into_iter().skip(1).take(count - 1).collect()
}

/// The coefficients and those behind, which matter little: their ratios as `1 - a/k - b/k²`, from two of those that are known.
fn continued(mut coefficients: Vec<f64>) -> Option<Vec<f64>> {
    let terms = coefficients.len();
    let fall = |k: usize| Some(k as f64 * (1.0 - coefficients.get(k)? / coefficients.get(k - 1)?));
    let (early, late) = (terms * 7 / 8, terms - 1);
    let (at_early, at_late) = (fall(early)?, fall(late)?);
    let b = (at_early - at_late) / (1.0 / early as f64 - 1.0 / late as f64);
    let a = at_late - b / late as f64;
    let mut last = *coefficients.last()?;
    coefficients.extend((terms..LONG_GONE * terms).map(|k| {
        last *= 1.0 - (a + b / k as f64) / k as f64;
        last
    }));
    Some(coefficients)
}

/// Where the first of the places has made terms too small to be seen: `e^(-4 · 10)`.
const LONG_GONE: usize = 10;
