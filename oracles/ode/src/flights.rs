//! Flights one at a time, from anywhere: what whole responses are made of.

use core::cell::Cell;

use contract::{Arrival, Departure, FlightSolver, Ground, Loss};
use diffsol::OdeSolverMethod;

use crate::Solver;
use crate::equation::Motion;
use crate::flight::Rescaled;
use crate::launch::{Equations, Launch, Outcome};
use crate::run::{Task, rescaled};

/// The flights of one block under one motion of the ground. Each has a solver of its own.
pub(crate) struct SingleFlights {
    pub method: Solver,
    pub rtol: f64,
    pub eta: f64,
    pub motion: Motion,
}

/// One flight, and whether it is only watched, to a time that it is known to reach.
struct Single {
    launch: Launch,
    horizon: f64,
    watched: bool,
}

impl Task for Single {
    type Output = (Outcome, (f64, f64));

    fn run<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>>(self, mut flight: Rescaled<'_, S>) -> Self::Output {
        flight.follow(&self.launch, self.horizon, self.watched)
    }
}

impl SingleFlights {
    fn follow(&self, departure: &Departure, horizon: f64, watched: bool) -> (Outcome, (f64, f64)) {
        let Departure { ground, time, side, rotation, velocity } = *departure;
        let motion = match ground {
            Ground::Shaking => self.motion,
            Ground::Still => self.motion.on_still_ground(),
        };
        let launch = Launch { i: side, tau: time, rotation: side * rotation, velocity: side * velocity };
        let single = Single { launch, horizon, watched };
        let end = rescaled(self.method, &motion, self.rtol, &Cell::new(0), single);
        end.unwrap_or((Outcome::Lost(Loss::SolverFailed), (rotation, velocity)))
    }
}

impl FlightSolver for SingleFlights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let (outcome, (rotation, velocity)) = self.follow(departure, horizon, false);
        match outcome {
            Outcome::Impact { interval, speed } => Arrival::Impact { interval, speed },
            Outcome::TimeIsUp => Arrival::Aloft { rotation, velocity },
            Outcome::Overturned { after } => Arrival::Overturned { after },
            Outcome::Lost(loss) => Arrival::Lost(loss),
        }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        if s > 0.0 { self.follow(departure, s, true).1 } else { (departure.rotation, departure.velocity) }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.motion.comes_to_rest(self.eta, departure.time, departure.velocity),
            Ground::Still => self.motion.comes_to_rest_on_still_ground(departure.velocity),
        }
    }
}
