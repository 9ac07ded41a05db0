//! Flights one at a time, from anywhere: what whole responses are made of.

use contract::{Arrival, Case, Departure, Estimate, FlightSolver, Ground, Loss};

use crate::{
    flow::Flow,
    forcing::Excitation,
    march::{self, End},
    rest::ProofOfRest,
    still,
    takeoff::{Outcome, Takeoff},
    twofold::Twofold,
};

/// The flights of one case.
pub(crate) struct Flights {
    excitation: Excitation,
    flow: Flow<f64>,
    shaken: ProofOfRest,
    eta: f64,
}

impl Flights {
    pub fn new(case: &Case) -> Self {
        let excitation = Excitation::new(case.epsilon(), case.omega());
        Self {
            flow: Flow::new(case.omega()),
            shaken: ProofOfRest::new(&excitation, case.eta()),
            eta: case.eta(),
            excitation,
        }
    }

    fn takeoff(&self, departure: &Departure, horizon: f64) -> Takeoff<'_> {
        let time = Twofold { high: departure.time, low: 0.0 };
        Takeoff {
            excitation: &self.excitation,
            flow: &self.flow,
            time,
            sign: departure.side,
            speed: departure.velocity,
            forcing: self.excitation.forcing(departure.side, self.excitation.half_phase(time)),
            guess: None,
            horizon,
        }
    }

    /// From the base, with the accuracy that chattering needs however deep it is.
    fn chattering(&self, takeoff: Takeoff) -> Arrival {
        match takeoff.fly() {
            Outcome::Landing(landing) => Arrival::Impact { interval: landing.interval, speed: -landing.velocity },
            // Where the march is, the landing knows too little of the way.
            Outcome::Aloft | Outcome::Overturned | Outcome::Stuck => self.marched(&takeoff, 0.0),
        }
    }

    /// From anywhere else.
    fn marched(&self, takeoff: &Takeoff, rotation: f64) -> Arrival {
        match march::follow(takeoff, (rotation, takeoff.speed)) {
            End::Base { elapsed, state: (_, velocity), .. } => Arrival::Impact { interval: elapsed, speed: -velocity },
            End::Aloft => {
                let (rotation, velocity) = self.shaken_motion(takeoff, rotation, takeoff.horizon);
                Arrival::Aloft { rotation, velocity }
            }
            End::Overturned(after) => Arrival::Overturned { after },
            End::Stuck => Arrival::Lost(Loss::SolverFailed),
        }
    }

    /// In equal stretches that the series reach.
    fn shaken_motion(&self, takeoff: &Takeoff, rotation: f64, s: f64) -> (f64, f64) {
        let stretches = (s / (0.5 * self.flow.longest())).ceil().max(1.0);
        let stretch = s / stretches;
        let (mut state, mut here, mut elapsed) = ((rotation, takeoff.speed), takeoff.forcing, 0.0);
        loop {
            state = self.flow.advance(stretch, state, &here);
            elapsed += stretch;
            if elapsed + 0.5 * stretch >= s {
                return state;
            }
            here = self.excitation.forcing(takeoff.sign, self.excitation.half_phase(takeoff.time.plus(elapsed)));
        }
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let Departure { rotation, velocity, ground, .. } = *departure;
        if ground == Ground::Still {
            return still::fly((rotation, velocity), horizon);
        }
        let takeoff = self.takeoff(departure, horizon);
        // From the base with a speed, or from rest at the threshold itself.
        let chatters = rotation == 0.0 && (velocity > 0.0 || takeoff.forcing.acceleration <= 0.0);
        if chatters { self.chattering(takeoff) } else { self.marched(&takeoff, rotation) }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        match departure.ground {
            Ground::Still => still::motion((departure.rotation, departure.velocity), s),
            Ground::Shaking => self.shaken_motion(&self.takeoff(departure, s), departure.rotation, s),
        }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            // On still ground each flight lands as fast as it left.
            Ground::Still => departure.velocity < 1.0,
            Ground::Shaking => self.shaken.holds(&self.takeoff(departure, 0.0).forcing, departure.velocity),
        }
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        let free = departure.ground == Ground::Still && departure.rotation == 0.0;
        free.then(|| still::time_to_rest(departure.velocity, self.eta)).flatten()
    }
}
