//! Running the chosen candidate, and the next one where its answer is worse than asked.

use contract::{Decline, Ending, Estimate, Oracle};

use super::{Candidate, Errors, Found, Plan, Question, Way, step, way::CLOSING_SHARE};
use crate::{
    measure::asking::{Reply, ask},
    motion::response::{BoutEnd, Request, Response},
};

/// How many impacts an oracle lists for a chattering time.
const IMPACTS: usize = 400;

/// One method that was run.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// The method.
    pub method: Way,
    /// What it found; `None` if it had no answer.
    pub found: Option<Conclusion>,
    /// Why it had none, if it declined.
    pub declined: Option<Decline>,
    /// How many impacts it took.
    pub impacts: usize,
}

/// What a method found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Conclusion {
    /// The block never rocks.
    NeverRocks,
    /// The chattering is incomplete: the block does not come to rest within half a period. It rocks on, or overturns later.
    Incomplete,
    /// The block still rocks when the response ends.
    Rocking,
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
    pub fn conclusion(&self) -> Option<Conclusion> {
        self.attempts.last()?.found
    }

    /// The chattering time, if the chattering is complete.
    pub fn chattering_time(&self) -> Option<Estimate> {
        match self.conclusion()? {
            Conclusion::Complete(time) => Some(time),
            Conclusion::NeverRocks | Conclusion::Incomplete | Conclusion::Rocking | Conclusion::Overturned => None,
        }
    }

    /// Why the first of the methods that declined did, if one did.
    pub fn declined(&self) -> Option<&Decline> {
        self.attempts.iter().find_map(|attempt| attempt.declined.as_ref())
    }

    /// The method whose answer it is.
    pub fn method(&self) -> Option<Way> {
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
        let (found, impacts, declined) = match run(candidate, question) {
            Ok((found, impacts)) => (found, impacts, None),
            Err(decline) => (None, 0, Some(decline)),
        };
        attempts.push(Attempt { method: candidate.method, found, declined, impacts });
        if meets(found, question.tolerance) {
            break;
        }
    }
    // What the history of a case leaves open, the response of the scene tells.
    let open = |found| matches!(found, None | Some(Conclusion::Incomplete | Conclusion::Overturned));
    if let Some(request) = question.afterwards.as_ref().filter(|_| open(attempts.last().and_then(|last| last.found))) {
        attempts.push(afterwards(question, request));
    }
    let meets = attempts.last().is_some_and(|attempt| meets(attempt.found, question.tolerance));
    Answer { attempts, meets }
}

/// Whether what was found is as accurate as asked.
fn meets(found: Option<Conclusion>, tolerance: f64) -> bool {
    match found {
        Some(Conclusion::Complete(time)) => time.uncertainty <= tolerance * time.value,
        Some(Conclusion::NeverRocks | Conclusion::Incomplete | Conclusion::Rocking | Conclusion::Overturned) => true,
        None => false,
    }
}

/// What happens after half a period, by flights of the very equation that is asked for.
fn afterwards(question: &Question, request: &Request) -> Attempt {
    let method = if question.alpha() > 0.0 { Way::Nonlinear } else { Way::Linear };
    let ran =
        method.oracle(question).map_or(Ok((None, 0)), |oracle| responded(oracle.as_ref(), request, &Errors::default()));
    match ran {
        Ok((found, impacts)) => Attempt { method, found, declined: None, impacts },
        Err(decline) => Attempt { method, found: None, declined: Some(decline), impacts: 0 },
    }
}

/// What was found, if anything, and how many impacts it took.
type Ran = Result<(Option<Conclusion>, usize), Decline>;

fn run(candidate: &Candidate, question: &Question) -> Ran {
    let Ok(errors) = &candidate.errors else { return Ok((None, 0)) };
    match candidate.method {
        Way::Nothing => Ok((Some(Conclusion::NeverRocks), 0)),
        Way::CriticalAmplitude => Ok((Some(Conclusion::Incomplete), 0)),
        Way::Linear | Way::Corrected | Way::Nonlinear => stepped(candidate.method, question, errors),
        method => asked(method, question, errors),
    }
}

