//! A block that falls: past the corner for good, and onto its side.

use contract::{Arrival, Departure, FlightSolver};

use crate::motion::walk::{Flight, Walk};

/// In what steps, and in how many, a falling block is followed.
const STEP: f64 = 0.05;
const MOST_STEPS: usize = 1000;
/// How often a time is halved that may be out of reach.
const MOST_HALVES: usize = 12;
/// How often a rotation that comes and goes is looked at, in units of the time in which the ground or the block changes.
const LOOKS: f64 = 0.1;

/// How far a block can turn, and where its fall ends.
pub(super) struct Fall<'a> {
    solver: &'a dyn FlightSolver,
    /// The rotation at which the side of the block lies on the ground, if that is known.
    lies_at: Option<f64>,
    /// `1 + a`, the strongest push of ground and gravity together.
    push: f64,
    /// The fastest growth of a rotation.
    rate: f64,
    /// How often a flight is looked at.
    look: f64,
}

/// How a flight that does not come back ends.
pub(super) struct Fallen {
    /// When.
    pub end: f64,
    /// The rotation at which it lies then, with its sign as that of the flight; `None` if it is not known to, or the response ends before.
    pub lies: Option<f64>,
}

impl<'a> Fall<'a> {
    /// Under a ground acceleration of no more than that, which changes no faster than that; with the slenderness of the nonlinear model.
    pub(super) fn new(
        solver: &'a dyn FlightSolver,
        (amplitude, omega): (f64, f64),
        alpha: Option<f64>,
        lies_at: Option<f64>,
    ) -> Self {
        let rate = alpha.map_or(1.0, |alpha| alpha.cos().sqrt().recip());
        let look = LOOKS / omega.max(rate);
        Self { solver, lies_at, push: 1.0 + amplitude, rate, look }
    }

    /// Follows a flight that was just flown to the side of the block or past its corner, and appends what it consists of; `None` from one that comes back or
    /// is in the air still.
    pub(super) fn follow(&self, walk: &mut Walk, flown: &Flight, flights: &mut Vec<Flight>) -> Option<Fallen> {
        if let Some(level) = self.lies_at
            && let Some(s) = self.reaches(flown, level)
        {
            return Some(self.down(flown, s, flights));
        }
        let Arrival::Overturned { after } = flown.arrival else { return None };
        if self.lies_at.is_none() && self.solver.motion(&flown.departure, after).0 >= 1.0 {
            return Some(self.passed(*flown, after, flights));
        }
        let level = self.lies_at.unwrap_or(1.0);
        let (mut flight, mut from) = (*flown, after);
        loop {
            let (leg, is_last) = walk.leg();
            let reached = self.first(&flight.departure, from, leg, level);
            if let Some(s) = reached {
                return Some(self.down(&flight, s, flights));
            }
            if !leg.is_finite() {
                // It stands on its corner as long as can be told.
                flights.push(flight);
                return Some(Fallen { end: flight.end, lies: None });
            }
            let state = self.solver.motion(&flight.departure, leg);
            walk.soar(state);
            flights.push(Flight { duration: leg, end: walk.now(), ..flight });
            if is_last {
                return Some(Fallen { end: walk.now(), lies: None });
            }
            flight = Flight {
                start: walk.now(),
                end: walk.now(),
                duration: 0.0,
                departure: walk.departure(),
                arrival: Arrival::Overturned { after: 0.0 },
            };
            from = 0.0;
        }
    }

    /// The flight ends a time `s` after its start, where the block lies or has passed its corner.
    fn down(&self, flight: &Flight, s: f64, flights: &mut Vec<Flight>) -> Fallen {
        let after = if let Arrival::Overturned { after } = flight.arrival { after.min(s) } else { s };
        let end = flight.start + s;
        flights.push(Flight { duration: s, end, arrival: Arrival::Overturned { after }, ..*flight });
        Fallen { end, lies: self.lies_at.map(|level| flight.departure.side * level) }
    }

    /// The flight is past the corner already when it is certain not to come back: it ends where it passed for the last time, which may be before the ground
    /// changed.
    fn passed(&self, mut flight: Flight, mut until: f64, flights: &mut Vec<Flight>) -> Fallen {
        loop {
            if let Some(s) = self.last(&flight.departure, until) {
                return self.down(&flight, s, flights);
            }
            match flights.pop() {
                Some(before) if matches!(before.arrival, Arrival::Aloft { .. }) => {
                    (flight, until) = (before, before.duration);
                }
                other => {
                    flights.extend(other);
                    return self.down(&flight, 0.0, flights);
                }
            }
        }
    }

