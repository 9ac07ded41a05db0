use contract::Estimate;
use twofloat::TwoFloat;

use super::{power::Power, power_of_what_is_left, sum::value_at_critical};
use crate::expansion::Expansion;
use crate::number::{Number, real};
use crate::singularity::precise_approach;

/// The exponent `β` of the approach to the critical amplitude, from the coefficients of the series and the critical amplitude; `None` where
/// they do not tell.
///
/// With the right `β` the function `H` of [`Resummed`](crate::Resummed), its tail summed as powers that belong to that `β`, vanishes at the critical
/// amplitude; with another one it does not. (The period of the factor that is periodic in the logarithm is taken as known; the closed formula for
/// `β` is not.)
pub fn exponent_of_coefficients(expansion: &Expansion, critical_epsilon: f64) -> Option<Estimate> {
    let (_, log_period) = precise_approach::<TwoFloat>(expansion.eta());
    let terms = expansion.coefficients().len();
    let found = |terms: usize, fewer: usize| exponent(expansion, critical_epsilon, log_period, terms, fewer);
    let value = found(terms, 0)?;
    let changes = [found(terms, 1)?, found(terms - terms / 8, 0)?].map(|other| (other - value).abs());
    Some(Estimate { value, uncertainty: SAFETY * changes.into_iter().fold(0.0, f64::max) })
}

/// The largest error met was 0.84 of the claim, so 3.4 times the difference (`diagnose`, `η = 0.95`).
const SAFETY: f64 = 4.0;
const MOST_SECANTS: usize = 30;

/// From the first `terms` coefficients, without the `fewer` weakest powers.
fn exponent(expansion: &Expansion, critical: f64, log_period: TwoFloat, terms: usize, fewer: usize) -> Option<f64> {
    let coefficients = expansion.precise().with_terms(terms);
    let left_at_critical = |exponent: f64| -> Option<f64> {
        let exponent = real::<TwoFloat>(exponent);
        let powers = Power::all(exponent, log_period, expansion.eta());
        let series = power_of_what_is_left(&coefficients, exponent);
        Some(value_at_critical(&series, powers.get(fewer..)?, real(critical))?.rounded())
    };
    let (mut earlier, mut value) = (0.6, 0.61);
    let mut left = left_at_critical(earlier)?;
    for _ in 0..MOST_SECANTS {
        let next = left_at_critical(value)?;
        let step = next * (value - earlier) / (next - left);
        (earlier, left) = (value, next);
        if step.is_nan() || step.abs() > 0.2 {
            return None;
        }
        value -= step;
        if step.abs() < 1e-10 {
            break;
        }
    }
    (0.3..0.9).contains(&value).then_some(value)
}
