//! A simulator of a rocking slender block, as somebody could have it: it knows nothing of the gate. What puts it under the gate is in `tests/gate.rs`.
//!
//! Each flight is a Taylor series in the time since its impact, `u'' = u - c`, with `u` the rotation away from the base and `c` the pull towards it.

use std::f64::consts::PI;

/// A block on shaking ground. Times are in units of `1/p`, rotations in units of `alpha`.
#[derive(Debug, Clone, Copy)]
pub struct Block {
    /// How far the amplitude of the ground acceleration is above that which starts the rocking, relative to it; above 0.
    pub excess: f64,
    /// The frequency of the ground, in units of `p`.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// Below this speed the block is taken to rest. 0 or less never is; `1e-250` is as good as never, and ends.
    pub rest_below: f64,
}

/// An impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// When, since the rocking began.
    pub time: f64,
    /// How long the flight before it lasted.
    pub interval: f64,
    /// The velocity after it; positive where the flight that follows is.
    pub velocity: f64,
}

/// What became of the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It rests, or will before the ground turns.
    Rest,
    /// It still rocked when the ground turned.
    Rocking,
    /// As many impacts as were wanted.
    Enough,
}

/// Terms of a series, and the longest time that it is used for, in units of `1/max(1, omega)`.
const TERMS: usize = 26;
const REACH: f64 = 0.5;

impl Block {
    /// The impacts in half a period of the ground, `most` of them at the most.
    pub fn rock(&self, most: usize) -> (Vec<Hit>, End) {
        let (mut hits, mut now, mut side, mut speed) = (Vec::new(), 0.0, -1.0, 0.0);
        let end = PI / self.omega;
        loop {
            let Some((interval, landing)) = self.flight(now, side, speed, end - now) else {
                return (hits, End::Rocking);
            };
            now += interval;
            (side, speed) = (-side, self.eta * landing);
            let last = hits.last().map_or(0.0, |hit: &Hit| hit.interval);
            hits.push(Hit { time: now, interval, velocity: side * speed });
            if speed < self.rest_below || hits.len() == most {
                // The intervals that are left are nearly a geometric series. It ends in time if the pull hardly changes meanwhile.
                let left = (last + interval) * self.eta * self.eta / (1.0 - self.eta * self.eta);
                let weakest = self.pull(now, 1.0)[0].min(self.pull(now, -1.0)[0]);
                let rests = left * self.pull(now, 1.0)[1].abs() < 0.1 * weakest;
                return (hits, if rests { End::Rest } else { End::Enough });
            }
        }
    }

    /// The first terms of the pull towards the base, `1 + side f`, with `f = cos(omega t) + r sin(omega t)` and `r` so that its peak is the amplitude.
    fn pull(&self, time: f64, side: f64) -> [f64; TERMS] {
        let r = (self.excess * (2.0 + self.excess)).sqrt();
        let phase = self.omega * time;
        let (half, cos_half) = (phase / 2.0).sin_cos();
        let (f, slope) = (phase.cos() + r * phase.sin(), r * phase.cos() - phase.sin());
        // Without the small difference of 1 and a cosine next to the start.
        let first =
            if side > 0.0 { 2.0 * cos_half * cos_half + r * phase.sin() } else { 2.0 * half * half - r * phase.sin() };
        let mut scale = side;
        std::array::from_fn(|k| {
            if k == 0 {
                return first;
            }
            scale *= self.omega / k as f64;
            scale * [f, slope, -f, -slope][k % 4]
        })
    }

    /// How long the flight lasts that begins at a time with a speed away from the base, and the speed of its landing, if it lands within `end`.
    fn flight(&self, start: f64, side: f64, speed: f64, end: f64) -> Option<(f64, f64)> {
        let (mut from, mut height, mut rate) = (0.0, 0.0, speed);
        while from < end {
            let pull = self.pull(start + from, side);
            let mut terms = [0.0; TERMS + 2];
            (terms[0], terms[1]) = (height, rate);
            for k in 0..TERMS {
                terms[k + 2] = (terms[k] - pull[k]) / ((k + 1) * (k + 2)) as f64;
            }
            let reach = (REACH / self.omega.max(1.0)).min(end - from);
            // From the base the height is divided by the time, so that the start is no root, and the shortest flight as right as any.
            let is_at_base = from == 0.0;
            let value = |s: f64| horner(&terms[usize::from(is_at_base)..], s);
            let step = if is_at_base && speed > 0.0 && pull[0] > 0.0 {
                (speed / pull[0]).min(reach / 8.0)
            } else {
                reach / 8.0
            };
            let (mut low, mut high) = (0.0, step);
            while value(high) > 0.0 && high < reach {
                (low, high) = (high, (high + step.max(high / 8.0)).min(reach));
            }
            if value(high) <= 0.0 {
                let landing = bisect(value, low, high);
                return Some((from + landing, -slope(&terms, landing)));
            }
            (height, rate, from) = (horner(&terms, reach), slope(&terms, reach), from + reach);
        }
        None
    }
}

fn horner(terms: &[f64], s: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * s + term)
}

fn slope(terms: &[f64], s: f64) -> f64 {
    (1..terms.len()).rev().fold(0.0, |sum, k| sum * s + k as f64 * terms[k])
}

/// The root between `low`, where `value` is positive, and `high`, where it is not.
fn bisect(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return high;
        }
        if value(middle) > 0.0 { low = middle } else { high = middle }
    }
}
