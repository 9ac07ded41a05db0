//! The condition in numbers that are exact.

use super::*;
use crate::panel;
use contract::{Ending, Estimate, History, Impact, Uncertainty};

fn case() -> Case {
    Case::from_epsilon(0.5, 2.0, 0.25).unwrap_or_else(|invalid| panic!("{invalid}"))
}

/// `|ε ∂x/∂ε| + |ω ∂x/∂ω| + |η ∂x/∂η|`, each with its own sign and size; what is lost bounds nothing.
#[test]
fn the_condition_is_the_sum_of_what_each_parameter_does() {
    assert_eq!(condition(&case(), [16.0, 0.0, 0.0]), 8.0);
    assert_eq!(condition(&case(), [0.0, -3.0, 0.0]), 6.0);
    assert_eq!(condition(&case(), [0.0, 0.0, 40.0]), 10.0);
    assert_eq!(condition(&case(), [-16.0, 3.0, -40.0]), 24.0);
    assert_eq!(condition(&case(), [f64::NAN, 0.0, 0.0]), f64::INFINITY);
}

/// Intervals and velocities relative, times absolute, and the ratio as the difference of two intervals.
#[test]
fn each_observable_has_the_condition_in_its_own_scale() {
    let impact = |interval: f64, velocity: f64| {
        let uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        Impact { time: 1.0, interval, velocity, uncertainty }
    };
    let impacts = vec![impact(0.5, 0.25), impact(0.25, -0.125), impact(0.125, 0.0625)];
    let history = History { impacts, ending: Ending::Incomplete, chattering_time: None };
    let observed = Observed { history, chattering_time: None };
    let of = |size: f64| Sensitivity { time: [size, 0.0, 0.0], interval: [0.0, size, 0.0], velocity: [0.0, 0.0, size] };
    let conditioning = Conditioning::new(&case(), &observed, &[of(1.0), of(2.0), of(3.0)]);
    let at = |observable: Observable| [1, 2, 3].map(|n| conditioning.at(observable, n));
    assert_eq!(at(Observable::ImpactTime), [0.5, 1.0, 1.5]);
    // ω times 1/0.5, 2/0.25, 3/0.125
    assert_eq!(at(Observable::Interval), [4.0, 16.0, 48.0]);
    // η times 1/0.25, 2/0.125, 3/0.0625
    assert_eq!(at(Observable::Velocity), [1.0, 4.0, 12.0]);
    // ω (3/0.125 - 1/0.5)
    assert_eq!(at(Observable::IntervalRatio), [0.0, 0.0, 44.0]);
    assert_eq!(conditioning.at(Observable::ChatteringTime, 0), 0.0);
    // Past the impacts that are known, that of the last; before the first likewise, for want of another.
    assert_eq!((conditioning.at(Observable::Interval, 4), conditioning.at(Observable::Interval, 0)), (48.0, 48.0));
    assert_eq!(Conditioning::default().at(Observable::Interval, 1), 0.0);
}

#[test]
fn differences_are_taken_by_each_parameter() {
    assert_eq!(difference(&[4.0, 6.0, 9.0], &[1.0, 2.0, 3.0]), [3.0, 4.0, 6.0]);
}

/// The chattering time has the condition of its closure, where it was closed.
#[test]
fn the_chattering_time_has_the_condition_of_its_closure() {
    let case = case();
    let stepper = panel::default().swap_remove(0);
    let Ok(mut history) = stepper.history(&Case::from_epsilon(0.01, 2.0, 0.25).unwrap_or(case)) else {
        panic!("declined")
    };
    history.impacts.truncate(12);
    let Some(mut of) = stepper.sensitivities(&case) else { panic!("no derivatives") };
    of.resize(12, Sensitivity { time: [1.0; 3], interval: [0.1; 3], velocity: [1.0; 3] });
    let closed = |chattering_time: Option<Estimate>| Observed { history: history.clone(), chattering_time };
    let some = Conditioning::new(&case, &closed(Some(Estimate { value: 1.0, uncertainty: 0.0 })), &of);
    let expected = zeno::sensitivity(&history, &of, 0.25).map(|by| condition(&case, by));
    assert_eq!(Some(some.at(Observable::ChatteringTime, 0)), expected);
    assert!(expected.is_some_and(|kappa| kappa > 0.0));
    assert_eq!(Conditioning::new(&case, &closed(None), &of).at(Observable::ChatteringTime, 0), 0.0);
}
