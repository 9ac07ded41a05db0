//! Flights one at a time, from anywhere: what whole responses are made of.

use core::cell::Cell;

use contract::{Arrival, Departure, FlightSolver, Ground, Loss};
use diffsol::OdeSolverMethod;

use crate::Solver;
use crate::equation::Motion;
use crate::flight::{Leg, Rescaled, Scaled};
use crate::forcing::Forcing;
use crate::launch::{Equations, Launch, Outcome};
use crate::run::{Task, rescaled};

/// The method and the tolerance of flights that have a solver of their own each.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Single {
    pub method: Solver,
    pub rtol: f64,
}

/// One flight, in the units that there are, as far as a leg of it.
struct One(Leg);

impl Task for One {
    type Output = (Outcome, (f64, f64));

    fn run<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>>(self, mut flight: Rescaled<'_, '_, S>) -> Self::Output {
        flight.follow(flight.units.get(), &self.0)
    }
}

impl Single {
    /// How a leg of a flight ends, and the rotation and the velocity away from the base then.
    pub fn follow(&self, scaled: Scaled<'_>, leg: Leg) -> (Outcome, (f64, f64)) {
        let end = rescaled(self.method, scaled, self.rtol, &Cell::new(0), One(leg));
        end.unwrap_or((Outcome::Lost(Loss::SolverFailed), (0.0, 0.0)))
    }
}

/// The flights of one case.
pub(crate) struct OnCase {
    pub single: Single,
    pub eta: f64,
    pub motion: Motion,
}

/// How a flight from here starts.
pub(crate) fn launch(departure: &Departure) -> Launch {
    let Departure { time, side, rotation, velocity, .. } = *departure;
    Launch { i: side, tau: time, rotation: side * rotation, velocity: side * velocity }
}

/// How a flight ends that ended so, with this rotation and velocity.
pub(crate) fn arrival(outcome: Outcome, (rotation, velocity): (f64, f64)) -> Arrival {
    match outcome {
        Outcome::Impact { interval, speed } => Arrival::Impact { interval, speed },
        Outcome::TimeIsUp => Arrival::Aloft { rotation, velocity },
        Outcome::Overturned { after } => Arrival::Overturned { after },
        Outcome::Lost(loss) => Arrival::Lost(loss),
    }
}

impl OnCase {
    fn follow(&self, departure: &Departure, lasts: f64, watched: bool) -> (Outcome, (f64, f64)) {
        let (shape, launch) = (self.motion.shape, launch(departure));
        let (forcing, strongest) = match departure.ground {
            Ground::Shaking => (self.motion.forcing(launch.i, launch.tau), self.motion.a),
            Ground::Still => (Forcing::still(launch.i), 0.0),
        };
        let leg = Leg { lasts, breaks: false, strongest: (!watched).then_some(strongest) };
        self.single.follow(Scaled::new(shape, forcing, &launch), leg)
    }
}

impl FlightSolver for OnCase {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let (outcome, state) = self.follow(departure, horizon, false);
        arrival(outcome, state)
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        if s > 0.0 { self.follow(departure, s, true).1 } else { (departure.rotation, departure.velocity) }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.motion.comes_to_rest(self.eta, departure.time, departure.velocity),
            Ground::Still => self.motion.shape.comes_to_rest_on_still_ground(departure.velocity),
        }
    }
}
