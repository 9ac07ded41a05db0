//! Following a flight of any length, in steps that cannot pass a root.
//!
//! On a step from `(u, u')` the acceleration is at least some `m`, so `u` is at least `u + u' d + m d²/2`, and no impact comes
//! before the first root of that parabola. Stepping to it again and again approaches the first impact from the left, and only
//! the first; near a transversal impact the steps converge quadratically, near a grazing one they halve.

use crate::{
    forcing::Forcing,
    takeoff::{Landing, Outcome, Takeoff},
    twofold::Twofold,
};

/// A flight takes more steps than this only if its horizon is thousands of periods away.
const STEPS: usize = 1_000_000;

/// How a march ends.
pub(crate) enum End {
    /// At the base, after the time `elapsed`.
    Base {
        elapsed: f64,
        /// `u` and `u'`.
        state: (f64, f64),
        /// `u''` without what the rotation adds.
        acceleration: f64,
        /// The largest `|u| + |u'|` on the way.
        size: f64,
    },
    /// In the air past the horizon.
    Aloft,
    /// Where no return is possible, after this time.
    Overturned(f64),
    /// Nowhere.
    Stuck,
}

/// Follows the flight to its first impact, its horizon, or past the point of no return.
pub(crate) fn fly(takeoff: Takeoff) -> Outcome {
    match follow(&takeoff, (0.0, takeoff.speed)) {
        End::Base { elapsed, state, acceleration, size } => {
            Outcome::Landing(land(&takeoff, elapsed, state, acceleration, size))
        }
        End::Aloft => Outcome::Aloft,
        End::Overturned(_) => Outcome::Overturned,
        End::Stuck => Outcome::Stuck,
    }
}

/// Follows a flight that starts anywhere, with `u` and `u'` as in `state`: on the base, at rest on it where the forcing pushes it away, or in
/// the air.
pub(crate) fn follow(takeoff: &Takeoff, mut state: (f64, f64)) -> End {
    let Takeoff { excitation, flow, time, sign, forcing, horizon, .. } = *takeoff;
    let (amplitude, omega) = (excitation.amplitude, excitation.omega);
    let longest = 0.5 * flow.longest();

    let mut elapsed = Twofold::ZERO;
    let mut here = forcing;
    let at_rest = state == (0.0, 0.0);
    if at_rest {
        let step = clear(&forcing, amplitude, omega).min(longest);
        state = flow.advance(step, state, &here);
        elapsed = elapsed.plus(step);
        here = excitation.forcing(sign, excitation.half_phase(time.plus(step)));
    }
    // Just above the threshold a block at rest first moves in a time of its own, however short: what the forcing does later must not shorten its steps.
    let pushed = at_rest && forcing.acceleration > 0.0;

    let mut size: f64 = 0.0;
    for _ in 0..STEPS {
        let (rotation, velocity) = state;
        size = size.max(rotation.abs() + velocity.abs());
        // (u + u')' = u + u' - 1 - i f is positive from here on, so u + u' stays above 1 + a: u cannot come down through zero, nor can it once the ground
        // is at rest, where 1 is enough. A step may have gone past the horizon, and what comes after that is not known.
        if rotation + velocity > 1.0 + amplitude && elapsed.high <= horizon {
            return End::Overturned(elapsed.value());
        }
        if elapsed.high >= horizon {
            return End::Aloft;
        }
        let reach = if pushed { longest.min(2.0 * elapsed.high) } else { longest };
        let step = safe_step(state, here.acceleration, reach, |step| {
            (omega * amplitude).min((-here.jerk).max(0.0) + omega * omega * amplitude * step)
        });
        let arrived = rotation <= 0.0 && elapsed.high > 0.0;
        if arrived || step <= 0.25 * f64::EPSILON * elapsed.high {
            return End::Base { elapsed: elapsed.value(), state, acceleration: here.acceleration, size };
        }
        state = flow.advance(step, state, &here);
        elapsed = elapsed.plus(step);
        here = excitation.forcing(sign, excitation.half_phase(time.plus(elapsed.high).plus(elapsed.low)));
    }
    End::Stuck
}

/// How long a block is off its base for sure that starts from rest, by `u'''' >= -Q` with `Q = 1 + |ω² - 1| a`.
fn clear(forcing: &Forcing, amplitude: f64, omega: f64) -> f64 {
    let Forcing { acceleration, jerk, .. } = *forcing;
    let bound = 1.0 + (omega * omega - 1.0).abs() * amplitude;
    // u >= b s²/2 + j s³/6 - Q s⁴/24. If it is pushed ever harder, half of 4 j/Q, where the last two are 0, is before the first root;
    let growing = 2.0 * jerk / bound;
    // and if it is pushed at all, so is where the last two take off a third of the first each.
    let pushed = if acceleration > 0.0 {
        let turning = if jerk < 0.0 { -acceleration / jerk } else { f64::INFINITY };
        turning.min(2.0 * (acceleration / bound).sqrt())
    } else {
        0.0
    };
    growing.max(pushed)
}

/// A step before which there is no root: to the first root of the parabola under `u`, or `longest`. `fall` bounds how fast the
/// forcing falls during a step of a given length.
fn safe_step((rotation, velocity): (f64, f64), acceleration: f64, longest: f64, fall: impl Fn(f64) -> f64) -> f64 {
    let root = |lowest: f64| {
        let square = velocity * velocity - 2.0 * lowest * rotation;
        let denominator = -velocity + square.max(0.0).sqrt();
        if square < 0.0 || (lowest >= 0.0 && velocity >= 0.0) {
            f64::INFINITY
        } else if velocity > 0.0 {
            (velocity + square.sqrt()) / -lowest
        } else if denominator > 0.0 {
            2.0 * rotation / denominator
        } else {
            0.0
        }
    };
    // A parabola that is too high gives a length, on which a parabola that is low enough can be drawn.
    let length = root(acceleration).min(longest);
    root(acceleration - length * fall(length)).min(length)
}

/// The impact at the end of the march, on which `|u| + |u'|` was `size` at the most. The flight is long, so what a short one must have by
/// itself is had by difference.
fn land(takeoff: &Takeoff, interval: f64, (_, velocity): (f64, f64), acceleration: f64, size: f64) -> Landing {
    let velocity = velocity.min(0.0);
    let (by_speed, by_time) = takeoff.derivatives(interval, velocity, acceleration);
    // Measured, as all that is made of it.
    let error = 4.0 * size * interval.cosh();
    Landing {
        interval,
        loss: velocity + takeoff.speed,
        velocity,
        acceleration,
        off_parabola: acceleration - 2.0 * velocity / interval,
        by_speed,
        by_time,
        rounding: (error / interval, error),
    }
}

#[cfg(test)]
mod tests;
