//! Other ways to sum the series near the critical amplitude, kept so that the choice of [`Resummed`](crate::Resummed) can be measured again.

use std::f64::consts::PI;

use twofloat::TwoFloat;

use super::power_of_what_is_left;
use crate::expansion::Expansion;
use crate::linear::solve;
use crate::number::{Number, real};
use crate::series::Series;
use crate::singularity::precise_approach;

/// A way to sum the series that knows less of its singularity than [`Resummed`](crate::Resummed).
#[derive(Debug, Clone)]
pub struct Alternative {
    omega: f64,
    exponent: f64,
    way: Way,
}

#[derive(Debug, Clone)]
enum Way {
    /// `ε` in powers of `z = (ω τ_ch)²`.
    Reverted(Vec<f64>),
    /// `H` in powers of `ε/ε_c`, cut off, with what `ε_c` is to within a few per cent to keep the numbers in range.
    Truncated(Vec<f64>, f64),
    /// `H` as a quotient of polynomials of `ε/ε_c`.
    Pade(Vec<f64>, Vec<f64>, f64),
}

impl Alternative {
    /// The reverted series: `ε` as a power series in `(ω τ_ch)²`, solved for it.
    ///
    /// At the critical amplitude, `ω τ_ch = π`, that has only the weak singularity `(π - ω τ_ch)^(1/β)`; but where the original series has a
    /// critical point off the real axis, for small `η` or `ω`, it has a singularity that may be nearer.
    pub fn reverted(expansion: &Expansion) -> Self {
        let coefficients = expansion.precise();
        let terms = coefficients.terms();
        // z = ε G(ε), and by Lagrange [z^k] ε = [ε^(k-1)] G^-k / k.
        let one = Series::constant(real(1.0), terms);
        let inverse = one.over(&coefficients.times(coefficients));
        let powers = std::iter::successors(Some(inverse.clone()), |power| Some(power.times(&inverse)));
        let reverted = (1..=terms).zip(powers).filter_map(|(k, power)| {
            let coefficient = power.0.get(k - 1)?.over(real(k as f64));
            // In powers of z/π².
            Some(coefficient.rounded() * PI.powi(2 * i32::try_from(k).ok()?))
        });
        Self::of(expansion, Way::Reverted(reverted.collect()))
    }

    /// The function `H` that [`Resummed`](crate::Resummed) sums, but cut off.
    pub fn truncated(expansion: &Expansion) -> Self {
        let (series, scale) = scaled(expansion);
        Self::of(expansion, Way::Truncated(series.0.into_iter().map(Number::rounded).collect(), scale))
    }

    /// The Padé approximant of the same function with a numerator and a denominator of equal degree; `None` if there is none.
    pub fn pade(expansion: &Expansion) -> Option<Self> {
        let (series, scale) = scaled(expansion);
        let degree = (series.terms() - 1) / 2;
        let at = |k: usize| series.0.get(k).copied().unwrap_or(real(0.0));
        // The denominator makes the coefficients behind the numerator vanish: Σ_j q_j h_(k-j) = 0 for k = degree + 1 to 2 degree, q_0 = 1.
        let rows = (degree + 1..=2 * degree).map(|k| (1..=degree).map(|j| at(k - j)).chain([-at(k)]).collect());
        let denominator: Vec<TwoFloat> = std::iter::once(real(1.0)).chain(solve(rows.collect())?).collect();
        let numerator = (0..=degree).map(|k| {
            denominator.iter().take(k + 1).enumerate().fold(real(0.0), |sum: TwoFloat, (j, &q)| sum + q * at(k - j))
        });
        let rounded = |numbers: Vec<TwoFloat>| numbers.into_iter().map(Number::rounded).collect();
        Some(Self::of(expansion, Way::Pade(rounded(numerator.collect()), rounded(denominator), scale)))
    }

    fn of(expansion: &Expansion, way: Way) -> Self {
        Self { omega: expansion.omega(), exponent: precise_approach::<f64>(expansion.eta()).0, way }
    }

