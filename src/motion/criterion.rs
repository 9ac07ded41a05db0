//! When it was certain that a block comes to rest, and how strong a motion has to be for it to miss its rest, or to fall.
//!
//! Impacts can accumulate only while the ground holds the block down, in a gap, `|f| < 1`. Chattering is complete if they do before the gap ends that they fall into.

use std::sync::Arc;

use contract::{Arrival, Decline, Departure, Estimate, Invalid, Motion, Oracle};
use serde::Serialize;

mod told;

pub use told::Told;

use super::response::{Bout, BoutEnd, OnMotion, Response};
use crate::measure::ground::{self, Push};

/// When it was certain that a bout ends with rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certain {
    /// From which impact on, the first being 1.
    pub impact: usize,
    /// When that was, `τ`.
    pub time: f64,
    /// The bounds on the time of rest that hold from then on, `τ`: proven of an impact as it was found, and wider by what rounding may have done to the flights of the
    /// bout. None on still ground, where it is the sum itself.
    pub between: Option<(f64, f64)>,
}

/// What the criterion says of a bout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criterion {
    /// When rest was certain; `None` for a bout that ends in another way, or for a solver that proves nothing.
    pub certain: Option<Certain>,
    /// When the gap ends that the block comes to rest in, and it is pushed off again; `None` if nothing pushes it any more, or it does not come to rest.
    pub gap_end: Option<f64>,
    /// Whether a push came after the first gap of the bout, and before it ended: then its chattering was incomplete there.
    pub missed_a_gap: bool,
    /// What a series said of it that knows one impact alone.
    pub predicted: Option<Predicted>,
}

/// When a bout was going to end, from the first impact on that tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Predicted {
    /// Which impact, the first being 1.
    pub impact: usize,
    /// When that was, `τ`.
    pub time: f64,
    /// When the block was going to rest, `τ`.
    pub rest: Estimate,
}

/// What the criterion says of each bout of a response, and what `closing` says, which closes a sequence from one impact.
///
/// # Errors
/// When `oracle`, which the response is of, declines, or `closing` does.
pub fn criteria(
    (oracle, closing): (&dyn Oracle, &dyn Oracle),
    request: &OnMotion,
    response: &Response,
) -> Result<Vec<Criterion>, Decline> {
    let solver = oracle.flights_on(&request.body, &request.motion)?;
    let closure = closing.closure_on(&request.body, &request.motion)?;
    let eta = request.body.eta();
    let of = |bout: &Bout| {
        let certain = departures(bout, eta).find_map(|(impact, departure)| {
            let time = departure.time;
            let bounds = |left: Estimate| {
                let (rest, off) = (time + left.value, left.uncertainty + bout.conditioning);
                (rest - off, rest + off)
            };
            solver.rests(&departure).then(|| Certain {
                impact,
                time,
                between: solver.time_to_rest(&departure).map(bounds),
            })
        });
        let predicted = departures(bout, eta).find_map(|(impact, departure)| {
            let (left, time) = (closure.time_left(&departure).ok()?, departure.time);
            // It does not know how far off the impact is that it starts from.
            let rest = Estimate { value: time + left.value, uncertainty: left.uncertainty + bout.conditioning };
            Some(Predicted { impact, time, rest })
        });
        let rests = bout.outcome.is_rest();
        let gap_end = if rests { ground::next_push(&request.motion, bout.end()).map(|push| push.time) } else { None };
        Criterion {
            certain: certain.filter(|_| rests),
            gap_end,
            missed_a_gap: misses(&request.motion, bout),
            predicted: predicted.filter(|_| rests),
        }
    };
    Ok(response.bouts.iter().map(of).collect())
}

/// The departures of a bout after its impacts, with their numbers, the first being 1.
fn departures(bout: &Bout, eta: f64) -> impl Iterator<Item = (usize, Departure)> {
    let landed = bout.flights.iter().filter_map(move |flight| {
        let Arrival::Impact { speed, .. } = flight.arrival else { return None };
        let (time, side) = (bout.lobe.start + flight.end, -bout.lobe.mirror * flight.departure.side);
        Some(Departure { time, side, rotation: 0.0, velocity: eta * speed, ..flight.departure })
    });
    (1..).zip(landed)
}

/// Whether the ground pushed again after the first gap of a bout, before the block was at rest.
fn misses(motion: &Motion, bout: &Bout) -> bool {
    let Some(gap) = ground::next_gap(motion, bout.begin(), bout.end()) else { return false };
    ground::next_push(motion, gap).is_some_and(|Push { time, .. }| time < bout.end())
}

/// What happens to a block under a motion.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Fate {
    /// Some chattering is incomplete: a gap is missed, or the block does not come to rest any more.
    pub incomplete: bool,
    /// It overturns.
    pub overturned: bool,
}

/// A scale of the motion between two neighbours of which it happens at one and not at the other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Crossing {
    /// The smaller one.
    pub lower: f64,
    /// The larger one.
    pub upper: f64,
    /// Whether it happens at the larger one; a block may survive a stronger shake.
    pub happens_above: bool,
}

