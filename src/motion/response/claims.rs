//! What is claimed for the impacts of a bout: what rounding does to them, as the same bout shows that is moved by some roundings.

use contract::Uncertainty;

use super::{Bout, Response};

/// What a flight leaves of rounding in its duration and its speed, relative.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// What multiple of the change is claimed. The motion is moved as a whole, and rounding moves each sample and each flight by itself: against the proofs of the first
/// impacts on records and pulses, errors came to 25 times the change.
pub(super) const MARGIN: f64 = 64.0;

impl Bout {
    /// The claims for its impacts, from the response that is moved: the time absolute, the interval and the velocity relative. Infinite for impacts that the
    /// other response has not.
    pub fn claims(&self, moved: &Response, eta: f64) -> Vec<Uncertainty> {
        let same = moved.bouts.iter().find(|other| other.is_beside(self));
        let mut others = same.into_iter().flat_map(|other| other.impact_list(eta));
        // The time at which it begins is a double, and the first flight is as much off as that is of it.
        let first = self.flights.first().map_or(1.0, |flight| flight.duration);
        let begin = ROUNDING + 4.0 * f64::EPSILON * self.begin() / first;
        // An impact is known no better than those before it: where two responses happen to agree, nothing is known.
        let mut worst = Uncertainty { time: 0.0, interval: begin, velocity: begin };
        let claim = |(time, interval, velocity): (f64, f64, f64)| {
            let unknown = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
            let (moved_time, moved_interval, moved_velocity) = others.next().unwrap_or(unknown);
            let relative = |value: f64, moved: f64| MARGIN * ((value - moved) / value).abs() + begin;
            worst = Uncertainty {
                time: worst.time.max(MARGIN * (time - moved_time).abs()),
                interval: worst.interval.max(relative(interval, moved_interval)),
                velocity: worst.velocity.max(relative(velocity, moved_velocity)),
            };
            // The time itself is a double, as is that at which it begins, and the intervals add up to it.
            let rounding = 4.0 * f64::EPSILON * time + begin * (time - self.begin());
            Uncertainty { time: worst.time + rounding, ..worst }
        };
        self.impact_list(eta).map(claim).collect()
    }
}
