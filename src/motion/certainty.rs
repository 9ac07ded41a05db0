//! A change between two scales of a motion, proven from both sides: that something happens at one of them, and not at the other.

use std::sync::Arc;

use contract::{BoutEnd, Followed, Oracle};

use super::{
    criterion::{Crossing, Fate},
    response::OnMotion,
};
use crate::measure::ground;

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
