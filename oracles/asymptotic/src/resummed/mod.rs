use std::f64::consts::PI;

use contract::{Decline, Estimate};
use twofloat::TwoFloat;

mod alternatives;
mod exponent;
mod power;
mod sum;

pub use alternatives::Alternative;
pub use exponent::exponent_of_coefficients;
use power::Power;
use sum::Sum;

use crate::expansion::Expansion;
use crate::number::{Number, real};
use crate::series::Series;
use crate::singularity::{precise_approach, ratios};
use crate::truncated::BEYOND;

/// The series summed with what is known of its singularity, up to the critical amplitude.
///
/// The chattering time itself has a branch point at `ε_c = a_cr - 1`, `1 - τ_ch/(T/2) ~ (ε_c - ε)^β`, so that its series converges there like
/// `Σ k^-(1+β)`. The function `H = (1 - (τ_ch/(T/2))²)^(1/β)` has a simple zero instead, and behind it only the weaker powers
/// `(ε_c - ε)^s` with `s = 1 + jβ + l`, and `1 ± 2πi/ln μ` and so on from the factor that is periodic in the logarithm (see
/// [`Approach`](crate::Approach)). Its last coefficients tell how much there is of each. What they leave is summed as it stands. Where `H` vanishes is the
/// critical amplitude.
#[derive(Debug, Clone)]
pub struct Resummed {
    /// For the plain sum; without its impacts.
    expansion: Expansion,
    exponent: f64,
    best: Sum,
    /// Sums that know less, from which the error is estimated.
    poorer: Vec<Sum>,
}

/// How many terms of the series the resummation takes.
pub const RESUMMED_TERMS: usize = Expansion::MOST_TERMS;
/// Fewer terms have no tail to fit.
const FEWEST_TERMS: usize = 16;

impl Resummed {
    /// From the coefficients of the series.
    ///
    /// # Errors
    /// With fewer than 16 terms; where `omega` is below 0.5 or `eta` outside [0.5, 0.98], where its error was not calibrated (for a slow
    /// excitation the first flight alone becomes critical, which is another singularity); and where the tail of the coefficients is not that of
    /// such a singularity.
    pub fn new(expansion: &Expansion) -> Result<Self, Decline> {
        let terms = expansion.coefficients().len();
        for (field, value, least, most, allowed) in [
            ("omega", expansion.omega(), 0.5, f64::INFINITY, "0.5 to 1000 to be resummed"),
            ("eta", expansion.eta(), 0.5, 0.98, "0.5 to 0.98 to be resummed"),
        ] {
            if !(least..=most).contains(&value) {
                return Err(Decline::OutOfRange { field, value, allowed });
            }
        }
        if terms < FEWEST_TERMS {
            return Err(Decline::OutOfRange { field: "order", value: terms as f64, allowed: "16 or more to resum" });
        }
        let (exponent, log_period) = precise_approach::<TwoFloat>(expansion.eta());
        let series = power_of_what_is_left(expansion.precise(), exponent);
        let guess = ratios(expansion.coefficients(), exponent.rounded()).last().map_or(f64::NAN, |ratio| ratio.biased);
        let powers = Power::all(exponent, log_period, expansion.eta());
        let sum = |series: &Series<TwoFloat>, powers: &[Power]| {
            Sum::new(series, powers, guess).ok_or_else(|| Decline::NotConvergent {
                why: format!(
                    "the coefficients of the series at omega = {}, eta = {} do not end in a power law",
                    expansion.omega(),
                    expansion.eta()
                ),
            })
        };
        let fewer: Vec<Power> = powers.iter().copied().skip(1).collect();
        let shorter = series.with_terms(series.terms() - terms / 8);
        Ok(Self {
            expansion: expansion.shortened(terms),
            exponent: exponent.rounded(),
            best: sum(&series, &powers)?,
            poorer: vec![sum(&series, &fewer)?, sum(&shorter, &powers)?],
        })
    }