/// Where between two scales of a motion something begins to happen, or ceases to.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Crossings {
    /// What happens at the smallest scale.
    pub at_first: Fate,
    /// That some chattering is incomplete.
    pub incomplete: Vec<Crossing>,
    /// That the block overturns.
    pub overturned: Vec<Crossing>,
}

/// In how many steps a range of scales is searched.
const STEPS: usize = 400;
/// A scale is narrowed down to this share of it.
const NARROW: f64 = 4.0 * f64::EPSILON;

/// Every change between two scales of the motion that shows at 400 of them, narrowed down to neighbouring doubles. By the responses themselves: it is not certified.
///
/// # Errors
/// When the oracle declines, or a scale is out of range.
pub fn crossings(oracle: &dyn Oracle, request: &OnMotion, (low, high): (f64, f64)) -> Result<Crossings, CrossingError> {
    let scales = Scales { oracle, request };
    let (mut before, mut was) = (low, scales.fate(low)?);
    let mut found = Crossings { at_first: was, ..Crossings::default() };
    for scale in Scales::steps(low, high) {
        let is = scales.fate(scale)?;
        if is.incomplete != was.incomplete {
            found.incomplete.push(scales.narrow((before, scale), |fate| fate.incomplete, is.incomplete)?);
        }
        if is.overturned != was.overturned {
            found.overturned.push(scales.narrow((before, scale), |fate| fate.overturned, is.overturned)?);
        }
        (before, was) = (scale, is);
    }
    Ok(found)
}

/// The first scale from 1 to `most` at which some chattering is incomplete, among 400 of them, narrowed down to neighbouring doubles; `None` if it never is. Where it is at
/// 1 already both ends are 1.
///
/// # Errors
/// As [`crossings`].
pub fn critical_scale(oracle: &dyn Oracle, request: &OnMotion, most: f64) -> Result<Option<Crossing>, CrossingError> {
    let scales = Scales { oracle, request };
    if scales.fate(1.0)?.incomplete {
        return Ok(Some(Crossing { lower: 1.0, upper: 1.0, happens_above: true }));
    }
    let mut before = 1.0;
    for scale in Scales::steps(1.0, most) {
        if scales.fate(scale)?.incomplete {
            return scales.narrow((before, scale), |fate| fate.incomplete, true).map(Some);
        }
        before = scale;
    }
    Ok(None)
}

/// A motion at any scale.
struct Scales<'a> {
    oracle: &'a dyn Oracle,
    request: &'a OnMotion,
}

impl Scales<'_> {
    /// All but the first.
    fn steps(low: f64, high: f64) -> impl Iterator<Item = f64> {
        let ratio = (high / low).powf(1.0 / STEPS as f64);
        (1..=STEPS).map(move |step| if step == STEPS { high } else { low * ratio.powf(step as f64) })
    }

    fn fate(&self, scale: f64) -> Result<Fate, CrossingError> {
        let motion = Arc::new(self.request.motion.scaled(scale)?);
        let scaled = OnMotion { motion: Arc::clone(&motion), ..self.request.clone() };
        let bouts = Response::once_on_motion(self.oracle, &scaled)?.bouts;
        let is_lost = |bout: &&Bout| matches!(bout.outcome, BoutEnd::Lost(_) | BoutEnd::TooManyImpacts);
        if let Some(bout) = bouts.iter().find(is_lost) {
            return Err(CrossingError::Lost { scale, ending: bout.outcome.name() });
        }
        Ok(Fate {
            // A block that overturns has missed its gap too.
            incomplete: bouts.iter().any(|bout| !bout.outcome.is_rest() || misses(&motion, bout)),
            overturned: bouts.iter().any(|bout| bout.outcome == BoutEnd::Overturned),
        })
    }

    /// The change between two scales, of which it `happens` at the larger one or at the smaller.
    fn narrow(
        &self,
        (mut lower, mut upper): (f64, f64),
        happens: fn(Fate) -> bool,
        above: bool,
    ) -> Result<Crossing, CrossingError> {
        while upper - lower > NARROW * upper {
            let middle = lower + 0.5 * (upper - lower);
            if happens(self.fate(middle)?) == above { upper = middle } else { lower = middle }
        }
        Ok(Crossing { lower, upper, happens_above: above })
    }
}

/// Why no crossing can be found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CrossingError {
    /// A scale is out of range.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The sequence was lost: that is no fate.
    #[error("at {scale} times the motion the response ends with \"{ending}\", and nothing can be said")]
    Lost {
        /// At which scale.
        scale: f64,
        /// How.
        ending: &'static str,
    },
    /// The method declines.
    #[error("{0}")]
    Declined(Decline),
}

impl From<Decline> for CrossingError {
    fn from(decline: Decline) -> Self {
        Self::Declined(decline)
    }
}
