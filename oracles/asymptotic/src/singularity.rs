use crate::expansion::Coefficient;
use crate::number::{Number, real};

/// How `τ_ch` approaches `T/2` as the amplitude approaches the critical one: `1 - τ_ch/(T/2) ~ (a_cr - a)^β P(ln (a_cr - a))`, where `P` is a
/// periodic function.
///
/// Close to `T/2` the forcing leaves an acceleration on the odd flights that falls to zero linearly, while the even flights take no time: two
/// impacts act as one bounce with the restitution `η²`. With `x` the flight over the time left to `T/2`, the bounce that repeats itself in
/// ever smaller copies solves `(1-x)² (3-x) = η² (3-2x)`. A deviation from it grows by the factor `μ` each bounce, and the time left shrinks by
/// `1 - x`; hence `β = -ln(1-x)/ln μ`. Whatever else depends on the deviation repeats itself each time that grows by `μ`: the factor in
/// front of the power is periodic in its logarithm, with the period `ln μ`. At `η = 0.92` that hardly shows, at 0.5 it does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// `β`, 3/5 as `η` tends to 1.
    pub exponent: f64,
    /// `ln μ`.
    pub log_period: f64,
}

/// The approach to the critical amplitude for the restitution `eta` inside (0, 1).
pub fn approach(eta: f64) -> Approach {
    let (exponent, log_period) = precise_approach::<f64>(eta);
    Approach { exponent, log_period }
}

/// `β` and `ln μ`.
pub(crate) fn precise_approach<T: Number>(eta: f64) -> (T, T) {
    let x: T = repeating_flight(eta);
    let eta = real::<T>(eta);
    let [one, two, three] = [1.0, 2.0, 3.0].map(real::<T>);
    // With `u = x/2 - x²/6` the velocity before it over the square of the time left, `u' = η² (x/2 - x²/3)/(1-x)²` is the next one.
    let slope = one.over(two) - x.over(three);
    let left = one - x;
    let velocity = x.over(two) - (x * x).over(three);
    let velocity_by = one.over(two) - (two * x).over(three);
    let next_by = (eta * eta * (velocity_by + (two * velocity).over(left))).over(left * left);
    let log_period = next_by.over(slope).logarithm();
    (-left.logarithm().over(log_period), log_period)
}

/// The root of `(1-x)² (3-x) = η² (3-2x)` in (0, 1): the left side falls faster.
fn repeating_flight<T: Number>(eta: f64) -> T {
    // With 1 - η² kept from cancelling: (1-x)²(3-x) - η²(3-2x) = 3 (1-η²) - x (7 - 2η²) + 5 x² - x³.
    let eta = real::<T>(eta);
    let [one, two, three, five, seven] = [1.0, 2.0, 3.0, 5.0, 7.0].map(real::<T>);
    let (constant, linear) = (three * (one - eta) * (one + eta), seven - two * eta * eta);
    // Newton's method from 0 rises to the root without passing it, because the function falls and is convex there.
    let mut x = T::zero();
    for _ in 0..MOST_STEPS {
        let value = constant - x * (linear - x * (five - x));
        let next = x + value.over(linear - x * (two * five - three * x));
        if next <= x {
            break;
        }
        x = next;
    }
    x
}

/// Far more than the convergence takes.
const MOST_STEPS: usize = 200;

/// What two neighbouring coefficients say of the critical amplitude (Domb and Sykes).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratio {
    /// The order of the later one.
    pub k: usize,
    /// `c_k/c_(k-1)`, which tends to `1/(a_cr - 1)`.
    pub ratio: f64,
    /// `a_cr - 1` if the singularity were `(a_cr - a)^β` and nothing else.
    pub biased: f64,
}

