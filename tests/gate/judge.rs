//! The judge: what it proves is what the others find, it names the one that is wrong, and no oracle claims less than its true error.

use chattercheck::{
    cases::generate::{Generator, Named},
    faults::plant::{Plant, Planted},
    gate::{
        finding::Finding,
        judge::Judges,
        ladder,
        report::{self, Report},
        run,
        shortfall::Shortfall,
        tolerance,
    },
    measure::asking::ask,
    panel,
};
use contract::{Case, Decline, Ending, History, Model, Oracle, Uncertainty};

fn fig2() -> Named {
    let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
    Named { generator: Generator::List, name: "fig-2".to_owned(), case }
}

fn judged(panel: &[&dyn Oracle], cases: &[Named], whole: bool) -> Report {
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    let ladders = whole.then(|| ladder::descend(panel, panel::SERIES).unwrap());
    Report::new(&run::run(panel, &judges, cases, 0, ladders, &()), &panel::roles())
}

/// The closed form, tampered with, beside an honest solver.
fn with_faulty(answer: fn(&Case, f64, &mut History)) -> Report {
    let closed_form = panel::default().swap_remove(0);
    let faulty = Planted { honest: closed_form.as_ref(), plant: Plant::Answer(answer), size: 1.0 };
    let honest = panel::select("ode/linear/tsit45").unwrap();
    judged(&[&faulty, honest[0].as_ref()], &[fig2()], false)
}

fn refuted(report: &Report) -> Vec<&str> {
    let findings = report.failures.iter().flat_map(|failure| &failure.findings);
    findings
        .filter_map(|finding| if let Finding::Refuted { oracle, .. } = finding { Some(oracle.as_str()) } else { None })
        .collect()
}

#[test]
fn claims_are_calibrated() {
    let cases = run::cases(&run::Selection { cases: 60, seed: 5 }, panel::stepper().as_ref());
    let cases: Vec<Named> = cases.into_iter().step_by(4).collect();
    let panel = panel::default();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let report = judged(&panel, &cases, false);
    assert!(report.passes(), "{}", report::text(&report));
    assert_eq!(report.judged.cases, cases.len());
    assert_eq!(report.judged.claims.len(), panel.len(), "every oracle is judged");
    for (oracle, claims) in &report.judged.claims {
        assert_eq!(claims.len(), 4, "{oracle}: interval, velocity, time and chattering time");
        for (observable, figure) in claims {
            assert!(figure.smallest >= 1.0, "{oracle} claims {} times its error in the {observable}", figure.smallest);
            assert!(figure.median <= tolerance::CALIBRATION.value, "{oracle}: {} in the {observable}", figure.median);
            assert!(figure.numbers > 50, "{oracle}: {} numbers in the {observable}", figure.numbers);
        }
    }
}

#[test]
fn the_one_that_is_wrong_is_named() {
    let report = with_faulty(|_, _, history| history.impacts[20].interval *= 1.0 + 1e-6);
    assert_eq!(refuted(&report), ["closed-form"]);
    let failure = &report.failures[0];
    assert_eq!(failure.sound, ["ode/linear/tsit45"]);
    let text = report::failure_text(failure);
    assert!(text.contains("closed-form is WRONG on interval, first at impact 21"), "{text}");
    assert!(text.contains("nothing is wrong, by the judge and the laws, with ode/linear/tsit45"), "{text}");
}

#[test]
fn a_claim_below_the_true_error_is_refuted_though_every_oracle_agrees() {
    // The two agree to within the claims of the solver; only the judge sees that the closed form claims too little.
    let report = with_faulty(|_, _, history| {
        for impact in &mut history.impacts {
            impact.uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        }
    });
    assert_eq!(refuted(&report), ["closed-form"]);
    assert!(report.failures[0].findings.iter().all(|finding| matches!(finding, Finding::Refuted { .. })));
}

/// What is listed before a loss may be right; that does not make the oracle right.
#[test]
fn an_oracle_that_breaks_a_law_is_not_called_sound() {
    let report = with_faulty(|_, _, history| {
        history.impacts.truncate(30);
        history.ending = Ending::Lost(contract::Loss::FellThrough);
    });
    assert!(refuted(&report).is_empty(), "the judge has nothing to say against the first thirty impacts");
    assert_eq!(report.failures[0].sound, ["ode/linear/tsit45"]);
    let text = report::failure_text(&report.failures[0]);
    assert!(!text.lines().any(|line| line.contains("nothing is wrong") && line.contains("closed-form")), "{text}");
}

#[test]
fn a_wrong_ending_is_refuted() {
    assert_eq!(refuted(&with_faulty(|_, _, history| history.ending = Ending::Incomplete)), ["closed-form"]);
}

