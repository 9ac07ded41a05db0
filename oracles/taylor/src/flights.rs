//! Flights one at a time, from anywhere: what whole responses are made of.

use contract::{Arrival, Departure, Estimate, FlightSolver, Ground};

use crate::{
    equation::Block,
    flight::{Course, Landing, follow},
    still::Still,
};

/// The flights of one block under one motion of the ground.
pub(crate) struct Flights(pub Block);

impl Flights {
    fn course(&self, departure: &Departure, horizon: f64) -> Course {
        let Departure { time, side, rotation, velocity, .. } = *departure;
        follow(&self.block(departure), side, time, (rotation, velocity), horizon)
    }

    fn block(&self, departure: &Departure) -> Block {
        match departure.ground {
            Ground::Shaking => self.0,
            Ground::Still => self.0.on_still_ground(),
        }
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let Course { landing, elapsed, state: (rotation, velocity) } = self.course(departure, horizon);
        match landing {
            Landing::Impact { interval, speed, .. } => Arrival::Impact { interval, speed },
            Landing::Flying => Arrival::Aloft { rotation, velocity },
            Landing::Overturned => Arrival::Overturned { after: elapsed },
            Landing::Lost(loss) => Arrival::Lost(loss),
        }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        // It is certain that the block overturns before it has: from there on it is followed piece by piece.
        let (mut from, mut left) = (*departure, s);
        loop {
            let Course { landing, elapsed, state: (rotation, velocity) } = self.course(&from, left);
            if !matches!(landing, Landing::Overturned) || elapsed >= left {
                return (rotation, velocity);
            }
            left -= elapsed;
            from = Departure { time: from.time + elapsed, rotation, velocity, ..from };
        }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.0.certainly_rests(departure.time, departure.velocity),
            // The energy φ'²/2 - (cos(α(1 - u)) - cos α)/α² is kept, so a flight lands as fast as it left, if it does not pass the balance u = 1.
            Ground::Still => departure.velocity < Still::new(self.0.alpha).fastest(),
        }
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        let free = departure.ground == Ground::Still && departure.rotation == 0.0;
        free.then(|| Still::new(self.0.alpha).time_to_rest(departure.velocity, self.0.eta)).flatten()
    }
}
