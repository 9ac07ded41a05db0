//! The gap against linear blocks of other stiffness, asked for directly.

use super::*;
use crate::panel;
use contract::{Ending, Slenderness};

fn stepper() -> Box<dyn Oracle> {
    panel::default().swap_remove(0)
}

fn cases() -> (Case, Case) {
    let case = Case::from_epsilon(0.02, 2.0, 0.8).and_then(|case| case.with_max_impacts(60));
    let block = Slenderness::new(0.2, Normalisation::Threshold);
    match (case, block) {
        (Ok(case), Ok(block)) => (case, case.with_slenderness(block)),
        other => panic!("{other:?}"),
    }
}

fn observed(case: &Case) -> Observed {
    let Ok(history) = stepper().history(case) else { panic!("declined") };
    Observed::new(case, history)
}

/// `1 ± 1.1 α² (1/2 + a)`, in the time `τ sqrt(κ)`; the largest difference up to each impact.
#[test]
fn the_gap_is_what_a_stiffer_and_a_softer_block_do() {
    let (plain, case) = cases();
    let base = observed(&plain);
    let Ok(Some(gap)) = ModelGap::new(stepper().as_ref(), &case, &base) else { panic!("no gap") };
    assert_eq!(gap.velocity_scale, 0.2f64.sin() / 0.2);
    let others = [-1.0, 1.0].map(|sign| {
        let rate = f64::sqrt(1.0 + sign * 1.1 * 0.04 * 1.52);
        let scaled = Case::from_epsilon(0.02, 2.0 / rate, 0.8).and_then(|case| case.with_max_impacts(60));
        (observed(&scaled.unwrap_or(plain)), rate)
    });
    let mut largest = [0.0f64; 4];
    for n in 1..=60 {
        let at = |of: &Observed| of.history.impacts[n - 1];
        let ratio = |of: &Observed| if n < 3 { 0.0 } else { at(of).interval / of.history.impacts[n - 3].interval };
        let this = at(&base);
        for (other, rate) in &others {
            let relative = |found: f64, expected: f64| (found / expected - 1.0).abs();
            largest[0] = largest[0].max(relative(at(other).interval / rate, this.interval));
            largest[1] = largest[1].max(relative(at(other).velocity / rate, this.velocity));
            largest[2] = largest[2].max((at(other).time / rate - this.time).abs());
            largest[3] = if n < 3 { 0.0 } else { largest[3].max(relative(ratio(other), ratio(&base))) };
        }
        for (observable, expected) in Observable::OF_AN_IMPACT.into_iter().zip(largest) {
            let found = gap.at(observable, n);
            assert!((found - expected).abs() <= 1e-9 * expected, "impact {n}, {observable}: {found:e} {expected:e}");
        }
    }
    let close = |of: &Observed| of.chattering_time.map_or(f64::NAN, |time| time.value);
    let expected = others.iter().map(|(of, rate)| (close(of) / rate - close(&base)).abs()).fold(0.0, f64::max);
    for observable in [Observable::ChatteringTime, Observable::Ending] {
        assert!((gap.at(observable, 0) / expected - 1.0).abs() < 1e-9);
    }
    // Where the other block has no impact to compare with there is no bound.
    assert_eq!((gap.at(Observable::Interval, 0), gap.at(Observable::Interval, 61)), (f64::INFINITY, f64::INFINITY));
}

#[test]
fn what_the_other_block_does_not_do_is_not_bounded() {
    let (plain, case) = cases();
    let mut longer = observed(&plain);
    let last = longer.history.impacts[59];
    longer.history.impacts.push(last);
    let Ok(Some(gap)) = ModelGap::new(stepper().as_ref(), &case, &longer) else { panic!("no gap") };
    assert!(gap.at(Observable::ImpactTime, 60).is_finite());
    assert_eq!(gap.at(Observable::ImpactTime, 61), f64::INFINITY);
    assert_eq!(gap.at(Observable::IntervalRatio, 61), f64::INFINITY);
    // A block that is so slender that nothing of the linear stiffness is left.
    let Ok(thick) = Slenderness::new(1.0, Normalisation::Threshold) else { panic!("refused") };
    let Ok(Some(gap)) = ModelGap::new(stepper().as_ref(), &case.with_slenderness(thick), &observed(&plain)) else {
        panic!("no gap")
    };
    assert_eq!(
        (gap.at(Observable::Interval, 1), gap.at(Observable::ChatteringTime, 0)),
        (f64::INFINITY, f64::INFINITY)
    );
}

/// Models are compared under the threshold normalisation only, and the gap is computed by a linear oracle.
#[test]
fn there_is_no_gap_where_the_models_are_not_compared() {
    let (plain, case) = cases();
    let base = observed(&plain);
    let Ok(slender) = Slenderness::new(0.2, Normalisation::Slender) else { panic!("refused") };
    let gap = |oracle: &dyn Oracle, case: &Case| ModelGap::new(oracle, case, &base);
    assert_eq!(gap(stepper().as_ref(), &plain), Ok(None));
    assert_eq!(gap(stepper().as_ref(), &plain.with_slenderness(slender)), Ok(None));
    let Ok(mut nonlinear) = panel::select("taylor") else { panic!("no such oracle") };
    let nonlinear = nonlinear.swap_remove(0);
    assert_eq!(gap(nonlinear.as_ref(), &case), Ok(None));
}

/// A block of no stiffness has no time of its own; a horizon is one of time, and scales as such.
#[test]
fn the_time_of_another_stiffness() {
    let (plain, _) = cases();
    assert!(matches!(stiffened(stepper().as_ref(), &plain, 0.0), Ok(None)));
    assert!(matches!(stiffened(stepper().as_ref(), &plain, -1.0), Ok(None)));
    assert!(matches!(stiffened(stepper().as_ref(), &plain, 0.01), Ok(Some(_))));
    // Slow, as ever, and fast: the frequency scales with the time.
    for (epsilon, omega) in [(0.01, 0.2), (0.5, 2.0), (0.5, 40.0)] {
        let rocking = |rate: f64| {
            let case = Case::from_epsilon(epsilon, omega / rate, 0.8);
            let case = case.and_then(|case| case.with_horizon(Horizon::Until(rate * 6.0 / omega)));
            case.unwrap_or_else(|invalid| panic!("{invalid}"))
        };
        let Ok(Some(other)) = stiffened(stepper().as_ref(), &rocking(1.0), 2.25) else { panic!("declined") };
        assert_eq!(other.rate, 1.5);
        // The same case by hand: ω/1.5 to 1.5 times the time.
        let expected = observed(&rocking(1.5));
        assert_eq!(other.observed, expected);
        assert_ne!(expected.history.ending, Ending::AtRest);
        assert_eq!(
            other.at(Observable::ImpactTime, 1),
            expected.at(Observable::ImpactTime, 1).map(|at| at.value / 1.5)
        );
        assert_eq!(other.chattering_time(), None);
    }
}
