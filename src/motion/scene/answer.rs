//! What a scene asks, answered.

use contract::{Decline, Ground, Invalid, Oracle};
use serde::Serialize;

use super::{Question, Scene};
use crate::{
    measure::asking::ask,
    motion::response::{Bout, BoutEnd, Request, Response, Termination},
};

/// How many impacts the claim of a chattering time is made from.
const IMPACTS: usize = 400;

/// Why a scene can't be answered.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AnswerError {
    /// Its numbers leave the range of a case.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The method declines it.
    #[error("{oracle} declines: {why}")]
    Declined {
        /// The method.
        oracle: String,
        /// Why.
        why: Decline,
    },
}

/// The answers, in seconds since the start of the ground motion. What was not asked is `None`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answers {
    /// When rocking begins; `None` if it never does.
    pub initiation: Option<f64>,
    /// How long the first rocking lasts until it comes to rest by complete chattering.
    pub chattering_time: Option<ChatteringTime>,
    /// When the block hits its base in the first rocking.
    pub impact_times: Option<Vec<f64>>,
    /// When it rests, each from and to.
    pub rest_periods: Option<Vec<(f64, f64)>>,
    /// The whole response in short; `chattercheck response` has it at length.
    pub response: Option<Summary>,
}

/// The chattering time of the first rocking.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ChatteringTime {
    /// In seconds; `None` if the chattering is not complete.
    pub seconds: Option<f64>,
    /// In `τ`.
    pub tau_ch: Option<f64>,
    /// The error claimed for it, relative.
    pub relative_uncertainty: Option<f64>,
    /// Whether that is no more than the scene's tolerance.
    pub meets_tolerance: Option<bool>,
    /// Whether the block comes to rest by complete chattering; `None` if that was not found out.
    pub complete: Option<bool>,
    /// Whether it does so after the motion of the ground has ended, in free rocking.
    pub after_the_motion: bool,
    /// How the first rocking ends.
    pub ending: &'static str,
}

/// A response in three numbers and a word.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Summary {
    /// How often the block rocks, from rest to rest.
    pub bouts: usize,
    /// How many impacts are resolved.
    pub impacts: usize,
    /// When the last of it ends, in seconds.
    pub end: f64,
    /// How.
    pub ending: &'static str,
}

impl Scene {
    /// Answers what the scene asks, with a method that follows flights on its equation of motion.
    ///
    /// # Errors
    /// When its numbers leave the range of a case, or the method declines it.
    pub fn answers(&self, oracle: &dyn Oracle) -> Result<Answers, AnswerError> {
        let (response, of_case) = if self.sine().is_ok() {
            let request = self.response(None, Termination::Exact)?;
            (Response::new(oracle, &request), Some(request))
        } else {
            (Response::on_motion(oracle, &self.on_motion(None, Termination::Exact)?), None)
        };
        let response = response.map_err(|why| AnswerError::Declined { oracle: oracle.name().to_owned(), why })?;
        let seconds = |tau: f64| tau / self.block.frequency_parameter();
        let asked = |question| self.ask.what.contains(&question);
        let first = response.bouts.first();
        let impact_times =
            first.map_or_else(Vec::new, |bout| bout.impact_times().take(self.ask.impacts).map(seconds).collect());
        let rests = || response.rests().into_iter().map(|(from, to)| (seconds(from), seconds(to))).collect();
        Ok(Answers {
            initiation: first.map(|bout| seconds(bout.begin())),
            chattering_time: first
                .filter(|_| asked(Question::ChatteringTime))
                .map(|bout| self.chattering_time(oracle, of_case.as_ref(), bout)),
            impact_times: asked(Question::ImpactTimes).then_some(impact_times),
            rest_periods: asked(Question::RestPeriods).then(rests),
            response: asked(Question::Response).then(|| Summary {
                bouts: response.bouts.len(),
                impacts: response.bouts.iter().map(Bout::impacts).sum(),
                end: seconds(response.bouts.last().map_or(0.0, Bout::end)),
                ending: response.bouts.last().map_or("never rocks", Bout::ending),
            }),
        })
    }

    /// That of a bout: of a case, where the motion is a sinusoid under a block at rest.
    fn chattering_time(&self, oracle: &dyn Oracle, request: Option<&Request>, bout: &Bout) -> ChatteringTime {
        let complete = match bout.outcome {
            _ if bout.is_unsure() => None,
            BoutEnd::Complete { .. } => Some(true),
            BoutEnd::Overturned | BoutEnd::Cut => Some(false),
            _ => None,
        };
        let tau = (complete == Some(true)).then_some(bout.duration - bout.start);
        // From the threshold on moving ground it is that of the case, for which the oracle claims an error too.
        let shaken = bout.flights.iter().all(|flight| flight.departure.ground == Ground::Shaking);
        let of_case = request.filter(|_| bout.start == 0.0 && shaken);
        let of_case = of_case.and_then(|request| request.case.with_max_impacts(IMPACTS).ok());
        let claimed = of_case.and_then(|case| ask(oracle, &case).into_observed()?.chattering_time);
        // What the rounding of the scene's own numbers does is not known to the oracle.
        let numbers = if request.is_some_and(|request| request.rounding > 0.0) { bout.conditioning } else { 0.0 };
        let uncertainty = match bout.outcome {
            BoutEnd::Complete { uncertainty } => {
                Some(claimed.map_or(uncertainty, |claimed| claimed.uncertainty + numbers))
            }
            _ => None,
        };
        let relative = tau.zip(uncertainty).map(|(tau, uncertainty)| uncertainty / tau);
        ChatteringTime {
            seconds: tau.map(|tau| tau / self.block.frequency_parameter()),
            tau_ch: tau,
            relative_uncertainty: relative,
            meets_tolerance: relative.map(|relative| relative <= self.ask.tolerance),
            complete,
            after_the_motion: !shaken,
            ending: bout.ending(),
        }
    }
}