/// The ratios of successive coefficients, with the exponent that they tend to.
///
/// `(1 - ε/ε_c)^β` has coefficients whose ratio is `(k - 1 - β)/(k ε_c)`.
pub fn ratios(coefficients: &[Coefficient], exponent: f64) -> Vec<Ratio> {
    let pairs = (1..).zip(coefficients.windows(2));
    pairs
        .filter_map(|(k, two)| match two {
            [early, late] => {
                let ratio = late.value / early.value;
                Some(Ratio { k, ratio, biased: (k as f64 - 1.0 - exponent) / (k as f64 * ratio) })
            }
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use twofloat::TwoFloat;

    use super::*;

    /// The bounce itself: the velocity before it over the square of the time left, and the next one, for a flight `x` of the time left.
    fn before_and_after(eta: f64, x: f64) -> (f64, f64) {
        (x / 2.0 - x * x / 6.0, eta * eta * (x / 2.0 - x * x / 3.0) / (1.0 - x).powi(2))
    }

    #[test]
    fn the_exponent_is_that_of_the_bounce_and_its_growing_deviation() {
        for eta in [1e-3, 0.1, 0.5, 0.92, 0.999] {
            let x: f64 = repeating_flight(eta);
            let (before, after) = before_and_after(eta, x);
            assert!(x > 0.0 && x < 1.0 && (after / before - 1.0).abs() < 1e-9, "{eta}: {x}");
            // Central differences.
            let h = 1e-5 * (1.0 - x).min(x);
            let ((b0, a0), (b1, a1)) = (before_and_after(eta, x - h), before_and_after(eta, x + h));
            let growth = (a1 - a0) / (b1 - b0);
            let found = approach(eta);
            assert!((found.log_period / growth.ln() - 1.0).abs() < 1e-7, "{eta}: {found:?}");
            assert!((found.exponent / (-(1.0 - x).ln() / growth.ln()) - 1.0).abs() < 1e-7, "{eta}: {found:?}");
            let (exponent, log_period) = precise_approach::<TwoFloat>(eta);
            let digits = 1e-14 / (x * (1.0 - x).powi(2));
            assert!((exponent.rounded() / found.exponent - 1.0).abs() < digits, "{eta}: {exponent} {found:?}");
            assert!((log_period.rounded() / found.log_period - 1.0).abs() < digits, "{eta}: {log_period} {found:?}");
        }
        assert!((approach(1.0 - 1e-9).exponent - 0.6).abs() < 1e-7);
    }

    /// The root is that of `(1-x)² (3-x) = η² (3-2x)` to the last digits of two doubles, also where it is small.
    #[test]
    fn the_flight_that_repeats_itself_is_found_to_all_digits() {
        for eta in [0.01, 0.5, 0.92, 1.0 - 1e-12] {
            let x: TwoFloat = repeating_flight(eta);
            let [one, two, three] = [1.0, 2.0, 3.0].map(real::<TwoFloat>);
            let square: TwoFloat = real::<TwoFloat>(eta) * eta;
            let residual: TwoFloat = (one - x) * (one - x) * (three - x) - square * (three - two * x);
            assert!(residual.hi().abs() < 1e-30, "{eta}: {residual}");
        }
    }

    #[test]
    fn the_ratios_of_a_pure_power_give_its_singularity() {
        let (exponent, critical) = (0.6, 0.04);
        let mut coefficients = vec![Coefficient { value: 2.0, error: 0.0 }];
        for k in 1..12 {
            let last = coefficients[coefficients.len() - 1].value;
            let value = last * (f64::from(k) - 1.0 - exponent) / (f64::from(k) * critical);
            coefficients.push(Coefficient { value, error: 0.0 });
        }
        let found = ratios(&coefficients, exponent);
        assert_eq!(found.iter().map(|ratio| ratio.k).collect::<Vec<_>>(), (1..12).collect::<Vec<_>>());
        for Ratio { k, ratio, biased } in found {
            assert!((biased / critical - 1.0).abs() < 1e-14, "{k}: {biased}");
            assert_eq!(ratio, coefficients[k].value / coefficients[k - 1].value);
        }
    }
}