/// An oracle's answer.
fn asked(method: Way, question: &Question, errors: &Errors) -> Ran {
    let (Some(oracle), Ok(case)) = (method.oracle(question), question.case.with_max_impacts(IMPACTS)) else {
        return Ok((None, 0));
    };
    let observed = match ask(oracle.as_ref(), &case).reply {
        Reply::Observed(observed) => observed,
        Reply::Declined(why) | Reply::Broke(why) => return Err(why),
        Reply::Panicked(_) => return Ok((None, 0)),
    };
    let outcome = match observed.history.ending {
        Ending::Incomplete => Some(Conclusion::Incomplete),
        Ending::Overturned => Some(Conclusion::Overturned),
        _ => observed
            .chattering_time
            .map(|time| Conclusion::Complete(with(time, errors.model + numbers(question, errors)))),
    };
    Ok((outcome, observed.history.impacts.len()))
}

/// The estimate with a relative error that its method does not know of.
fn with(time: Estimate, relative: f64) -> Estimate {
    Estimate { uncertainty: time.uncertainty + relative * time.value, ..time }
}

/// Flights, no more than are needed.
fn stepped(method: Way, question: &Question, errors: &Errors) -> Ran {
    if let Some(request) = &question.request {
        return method.oracle(question).map_or(Ok((None, 0)), |oracle| responded(oracle.as_ref(), request, errors));
    }
    let Some(solver) = method.flights(question)? else { return Ok((None, 0)) };
    // Below a_cr of the linear model by more than the models differ, chattering is known to be complete.
    let complete = question.place.is_some_and(|place| place.share < 1.0 && !place.is_near(question.alpha()));
    Ok(match step(solver.as_ref(), &question.case, CLOSING_SHARE * question.tolerance, complete) {
        Found::Complete(time, impacts) => {
            let time = with(time, known(question, errors) + claimed(method, question, impacts)?);
            (Some(Conclusion::Complete(time)), impacts)
        }
        Found::Incomplete(impacts) => (Some(Conclusion::Incomplete), impacts),
        Found::Overturned(impacts) => (Some(Conclusion::Overturned), impacts),
        Found::Undecided => (None, 0),
    })
}

/// What the method itself claims of so many impacts, relative, where nothing is predicted.
fn claimed(method: Way, question: &Question, impacts: usize) -> Result<f64, Decline> {
    let (None, Some(oracle)) = (question.place, method.oracle(question)) else { return Ok(0.0) };
    let case = question.case.with_max_impacts(impacts);
    let case = case.map_err(|invalid| Decline::NotConvergent { why: invalid.to_string() })?;
    let last = oracle.history(&case)?.impacts.last().copied();
    Ok(last.map_or(0.0, |last| last.uncertainty.time / last.time))
}

/// What is known to be wrong beside what closing the sum leaves.
fn known(question: &Question, errors: &Errors) -> f64 {
    errors.model + errors.discretisation + numbers(question, errors)
}

/// What the rounding of the case's own numbers does; outside of the range in which that is predicted, as much as it is itself.
fn numbers(question: &Question, errors: &Errors) -> f64 {
    errors.conditioning.max(question.rounding)
}

/// The first rocking of a motion that is not that of a case.
fn responded(oracle: &dyn Oracle, request: &Request, errors: &Errors) -> Ran {
    let response = Response::new(oracle, request)?;
    let Some(bout) = response.bouts.first() else { return Ok((Some(Conclusion::NeverRocks), 0)) };
    // What rounding does is in what the response itself says.
    let of_method = errors.model + errors.discretisation;
    let outcome = match bout.outcome {
        _ if bout.is_unsure() => None,
        BoutEnd::Complete { uncertainty } => {
            Some(Conclusion::Complete(with(Estimate { value: bout.duration - bout.start, uncertainty }, of_method)))
        }
        BoutEnd::Overturned => Some(Conclusion::Overturned),
        BoutEnd::Cut => Some(Conclusion::Rocking),
        _ => None,
    };
    Ok((outcome, bout.impacts()))
}
