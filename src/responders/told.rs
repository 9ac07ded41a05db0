//! Whole responses as an oracle tells them by itself, without flights of which the harness makes them: what the judge proves, and what a law foretells.
//! They are asked on motions of the ground that are no steady sinusoids.

use contract::{BoutEnd, Followed, Impact, Model, Oracle};

use crate::{
    cases::shaking::{AnyMotion, Question},
    gate::responses::{self, Bout, BoutEnding, Responder, Whole},
    panel::{self, Role},
};

/// The first impacts of each bout are enough: what is wrong with later ones shows in when it rests.
const IMPACTS: usize = 40;
/// Above this restitution the judge would follow too many impacts to the proof.
const MOST_ETA: f64 = 0.97;
/// Each says by itself how far its rests may be off: what else there is, is rounding.
const ACCURACY: f64 = 1e-15;

/// What an oracle tells by itself.
pub struct Told {
    oracle: Box<dyn Oracle>,
    lists_impacts: bool,
}

/// The judges of the panel, and then what foretells rests without an impact; that only where it is among those of which `is_asked` says so.
pub fn told(is_asked: impl Fn(&dyn Oracle) -> bool) -> Vec<Told> {
    let judges = panel::with_role(Role::Judge).into_iter().map(|oracle| Told { oracle, lists_impacts: true });
    let foretells = panel::foretelling().into_iter().filter(|oracle| is_asked(oracle.as_ref()));
    judges.chain(foretells.map(|oracle| Told { oracle, lists_impacts: false })).collect()
}

impl Responder for Told {
    fn name(&self) -> &str {
        self.oracle.name()
    }

    fn model(&self) -> Model {
        self.oracle.model()
    }

    fn accuracy(&self) -> f64 {
        ACCURACY
    }

    fn lists_impacts(&self) -> bool {
        self.lists_impacts
    }

    fn is_asked(&self, question: &Question) -> bool {
        matches!(question, Question::Motion(asked) if asked.body.eta() <= MOST_ETA)
    }

    fn respond(&self, question: &Question, _: usize) -> Option<Whole> {
        let Question::Motion(AnyMotion { body, motion, start, until }) = question else { return None };
        let asked = Followed { start: *start, until: *until, most_impacts: IMPACTS };
        let bouts = self.oracle.bouts_on(body, motion, &asked).ok()?;
        let decided = bouts.iter().take_while(|bout| bout.end != BoutEnd::Undecided);
        let decided: Vec<Bout> = decided.map(|found| bout(found, body.eta(), *until)).collect();
        let last = decided.last();
        let now = last.map_or(0.0, |bout| bout.end);
        if decided.len() < bouts.len() {
            // Nothing is told from the first bout on that it can't decide; where that is the first of all, it has no answer.
            last?;
            return Some(Whole {
                rests: rests(&decided, now),
                bouts: decided,
                end: now,
                told_until: Some(now),
                rows: Vec::new(),
            });
        }
        let end = match last.map_or(BoutEnding::Rest, |bout| bout.outcome) {
            BoutEnding::Rest => motion.duration().max(now).min(*until),
            _ => now,
        };
        Some(Whole { rests: rests(&decided, end), bouts: decided, end, told_until: None, rows: Vec::new() })
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
