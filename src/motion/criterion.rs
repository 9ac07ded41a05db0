//! When it was certain that a block comes to rest, and how strong a motion has to be for it to miss its rest, or to fall.
//!
//! Impacts can accumulate only while the ground holds the block down, in a gap, `|f| < 1`. Chattering is complete if they do before the gap ends that they fall into.

use std::sync::Arc;

use contract::{Arrival, Decline, Departure, Estimate, Invalid, Motion, Oracle};

use super::response::{Bout, BoutEnd, OnMotion, Response};
use crate::measure::ground::{self, Push};

/// When it was certain that a bout ends with rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certain {
    /// From which impact on, the first being 1.
    pub impact: usize,
    /// When that was, `τ`.
    pub time: f64,
    /// The bounds on the time of rest that were proven then, `τ`; none on still ground, where it is the sum itself.
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
}

/// What the criterion says of each bout of a response.
///
/// # Errors
/// When `oracle`, which the response is of, declines.
pub fn criteria(oracle: &dyn Oracle, request: &OnMotion, response: &Response) -> Result<Vec<Criterion>, Decline> {
    let solver = oracle.flights_on(&request.body, &request.motion)?;
    let eta = request.body.eta();
    let of = |bout: &Bout| {
        let mut impact = 0;
        let certain = bout.flights.iter().find_map(|flight| {
            let Arrival::Impact { speed, .. } = flight.arrival else { return None };
            impact += 1;
            let time = bout.lobe.start + flight.end;
            let side = -bout.lobe.mirror * flight.departure.side;
            let departure = Departure { time, side, rotation: 0.0, velocity: eta * speed, ..flight.departure };
            let bounds = |left: Estimate| (time + left.value - left.uncertainty, time + left.value + left.uncertainty);
            solver.rests(&departure).then(|| Certain {
                impact,
                time,
                between: solver.time_to_rest(&departure).map(bounds),
            })
        });
        let rests = bout.outcome.is_rest();
        let gap_end = if rests { ground::next_push(&request.motion, bout.end()).map(|push| push.time) } else { None };
        Criterion { certain: certain.filter(|_| rests), gap_end, missed_a_gap: misses(&request.motion, bout) }
    };
    Ok(response.bouts.iter().map(of).collect())
}

/// Whether the ground pushed again after the first gap of a bout, before the block was at rest.
fn misses(motion: &Motion, bout: &Bout) -> bool {
    let Some(gap) = ground::next_gap(motion, bout.begin()) else { return false };
    ground::next_push(motion, gap).is_some_and(|Push { time, .. }| time < bout.end())
}

/// What may happen to a block that is shaken ever more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// Some chattering is incomplete: a gap is missed.
    Incomplete,
    /// It overturns.
    Overturned,
}

/// A scale of the motion between two neighbours of which it happens at one and not at the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The smaller one.
    pub lower: f64,
    /// The larger one.
    pub upper: f64,
    /// Whether it happens at the larger one; a block may survive a stronger shake.
    pub happens_above: bool,
}

/// In how many steps a range of scales is searched.
const STEPS: usize = 400;
/// A scale is narrowed down to this share of it.
const NARROW: f64 = 4.0 * f64::EPSILON;

/// Where between two scales of the motion it begins or ceases to happen: every change that shows at 400 scales in between, narrowed down to neighbouring doubles. By
/// the responses themselves: it is not certified.
///
/// # Errors
/// When the oracle declines, or a scale is out of range.
pub fn crossings(
    oracle: &dyn Oracle,
    request: &OnMotion,
    fate: Fate,
    (low, high): (f64, f64),
) -> Result<Vec<Crossing>, CrossingError> {
    let happens = |scale: f64| -> Result<bool, CrossingError> {
        let motion = Arc::new(request.motion.scaled(scale)?);
        let scaled = OnMotion { motion: Arc::clone(&motion), ..request.clone() };
        let response = Response::once_on_motion(oracle, &scaled)?;
        Ok(match fate {
            Fate::Overturned => response.bouts.iter().any(|bout| bout.outcome == BoutEnd::Overturned),
            Fate::Incomplete => response.bouts.iter().any(|bout| !bout.outcome.is_rest() || misses(&motion, bout)),
        })
    };
    let ratio = (high / low).powf(1.0 / STEPS as f64);
    let mut found = Vec::new();
    let (mut before, mut was) = (low, happens(low)?);
    for step in 1..=STEPS {
        let scale = if step == STEPS { high } else { low * ratio.powf(step as f64) };
        let is = happens(scale)?;
        if is != was {
            let (mut lower, mut upper) = (before, scale);
            while upper - lower > NARROW * upper {
                let middle = lower + 0.5 * (upper - lower);
                if middle <= lower || middle >= upper {
                    break;
                }
                if happens(middle)? == is { upper = middle } else { lower = middle }
            }
            found.push(Crossing { lower, upper, happens_above: is });
        }
        (before, was) = (scale, is);
    }
    Ok(found)
}

/// Why no crossing can be found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CrossingError {
    /// A scale is out of range.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The method declines.
    #[error("{0}")]
    Declined(Decline),
}

impl From<Decline> for CrossingError {
    fn from(decline: Decline) -> Self {
        Self::Declined(decline)
    }
}
