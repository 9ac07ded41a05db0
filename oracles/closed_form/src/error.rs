//! The error that is expected of each number: rounding errors, independent of each other, carried through the derivatives of the flights.

use crate::{
    UNIT,
    takeoff::{Landing, Takeoff},
};

/// The covariance of the errors after an impact, of the time (absolute) and of the speed (relative, for its square to stay in the range of a
/// double at any depth), in units of the unit round-off.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Errors {
    time: f64,
    both: f64,
    speed: f64,
}

/// What is claimed, as a multiple of the standard error. In `chattercheck verify --judge all` (531,252 numbers in 2,474 cases, to within a double of
/// the critical amplitudes and 1,044 impacts deep) no claim is less than 1.8 times the true error, and the median is 29 to 39 times it.
const SAFETY: f64 = 3.0;

/// Less than this share of its terms is not left when a variance cancels: it would be rounding errors of its own.
const RESOLUTION: f64 = 1e-15;

impl Errors {
    /// At initiation all is known.
    pub const NONE: Self = Self { time: 0.0, both: 0.0, speed: 0.0 };

    /// The errors after an impact, and the variance of that of the interval, relative.
    #[inline]
    pub fn after(&self, takeoff: &Takeoff, landing: &Landing) -> (Self, f64) {
        let Landing { interval, by_speed: (sinh, cosh), by_time: (tilt, turn), rounding: (rotation, loss), .. } =
            *landing;
        let slowness = -1.0 / landing.velocity.min(-f64::MIN_POSITIVE);
        // What errors of the time (absolute) and the speed (relative) make of the interval (relative), by u = 0; and what the flight adds.
        let per_interval = 1.0 / interval;
        let (by_time, by_speed) = (tilt * slowness, sinh * slowness * takeoff.speed);
        let (stretch_by_time, stretch_by_speed) = (by_time * per_interval, by_speed * per_interval);
        let own = 1.0 + rotation * slowness;
        // The same of the speed after the impact. Moving the impact by ds changes the speed by u'' ds; an error of its own place leaves out
        // what the parabola changes without changing the loss.
        let time = -slowness * (turn + landing.acceleration * by_time);
        let speed = -slowness * (cosh * takeoff.speed + landing.acceleration * by_speed);
        let moved = -slowness * landing.off_parabola * interval;
        let added = slowness * loss;

        let with_time = stretch_by_time * self.time + stretch_by_speed * self.both;
        let with_speed = stretch_by_time * self.both + stretch_by_speed * self.speed;
        let own = own * own;
        let interval_variance = resolved(
            stretch_by_time * with_time + stretch_by_speed * with_speed,
            stretch_by_time * stretch_by_time * self.time,
        ) + own;
        let after = Self {
            time: resolved(self.time + interval * (2.0 * with_time + interval * interval_variance), self.time),
            both: time * self.time
                + speed * self.both
                + interval * (time * with_time + speed * with_speed + moved * own),
            speed: resolved(
                time * (time * self.time + 2.0 * speed * self.both) + speed * speed * self.speed,
                time * time * self.time,
            ) + moved * moved * own
                + added * added,
        };
        (after, interval_variance)
    }

    /// What is claimed for the time (absolute), the interval and the speed (relative), from the variance of the interval and these.
    #[inline(always)]
    pub fn claims(&self, interval: f64) -> [f64; 3] {
        let variances = [self.time, interval, self.speed];
        // Without bound once a variance has left the range of a double.
        if !(self.time + interval + self.speed).is_finite() {
            return [f64::INFINITY; 3];
        }
        variances.map(|variance| SAFETY * UNIT * variance.sqrt())
    }
}

/// A variance, not below what rounding leaves of its largest term.
fn resolved(variance: f64, term: f64) -> f64 {
    // Not `max`, which would take a lost variance for one that is found.
    let least = RESOLUTION * term;
    if least > variance { least } else { variance }
}

#[cfg(test)]
mod tests;
