//! Every fault of the catalogue, planted in an engine, is named by what explains the engine's answers; or another that is the same on these cases, and then that is
//! said. Never is a wrong one named without doubt.

use std::sync::LazyLock;

use chattercheck::{
    cases::generate::{Generator, Named},
    faults::{Fault, Size, catalogue::catalogue, explain::explain, plant::Planted, remember::Remembering},
    gate::{examine::examine_and_judge, explanation::Explanation, judge::Judges, samples::Sample},
    panel,
};
use contract::{History, Model, Oracle};

use super::effort;

/// Spaced, random and edge cases, as an engine would be asked for.
fn cases() -> Vec<Named> {
    let stepper = panel::stepper();
    let of = |(generator, every): (Generator, usize)| {
        generator.cases(1, 24, stepper.as_ref()).into_iter().step_by(every).collect::<Vec<_>>()
    };
    [(Generator::Spaced, 12), (Generator::Random, 1), (Generator::Edge, 9)].into_iter().flat_map(of).collect()
}

fn samples(engine: &dyn Oracle, cases: &[Named]) -> Vec<Sample> {
    static JUDGES: LazyLock<Vec<Remembering>> =
        LazyLock::new(|| panel::judges().into_iter().map(Remembering::new).collect());
    let judges = Judges { oracles: JUDGES.iter().map(|judge| judge as &dyn Oracle).collect(), every: 1 };
    let sample = |named: &Named| {
        let examination = examine_and_judge(&[engine], &judges, &named.case, true);
        let answer = engine.history(&named.case).ok();
        let proven = JUDGES.iter().find(|judge| judge.model() == engine.model())?.history(&named.case).ok()?;
        // That a list just ends is no finding: the gate notices that the chattering time is missing.
        let is_right = answer.as_ref().is_some_and(|answer| answer.ending == proven.ending);
        Some(Sample { case: named.case, is_wrong: !is_right || !examination.findings().is_empty(), answer })
    };
    cases.iter().filter_map(sample).collect()
}

/// The names of what explains an engine with this fault.
fn named(fault: &Fault, cases: &[Named]) -> Vec<Explanation> {
    let honest = panel::all().into_iter().find(|oracle| oracle.name() == fault.oracle).unwrap();
    let size = match fault.size {
        Size::Amount { natural, .. } => natural,
        Size::Depth(_) => 7.0,
        Size::Whole => 1.0,
    };
    let engine = Planted { honest: honest.as_ref(), plant: fault.plant, size };
    explain(&samples(&engine, cases), honest.model())
}

#[test]
fn the_fault_that_is_planted_is_named() {
    let cases = cases();
    let engines = [("closed-form", Model::Linear), (panel::SERIES, Model::Linear), ("taylor", Model::Nonlinear)];
    let every = effort::pick("of the faults of the catalogue one in", 8, 1);
    let faults = catalogue(engines.into_iter()).into_iter().step_by(every);
    let (mut all, mut missed, mut misnamed) = (0, Vec::new(), Vec::new());
    for fault in faults {
        let found = named(&fault, &cases);
        all += 1;
        if !found.iter().any(|found| found.fault == fault.name) {
            missed.push(fault.name);
        }
        if let [only] = &found[..]
            && only.is_sure()
            && only.fault != fault.name
        {
            misnamed.push((fault.name, only.to_string()));
        }
    }
    assert!(10 * missed.len() <= all, "{missed:?} of {all}");
    assert!(misnamed.is_empty(), "{misnamed:?}");
}

/// What no hypothesis is like is not explained, and neither is what is right.
#[test]
fn what_is_no_fault_of_the_catalogue_is_not_explained() {
    let cases = cases();
    let stepper = panel::stepper();
    let by = |change: fn(&mut History)| {
        let answer = |sample: &Sample| {
            let mut history = stepper.history(&sample.case).ok();
            history.iter_mut().for_each(change);
            Sample { answer: history, is_wrong: true, ..sample.clone() }
        };
        explain(&samples(stepper.as_ref(), &cases).iter().map(answer).collect::<Vec<_>>(), Model::Linear)
    };
    let wiggles = |history: &mut History| {
        history.impacts.iter_mut().enumerate().for_each(|(n, impact)| impact.interval *= 1.0 + 1e-3 * (n as f64).sin());
    };
    assert_eq!(by(wiggles), []);
    assert_eq!(explain(&samples(stepper.as_ref(), &cases), Model::Linear), []);
}
