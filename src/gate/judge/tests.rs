//! How claims are counted, and which cases are asked.

use super::*;
use crate::panel;

fn stepper() -> Box<dyn Oracle> {
    panel::default().swap_remove(0)
}

fn case() -> Case {
    Case::from_epsilon(0.02, 2.0, 0.9).unwrap_or_else(|invalid| panic!("{invalid}"))
}

/// The figures after these claims, errors and widths of the enclosure.
fn figures(of: &[(f64, f64, f64)]) -> ClaimOverError {
    let mut calibration = Calibration::default();
    for (claim, error, unsure) in of {
        calibration.add(Observable::Interval, *claim, *error, *unsure);
    }
    calibration.figures()[&Observable::Interval]
}

/// A class is the sixteenth part of a factor of ten, and is named by its middle.
fn middle(ratio: f64) -> f64 {
    10f64.powf(((16.0 * ratio.log10()).floor() + 0.5) / 16.0)
}

#[test]
fn a_claim_is_counted_in_multiples_of_the_error_that_the_enclosure_can_tell() {
    for (claim, error, unsure, ratio) in [
        (6.0, 2.0, 0.0, 3.0),
        (1.0, 2.0, 0.0, 0.5),
        (6.0, 2.0, 8.0, 1.5), // half of 8 is more than 2
        (6.0, 2.0, 3.0, 3.0),
        (500.0, 1.0, 0.0, 500.0),
        (6.0, 0.0, 0.0, 1e30),
    ] {
        let found = figures(&[(claim, error, unsure)]);
        assert_eq!((found.numbers, found.smallest), (1, ratio), "{claim} {error} {unsure}");
        assert!((found.median / middle(ratio) - 1.0).abs() < 1e-12, "{} for {ratio}", found.median);
        assert!((found.median / ratio).log10().abs() <= 0.5 / 16.0 + 1e-12);
    }
    // What claims nothing, or is not a number, is the smallest of all, and of no class that has a size.
    for claim in [0.0, f64::NAN] {
        let found = figures(&[(claim, 1.0, 0.0), (2.0, 1.0, 0.0), (2.0, 1.0, 0.0)]);
        assert_eq!((found.numbers, found.smallest), (3, 0.0), "{claim}");
        assert!((found.median / middle(2.0) - 1.0).abs() < 1e-12);
        assert_eq!(figures(&[(claim, 1.0, 0.0)]).median, 0.0);
    }
}

/// Of an even number the lower of the two in the middle.
#[test]
fn the_median_has_half_of_the_numbers_below_it() {
    for (claims, median) in [
        (&[1.0, 10.0, 100.0][..], 10.0),
        (&[1.0, 10.0, 100.0, 1000.0], 10.0),
        (&[1.0, 1.0, 1.0, 100.0], 1.0),
        (&[5.0], 5.0),
    ] {
        let of: Vec<_> = claims.iter().map(|claim| (1.001 * claim, 1.0, 0.0)).collect();
        let found = figures(&of);
        assert!((found.median / middle(1.001 * median) - 1.0).abs() < 1e-12, "{claims:?}: {found:?}");
        assert_eq!(
            (found.numbers, found.smallest),
            (claims.len(), 1.001 * claims.iter().copied().fold(f64::INFINITY, f64::min))
        );
    }
}

#[test]
fn the_claims_of_several_cases_are_added_up() {
    let of = |claims: &[f64]| {
        let mut calibration = Calibration::default();
        claims.iter().for_each(|claim| calibration.add(Observable::Velocity, *claim, 1.0, 0.0));
        calibration
    };
    let mut sum = of(&[2.0, 30.0]);
    sum.add_all(of(&[1.5, 2.0, 400.0]));
    assert_eq!(sum.figures(), of(&[2.0, 30.0, 1.5, 2.0, 400.0]).figures());
    assert_eq!((sum.figures()[&Observable::Velocity].numbers, sum.figures()[&Observable::Velocity].smallest), (5, 1.5));
    let mut sum = of(&[1.5]);
    sum.add_all(of(&[2.0]));
    assert_eq!(sum.figures()[&Observable::Velocity].smallest, 1.5);
    let mut none = Calibration::default();
    none.add_all(of(&[1.5, 2.0]));
    assert_eq!(none, of(&[1.5, 2.0]));
}

