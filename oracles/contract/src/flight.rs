use crate::{Estimate, Loss};

/// A method that follows one flight at a time, from anywhere: what whole responses are made of, with what a [`Case`](crate::Case) does not
/// have (a motion of the ground that starts above the threshold, or ends).
///
/// It is of one case: its model, amplitude, frequency and restitution.
pub trait FlightSolver: Send + Sync {
    /// Where the flight ends, if it does within `horizon` (a duration in `τ`, above 0).
    ///
    /// Until the horizon the ground does what the departure says; what it does after it is not known, but that it may come to rest. So nothing is
    /// concluded from a motion of the ground beyond the horizon, and [`Arrival::Overturned`] has to hold for a ground that stops there as for one that
    /// goes on.
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival;

    /// The rotation and the velocity, both counted away from the base (`iφ` and `iφ'`), a time `s` after the departure, which is not
    /// after the arrival.
    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64);

    /// Whether it is certain that infinitely many impacts follow this departure from the base and accumulate while the ground still holds the
    /// block down, provided that the ground goes on as it does.
    fn rests(&self, departure: &Departure) -> bool;

    /// How long it takes until infinitely many impacts have accumulated after this departure from the base, on ground that stays at rest: the whole
    /// sum of free rocking, which does not have to be followed. `None` where they don't accumulate, on shaking ground, and from a solver that only
    /// flies.
    fn time_to_rest(&self, _departure: &Departure) -> Option<Estimate> {
        None
    }
}

/// What the ground does during a flight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ground {
    /// It shakes as the case says.
    Shaking,
    /// It has come to rest, and the block rocks freely.
    Still,
}

/// How a flight starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure {
    /// What the ground does.
    pub ground: Ground,
    /// The time `τ` since the ground acceleration reached the threshold to the positive side, growing: 0 is the initiation of every case.
    /// Without meaning on still ground.
    pub time: f64,
    /// `i`, 1 or -1: the sign of the rotation.
    pub side: f64,
    /// The rotation away from the base, `iφ >= 0`: 0 after an impact, and from rest.
    pub rotation: f64,
    /// The velocity away from the base, `iφ'`: 0 from rest, above 0 after an impact, of either sign in the air.
    pub velocity: f64,
}

/// How a flight ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arrival {
    /// With an impact.
    Impact {
        /// How long the flight lasted, in `τ`.
        interval: f64,
        /// The speed `|φ'|` just before the impact.
        speed: f64,
    },
    /// In the air at the horizon.
    Aloft {
        /// The rotation away from the base.
        rotation: f64,
        /// The velocity away from the base.
        velocity: f64,
    },
    /// Past the point from which no return is possible, so long after the departure, which is not after the horizon: whether the ground goes on as it
    /// does or comes to rest at any time from then on.
    Overturned {
        /// When that is certain, in `τ` after the departure.
        after: f64,
    },
    /// It was lost.
    Lost(Loss),
}