    /// When in a flight the rotation first reaches a level.
    fn reaches(&self, flight: &Flight, level: f64) -> Option<f64> {
        let Flight { departure, duration, .. } = flight;
        let at = |s: f64| self.solver.motion(departure, s);
        let looks = (duration / self.look).ceil().max(1.0);
        let (mut look, mut here, mut state) = (0.0, 0.0, (departure.rotation, departure.velocity));
        while look < looks {
            // What is out of reach is not looked at.
            let skipped = (self.out_of_reach(state, level, duration - here) / duration * looks).floor();
            if skipped >= looks - look {
                return None;
            }
            if skipped >= 1.0 {
                look += skipped;
                here = duration * (look / looks);
                state = at(here);
            }
            look += 1.0;
            let there = duration * (look / looks);
            // The end of a flight is not always in reach of its motion.
            let next =
                if look == looks && matches!(flight.arrival, Arrival::Impact { .. }) { (0.0, -1.0) } else { at(there) };
            let top = if next.0 >= level {
                Some(there)
            } else if state.1 > 0.0 && next.1 < 0.0 {
                Some(bisected(here, there, |s| at(s).1 <= 0.0)).filter(|top| at(*top).0 >= level)
            } else {
                None
            };
            if let Some(top) = top {
                return Some(bisected(here, top, |s| at(s).0 >= level));
            }
            (here, state) = (there, next);
        }
        None
    }

    /// A time, of `most` at the most, for which the rotation stays below a level whatever the ground does.
    fn out_of_reach(&self, (rotation, velocity): (f64, f64), level: f64, most: f64) -> f64 {
        // u + 1 + a grows no faster than by u'' = rate² (u + 1 + a).
        let speed = velocity.max(0.0) / self.rate;
        let highest = |time: f64| {
            let grown = self.rate * time;
            (rotation + self.push) * grown.cosh() + speed * grown.sinh() - self.push
        };
        let halves = std::iter::successors(Some(most), |time| Some(0.5 * time)).take(MOST_HALVES);
        halves.into_iter().find(|time| highest(*time) < level).unwrap_or(0.0)
    }

    /// When after `from`, and not after `leg`, a falling block reaches a level.
    fn first(&self, departure: &Departure, from: f64, leg: f64, level: f64) -> Option<f64> {
        let above = |s: f64| self.solver.motion(departure, s).0 >= level;
        let mut here = from;
        for _ in 0..MOST_STEPS {
            let there = (here + STEP).min(leg);
            if above(there) {
                return Some(bisected(here, there, above));
            }
            if there >= leg {
                return None;
            }
            here = there;
        }
        None
    }

    /// When before `until` the block passed its corner for the last time; `None` if it was past it all the time.
    fn last(&self, departure: &Departure, until: f64) -> Option<f64> {
        let above = |s: f64| self.solver.motion(departure, s).0 >= 1.0;
        let mut there = until;
        while there > 0.0 {
            let here = (there - self.look).max(0.0);
            let is_above = if here == 0.0 { departure.rotation >= 1.0 } else { above(here) };
            if !is_above {
                return Some(bisected(here, there, above));
            }
            there = here;
        }
        None
    }
}

/// The first of the neighbouring doubles between which `holds` begins to, where it does not at `low` and does at `high`.
fn bisected(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if holds(middle) { high = middle } else { low = middle }
    }
}

#[cfg(test)]
mod tests {
    use contract::Ground;

    use super::*;

    /// A flight along `rotation = top - (s - peak)²`.
    struct Parabola {
        top: f64,
        peak: f64,
    }

    impl FlightSolver for Parabola {
        fn fly(&self, _: &Departure, horizon: f64) -> Arrival {
            let (rotation, velocity) = self.at(horizon);
            Arrival::Aloft { rotation, velocity }
        }

        fn motion(&self, _: &Departure, s: f64) -> (f64, f64) {
            self.at(s)
        }

        fn rests(&self, _: &Departure) -> bool {
            false
        }
    }

    impl Parabola {
        fn at(&self, s: f64) -> (f64, f64) {
            (self.top - (s - self.peak).powi(2), 2.0 * (self.peak - s))
        }
    }

    /// A side that is only just reached is reached, wherever that falls between two looks at the flight: at `peak - sqrt(top - level)`.
    #[test]
    fn a_side_that_is_touched_between_two_looks_is_not_missed() {
        let level = 2.0;
        for (peak, over, touches) in
            [(0.349, 1e-6, true), (0.351, 1e-6, true), (0.4, 1e-8, true), (0.45, 1e-4, true), (0.37, -1e-9, false)]
        {
            let flight = Parabola { top: level + over, peak };
            let (rotation, velocity) = flight.at(0.0);
            let departure = Departure { ground: Ground::Shaking, time: 0.0, side: 1.0, rotation, velocity };
            let flown = Flight { start: 0.0, duration: 1.0, end: 1.0, departure, arrival: flight.fly(&departure, 1.0) };
            let at = Fall::new(&flight, (1.5, 1.0), None, Some(level)).reaches(&flown, level);
            let expected = touches.then(|| peak - over.sqrt());
            let right = match (at, expected) {
                (Some(at), Some(expected)) => (at - expected).abs() < 1e-7,
                (at, expected) => at == expected,
            };
            assert!(right, "{at:?}, expected {expected:?}");
        }
    }
}
