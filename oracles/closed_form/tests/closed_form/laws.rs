//! What every history obeys, by properties of random cases.

use crate::common::{Flight, inside};
use approx::assert_relative_eq;
use closed_form::ClosedForm;
use contract::{Case, Ending, History, Horizon, Impact, Oracle};
use proptest::prelude::*;

fn history(case: &Case) -> History {
    ClosedForm.history(case).unwrap()
}

/// The flights of a history, each with how long it lasted: initiation first.
fn flights<'a>(case: &'a Case, impacts: &'a [Impact]) -> impl Iterator<Item = (Flight, &'a Impact)> {
    let starts = impacts.iter().map(|impact| Flight::new(case, impact.velocity.signum(), impact.time, impact.velocity));
    core::iter::once(Flight::first(case)).chain(starts).zip(impacts)
}

/// Cases of the paper's range, chattering completely or nearly so.
fn chattering() -> impl Strategy<Value = Case> {
    (-4.0..-1.5f64, 0.5..8.0f64, 0.5..0.95f64)
        .prop_map(|(exponent, omega, eta)| Case::from_amplitude(1.0 + 10f64.powf(exponent), omega, eta).unwrap())
}

/// Cases above the critical amplitude, followed for three periods: long flights and grazing ones.
fn rocking() -> impl Strategy<Value = Case> {
    (1.04..2.5f64, 0.3..8.0f64, 0.5..0.95f64).prop_map(|(a, omega, eta)| {
        let horizon = Horizon::Until(6.0 * core::f64::consts::PI / omega);
        Case::from_amplitude(a, omega, eta).unwrap().with_horizon(horizon).unwrap()
    })
}

/// Each flight that Eq. 6 can resolve in doubles stays above the base until the listed impact, returns to it there, and loses
/// speed as Eq. 13 says. What Eq. 6 itself rounds is of order 1e-16 and grows with `cosh s`.
fn each_flight_is_that_of_eq_6(case: &Case) {
    for (flight, impact) in flights(case, &history(case).impacts) {
        let s = impact.interval;
        if !(0.02..5.0).contains(&s) {
            continue;
        }
        let tolerance = 1e-14 * (1.0 + s.cosh());
        let (rotation, velocity) = flight.motion(s);
        assert!(rotation.abs() <= tolerance, "{case:?}: u = {rotation:e} at τ = {}", impact.time);
        for earlier in inside(s, 200) {
            let (rotation, _) = flight.motion(earlier);
            assert!(
                rotation > -tolerance,
                "{case:?}: u = {rotation:e}, {earlier} into the flight to τ = {}",
                impact.time
            );
        }
        // i_n changes at the impact, so φ' keeps its sign.
        assert_relative_eq!(
            impact.velocity,
            case.eta() * flight.sign * velocity,
            epsilon = 2.0 * tolerance,
            max_relative = 1e-13
        );
        assert!(impact.velocity * flight.sign < 0.0, "{case:?}: leaves to the side that it came from");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn chattering_flights_end_at_the_first_zero_of_eq_6_with_the_loss_of_eq_13(case in chattering()) {
        each_flight_is_that_of_eq_6(&case);
    }

    #[test]
    fn long_and_grazing_flights_end_at_the_first_zero_of_eq_6(case in rocking()) {
        each_flight_is_that_of_eq_6(&case);
    }

    #[test]
    fn impacts_follow_one_another_and_alternate(case in chattering()) {
        let History { impacts, .. } = history(&case);
        let mut previous = 0.0;
        for (n, impact) in impacts.iter().enumerate() {
            prop_assert!(impact.interval > 0.0);
            prop_assert!(impact.time >= previous);
            prop_assert!(n >= 20 || impact.time > previous);
            // i_0 = -1
            prop_assert_eq!(impact.velocity > 0.0, n % 2 == 0);
            // Sums of doubles: as many roundings as there are impacts, at the most.
            prop_assert!((impact.time - previous - impact.interval).abs() <= 2.0 * f64::EPSILON * impact.time);
            previous = impact.time;
        }
    }

    #[test]
    fn every_impact_of_complete_chattering_comes_later_at_a_larger_amplitude(case in chattering(), more in 1.001..1.2f64) {
        let larger = Case::from_epsilon(case.epsilon() * more, case.omega(), case.eta()).unwrap();
        for (impact, later) in history(&case).impacts.iter().zip(&history(&larger).impacts) {
            prop_assert!(later.time > impact.time);
        }
    }

    /// Without `u` on its right side Eq. 4 scales: `ωτ` is free of `ω`. With it the difference is of order `1/ω²`.
    #[test]
    fn a_fast_excitation_scales_time(epsilon in 1e-3..0.03f64, omega in 100.0..1e5f64, eta in 0.5..0.95f64) {
        let [one, other] = [omega, 2.0 * omega]
            .map(|omega| history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).impacts);
        for (one, other) in one.iter().zip(&other).take(20) {
            let tolerance = 10.0 / (omega * omega) + 1e-14;
            assert_relative_eq!(omega * one.time, 2.0 * omega * other.time, max_relative = tolerance);
        }
    }

    #[test]
    fn no_claim_is_smaller_than_a_rounding_or_as_large_as_the_value(case in chattering()) {
        for impact in history(&case).impacts {
            let claims = [impact.uncertainty.time / impact.time, impact.uncertainty.interval, impact.uncertainty.velocity];
            prop_assert!(claims.iter().all(|claim| (0.5 * f64::EPSILON..1e-6).contains(claim)), "{:?}", claims);
        }
    }
}

#[test]
fn intervals_are_resolved_down_to_1e_150_with_the_ratio_eta_squared() {
    for (epsilon, omega, eta) in [(0.01, 2.0, 0.9f64), (0.005, 6.0, 0.7), (1e-3, 0.5, 0.85), (0.02, 1.0, 0.5)] {
        let impacts = (1e-155f64.ln() / eta.ln()) as usize;
        let case = Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(impacts).unwrap();
        let History { impacts, ending, .. } = history(&case);
        assert_eq!(ending, Ending::AtRest);
        assert!(impacts.last().unwrap().interval < 1e-150);
        for pair in impacts.windows(3).filter(|three| three[0].interval < 1e-20) {
            assert_relative_eq!(pair[2].interval / pair[0].interval, eta * eta, max_relative = 1e-12);
        }
        // The forcing has come to stand still: a flight lasts 2v/(1 + i f), so two of them in a row are as 1 + f to 1 - f.
        let [.., last, next] = &impacts[..] else { panic!("two impacts") };
        let f = case.amplitude() * (omega * next.time + (1.0 / case.amplitude()).asin()).sin();
        let pull = 1.0 + f * last.velocity.signum();
        assert_relative_eq!(next.interval, 2.0 * last.velocity.abs() / pull, max_relative = 1e-12);
    }
}

/// Thousands of impacts of rocking that forgets where it began: what the flights leave of errors no longer grows, and a time that is late is still a double.
#[test]
fn no_time_is_claimed_to_more_than_its_rounding() {
    for (epsilon, omega, eta, until) in [(1.0, 200.0, 0.9, 100.0), (0.3, 20.0, 0.9, 30.0), (1.0, 200.0, 0.99, 100.0)] {
        let case = Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(10_000).unwrap();
        let history = history(&case.with_horizon(Horizon::Until(until)).unwrap());
        assert!(history.impacts.len() > 150);
        for impact in &history.impacts {
            assert!(impact.uncertainty.time >= 0.5 * f64::EPSILON * impact.time, "{case:?}: {impact:?}");
        }
    }
}
