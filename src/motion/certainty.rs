//! A change between two scales of a motion, proven from both sides: that something happens at one of them, and not at the other.

use std::sync::Arc;

use contract::{BoutEnd, Followed, Oracle};
use serde::Serialize;

use super::{
    criterion::{Crossing, Fate},
    response::OnMotion,
};
use crate::measure::ground;

/// Where between two scales of a motion something begins to happen, and ceases to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Changes {
    /// The smallest scale from which on it happens is between these: neighbouring doubles, or the nearest at which it is proven; `None` where it does not begin between the two.
    pub lower: Option<f64>,
    /// See `lower`.
    pub upper: Option<f64>,
    /// Whether it is proven that it happens at `upper` and does not at `lower`.
    pub certified: bool,
    /// Whether it happens at the smaller one of the two already.
    pub happens_at_from: bool,
    /// Every change, in order.
    pub changes: Vec<Crossing>,
}

impl Changes {
    /// The changes that were found, the first of them as the judge proves it, if there is one and it can.
    pub fn of(
        happens_at_from: bool,
        changes: Vec<Crossing>,
        judged: Option<(&dyn Oracle, &OnMotion)>,
        happens: fn(Fate) -> bool,
    ) -> Self {
        let found = changes.first().filter(|first| first.happens_above);
        let proven = judged.zip(found).and_then(|((judge, request), first)| certified(judge, request, first, happens));
        let first = proven.as_ref().or(found);
        Self {
            lower: first.map(|first| first.lower),
            upper: first.map(|first| first.upper),
            certified: proven.is_some(),
            happens_at_from,
            changes,
        }
    }
}

/// How far beside the change that was found a proof is tried, relative, one after the other: next to it all methods need ever more digits.
const BESIDE: [f64; 7] = [0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9];
/// A rest and a push that are nearer to each other than this are not told apart: when the ground pushes is known to rounding.
const APART: f64 = 1e-12;

/// The nearest two scales about a change at which the judge proves what the fate is; `None` if it proves none of those tried. That nothing else changes before is not
/// proven.
pub fn certified(
    judge: &dyn Oracle,
    request: &OnMotion,
    crossing: &Crossing,
    happens: fn(Fate) -> bool,
) -> Option<Crossing> {
    let Crossing { lower, upper, happens_above } = *crossing;
    let proven = |scale: f64, expected: bool| fate(judge, request, scale).map(happens) == Some(expected);
    let lower = BESIDE.iter().map(|by| lower * (1.0 - by)).find(|scale| proven(*scale, !happens_above))?;
    let upper = BESIDE.iter().map(|by| upper * (1.0 + by)).find(|scale| proven(*scale, happens_above))?;
    Some(Crossing { lower, upper, happens_above })
}

/// What is proven to happen at a scale, if all of it is.
fn fate(judge: &dyn Oracle, request: &OnMotion, scale: f64) -> Option<Fate> {
    let motion = Arc::new(request.motion.scaled(scale).ok()?);
    let asked = Followed { start: request.start, until: request.until, most_impacts: 1 };
    let mut fate = Fate::default();
    for bout in judge.bouts_on(&request.body, &motion, &asked).ok()? {
        match bout.end {
            BoutEnd::Rest(at) => {
                let Some(gap) = ground::next_gap(&motion, bout.begin.value, at.value) else { continue };
                let Some(push) = ground::next_push(&motion, gap) else { continue };
                let apart = at.uncertainty + APART * (1.0 + push.time);
                if (push.time - at.value).abs() <= apart {
                    return None;
                }
                fate.incomplete |= push.time < at.value;
            }
            BoutEnd::Overturned => fate = Fate { incomplete: true, overturned: true },
            BoutEnd::Aloft => fate.incomplete = true,
            BoutEnd::Undecided => return None,
        }
    }
    Some(fate)
}