/// Every so many cases of a run with so many random ones.
fn every(step: usize, random: usize) -> Vec<Named> {
    let all = run::cases(&run::Selection { cases: random, seed: 5 }, panel::stepper().as_ref());
    all.into_iter().step_by(step).collect()
}

#[test]
fn claims_that_are_far_too_wide_fall_short() {
    let cases = every(4, 40);
    let closed_form = panel::default().swap_remove(0);
    let wider = Plant::Answer(|_, factor, history| {
        for impact in &mut history.impacts {
            let Uncertainty { time, interval, velocity } = impact.uncertainty;
            impact.uncertainty =
                Uncertainty { time: factor * time, interval: factor * interval, velocity: factor * velocity };
        }
    });
    let faulty = Planted { honest: closed_form.as_ref(), plant: wider, size: 10.0 };
    let honest = panel::select("ode/linear/tsit45").unwrap();
    let report = judged(&[&faulty, honest[0].as_ref()], &cases, true);
    let short =
        |shortfall: &Shortfall| matches!(shortfall, Shortfall::TooWide { oracle, .. } if oracle == "closed-form");
    assert!(report.shortfalls.iter().any(short), "{:?}", report.shortfalls);
}

#[test]
fn only_a_sample_is_judged_unless_something_is_wrong() {
    let cases = every(8, 4);
    let judges = panel::judges();
    let panel = panel::select("closed-form,ode/linear/tsit45").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let listed = |(place, named): &(usize, &Named)| named.generator == Generator::List || place.is_multiple_of(7);
    let sample = cases.iter().enumerate().filter(listed).count();
    assert!(sample > cases.len().div_ceil(7) && sample < cases.len());
    for (every, expected) in [(1, cases.len()), (7, sample)] {
        let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every, closing: None };
        assert_eq!(run::run(&panel, &judges, &cases, 0, None, &()).tally.judged(), expected);
    }
}

/// Where the judge of one model is missing, what the other model's oracles said was not judged, and neither was the case.
#[test]
fn a_case_is_judged_where_every_history_is() {
    let slender = contract::Slenderness::new(0.1, contract::Normalisation::Threshold).unwrap();
    let named = Named { case: fig2().case.with_slenderness(slender), ..fig2() };
    let panel = panel::select("closed-form,taylor").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let judges = panel::judges();
    let oracles: Vec<&dyn Oracle> = judges.iter().map(AsRef::as_ref).collect();
    let judged = |oracles: &[&dyn Oracle]| {
        let judges = Judges { oracles: oracles.to_vec(), every: 1, closing: None };
        run::run(&panel, &judges, std::slice::from_ref(&named), 0, None, &()).tally.judged()
    };
    assert_eq!((judged(&oracles), judged(&oracles[..1]), judged(&oracles[1..])), (1, 0, 0));
}

#[test]
fn the_judge_and_the_oracle_with_the_printed_equations_agree() {
    // Both claim little more than the rounding to doubles, and have nothing in common.
    let printed = panel::select("printed").unwrap();
    let judge = panel::select("enclosure/linear").unwrap();
    let case = fig2().case;
    let (one, two) = (ask(printed[0].as_ref(), &case), ask(judge[0].as_ref(), &case));
    let (one, two) = (one.observed().unwrap(), two.observed().unwrap());
    assert_eq!(one.history.impacts.len(), two.history.impacts.len());
    for (mine, theirs) in one.history.impacts.iter().zip(&two.history.impacts) {
        assert!((mine.interval / theirs.interval - 1.0).abs() <= 2.0 * f64::EPSILON);
        assert!((mine.time - theirs.time).abs() <= 2.0 * f64::EPSILON);
    }
}

/// A judge that does not answer.
struct Silent;

impl Oracle for Silent {
    fn name(&self) -> &str {
        "silent"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, _: &Case) -> Result<History, Decline> {
        Err(Decline::NotConvergent { why: "undecided".to_owned() })
    }
}

#[test]
fn a_judge_that_says_nothing_falls_short() {
    let panel = panel::select("closed-form,ode/linear/tsit45").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let cases = every(8, 4);
    let judges = Judges { oracles: vec![&Silent], every: 2, closing: None };
    let report = Report::new(&run::run(&panel, &judges, &cases, 0, Some(Vec::new()), &()), &panel::roles());
    assert!(report.judged.asked >= cases.len() / 2 && report.judged.cases == 0);
    let silent = |shortfall: &Shortfall| matches!(shortfall, Shortfall::Unjudged { judged: 0, .. });
    assert!(report.shortfalls.iter().any(silent), "{:?}", report.shortfalls);
}
