use twofloat::TwoFloat;

use super::power::Power;
use crate::linear::solve;
use crate::number::{Number, real};
use crate::series::Series;

/// `H` as a sum of powers `(1 - ε/ε_c)^s` and of a series that is left.
#[derive(Debug, Clone)]
pub(super) struct Sum {
    /// `ε_c`.
    pub(super) critical: TwoFloat,
    /// In powers of `ε/ε_c`.
    left: Vec<f64>,
    powers: Vec<Power>,
    /// One for each part of each power.
    factors: Vec<f64>,
}

impl Sum {
    /// With the `ε_c` at which it vanishes, near `guess`; `None` if none is found.
    pub(super) fn new(series: &Series<TwoFloat>, powers: &[Power], guess: f64) -> Option<Self> {
        let at_zero = |critical| value_at_critical(series, powers, critical);
        let mut earlier = real::<TwoFloat>(guess);
        let mut critical = real::<TwoFloat>(guess * (1.0 + 1e-4));
        let mut value = at_zero(earlier)?;
        // Secants.
        for _ in 0..MOST_SECANTS {
            let next = at_zero(critical)?;
            let step = (next * (critical - earlier)).over(next - value);
            (earlier, value) = (critical, next);
            if !step.rounded().is_finite() {
                return None;
            }
            critical -= step;
            if step.rounded().abs() < 1e-20 * critical.rounded().abs() {
                break;
            }
        }
        let near = 0.5 * guess..2.0 * guess;
        if !near.contains(&critical.rounded()) {
            return None;
        }
        let (left, factors) = split(series, powers, critical)?;
        let rounded = |numbers: Vec<TwoFloat>| numbers.into_iter().map(Number::rounded).collect();
        Some(Self { critical, left: rounded(left), powers: powers.to_vec(), factors: rounded(factors) })
    }

    /// The value at `epsilon`, below `ε_c`.
    pub(super) fn at(&self, epsilon: f64) -> f64 {
        // One subtraction of nearly equal numbers, with the rounding of ε_c made good.
        let to_go = (self.critical.hi() - epsilon + self.critical.lo()) / self.critical.hi();
        let x = 1.0 - to_go;
        let regular = self.left.iter().rev().fold(0.0, |sum, term| sum * x + term);
        let logarithm = to_go.ln();
        let parts = self.powers.iter().flat_map(|power| power.values(logarithm));
        let singular = self.factors.iter().zip(parts).map(|(factor, part)| factor * part);
        regular + singular.sum::<f64>()
    }
}

/// What it is at `ε_c`, where all the powers vanish.
pub(super) fn value_at_critical(series: &Series<TwoFloat>, powers: &[Power], critical: TwoFloat) -> Option<TwoFloat> {
    let (left, _) = split(series, powers, critical)?;
    Some(left.into_iter().fold(real(0.0), |sum, term| sum + term))
}

const MOST_SECANTS: usize = 50;

/// The factors of the powers, such that they make up the last coefficients of the series exactly; and the coefficients that they leave, in powers
/// of `ε/ε_c`.
fn split(series: &Series<TwoFloat>, powers: &[Power], critical: TwoFloat) -> Option<(Vec<TwoFloat>, Vec<TwoFloat>)> {
    let terms = series.terms();
    let scale = std::iter::successors(Some(real::<TwoFloat>(1.0)), |power| Some(*power * critical));
    let scaled: Vec<TwoFloat> = series.0.iter().zip(scale).map(|(&term, power)| term * power).collect();
    let columns: Vec<Vec<TwoFloat>> = powers.iter().flat_map(|power| power.columns(terms)).collect();
    let first = terms.checked_sub(columns.len())?;
    let rows = (first..terms).map(|k| {
        let row = columns.iter().chain(std::iter::once(&scaled)).map(|column| column.get(k).copied());
        row.collect::<Option<Vec<_>>>()
    });
    let factors = solve(rows.collect::<Option<Vec<_>>>()?)?;
    let left = scaled.iter().take(first).enumerate().map(|(k, &term)| {
        let model = columns.iter().zip(&factors).filter_map(|(column, &factor)| Some(*column.get(k)? * factor));
        model.fold(term, |left, part| left - part)
    });
    let left = left.collect();
    Some((left, factors))
}