    /// The chattering time at `epsilon`; `None` where this way gives none below `T/2`.
    pub fn chattering_time(&self, epsilon: f64) -> Option<f64> {
        let from_h = |h: f64| (h > 0.0 && h < 1.0).then(|| (1.0 - h.powf(self.exponent)).sqrt());
        let fraction = match &self.way {
            Way::Reverted(coefficients) => root(coefficients, epsilon)?.sqrt(),
            Way::Truncated(coefficients, scale) => from_h(polynomial(coefficients, epsilon / scale))?,
            Way::Pade(above, below, scale) => {
                from_h(polynomial(above, epsilon / scale) / polynomial(below, epsilon / scale))?
            }
        };
        Some(fraction * PI / self.omega)
    }
}

/// `H` in powers of `ε` over the returned scale, near `ε_c`.
fn scaled(expansion: &Expansion) -> (Series<TwoFloat>, f64) {
    let (exponent, _) = precise_approach::<TwoFloat>(expansion.eta());
    let series = power_of_what_is_left(expansion.precise(), exponent);
    let last = crate::singularity::ratios(expansion.coefficients(), exponent.rounded());
    let scale = last.last().map_or(1.0, |ratio| ratio.biased);
    let powers = std::iter::successors(Some(real::<TwoFloat>(1.0)), |power| Some(*power * scale));
    (Series(series.0.iter().zip(powers).map(|(&term, power)| term * power).collect()), scale)
}

fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// The `x` in (0, 1) at which `Σ c_k x^k`, `k` from 1, first is `value`: by bisection after steps that bracket it.
fn root(coefficients: &[f64], value: f64) -> Option<f64> {
    const STEPS: u32 = 200;
    let at = |x: f64| x * polynomial(coefficients, x);
    let place = |k: u32| f64::from(k) / f64::from(STEPS);
    let first = (1..=STEPS).find(|&k| at(place(k)) >= value)?;
    let (mut low, mut high) = (place(first - 1), place(first));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle) < value { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half way to `a_cr` all of them are the series that they were made from; the more of it, the better.
    #[test]
    fn well_below_the_critical_amplitude_every_way_is_the_series() {
        let critical = 0.038_015_5;
        let truth = Expansion::new(2.0, 0.92, 60, 0).unwrap();
        let ways: [fn(&Expansion) -> Option<Alternative>; 3] = [
            |expansion| Some(Alternative::reverted(expansion)),
            |expansion| Some(Alternative::truncated(expansion)),
            Alternative::pade,
        ];
        for (name, way) in ["reverted", "truncated", "pade"].into_iter().zip(ways) {
            for (terms, worst, best) in [(8, 1e-4, 2e-7), (20, 1e-8, 1e-12)] {
                let way = way(&Expansion::new(2.0, 0.92, terms, 0).unwrap()).unwrap();
                let error = |share: f64| {
                    let epsilon = share * critical;
                    let expected = truth.chattering_time(50, epsilon).unwrap().value;
                    (way.chattering_time(epsilon).unwrap() / expected - 1.0).abs()
                };
                println!("{name} {terms}: {:e} {:e}", error(0.25), error(0.5));
                assert!(error(0.5) < worst && error(0.25) < best, "{name} of {terms} terms");
            }
        }
    }

    #[test]
    fn the_first_root_is_found_in_the_cell_that_brackets_it() {
        for value in [1e-3, 0.3, 0.5012, 0.9999] {
            assert!((root(&[1.0], value).unwrap() - value).abs() < 1e-15);
            assert!((root(&[0.0, 1.0], value).unwrap() - f64::sqrt(value)).abs() < 1e-15);
        }
        // 4x (1 - x) is 0.64 at 0.2 and at 0.8, and never 2.
        assert!((root(&[4.0, -4.0], 0.64).unwrap() - 0.2).abs() < 1e-14);
        assert_eq!(root(&[4.0, -4.0], 2.0), None);
    }
}