#[test]
fn every_listed_case_and_every_so_many_others_are_asked() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let named = |generator: Generator| Named { name: String::new(), case: case(), generator };
    let asks = |judges: &Judges| {
        [Generator::List, Generator::Random].map(|of| [0, 1, 2, 3].map(|place| judges.asks(place, &named(of))))
    };
    let every = |every: usize| Judges { oracles: vec![oracle], every };
    assert_eq!(asks(&every(2)), [[true; 4], [true, false, true, false]]);
    assert_eq!(asks(&every(0)), [[true; 4], [true; 4]]);
    assert_eq!(asks(&Judges { oracles: Vec::new(), every: 1 }), [[false; 4]; 2]);
}

/// The judge is another method here, which serves to see what is put beside what.
#[test]
fn answers_are_judged_by_the_judge_of_their_model_and_only_where_they_are_wanted() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let case = case();
    let judges = Judges { oracles: vec![oracle], every: 1 };
    let answer = ask(oracle, &case);
    let mut wrong = answer.clone();
    if let crate::measure::asking::Reply::Observed(observed) = &mut wrong.reply {
        observed.history.impacts[4].velocity *= 1.001;
    }
    let mut other = answer.clone();
    other.model = contract::Model::Nonlinear;
    let answers = [answer, other, wrong];
    let found = judges.judge(&case, &answers, |_| true);
    assert_eq!(found.iter().map(|judgement| judgement.place).collect::<Vec<_>>(), [0, 2]);
    assert!(found.iter().all(|judgement| judgement.judge == "closed-form"));
    assert!(found[0].refuted.is_none());
    let refuted = found[1].refuted.as_ref().map(|refuted| (refuted.observable, refuted.figure.impact));
    assert_eq!(refuted, Some((Observable::Velocity, 5)));
    let places =
        |wanted: fn(usize) -> bool| judges.judge(&case, &answers, wanted).iter().map(|j| j.place).collect::<Vec<_>>();
    assert_eq!((places(|place| place == 2), places(|place| place != 2)), (vec![2], vec![0]));
    // Where the two are the same an error is half of the claim: every claim is twice it. Ratios are not judged.
    let figures = found[0].calibration.figures();
    let observables: Vec<_> = figures.keys().copied().collect();
    use Observable::{ChatteringTime, ImpactTime, Interval, Velocity};
    assert_eq!(observables, [Interval, Velocity, ImpactTime, ChatteringTime]);
    assert!(figures.values().all(|figure| figure.smallest == 2.0));
    assert_eq!((figures[&Interval].numbers, figures[&ChatteringTime].numbers), (60, 1));
    // A thousandth against the claim, relative.
    let crate::measure::asking::Reply::Observed(observed) = &answers[2].reply else { panic!("no history") };
    let claim = observed.history.impacts[4].uncertainty.velocity;
    let smallest = found[1].calibration.figures()[&Velocity].smallest;
    assert!((smallest / (claim / 0.001) - 1.0).abs() < 1e-9, "{smallest}");
}

/// Times and the chattering time are judged absolutely, in their own unit.
#[test]
fn times_are_judged_as_they_are() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let case = case();
    let answer = ask(oracle, &case);
    let Some(truth) = answer.observed() else { panic!("no history") };
    let mut late = truth.clone();
    for impact in &mut late.history.impacts {
        (impact.time, impact.uncertainty.time) = (impact.time + 0.25, 0.5);
    }
    let Some(estimate) = &mut late.chattering_time else { panic!("no chattering time") };
    (estimate.value, estimate.uncertainty) = (estimate.value - 0.25, 0.75);
    let figures = judgement(0, &case, truth, String::new(), &late).calibration.figures();
    assert!((figures[&Observable::ImpactTime].smallest - 2.0).abs() < 1e-12);
    assert!((figures[&Observable::ChatteringTime].smallest - 3.0).abs() < 1e-12);
}

/// What is asked for is judged, and what is not is where something is wrong.
#[test]
fn a_case_in_which_something_is_wrong_is_judged_unasked() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let judges = Judges { oracles: vec![oracle], every: 1 };
    assert_eq!(judges.examine(&[oracle], &case(), true).judgements.len(), 1);
    assert_eq!(judges.examine(&[oracle], &case(), false).judgements.len(), 0);
    struct Late;
    impl Oracle for Late {
        fn name(&self) -> &str {
            "late"
        }
        fn model(&self) -> contract::Model {
            contract::Model::Linear
        }
        fn history(&self, case: &Case) -> Result<contract::History, contract::Decline> {
            let mut history = stepper().history(case)?;
            history.impacts.iter_mut().for_each(|impact| impact.time += 0.1);
            Ok(history)
        }
    }
    assert_eq!(judges.examine(&[oracle, &Late], &case(), false).judgements.len(), 2);
}