    /// `a_cr - 1`: where the chattering time reaches `T/2`.
    pub fn critical_epsilon(&self) -> Estimate {
        let value = self.best.critical.rounded();
        let changes = self.poorer.iter().map(|sum| (sum.critical.rounded() - value).abs());
        Estimate { value, uncertainty: SAFETY * changes.fold(0.0, f64::max) + 1e-15 * value }
    }

    /// The chattering time at `epsilon`, or `None` at and past the critical amplitude as far as the resummation knows it.
    ///
    /// Far from the critical amplitude, where nothing is left to be resummed and the plain sum rounds less, it is that: whichever claims less.
    pub fn chattering_time(&self, epsilon: f64) -> Option<Estimate> {
        let resummed = self.resummed(epsilon);
        if resummed.is_none() && epsilon > 0.5 * self.best.critical.rounded() {
            return None;
        }
        let order = self.expansion.coefficients().len() - BEYOND;
        let sums = resummed.into_iter().chain(self.expansion.chattering_time(order, epsilon));
        sums.min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty))
    }

    fn resummed(&self, epsilon: f64) -> Option<Estimate> {
        let best = self.best.at(epsilon);
        // Past the critical amplitude of one of the sums, where that is not a number, it is as if that were any distance away.
        let changes = self.poorer.iter().map(|sum| (sum.at(epsilon) - best).abs());
        let largest = changes.map(|change| if change.is_nan() { f64::INFINITY } else { change }).fold(0.0, f64::max);
        let uncertainty = SAFETY * largest + ROUNDING;
        // The negation takes NaN as well.
        if !(best > uncertainty && best < 1.0) {
            return None;
        }
        let half_period = PI / self.expansion.omega();
        // τ_ch/(T/2) = (1 - H^β)^(1/2)
        let fraction = |h: f64| (1.0 - h.min(1.0).powf(self.exponent)).sqrt();
        let value = fraction(best);
        let off = (fraction(best - uncertainty) - value).max(value - fraction(best + uncertainty));
        Some(Estimate { value: half_period * value, uncertainty: half_period * (off + f64::EPSILON * value) })
    }
}

/// The largest error met in random cases (`tests/asymptotic/resummed.rs`) was 0.6 of the claim, so 2.4 times the difference between the sums.
const SAFETY: f64 = 4.0;
/// Of `H`, which is 1 at `ε = 0`.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// `H = (1 - z/π²)^(1/β)` with `z = (ω τ_ch)² = ε (c₀ + c₁ ε + ...)²`.
fn power_of_what_is_left(coefficients: &Series<TwoFloat>, exponent: TwoFloat) -> Series<TwoFloat> {
    let pi = twofloat::consts::PI;
    let squared = coefficients.times(coefficients).with_terms(coefficients.terms() + 1).shifted();
    let one = Series::constant(real(1.0), squared.terms());
    one.minus(&squared.scaled(real::<TwoFloat>(1.0).over(pi * pi))).power(real::<TwoFloat>(1.0).over(exponent))
}

/// The coefficients of `H` times `ε_c^k k^(2+β)`, from `k = 1`: slowly varying, but for what is periodic in `ln k` with the period `ln μ`.
///
/// Of a singularity `(ε_c - ε)^(1+β)` the coefficients fall as `k^-(2+β)`, of one with the exponent `1 ± 2πi/ln μ` as `k^-2` times
/// `cos(2π ln k/ln μ)`: so this is where the periodic factor of the approach shows, though it is small in the chattering time itself.
pub fn scaled_tail(expansion: &Expansion, critical_epsilon: f64) -> Vec<f64> {
    let (exponent, _) = precise_approach::<TwoFloat>(expansion.eta());
    let series = power_of_what_is_left(expansion.precise(), exponent);
    let scale = |k: usize| (k as f64).powf(2.0 + exponent.rounded());
    let terms = series.0.iter().enumerate().skip(1);
    let power = |k: usize| (k as f64 * critical_epsilon.ln()).exp();
    terms.map(|(k, term)| term.rounded() * power(k) * scale(k)).collect()
}
