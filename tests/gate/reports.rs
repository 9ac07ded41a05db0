//! What the reports say of a run that was interrupted, of responses that fall short as a whole, of many failures, and of what was narrow.

use std::{
    collections::BTreeSet,
    sync::atomic::{AtomicUsize, Ordering},
};

use chattercheck::{
    cases::generate::Named,
    faults::plant::{Plant, Planted},
    gate::{
        judge::Judges,
        outcome::Outcomes,
        progress::Progress,
        report::{self, Report},
        responses,
        run::{self, Selection},
        verdict::Verdict,
    },
    measure::observables::Observable,
    panel,
};
use contract::{Case, History, Oracle};

/// Interrupts a run once so many cases are done.
struct After {
    cases: usize,
    done: AtomicUsize,
}

impl Progress for After {
    fn done(&self, _: bool) {
        self.done.fetch_add(1, Ordering::SeqCst);
    }

    fn is_interrupted(&self) -> bool {
        self.done.load(Ordering::SeqCst) >= self.cases
    }
}

fn after(cases: usize) -> After {
    After { cases, done: AtomicUsize::new(0) }
}

fn cases() -> Vec<Named> {
    let all = run::cases(&Selection { cases: 0, seed: 1 }, panel::stepper().as_ref());
    all.into_iter().take(6).collect()
}

fn report(progress: &impl Progress) -> Report {
    let panel = panel::select("closed-form,taylor").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let judges = Judges { oracles: Vec::new(), every: 1, closing: None };
    Report::new(&run::run(&panel, &judges, &cases(), 1, None, progress), &panel::roles())
}

/// The test cases of a JUnit file in which there is an element of this name.
fn junit_with(xml: &str, element: &str) -> BTreeSet<String> {
    let with = xml.split("<testcase ").skip(1).filter(|text| text.contains(&format!("<{element}")));
    with.map(|text| text.split('"').nth(1).unwrap().to_owned()).collect()
}

fn failed_response() -> responses::Failed {
    responses::Failed {
        name: "response/3".to_owned(),
        a: Some(1.5),
        omega: Some(2.0),
        motion: None,
        eta: 0.9,
        alpha: None,
        phase: None,
        lasts: None,
        until: Some(9.0),
        findings: Vec::new(),
    }
}

/// A CI that reads JUnit only sees it too where every response is right but the run of them proves too little.
#[test]
fn what_the_responses_fall_short_of_is_a_failure_in_junit() {
    let shortfall = responses::Shortfall::NoImpact { method: "idle".to_owned() };
    let said = shortfall.to_string();
    let of = responses::Report { shortfalls: vec![shortfall], ..responses::Report::default() };
    let report = report(&()).with_responses(Some(of));
    assert_eq!(report.verdict, Verdict::Fail);
    let junit = report::junit(&report, &cases(), &Outcomes::default()).unwrap();
    assert_eq!(junit_with(&junit, "failure"), ["shortfalls of the responses".to_owned()].into());
    assert!(junit.contains(&said) && report::text(&report).contains(&format!("SHORTFALL: {said}")), "{junit}");
}

/// What was not run is neither green nor red, and is named: a file in which it were missing would read as a run that was never to have it.
#[test]
fn what_an_interruption_leaves_out_is_skipped() {
    let of_cases = report(&after(2));
    assert!(!of_cases.left_out.is_empty() && of_cases.reach.cases + of_cases.left_out.len() == cases().len());
    assert_eq!(of_cases.verdict, Verdict::Undecided);
    let (of_responses, _) =
        responses::run(&[], &responses::questions(&responses::Selection { responses: 4, seed: 1 }), &after(0));
    assert_eq!(of_responses.verdict(), Verdict::Undecided);
    let responses = ["response/1", "response/2", "response/3", "motion/1"].map(str::to_owned);
    let left_out: BTreeSet<String> = of_cases.left_out.iter().cloned().chain(responses).collect();
    let report = of_cases.with_responses(Some(of_responses));
    let junit = report::junit(&report, &cases(), &Outcomes::default()).unwrap();
    assert_eq!(junit_with(&junit, "skipped"), left_out);
    assert_eq!(junit_with(&junit, "failure"), BTreeSet::new(), "an interruption is an error, not a failure");
    assert_eq!(junit_with(&junit, "error").len(), 2);
}

/// Interrupted or not: what was found wrong is wrong.
#[test]
fn a_wrong_response_turns_an_interrupted_run_red() {
    let of = responses::Report { failures: vec![failed_response()], ..responses::Report::default() };
    for progress in [after(2), after(100)] {
        let report = report(&progress).with_responses(Some(of.clone()));
        assert_eq!(report.verdict, Verdict::Fail);
        assert!(report::text(&report).starts_with("FAIL"));
    }
}

#[test]
fn every_failed_case_is_counted() {
    let panel = panel::select("closed-form,taylor").unwrap();
    let off = Plant::Answer(|_, _, history| history.impacts.iter_mut().for_each(|impact| impact.velocity *= 2.0));
    let wrong = Planted { honest: panel[0].as_ref(), plant: off, size: 1.0 };
    let judges = Judges { oracles: Vec::new(), every: 1, closing: None };
    let run = run::run(&[&wrong, panel[1].as_ref()], &judges, &cases(), 1, None, &());
    let mut report = Report::new(&run, &panel::roles());
    let one = report.failures[0].clone();
    for count in [1, 99, 100, 1234] {
        report.failures = vec![one.clone(); count];
        let text = report::text(&report);
        assert!(text.starts_with(&format!("FAIL: {count} of ")), "{text}");
        assert!(text.contains(&format!("{count} of {count} failed cases point to ")), "{text}");
    }
}

/// The comparisons that came nearest to failing, the nearest first.
#[test]
fn the_narrowest_comparisons_are_shown() {
    let mut report = report(&());
    let pair = &mut report.pairs[0];
    let sample = pair.worst[&Observable::Interval].clone();
    pair.worst.clear();
    for (observable, share) in [
        (Observable::Interval, 0.3),
        (Observable::Velocity, 0.9),
        (Observable::ImpactTime, 0.1),
        (Observable::IntervalRatio, 0.2),
        (Observable::ChatteringTime, 0.6),
    ] {
        let mut worst = sample.clone();
        worst.share = share;
        pair.worst.insert(observable, worst);
    }
    let text = report::text(&report);
    let shown: Vec<&str> = text
        .lines()
        .filter_map(|line| line.split_once(" % of what is allowed")?.0.split_whitespace().next_back())
        .collect();
    assert_eq!(shown, ["90", "60", "30"], "{text}");
}

/// How deep a run compares is how deep its claims let it: an interval with a claim of its own size is compared in name only.
#[test]
fn what_is_compared_in_name_only_is_not_deep() {
    let change: fn(&Case, f64, &mut History) = |_, claim, history| {
        if let Some(last) = history.impacts.last_mut() {
            last.uncertainty.interval = claim;
        }
    };
    let oracles = panel::select("closed-form,ode/linear/tsit45").unwrap();
    let deepest = |claim: f64| {
        let unsure = Planted { honest: oracles[0].as_ref(), plant: Plant::Answer(change), size: claim };
        let judges = Judges { oracles: Vec::new(), every: 1, closing: None };
        let run = run::run(&[&unsure, oracles[1].as_ref()], &judges, &cases()[..1], 1, None, &());
        Report::new(&run, &panel::roles()).reach.deepest_interval
    };
    assert!(deepest(1e-9).is_some());
    assert_eq!(deepest(0.9), None);
}
