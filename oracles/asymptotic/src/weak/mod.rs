//! Weak excitation by any motion of the ground: when a block comes to rest that a short push sets rocking.
//!
//! About the peak of a push `f = 1 + ε - κ x²/2 + f₃ x³/6 + f₄ x⁴/24 + ..` times scale with `(ε/κ)^(1/2)`, and the motion is the same for all:
//!
//! `τ_ch = (ε/κ)^(1/2) {X + X₃ f₃ ε^(1/2)/κ^(3/2) + ε [X₃₃ f₃²/κ³ + X₄ f₄/κ² + X_l/κ + X_e] + ..}`
//!
//! with functions of `η` alone. Instead of those the iteration of the paper's Section 3 runs for the push as it is, in the powers of `ε^(1/2)`, from its Taylor coefficients
//! where the rocking begins: at the threshold, or by a jump past it before the peak, at it or after it. A record has a kinked peak, and the powers are those of `ε`.
//!
//! It holds while the terms fall, the block rests before the ground pushes again, and the motion stays the function that it was at the start. Impacts are not listed.

mod flight;
mod ground;
mod push;
mod sum;
#[cfg(test)]
mod tests;
mod threshold;

use contract::{Body, Bout, BoutEnd, Decline, Estimate, Followed, Motion};

use push::Scaled;
use threshold::{Start, next_start, push_ends};

/// To what the law is carried, and what is accepted of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// Up to `ε^(order - 1)`, relative.
    pub order: usize,
    /// The largest claimed error of a chattering time, relative.
    pub tolerance: f64,
}

/// The largest order: more terms take long.
pub(crate) const MOST_ORDER: usize = 12;
/// How many bouts are followed.
const MOST_BOUTS: usize = 10_000;

/// The bouts of a block from rest, one after another as long as each is weak: the first that is not ends the list undecided.
///
/// # Errors
/// A [`Decline`] where not even the first bout is known.
pub(crate) fn bouts(body: &Body, motion: &Motion, asked: &Followed, wanted: Wanted) -> Result<Vec<Bout>, Decline> {
    if asked.start != (0.0, 0.0) {
        return Err(Decline::Unsupported { what: "blocks that move at the start" });
    }
    let eta = body.eta();
    for (field, value, range, allowed) in [
        ("eta", eta, 0.01..=0.99, "0.01 to 0.99 for the weak law"),
        ("order", wanted.order as f64, 1.0..=MOST_ORDER as f64, "1 to 12 on other motions than the sinusoid of a case"),
        ("until", asked.until.min(motion.duration()), 0.0..=1e9, "0 to 1e9 (in tau), for a motion without end"),
    ] {
        if !range.contains(&value) {
            return Err(Decline::OutOfRange { field, value, allowed });
        }
    }
    let mut bouts = Vec::new();
    let mut now = 0.0;
    while let Some(start) = next_start(motion, now, asked.until)? {
        let begin = Estimate { value: start.time, uncertainty: start.unsure() };
        let end = match rest(motion, &start, eta, wanted) {
            Ok(rest) if rest.value - rest.uncertainty > asked.until => BoutEnd::Aloft,
            Ok(rest) if rest.value + rest.uncertainty <= asked.until && bouts.len() < MOST_BOUTS => BoutEnd::Rest(rest),
            Err(why) if bouts.is_empty() => return Err(why),
            Ok(_) | Err(_) => BoutEnd::Undecided,
        };
        bouts.push(Bout { begin, side: -start.sign, impacts: Vec::new(), end });
        let BoutEnd::Rest(rest) = end else { break };
        now = rest.value;
    }
    Ok(bouts)
}

impl Start<'_> {
    /// What rounding may add to when it is.
    fn unsure(&self) -> f64 {
        let (_, slope) = self.piece.at(self.time);
        let crossing = if self.crosses { self.piece.unsure / slope.abs() } else { 0.0 };
        crossing + 2.0 * f64::EPSILON * self.time
    }
}

/// When the block rests again.
fn rest(motion: &Motion, start: &Start, eta: f64, wanted: Wanted) -> Result<Estimate, Decline> {
    let Scaled { push, powers, unit, unsure, until } = Scaled::new(motion, start, wanted.order)?;
    let why = |why: String| Decline::NotConvergent {
        why: format!("the push that begins at tau = {} is not weak: {why}", start.time),
    };
    let sum = sum::terms(push, eta).and_then(|terms| sum::sum(&terms, powers, wanted.order));
    let sum = sum.ok_or_else(|| why("the terms of the series do not fall".to_owned()))?;
    let (value, uncertainty) = (unit * sum.value, unit * (sum.uncertainty + unsure * sum.value));
    // Each so that what is not a number is declined as well.
    let is_near = uncertainty <= wanted.tolerance * value;
    if !is_near {
        let relative = uncertainty / value;
        return Err(why(format!("it claims a relative error of {relative:.1e}, {:.1e} is accepted", wanted.tolerance)));
    }
    let rest = Estimate { value: start.time + value, uncertainty: uncertainty + start.unsure() };
    let latest = rest.value + rest.uncertainty;
    let in_time = latest < until;
    if !in_time {
        return Err(why(format!("the motion changes at tau = {until}, before the block rests")));
    }
    let ends = if start.piece.is_straight() { None } else { Some(push_ends(start)) };
    // A line that falls below the threshold stays below it until it meets the other one.
    let from = ends.unwrap_or(rest.value);
    let pushed_before = from <= rest.value;
    if !pushed_before || next_start(motion, from, latest)?.is_some() {
        return Err(why("the ground pushes again before the block rests".to_owned()));
    }
    Ok(rest)
}
