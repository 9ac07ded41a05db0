//! How the impacts move with the slenderness, against Eq. 2 as it is printed and against the perturbation of it about Eq. 4 by quadrature.

use crate::common::{Flight, inside};
use closed_form::ClosedForm;
use contract::{Case, Horizon, Oracle};
use proptest::prelude::*;

fn case([epsilon, omega, eta]: [f64; 3], horizon: Horizon, count: usize) -> Case {
    let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
    case.with_max_impacts(count).unwrap().with_horizon(horizon).unwrap()
}

/// The shifts of each impact in powers of `μ`: of the time, the interval and the velocity.
fn shifts(case: &Case) -> Vec<[[f64; 3]; 3]> {
    let found = ClosedForm.slenderness_shifts(case).unwrap();
    found.iter().map(|of| [of.time, of.interval, of.velocity]).collect()
}

/// The impacts of Eq. 2 as printed, under threshold normalisation, by Runge and Kutta's method: time, interval, velocity.
fn printed_impacts(case: &Case, alpha: f64, count: usize) -> Vec<[f64; 3]> {
    let psi = (1.0 / case.amplitude()).asin();
    let acceleration = |sign: f64, time: f64, phi: f64| {
        let ground = case.amplitude() * alpha.tan() * (case.omega() * time + psi).sin();
        let angle = alpha * (sign - phi);
        -(angle.sin() + ground * angle.cos()) / alpha
    };
    let step = |sign: f64, time: f64, (phi, rate): (f64, f64), h: f64| {
        let k1 = (rate, acceleration(sign, time, phi));
        let k2 = (rate + 0.5 * h * k1.1, acceleration(sign, time + 0.5 * h, phi + 0.5 * h * k1.0));
        let k3 = (rate + 0.5 * h * k2.1, acceleration(sign, time + 0.5 * h, phi + 0.5 * h * k2.0));
        let k4 = (rate + h * k3.1, acceleration(sign, time + h, phi + h * k3.0));
        (
            phi + h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0),
            rate + h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1),
        )
    };
    let (h, mut sign, mut time, mut rate) = (2e-4, -1.0, 0.0, 0.0);
    let mut impacts = Vec::new();
    while impacts.len() < count {
        let (mut elapsed, mut state) = (0.0, (0.0, rate));
        loop {
            let next = step(sign, time + elapsed, state, h);
            if sign * next.0 < 0.0 && elapsed > 0.0 {
                break;
            }
            (elapsed, state) = (elapsed + h, next);
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            let above = sign * step(sign, time + elapsed, state, middle).0 > 0.0;
            if above { low = middle } else { high = middle }
        }
        let (_, landing) = step(sign, time + elapsed, state, low);
        let interval = elapsed + low;
        (time, rate, sign) = (time + interval, case.eta() * landing, -sign);
        impacts.push([time, interval, rate]);
    }
    impacts
}

/// Three powers of `μ` are right if what is left of Eq. 2 falls as `μ⁴`, `α⁸`: flights from 0.5 to 2.8 long, in one stretch and in several.
#[test]
fn three_powers_of_the_slenderness_leave_an_error_of_the_eighth_power_of_alpha() {
    for (parameters, count) in [([0.4, 2.0, 0.5], 4), ([1.2, 3.0, 0.8], 4), ([0.2, 1.5, 0.7], 3)] {
        let case = case(parameters, Horizon::Until(12.0), count);
        let linear = ClosedForm.history(&case).unwrap().impacts;
        let shifts = shifts(&case);
        let left = |alpha: f64| -> Vec<[f64; 3]> {
            let mu = 2.0 * (1.0 / alpha.cos() - 1.0);
            let printed = printed_impacts(&case, alpha, count);
            let each = printed.iter().zip(&linear).zip(&shifts).map(|((impact, linear), of)| {
                let [time, interval, velocity] = of.map(|[one, two, three]| mu * (one + mu * (two + mu * three)));
                [
                    impact[0] - linear.time - time,
                    impact[1] / linear.interval - 1.0 - interval,
                    impact[2] * alpha / (alpha.sin() * linear.velocity) - 1.0 - velocity,
                ]
            });
            each.collect()
        };
        let (large, small) = (left(0.2), left(0.1));
        assert_eq!(small.len(), count);
        for (n, (large, small)) in large.iter().zip(&small).enumerate() {
            for (large, small) in large.iter().zip(small) {
                // 2⁸ but for the powers after it; a coefficient that is wrong by 1e-5 leaves 2⁶ or less.
                let falls = small.abs() <= large.abs() / 120.0 + 3e-12;
                assert!(falls, "{parameters:?}, impact {}: {large:e} {small:e}", n + 1);
            }
        }
    }
}

/// The four terms of `g = w/2 + i f w - G w²/2 + w³/6`, `G = 1 + i f`.
fn source(u: f64, forcing: f64) -> [f64; 4] {
    [0.5 * u, forcing * u, -0.5 * (1.0 + forcing) * u * u, u * u * u / 6.0]
}

