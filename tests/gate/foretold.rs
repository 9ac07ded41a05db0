//! Rests that the weak law foretells on motions of the ground: they are compared in a run, and a law that is wrong, or claims too much of itself, is found.

use chattercheck::{
    cases::{generate, shaking::Question},
    gate::responses::{self, BoutEnding, Report, Responder, What, Whole, Wrong},
    responders::{self, Told},
};
use contract::Model;

use crate::effort::pick;

fn foretelling() -> Told {
    responders::told(|_| true).into_iter().find(|told| !told.lists_impacts()).unwrap()
}

fn run(method: &dyn Responder, motions: usize) -> Report {
    let motions = generate::motions(1, motions).into_iter().enumerate();
    let questions: Vec<_> = motions.map(|(n, motion)| (format!("motion/{n}"), Question::Motion(motion))).collect();
    responses::run(&[method], &questions, &()).0
}

/// The law with its answers spoilt.
struct Spoilt(Told, fn(&mut Whole));

impl Responder for Spoilt {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn model(&self) -> Model {
        self.0.model()
    }

    fn accuracy(&self) -> f64 {
        self.0.accuracy()
    }

    fn lists_impacts(&self) -> bool {
        false
    }

    fn is_asked(&self, question: &Question) -> bool {
        self.0.is_asked(question)
    }

    fn respond(&self, question: &Question, rows: usize) -> Option<Whole> {
        let mut whole = self.0.respond(question, rows)?;
        (self.1)(&mut whole);
        Some(whole)
    }
}

/// What is found wrong in the most responses, and of how many.
fn found(spoil: fn(&mut Whole)) -> Vec<Wrong> {
    let report = run(&Spoilt(foretelling(), spoil), 100);
    report.failures.into_iter().flat_map(|failed| failed.findings).map(|finding| finding.wrong).collect()
}

#[test]
fn the_law_is_right_within_its_claims_and_comes_near_them() {
    let report = run(&foretelling(), pick("foretold", 300, 5000));
    assert!(report.failures.is_empty(), "{}", responses::failures_text(&report));
    let counts = report.tally.methods.values().next().unwrap();
    assert!(counts.rests > 40 && counts.related > 10, "{counts:?}");
    assert!((0.01..1.0).contains(&counts.used) && counts.impacts == 0, "{counts:?}");
}

#[test]
fn rests_that_are_wrong_are_found() {
    let kinds = found(|whole| {
        let claims = |bout: &mut responses::Bout| bout.end += 2.0 * bout.uncertainty + 1e-9 * bout.end;
        whole.bouts.iter_mut().filter(|bout| bout.outcome == BoutEnding::Rest).for_each(claims);
        let ends: Vec<f64> = whole.bouts.iter().map(|bout| bout.end).collect();
        for rest in &mut whole.rests {
            // A rest follows a bout, but for the first.
            if let Some(end) = ends.iter().find(|end| (*end - rest.0).abs() < 1e-3 * (1.0 + *end)) {
                rest.0 = *end;
            }
        }
    });
    let is_late = |wrong: &Wrong| matches!(wrong, Wrong::Differs(of) if of.what == What::RestTime);
    assert!(kinds.iter().any(is_late), "{kinds:?}");
}

/// To know nothing is no answer, and to know everything neither.
#[test]
fn claims_that_are_too_wide_or_too_narrow_are_found() {
    let is = |what: What| move |wrong: &Wrong| matches!(wrong, Wrong::Differs(of) if of.what == what);
    let unsure = found(|whole| whole.bouts.iter_mut().for_each(|bout| bout.uncertainty = 0.1));
    assert!(unsure.iter().any(is(What::Unsure)), "{unsure:?}");
    let certain = found(|whole| whole.bouts.iter_mut().for_each(|bout| bout.uncertainty = 0.0));
    assert!(certain.iter().any(is(What::RestTime)), "{certain:?}");
}

/// What it says to know to the end, it has to know.
#[test]
fn a_bout_that_is_left_out_is_found() {
    let all = found(|whole| whole.told_until = whole.told_until.map(|_| f64::INFINITY));
    assert!(all.iter().any(|wrong| matches!(wrong, Wrong::Differs(of) if of.what == What::NoBout)), "{all:?}");
}
