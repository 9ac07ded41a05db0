//! Every mistake of the catalogue, planted in an engine behind the protocol, is named by what explains the engine's answers; or others that are the same on
//! these cases are too, and then that is said. Never is a wrong one named without doubt.

use chattercheck::{
    cases::generate::Generator,
    faults::{
        Fault,
        catalogue::of_engines,
        confusion::{Bench, Outcome, Row, are_named, honest},
        explain::explain,
    },
    gate::samples::Sample,
    panel,
};
use contract::{Case, Ending, History, Model};
use process::{Engine, Launch};

use super::effort;

/// The program as an engine with a fault.
fn engine(fault: &Fault) -> Engine {
    let run = [env!("CARGO_BIN_EXE_chattercheck"), "engine", "planted", fault.name, "--oracle", &fault.oracle];
    Engine::start(Launch::new("planted", run, honest(fault).model()), None).unwrap()
}

#[test]
fn the_mistake_that_an_engine_makes_is_named() {
    let bench = Bench::new(1);
    let every = effort::pick("of the mistakes of the catalogue one in", 9, 1);
    let faults = of_engines().into_iter().step_by(every);
    let rows: Vec<Row> = faults.map(|fault| bench.row(&fault, &engine(&fault))).collect();
    let amiss = |row: &&Row| matches!(row.outcome, Outcome::Missed | Outcome::Misnamed) || row.is_unnoticed();
    assert!(are_named(&rows), "{:?}", rows.iter().filter(amiss).collect::<Vec<_>>());
}

/// What no hypothesis is like is not explained, and neither is what is right.
#[test]
fn what_is_no_mistake_of_the_catalogue_is_not_explained() {
    let stepper = panel::stepper();
    let cases: Vec<_> = Generator::Spaced.cases(1, 0, stepper.as_ref()).into_iter().step_by(5).collect();
    let by = |change: fn(&mut History)| {
        let sample = |named: &chattercheck::cases::generate::Named| {
            let mut history = stepper.history(&named.case).ok();
            history.iter_mut().for_each(change);
            Sample { case: named.case, answer: history, is_wrong: true, is_ending_wrong: false }
        };
        explain(&cases.iter().map(sample).collect::<Vec<_>>(), Model::Linear)
    };
    let wiggles = |history: &mut History| {
        history.impacts.iter_mut().enumerate().for_each(|(n, impact)| impact.interval *= 1.0 + 1e-3 * (n as f64).sin());
    };
    assert_eq!(by(wiggles), []);
    assert_eq!(by(|_| ()), []);
}

/// Answers as the stepper gives them to another question.
fn answered(case: Case, asked: Case, is_wrong: bool) -> Sample {
    Sample { case, answer: panel::stepper().history(&asked).ok(), is_wrong, is_ending_wrong: false }
}

fn case(epsilon: f64, eta: f64) -> Case {
    Case::from_epsilon(epsilon, 2.0, eta).unwrap().with_max_impacts(24).unwrap()
}

/// A mistake that does nothing in a case explains nothing there, also where the engine says more about the end than it has to.
#[test]
fn what_does_not_act_does_not_explain() {
    let lost = |epsilon: f64| {
        let mut sample = answered(case(epsilon, 0.92), case((1.0 + epsilon) - 1.0, 0.92), true);
        sample.answer.iter_mut().for_each(|history| history.ending = Ending::AtRest);
        sample
    };
    let found = explain(&[1e-12, 3e-12, 7e-11, 2e-10].map(lost), Model::Linear);
    let named: Vec<&str> = found.iter().map(|found| found.fault.as_str()).collect();
    assert_eq!(named, ["a - 1 from a"], "{found:?}");
    assert!(found[0].explained == 4 && found[0].left < 1e-12, "{found:?}");
}

/// What explains all that is wrong and would spoil what is right is no explanation.
#[test]
fn what_spoils_right_answers_is_not_named() {
    let mut samples =
        [0.01, 0.02, 0.03].map(|epsilon| answered(case(epsilon, 0.9), case(epsilon, 0.9009), true)).to_vec();
    let named = |samples: &[Sample]| explain(samples, Model::Linear).first().map(|found| found.fault.clone());
    assert_eq!(named(&samples).as_deref(), Some("eta is off"));
    samples.extend([0.8, 0.85, 0.95].map(|eta| answered(case(0.01, eta), case(0.01, eta), false)));
    assert_eq!(named(&samples), None);
}
