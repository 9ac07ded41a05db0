//! Why a history ends, and which cases are declined.

use crate::common::{Flight, inside};
use closed_form::ClosedForm;
use contract::{Case, Decline, Ending, History, Horizon, Limit, Oracle};
use core::f64::consts::PI;
use proptest::prelude::*;

fn history(case: &Case) -> History {
    ClosedForm.history(case).unwrap()
}

fn until(a: f64, omega: f64, eta: f64, time: f64) -> Case {
    Case::from_amplitude(a, omega, eta).unwrap().with_horizon(Horizon::Until(time)).unwrap()
}

#[test]
fn a_block_at_or_below_the_threshold_never_rocks() {
    for a in [0.0, 0.5, 1.0] {
        let history = history(&Case::from_amplitude(a, 2.0, 0.9).unwrap());
        assert_eq!((history.impacts.len(), history.ending), (0, Ending::NeverRocks));
    }
}

#[test]
fn a_case_out_of_range_is_declined_by_the_name_of_its_field() {
    for (epsilon, omega, eta, expected) in
        [(1e-70, 2.0, 0.9, "epsilon"), (0.01, 1e-7, 0.9, "omega"), (0.01, 1e7, 0.9, "omega"), (0.01, 2.0, 1e-7, "eta")]
    {
        let declined = ClosedForm.history(&Case::from_epsilon(epsilon, omega, eta).unwrap());
        let Err(Decline::OutOfRange { field, .. }) = declined else { panic!("{declined:?}") };
        assert_eq!(field, expected);
    }
}

#[test]
fn the_endings_on_either_side_of_the_critical_amplitude() {
    // a_cr = 1.0380155387 at ω = 2, η = 0.92 (docs: theory, section 5)
    let ending = |a: f64, impacts: usize| {
        history(&Case::from_amplitude(a, 2.0, 0.92).unwrap().with_max_impacts(impacts).unwrap()).ending
    };
    assert_eq!(ending(1.0380, 1000), Ending::AtRest);
    assert_eq!(ending(1.0381, 1000), Ending::Incomplete);
    assert_eq!(ending(1.0380, 5), Ending::LimitReached(Limit::Impacts));
}

/// The flight after the first impact leads to overturning, but not yet at 2.9.
#[test]
fn what_has_not_overturned_when_the_time_is_up_is_not_reported_as_overturned() {
    let of = |time: f64| {
        let History { impacts, ending, .. } = history(&until(1.2, 1.0, 0.7, time));
        (impacts.len(), ending)
    };
    assert_eq!(of(2.9), (1, Ending::LimitReached(Limit::Time)));
    assert_eq!(of(30.0), (1, Ending::Overturned));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_horizon_cuts_the_history_and_changes_nothing_before(
        a in 1.001..1.5f64, omega in 0.5..8.0f64, eta in 0.5..0.95f64, share in 0.1..1.0f64,
    ) {
        let time = share * PI / omega;
        let whole = history(&until(a, omega, eta, 2.0 * PI / omega));
        let cut = history(&until(a, omega, eta, time));
        prop_assert_eq!(&cut.impacts[..], &whole.impacts[..cut.impacts.len()]);
        prop_assert!(cut.impacts.iter().all(|impact| impact.time < time));
        if cut.ending == Ending::LimitReached(Limit::Time) {
            prop_assert!(whole.impacts.get(cut.impacts.len()).is_none_or(|next| next.time >= time));
        } else {
            prop_assert_eq!(cut.ending, whole.ending);
        }
    }

    /// By Eq. 6 the flight after the last impact stays in the air for 20 time constants and is far away, and receding, then.
    #[test]
    fn a_block_reported_overturned_does_not_come_back(a in 1.1..6.0f64, omega in 0.2..3.0f64, eta in 0.5..0.95f64) {
        let case = until(a, omega, eta, 8.0 * PI / omega);
        let History { impacts, ending, .. } = history(&case);
        prop_assume!(ending == Ending::Overturned);
        let flight = impacts.last().map_or_else(
            || Flight::first(&case),
            |impact| Flight::new(&case, impact.velocity.signum(), impact.time, impact.velocity),
        );
        prop_assert!(inside(20.0, 4000).all(|s| flight.motion(s).0 > -1e-12 ));
        let (rotation, velocity) = flight.motion(20.0);
        prop_assert!(rotation > 10.0 && velocity > 0.0, "u = {rotation}, u' = {velocity}");
    }

    /// The other way round: where no overturning is reported, the block is within reach of the base at the horizon.
    #[test]
    fn a_block_that_overturns_is_reported(a in 3.0..6.0f64, eta in 0.5..0.95f64) {
        // ω = 0.3 at this amplitude is a push that no block withstands.
        let case = until(a, 0.3, eta, 100.0);
        prop_assert_eq!(history(&case).ending, Ending::Overturned);
    }
}

#[test]
fn it_answers_to_the_name_by_which_it_is_asked() {
    assert_eq!((ClosedForm.name(), ClosedForm.model()), ("closed-form", contract::Model::Linear));
}
