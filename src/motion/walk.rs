//! The loop of events: from flight to flight, while the ground shakes and after it has come to rest.
//!
//! Whoever walks decides after each flight whether to go on: until the block rests, or its sum can be closed well enough.

use contract::{Arrival, Departure, FlightSolver, Ground};

use crate::measure::clock::Sum;

/// One flight, with the times on the clock of its walk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// When it starts.
    pub start: f64,
    /// When it ends: the very double with which the next one starts.
    pub end: f64,
    /// How long it lasts; more digits than the difference of the two.
    pub duration: f64,
    /// How it starts.
    pub departure: Departure,
    /// How it ends; in the air where the ground comes to rest, or the response ends.
    pub arrival: Arrival,
}

/// A block on its way.
pub struct Walk<'a> {
    solver: &'a dyn FlightSolver,
    eta: f64,
    clock: Sum,
    departure: Departure,
    /// When the ground stops.
    shaken: f64,
    /// When the walk ends at the latest.
    until: f64,
}

impl<'a> Walk<'a> {
    /// From rest at the time `start`, at which the ground pushes the block away from its negative side; the ground stops at `shaken`, and the walk ends at
    /// `until` at the latest.
    pub fn from_rest(solver: &'a dyn FlightSolver, eta: f64, start: f64, shaken: f64, until: f64) -> Self {
        let departure = Departure { ground: Ground::Shaking, time: start, side: -1.0, rotation: 0.0, velocity: 0.0 };
        Self::from(solver, eta, departure, shaken, until)
    }

    /// From anywhere; the ground stops at `shaken`, and the walk ends at `until` at the latest.
    pub fn from(solver: &'a dyn FlightSolver, eta: f64, departure: Departure, shaken: f64, until: f64) -> Self {
        Self { solver, eta, clock: Sum::at(departure.time), departure, shaken, until }
    }

    /// What time it is.
    pub fn now(&self) -> f64 {
        self.clock.value()
    }

    /// How the next flight starts, as far as the ground does not change before it.
    pub fn departure(&self) -> Departure {
        let ground = if self.is_still() { Ground::Still } else { self.departure.ground };
        Departure { ground, ..self.departure }
    }

    fn is_still(&self) -> bool {
        self.now() >= self.shaken
    }

    /// Until when the ground stays as it is, or the walk goes on.
    fn horizon(&self) -> f64 {
        if self.is_still() { self.until } else { self.shaken.min(self.until) }
    }

    /// How long the ground stays as it is, or the walk goes on, and whether the walk ends then.
    pub fn leg(&self) -> (f64, bool) {
        (self.horizon() - self.now(), self.horizon() >= self.until)
    }

    /// The next flight, as far as it goes on the ground as it is; `None` once the walk has ended. The walk goes on from where it ends; from one that
    /// overturns or is lost it does not, and starts it again.
    pub fn fly(&mut self) -> Option<Flight> {
        let start = self.now();
        let horizon = self.horizon();
        if start >= self.until {
            return None;
        }
        let departure = self.departure();
        let arrival = self.solver.fly(&departure, horizon - start);
        let duration = match arrival {
            Arrival::Impact { interval, speed } => {
                self.clock = self.clock.plus(interval);
                let (side, velocity) = (-departure.side, self.eta * speed);
                self.departure = Departure { time: self.now(), side, rotation: 0.0, velocity, ..departure };
                interval
            }
            Arrival::Aloft { rotation, velocity } => {
                self.soar((rotation, velocity));
                horizon - start
            }
            Arrival::Overturned { after } => after,
            Arrival::Lost(_) => 0.0,
        };
        let end = if matches!(arrival, Arrival::Overturned { .. }) { start + duration } else { self.now() };
        Some(Flight { start, end, duration, departure, arrival })
    }

    /// Goes on in the air to the end of this leg, where the block has the rotation and velocity given.
    pub fn soar(&mut self, (rotation, velocity): (f64, f64)) {
        let time = self.horizon();
        self.departure = Departure { time, rotation, velocity, ..self.departure() };
        self.clock = Sum::at(time);
    }
}
