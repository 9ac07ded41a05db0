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
use contract::{History, Model};
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
            Sample { case: named.case, answer: history, is_wrong: true }
        };
        explain(&cases.iter().map(sample).collect::<Vec<_>>(), Model::Linear)
    };
    let wiggles = |history: &mut History| {
        history.impacts.iter_mut().enumerate().for_each(|(n, impact)| impact.interval *= 1.0 + 1e-3 * (n as f64).sin());
    };
    assert_eq!(by(wiggles), []);
    assert_eq!(by(|_| ()), []);
}
