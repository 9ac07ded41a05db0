//! What sets a resting block off: a sinusoid, of which every lobe is the same but for its sign, or any other motion of the ground.

use std::sync::Arc;

use contract::{Arrival, Departure, Estimate, FlightSolver, Motion};

use super::lobes::{Lobe, Lobes};
use crate::measure::ground::{self, Push};

/// The motion of the ground under a response.
#[derive(Debug, Clone, PartialEq)]
pub enum Shaken {
    /// A sinusoid.
    Sinusoid(Lobes),
    /// Another one.
    Motion(Arc<Motion>),
}

impl Shaken {
    /// The lobe that a block at rest at `tau` starts to rock in, and when; `None` if nothing pushes it any more.
    pub fn departure(&self, tau: f64) -> Option<(Lobe, f64)> {
        match self {
            Self::Sinusoid(lobes) => Some(lobes.departure(tau)),
            Self::Motion(motion) => {
                let Push { time, side } = ground::next_push(motion, tau)?;
                Some((Lobe { start: time, mirror: -side }, time))
            }
        }
    }

    /// By when a block that comes to rest after `now` rests, both since the start of the lobe: then the ground pushes it off again.
    pub(super) fn latest(&self, lobe: Lobe, now: f64) -> f64 {
        match self {
            Self::Sinusoid(lobes) => ((now / lobes.half_period()).floor() + 1.0) * lobes.half_period(),
            Self::Motion(motion) => {
                ground::next_push(motion, lobe.start + now).map_or(f64::INFINITY, |push| push.time - lobe.start)
            }
        }
    }

    /// Half a period, of a sinusoid.
    pub fn half_period(&self) -> Option<f64> {
        match self {
            Self::Sinusoid(lobes) => Some(lobes.half_period()),
            Self::Motion(_) => None,
        }
    }

    /// A bound on the ground acceleration, in multiples of the threshold.
    pub(super) fn strongest(&self) -> f64 {
        match self {
            Self::Sinusoid(lobes) => lobes.amplitude(),
            Self::Motion(motion) => ground::strongest(motion),
        }
    }

    /// The ground acceleration at `tau`, in multiples of the threshold.
    pub fn acceleration(&self, tau: f64) -> f64 {
        match self {
            Self::Sinusoid(lobes) => lobes.acceleration(tau),
            Self::Motion(motion) => ground::acceleration(motion, tau),
        }
    }

    /// The solver as a bout sees it, whose times are counted from the start of its lobe, and whose signs are those of a lobe to the positive side. A sinusoid is
    /// the same in every lobe.
    pub(super) fn seen<'a>(&self, solver: &'a dyn FlightSolver, lobe: Lobe) -> Seen<'a> {
        let is_same = matches!(self, Self::Sinusoid(_));
        let (start, mirror) = if is_same { (0.0, 1.0) } else { (lobe.start, lobe.mirror) };
        Seen { solver, start, mirror }
    }
}

/// A solver whose times are counted from another moment, and its sides the other way round where the motion is a mirror image.
pub(super) struct Seen<'a> {
    solver: &'a dyn FlightSolver,
    start: f64,
    mirror: f64,
}

impl Seen<'_> {
    fn absolute(&self, departure: &Departure) -> Departure {
        Departure { time: self.start + departure.time, side: self.mirror * departure.side, ..*departure }
    }
}

impl FlightSolver for Seen<'_> {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        self.solver.fly(&self.absolute(departure), horizon)
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        self.solver.motion(&self.absolute(departure), s)
    }

    fn rests(&self, departure: &Departure) -> bool {
        self.solver.rests(&self.absolute(departure))
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        self.solver.time_to_rest(&self.absolute(departure))
    }
}
