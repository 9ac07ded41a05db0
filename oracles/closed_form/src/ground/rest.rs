//! Whether infinitely many impacts follow one and accumulate while the ground still holds the block down, and when they do, between two bounds.
//!
//! On a window of time let `m <= c <= M` for each side, and `j` bound the growth of its pull. A flight that leaves with `v` lasts between
//! `2 atanh(v/M)` and `2 atanh(v/m)`, as against a constant pull, and lands with at most `κ v`, `κ = 1 + j 2(A coth A - 1)/v`, `A = atanh(v/m)`, by the identity
//! `w - v = ∫ [c(m + x) - c(m - x)] cosh x dx / sinh a` about the middle of the flight. Both hold for all later flights, which are slower once
//! `q = η² κ κ' < 1`; then the times that are left are sums of geometric series, and all of it is proven if their upper bound fits into the window.
// `!(x < y)` is meant: it also holds where `x` is not a number.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use super::pull::{Change, Ground};

/// What bounds the pull on one side over a window.
#[derive(Debug, Clone, Copy)]
struct Side {
    least: f64,
    most: f64,
    /// The fastest that it grows, and that it falls.
    grows: f64,
    falls: f64,
}

/// How often the window is fitted to what is left.
const FITS: usize = 12;

/// The least and the most that is left until rest after an impact at `time` which the block leaves to `side` with `speed`; `None` where that is not proven.
pub fn time_left(ground: &Ground, eta: f64, (side, time, speed): (f64, f64, f64)) -> Option<(f64, f64)> {
    let (own, other) = (ground.level(side, time), ground.level(-side, time));
    if !(own > 0.0 && other > 0.0 && speed > 0.0) {
        return None;
    }
    let mut window = 2.0 * speed * (1.0 / own + eta / other) / (1.0 - eta * eta);
    for _ in 0..FITS {
        // A little wider than it has to be, so that it is not fitted for ever.
        window *= 1.0 + 1e-3;
        let own = Side::of(ground.changes(side, time, window), window, speed)?;
        let other = Side::of(ground.changes(-side, time, window), window, 0.0)?;
        let (least, most) = left(own, other, speed, eta)?;
        if most <= window {
            return Some((least, most));
        }
        window = most;
    }
    None
}

fn left(own: Side, other: Side, v: f64, eta: f64) -> Option<(f64, f64)> {
    if !(own.least > 0.0 && other.least > 0.0 && v < own.least) {
        return None;
    }
    let gain = |side: Side, v: f64, change: f64| {
        let a = (v / side.least).atanh();
        change * 2.0 * coth_gain(a) / v
    };
    let fastest = 1.0 + gain(own, v, own.grows.max(0.0));
    let slowest = (1.0 + gain(own, v, (-own.falls).min(0.0))).max(0.0);
    let (next_fast, next_slow) = (eta * fastest * v, eta * slowest * v);
    if !(next_fast < other.least) {
        return None;
    }
    let other_fastest = 1.0 + gain(other, next_fast, other.grows.max(0.0));
    let other_slowest = (1.0 + gain(other, next_fast, (-other.falls).min(0.0))).max(0.0);
    let (up, low) = (eta * eta * fastest * other_fastest, eta * eta * slowest * other_slowest);
    if !(up < 1.0) {
        return None;
    }
    let most = 2.0 * ((v / own.least).atanh() + (next_fast / other.least).atanh()) / (1.0 - up);
    let least = 2.0 * (v / own.most + next_slow / other.most) / (1.0 - low);
    // What rounding does to the formulas.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    Some((least * (1.0 - ROUNDING), most * (1.0 + ROUNDING)))
}

/// `a coth a - 1`, to the last digits of small `a`: `a²/3 - a⁴/45 + ...`, never less.
fn coth_gain(a: f64) -> f64 {
    if a < 0.1 { a * a / 3.0 } else { a / a.tanh() - 1.0 }
}

impl Side {
    /// Bounds over a window; `None` if the pull jumps in it, or may be as low as `low`.
    fn of(changes: impl Iterator<Item = Change>, window: f64, low: f64) -> Option<Self> {
        let mut changes = changes.peekable();
        let first = changes.peek()?;
        // What rounding may have done to the pull itself: a sum of terms of about 1.
        let size: f64 = 1.0 + first.waves.iter().map(|wave| wave.value.abs()).sum::<f64>();
        let rounding = 4.0 * f64::EPSILON * size;
        let slope = |change: &Change| change.slope + change.waves.iter().map(|wave| wave.rate).sum::<f64>();
        let (mut value, mut rate) = (first.level, 0.0);
        let mut bounds = Self { least: value, most: value, grows: 0.0, falls: 0.0 };
        let mut is_first = true;
        while let Some(change) = changes.next() {
            if !is_first && (change.level != 0.0 || !change.waves.is_empty()) || bounds.least <= low {
                return None;
            }
            rate += if is_first { slope(&change) } else { change.slope };
            is_first = false;
            let end = changes.peek().map_or(window, |next| next.at);
            let length = end - change.at;
            let bow = change.curvature * length;
            let straight = value + rate * length;
            bounds.least = bounds.least.min(straight - 0.5 * bow * length);
            bounds.most = bounds.most.max(straight + 0.5 * bow * length);
            bounds.grows = bounds.grows.max(rate + bow);
            bounds.falls = bounds.falls.max(bow - rate);
            value = straight;
        }
        Some(Self { least: bounds.least - rounding, most: bounds.most + rounding, ..bounds })
    }
}
