//! Running the chosen candidate, and the next one where its answer is worse than asked.

use contract::{Decline, Ending, Estimate, Oracle};

use super::{Candidate, Errors, Found, Method, Plan, Question, method::CLOSING_SHARE, step};
use crate::{
    answer::ask,
    response::{BoutEnd, Request, Response},
};

/// How many impacts an oracle lists for a chattering time.
const IMPACTS: usize = 400;

/// One method that was run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attempt {
    /// The method.
    pub method: Method,
    /// What it found; `None` if it had no answer.
    pub found: Option<Outcome>,
    /// How many impacts it took.
    pub impacts: usize,
}

/// What a method found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    /// The block never rocks.
    NeverRocks,
    /// The chattering is incomplete: the block does not come to rest within half a period. It rocks on, or overturns later.
    Incomplete,
    /// It overturns.
    Overturned,
    /// The chattering time in `τ`, and the error estimated after the fact: everything that is known to be wrong with it, absolute.
    Complete(Estimate),
}

/// An answer and how it was come by.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The methods that were run, in order; the last one's answer is the answer.
    pub attempts: Vec<Attempt>,
    /// Whether the answer is as accurate as asked, by its own estimate.
    pub meets: bool,
}

impl Answer {
    /// What was found in the end.
    pub fn outcome(&self) -> Option<Outcome> {
        self.attempts.last()?.found
    }

    /// The chattering time, if the chattering is complete.
    pub fn chattering_time(&self) -> Option<Estimate> {
        match self.outcome()? {
            Outcome::Complete(time) => Some(time),
            Outcome::NeverRocks | Outcome::Incomplete | Outcome::Overturned => None,
        }
    }

    /// Why the first of the methods that had no answer declined, if one did.
    pub fn declined(&self, question: &Question) -> Option<Decline> {
        let silent = self.attempts.iter().filter(|attempt| attempt.found.is_none());
        silent.filter_map(|attempt| attempt.method.oracle(question)?.flights(&question.case).err()).next()
    }

    /// The method whose answer it is.
    pub fn method(&self) -> Option<Method> {
        Some(self.attempts.last()?.method)
    }
}

pub(super) fn answer(plan: &Plan) -> Answer {
    let question = &plan.question;
    let mut attempts = Vec::new();
    let chosen = plan.chosen().map(|candidate| candidate.method);
    let able = || plan.candidates.iter().filter(|candidate| candidate.errors.is_ok());
    let from = able().position(|candidate| Some(candidate.method) == chosen).unwrap_or(0);
    // Then those that are dearer, as far as they are predicted to be better.
    let later = able().skip(from + 1).filter(|candidate| candidate.meets(question.tolerance));
    for candidate in able().skip(from).take(1).chain(later) {
        let (found, impacts) = run(candidate, question);
        attempts.push(Attempt { method: candidate.method, found, impacts });
        let meets = match found {
            Some(Outcome::NeverRocks | Outcome::Incomplete | Outcome::Overturned) => true,
            Some(Outcome::Complete(time)) => time.uncertainty <= question.tolerance * time.value,
            None => false,
        };
        if meets {
            return Answer { attempts, meets };
        }
    }
    Answer { attempts, meets: false }
}

fn run(candidate: &Candidate, question: &Question) -> (Option<Outcome>, usize) {
    let Ok(errors) = &candidate.errors else { return (None, 0) };
    match candidate.method {
        Method::Nothing => (Some(Outcome::NeverRocks), 0),
        Method::CriticalAmplitude => (Some(Outcome::Incomplete), 0),
        Method::Linear | Method::Corrected | Method::Nonlinear => {
            stepped(candidate.method, question, errors).unwrap_or((None, 0))
        }
        method => asked(method, question, errors).unwrap_or((None, 0)),
    }
}

/// An oracle's answer.
fn asked(method: Method, question: &Question, errors: &Errors) -> Option<(Option<Outcome>, usize)> {
    let case = question.case.with_max_impacts(IMPACTS).ok()?;
    let observed = ask(method.oracle(question)?.as_ref(), &case).into_observed()?;
    let outcome = match observed.history.ending {
        Ending::Incomplete => Some(Outcome::Incomplete),
        Ending::Overturned => Some(Outcome::Overturned),
        _ => observed.chattering_time.map(|time| Outcome::Complete(with(time, errors.model + errors.conditioning))),
    };
    Some((outcome, observed.history.impacts.len()))
}

/// The estimate with a relative error that its method does not know of.
fn with(time: Estimate, relative: f64) -> Estimate {
    Estimate { uncertainty: time.uncertainty + relative * time.value, ..time }
}

/// Flights, no more than are needed.
fn stepped(method: Method, question: &Question, errors: &Errors) -> Option<(Option<Outcome>, usize)> {
    if let Some(request) = &question.request {
        return responded(method.oracle(question)?.as_ref(), request, errors);
    }
    let solver = method.flights(question)?;
    // Below a_cr of the linear model by more than the models differ, chattering is known to be complete.
    let complete = question.place.is_some_and(|place| place.share < 1.0 && !place.is_near(question.alpha()));
    Some(match step(solver.as_ref(), &question.case, CLOSING_SHARE * question.tolerance, complete) {
        Found::Complete(time, impacts) => (Some(Outcome::Complete(with(time, known(errors)))), impacts),
        Found::Incomplete(impacts) => (Some(Outcome::Incomplete), impacts),
        Found::Overturned(impacts) => (Some(Outcome::Overturned), impacts),
        Found::Undecided => (None, 0),
    })
}

/// What is known to be wrong beside what closing the sum leaves.
fn known(errors: &Errors) -> f64 {
    errors.model + errors.discretisation + errors.conditioning
}

/// The first rocking of a motion that is not that of a case.
fn responded(oracle: &dyn Oracle, request: &Request, errors: &Errors) -> Option<(Option<Outcome>, usize)> {
    let response = Response::new(oracle, request).ok()?;
    let Some(bout) = response.bouts.first() else { return Some((Some(Outcome::NeverRocks), 0)) };
    let outcome = match bout.outcome {
        BoutEnd::Complete { uncertainty } => {
            Some(Outcome::Complete(with(Estimate { value: bout.duration - bout.start, uncertainty }, known(errors))))
        }
        BoutEnd::Overturned => Some(Outcome::Overturned),
        BoutEnd::Cut => Some(Outcome::Incomplete),
        _ => None,
    };
    Some((outcome, bout.impacts()))
}
