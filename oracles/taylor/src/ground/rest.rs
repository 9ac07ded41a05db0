//! Whether infinitely many impacts follow one and accumulate while the ground still holds the block down, and when they do, between two bounds.
//!
//! On a window of time let `m <= G <= M` for each side. Next to the base the acceleration towards it is `K G` but for at most `2 κ K u`, with
//! `κ = α/(sin α cos α)`, `0 < G < 2` and `u < 1`; so it is between `K m'` and `K M'`, with `m' = m - 2 κ u`, `M' = M + 2 κ u` and `u` the largest rotation. A
//! flight that leaves with `v` then rises to `v²/(2 K m')` at most, lasts between `2v/(K M')` and `2v/(K m')`, and lands with `v` times a factor between
//! `sqrt(m'/M')` and its inverse. Where the factors of both sides together are below `1/η²`, all later flights are slower, and the times that are left are sums of
//! geometric series; all of it is proven if their upper bound fits into the window.
// `!(x < y)` is meant: it also holds where `x` is not a number.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use contract::Motion;

use super::motion::{Piece, piece};
use crate::equation::Block;

/// How often the window is fitted to what is left.
const FITS: usize = 12;
/// No window is over more pieces than this.
const MOST_PIECES: usize = 64;

/// The least and the most that is left until rest after an impact at `time` which the block leaves to `side` with `speed`; `None` where that is not proven.
pub fn time_left(block: &Block, motion: &Motion, (side, time, speed): (f64, f64, f64)) -> Option<(f64, f64)> {
    let [now, ..] = piece(motion, time).powers;
    let (own, other) = (1.0 + side * now, 1.0 - side * now);
    if !(own > 0.0 && other > 0.0 && speed > 0.0) {
        return None;
    }
    let eta = block.eta;
    let mut window = 2.0 * speed * (1.0 / own + eta / other) / ((1.0 - eta * eta) * block.slope);
    for _ in 0..FITS {
        // A little wider than it has to be, so that it is not fitted for ever.
        window *= 1.0 + 1e-3;
        let (low, high) = between(motion, time, window)?;
        let (own, other) = if side > 0.0 {
            ((1.0 + low, 1.0 + high), (1.0 - high, 1.0 - low))
        } else {
            ((1.0 - high, 1.0 - low), (1.0 + low, 1.0 + high))
        };
        let (least, most) = left(block, own, other, speed)?;
        if most <= window {
            return Some((least, most));
        }
        window = most;
    }
    None
}

fn left(block: &Block, own: (f64, f64), other: (f64, f64), v: f64) -> Option<(f64, f64)> {
    let (eta, slope) = (block.eta, block.slope);
    let kappa = 1.0 / (slope * block.cos_alpha);
    // The first flights rise highest; with half of the pull left to them they rise no higher than this.
    let weakest = own.0.min(other.0);
    let highest = v * v / (slope * weakest) * 1.1;
    let bend = 2.0 * kappa * highest;
    let with = |(least, most): (f64, f64)| (least - bend, most + bend);
    let ((own_least, own_most), (other_least, other_most)) = (with(own), with(other));
    if !(own_least >= 0.55 * weakest
        && other_least >= 0.55 * weakest
        && highest < 1.0
        && own_most < 2.0
        && other_most < 2.0)
    {
        return None;
    }
    let (own_gain, other_gain) = ((own_most / own_least).sqrt(), (other_most / other_least).sqrt());
    // The second flight may leave with more than the first one where the side is stronger; it has to rise no higher either.
    if !(eta * own_gain <= 1.0 && eta * eta * own_gain * other_gain < 1.0) {
        return None;
    }
    let upper =
        2.0 * v / slope * (1.0 / own_least + eta * own_gain / other_least) / (1.0 - eta * eta * own_gain * other_gain);
    let lower =
        2.0 * v / slope * (1.0 / own_most + eta / own_gain / other_most) / (1.0 - eta * eta / (own_gain * other_gain));
    // What rounding does to the formulas.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    Some((lower * (1.0 - ROUNDING), upper * (1.0 + ROUNDING)))
}

/// Between what `f` is over a window; `None` if it jumps in it, or is in too many pieces.
fn between(motion: &Motion, time: f64, window: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut from, mut last): (f64, Option<f64>) = (time, None);
    for _ in 0..MOST_PIECES {
        let Piece { powers: [value, slope, ..], end, curvature, .. } = piece(motion, from);
        // A jump is more than rounding.
        if last.is_some_and(|last| (last - value).abs() > 1e-12 * (1.0 + value.abs())) {
            return None;
        }
        let length = (end - from).min(time + window - from).max(0.0);
        let (straight, bow) = (value + slope * length, 0.5 * curvature * length * length);
        low = low.min(value).min(straight - bow);
        high = high.max(value).max(straight + bow);
        if end >= time + window {
            let rounding = 4.0 * f64::EPSILON * (1.0 + value.abs());
            return Some((low - rounding, high + rounding));
        }
        last = match motion {
            Motion::Record(_) => Some(straight),
            // A sum or a wavelet ends, and what comes then is another motion.
            Motion::Sinusoids(_) | Motion::Ricker(_) => return None,
        };
        from = end;
    }
    None
}