/// The first impact with `u₁'' = u₁ - g` solved by variation of constants (Simpson's rule on Eq. 6 as printed): the shifts of the interval and
/// of the velocity, with each term of `g` multiplied by its weight.
fn by_quadrature(case: &Case, interval: f64, weights: [f64; 4]) -> [f64; 2] {
    let flight = Flight::first(case);
    let psi = (1.0 / case.amplitude()).asin();
    let forcing = |s: f64| flight.sign * case.amplitude() * (case.omega() * s + psi).sin();
    let g = |s: f64| {
        let terms = source(flight.motion(s).0, forcing(s));
        terms.iter().zip(weights).map(|(term, weight)| term * weight).sum::<f64>()
    };
    let parts = 2000_u32;
    let h = interval / f64::from(parts);
    let integral = |kernel: fn(f64) -> f64| {
        let at = |s: f64| kernel(interval - s) * g(s);
        let inner = (1..).zip(inside(interval, parts)).map(|(k, s)| if k % 2 == 1 { 4.0 * at(s) } else { 2.0 * at(s) });
        h / 3.0 * (at(0.0) + inner.sum::<f64>() + at(interval))
    };
    let (rotation, velocity) = (-integral(f64::sinh), -integral(f64::cosh));
    let (_, landing) = flight.motion(interval);
    let moved = -rotation / landing;
    let acceleration = -1.0 - forcing(interval);
    [moved / interval, (velocity + acceleration * moved) / landing]
}

/// A term of the source that is left out, or has the wrong sign, is seen at the first impact.
#[test]
fn the_first_order_is_the_perturbation_of_eq_2_about_eq_4() {
    for parameters in [[0.4, 2.0, 0.5], [0.05, 0.7, 0.9], [1.2, 3.0, 0.8]] {
        let case = case(parameters, Horizon::Until(12.0), 1);
        let linear = ClosedForm.history(&case).unwrap().impacts[0];
        let [_, interval, velocity] = shifts(&case)[0];
        let off = |weights: [f64; 4]| {
            let [expected, landed] = by_quadrature(&case, linear.interval, weights);
            (interval[0] - expected).abs() / interval[0].abs() + (velocity[0] - landed).abs() / velocity[0].abs()
        };
        assert!(off([1.0; 4]) < 1e-9, "{parameters:?}: {:e}", off([1.0; 4]));
        for term in 0..4 {
            for factor in [0.0, -1.0] {
                let mut weights = [1.0; 4];
                weights[term] = factor;
                assert!(off(weights) > 1e-4, "{parameters:?}: term {term} times {factor}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// The times are sums of the intervals (Eq. 42), and so are their shifts, to every order.
    #[test]
    fn the_shift_of_a_time_is_the_sum_of_those_of_the_intervals(
        share in 0.02..1.5f64, omega in 0.5..8.0f64, eta in 0.5..0.95f64,
    ) {
        let case = case([share * 0.04 * eta, omega, eta], Horizon::HalfPeriod, 100);
        let impacts = ClosedForm.history(&case).unwrap().impacts;
        let (mut sum, mut size) = ([0.0_f64; 3], [0.0_f64; 3]);
        for (impact, [time, interval, _]) in impacts.iter().zip(shifts(&case)) {
            for power in 0..3 {
                sum[power] += impact.interval * interval[power];
                size[power] += (impact.interval * interval[power]).abs();
                prop_assert!((time[power] - sum[power]).abs() <= 1e-12 * size[power]);
            }
        }
    }
}

/// At the bottom of the range of a double the interval and the velocity of an impact still move by what all those before it do: the block is as
/// good as at rest, and `η` is all that acts on it.
#[test]
fn the_shifts_stay_accurate_however_deep_the_sequence_goes() {
    let case = case([0.03, 2.0, 0.8], Horizon::HalfPeriod, 2500);
    let impacts = ClosedForm.history(&case).unwrap().impacts;
    let shifts = shifts(&case);
    assert_eq!(impacts.len(), shifts.len());
    assert!(impacts.last().unwrap().velocity.abs() < 1e-200);
    let deep = impacts.iter().position(|impact| impact.interval < 1e-20).unwrap();
    for (n, later) in shifts.iter().enumerate().skip(deep) {
        for (one, other) in shifts[n - 2].iter().flatten().zip(later.iter().flatten()) {
            assert!((one - other).abs() <= 1e-13 * one.abs(), "impact {}: {one:e} {other:e}", n + 1);
        }
    }
}

#[test]
fn a_block_that_never_rocks_has_none_and_a_case_that_is_declined_has_no_answer() {
    let of = |epsilon: f64| ClosedForm.slenderness_shifts(&Case::from_epsilon(epsilon, 2.0, 0.8).unwrap());
    assert_eq!(of(0.0), Some(Vec::new()));
    assert_eq!(of(1e-70), None);
}
