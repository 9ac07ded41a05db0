//! Whole responses as the judge proves them, where it follows them by itself: on motions of the ground that are no steady sinusoids.

use contract::{BoutEnd, Followed, Impact, Model, Oracle};

use crate::{
    cases::shaking::{AnyMotion, Question},
    gate::responses::{self, Bout, BoutEnding, Responder, Whole},
    panel::{self, Role},
};

/// The first impacts of each bout are enough: what is wrong with later ones shows in when it rests.
const IMPACTS: usize = 40;
/// Above this restitution it would follow too many impacts to the proof.
const MOST_ETA: f64 = 0.97;
/// Proven bounds are narrower than the rounding of their middles.
const ACCURACY: f64 = 1e-15;

/// The judge of one of the models.
pub struct Proven {
    oracle: Box<dyn Oracle>,
}

/// The judges of the panel.
pub fn judges() -> Vec<Proven> {
    panel::with_role(Role::Judge).into_iter().map(|oracle| Proven { oracle }).collect()
}

impl Responder for Proven {
    fn name(&self) -> &str {
        self.oracle.name()
    }

    fn model(&self) -> Model {
        self.oracle.model()
    }

    fn accuracy(&self) -> f64 {
        ACCURACY
    }

    fn is_asked(&self, question: &Question) -> bool {
        matches!(question, Question::Motion(asked) if asked.body.eta() <= MOST_ETA)
    }

    fn respond(&self, question: &Question, _: usize) -> Option<Whole> {
        let Question::Motion(AnyMotion { body, motion, start, until }) = question else { return None };
        let asked = Followed { start: *start, until: *until, most_impacts: IMPACTS };
        let bouts = self.oracle.bouts_on(body, motion, &asked).ok()?;
        // What is undecided with the digits that it tries is no answer.
        if bouts.iter().any(|bout| bout.end == BoutEnd::Undecided) {
            return None;
        }
        let bouts: Vec<Bout> = bouts.iter().map(|found| bout(found, body.eta(), *until)).collect();
        let last = bouts.last();
        let now = last.map_or(0.0, |bout| bout.end);
        let end = match last.map_or(BoutEnding::Rest, |bout| bout.outcome) {
            BoutEnding::Rest => motion.duration().max(now).min(*until),
            _ => now,
        };
        Some(Whole { rests: rests(&bouts, end), bouts, end, rows: Vec::new() })
    }
}

fn bout(found: &contract::Bout, eta: f64, until: f64) -> Bout {
    let last = found.impacts.last().map_or(found.begin.value, |impact| impact.time);
    let (outcome, end, uncertainty) = match found.end {
        BoutEnd::Rest(at) => (BoutEnding::Rest, at.value, at.uncertainty),
        BoutEnd::Overturned => (BoutEnding::Overturned, last, 0.0),
        BoutEnd::Aloft => (BoutEnding::Cut, until, 0.0),
        BoutEnd::Undecided => (BoutEnding::GivenUp, last, 0.0),
    };
    let impact = |impact: &Impact| responses::Impact {
        time: impact.time,
        before: impact.velocity.abs() / eta,
        after: Some(impact.velocity.abs()),
    };
    Bout {
        begin: found.begin.value,
        side: found.side,
        impacts: found.impacts.iter().map(impact).collect(),
        outcome,
        end,
        uncertainty,
        peak: None,
    }
}

/// The times between the bouts.
fn rests(bouts: &[Bout], end: f64) -> Vec<(f64, f64)> {
    let begins = bouts.iter().map(|bout| bout.begin).chain([end]);
    let ends = std::iter::once(0.0)
        .chain(bouts.iter().map(|bout| if bout.outcome == BoutEnding::Rest { bout.end } else { end }));
    ends.zip(begins).filter(|(from, to)| to > from).collect()
}
