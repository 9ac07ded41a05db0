//! The derivatives of every impact against differences of two histories.

use closed_form::ClosedForm;
use contract::{Case, Horizon, Oracle};
use proptest::prelude::*;

type Parameters = [f64; 3];

/// The time, interval and velocity of each impact, or nothing that can be compared.
fn impacts(parameters: Parameters, horizon: Horizon, count: usize) -> Vec<[f64; 3]> {
    let case = case(parameters, horizon, count);
    let history = ClosedForm.history(&case).unwrap();
    history.impacts.iter().map(|impact| [impact.time, impact.interval, impact.velocity]).collect()
}

fn case([epsilon, omega, eta]: Parameters, horizon: Horizon, count: usize) -> Case {
    let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
    case.with_max_impacts(count).unwrap().with_horizon(horizon).unwrap()
}

/// Two points on each side leave an error of order `h⁴` and of `1e-16/h`, both magnified where the case is ill-conditioned: such differences
/// are told by another with half the step, and left out. The number of those that were compared.
fn the_derivatives_are_the_differences(parameters: Parameters, horizon: Horizon, count: usize) -> usize {
    let asked = case(parameters, horizon, count);
    let found = ClosedForm.sensitivities(&asked).unwrap();
    let base = impacts(parameters, horizon, count);
    assert_eq!(found.len(), base.len());
    let mut compared = 0;
    for parameter in 0..3 {
        let unit = if parameter == 2 { 1.0 - parameters[2] } else { parameters[parameter] };
        let moved = |steps: f64, step: f64| {
            let mut moved = parameters;
            moved[parameter] += steps * step * unit;
            impacts(moved, horizon, count)
        };
        let differences = [1e-4, 5e-5].map(|step| [-2.0, -1.0, 1.0, 2.0].map(|steps| (moved(steps, step), step)));
        for (n, of) in found.iter().enumerate() {
            for (place, by) in [of.time, of.interval, of.velocity].map(|by| by[parameter]).into_iter().enumerate() {
                let quotient = |[a, b, c, d]: &[(Vec<[f64; 3]>, f64); 4]| {
                    let at = |list: &[[f64; 3]]| list.get(n).map_or(f64::NAN, |impact| impact[place]);
                    (at(&a.0) - 8.0 * at(&b.0) + 8.0 * at(&c.0) - at(&d.0)) / (12.0 * a.1 * unit)
                };
                let [coarse, fine] = [0, 1].map(|index| quotient(&differences[index]));
                let scale = base[n][place].abs() / unit + fine.abs();
                if (coarse - fine).abs() <= 1e-9 * scale {
                    compared += 1;
                    assert!(
                        (by - fine).abs() <= 1e-8 * scale,
                        "{parameters:?}, impact {}, observable {place} by parameter {parameter}: {by:e}, not {fine:e}",
                        n + 1
                    );
                }
            }
        }
    }
    compared
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn complete_chattering(epsilon in 1e-3..0.02f64, omega in 0.5..8.0f64, eta in 0.5..0.9f64) {
        let compared = the_derivatives_are_the_differences([epsilon, omega, eta], Horizon::HalfPeriod, 40);
        prop_assert!(compared > 150, "{compared} of 360");
    }
}

/// A block that loses most of its speed, whose intervals soon are a trillionth of the first.
#[test]
fn strongly_damped_chattering() {
    for (epsilon, omega, eta) in [(0.01, 2.0, 0.45), (0.05, 1.0, 0.3), (0.002, 6.0, 0.1), (0.02, 3.0, 0.02)] {
        let compared = the_derivatives_are_the_differences([epsilon, omega, eta], Horizon::HalfPeriod, 10);
        assert!(compared > 60, "eta = {eta}: {compared} of 90");
    }
}

/// Flights longer than the series reach at once, which are followed in stretches.
#[test]
fn long_flights() {
    for (epsilon, omega, eta) in
        [(0.4, 2.0, 0.5), (0.4, 4.0, 0.7), (1.2, 3.0, 0.8), (0.2, 1.5, 0.7), (1.5, 3.0, 0.9), (0.2, 3.0, 0.9)]
    {
        let horizon = 6.0 * core::f64::consts::PI / omega;
        let flights = impacts([epsilon, omega, eta], Horizon::Until(horizon), 6);
        let reach = 2.0 / omega;
        assert!(flights.iter().any(|[_, interval, _]| *interval > 1.5 * reach), "{omega}: {flights:?}");
        let compared = the_derivatives_are_the_differences([epsilon, omega, eta], Horizon::Until(horizon), 6);
        assert!(compared >= 27, "{omega}: {compared}");
    }
}

/// With the block at rest in the limit, the velocity is `η` times what it was at each impact, whatever else the case is.
#[test]
fn deep_in_the_sequence_only_the_restitution_counts() {
    let parameters = [0.01, 2.0, 0.8];
    let found = ClosedForm.sensitivities(&case(parameters, Horizon::HalfPeriod, 400)).unwrap();
    let base = impacts(parameters, Horizon::HalfPeriod, 400);
    let relative = |n: usize, parameter: usize| found[n].velocity[parameter] / base[n][2];
    for (parameter, expected) in [(0, 0.0), (1, 0.0), (2, 100.0 / 0.8)] {
        let change = relative(399, parameter) - relative(299, parameter);
        assert!((change - expected).abs() < 1e-9, "parameter {parameter}: {change:e}");
    }
}

#[test]
fn a_block_that_never_rocks_has_none_and_a_case_that_is_declined_has_no_answer() {
    let of = |epsilon: f64| ClosedForm.sensitivities(&Case::from_epsilon(epsilon, 2.0, 0.8).unwrap());
    assert_eq!(of(0.0), Some(Vec::new()));
    assert_eq!(of(-0.5), Some(Vec::new()));
    assert_eq!(of(1e-70), None);
}
