//! Which cases are asked, and what is put beside what.

use super::*;
use crate::{gate::examine::examine_and_judge, panel};

fn stepper() -> Box<dyn Oracle> {
    panel::default().swap_remove(0)
}

fn case() -> Case {
    Case::from_epsilon(0.02, 2.0, 0.9).unwrap_or_else(|invalid| panic!("{invalid}"))
}

#[test]
fn every_listed_case_and_every_so_many_others_are_asked() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let named = |generator: Generator| Named { name: String::new(), case: case(), generator };
    let asks = |judges: &Judges| {
        [Generator::List, Generator::Random].map(|of| [0, 1, 2, 3].map(|place| judges.asks(place, &named(of))))
    };
    let every = |every: usize| Judges { oracles: vec![oracle], every, closing: None };
    assert_eq!(asks(&every(2)), [[true; 4], [true, false, true, false]]);
    assert_eq!(asks(&every(0)), [[true; 4], [true; 4]]);
    assert_eq!(asks(&Judges { oracles: Vec::new(), every: 1, closing: None }), [[false; 4]; 2]);
    // As many at the end of a long run as at its beginning.
    let of_a_thousand = |from: usize| {
        let asked = (from..from + 1000).filter(|place| every(10).asks(*place, &named(Generator::Random)));
        asked.count()
    };
    assert_eq!([0, 1000, 50_000, 900_000].map(of_a_thousand), [100; 4]);
}

/// The judge is another method here, which serves to see what is put beside what.
#[test]
fn answers_are_judged_by_the_judge_of_their_model_and_only_where_they_are_wanted() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let case = case();
    let judges = Judges { oracles: vec![oracle], every: 1, closing: None };
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
    let figures = judgement(0, &case, &Arc::new(truth.clone()), String::new(), &late).calibration.figures();
    assert!((figures[&Observable::ImpactTime].smallest - 2.0).abs() < 1e-12);
    assert!((figures[&Observable::ChatteringTime].smallest - 3.0).abs() < 1e-12);
}

/// What is asked for is judged, and what is not is where something is wrong.
#[test]
fn a_case_in_which_something_is_wrong_is_judged_unasked() {
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let judges = Judges { oracles: vec![oracle], every: 1, closing: None };
    assert_eq!(examine_and_judge(&[oracle], &judges, &case(), true).judgements.len(), 1);
    assert_eq!(examine_and_judge(&[oracle], &judges, &case(), false).judgements.len(), 0);
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
    assert_eq!(examine_and_judge(&[oracle, &Late], &judges, &case(), false).judgements.len(), 2);
}

/// That what is overturned lands again is not said on the word of an oracle that the judge refutes.
#[test]
fn who_is_refuted_bears_no_witness() {
    struct Dreamer;
    impl Oracle for Dreamer {
        fn name(&self) -> &str {
            "dreamer"
        }
        fn model(&self) -> contract::Model {
            contract::Model::Linear
        }
        fn history(&self, _: &Case) -> Result<contract::History, contract::Decline> {
            let uncertainty = contract::Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
            let impacts = vec![contract::Impact { time: 1.0, interval: 1.0, velocity: 0.1, uncertainty }];
            Ok(contract::History { impacts, ending: contract::Ending::Incomplete, chattering_time: None })
        }
    }
    let oracle = stepper();
    let oracle = oracle.as_ref();
    let case = Case::from_amplitude(1.5, 1.0, 0.9).and_then(|case| case.with_max_impacts(20)).unwrap();
    let accused = |judges: &Judges| {
        let examination = examine_and_judge(&[oracle, &Dreamer], judges, &case, true);
        let lands = |law: crate::gate::laws::Law| law == crate::gate::laws::Law::OverturnedStays;
        let accused = examination.checked[0].breach.as_ref().is_some_and(|breach| lands(breach.law));
        (accused, examination.sound())
    };
    let judges = Judges { oracles: vec![oracle], every: 1, closing: None };
    assert_eq!(accused(&judges), (false, vec![oracle.name().to_owned()]));
    // Where nobody proves anything, it stays open who is wrong.
    assert!(accused(&Judges::default()).0);
}
