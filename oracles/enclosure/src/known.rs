//! What is known of a block between two flights, and its next flight.

use crate::{
    directed::Directed,
    excitation::HalfPhase,
    flight::{From, Outcome, Takeoff},
    interval::Interval,
    parallelogram::Parallelogram,
    pull::Side,
    scene::{Flown, Scene},
};

/// Where in time the block is, and how it takes off next.
pub enum Known<F> {
    /// Time and speed, each by itself.
    Apart { time: Interval<F>, phase: HalfPhase<F>, from: From<F> },
    /// Both together.
    Together(Parallelogram<F>),
}

impl<F: Directed> Known<F> {
    /// At initiation.
    pub fn initiation() -> Self {
        Self::Apart { time: Interval::zero(), phase: HalfPhase::start(), from: From::Threshold }
    }

    pub fn time(&self) -> Interval<F> {
        match self {
            Self::Apart { time, .. } => time.clone(),
            Self::Together(states) => states.time(),
        }
    }

    pub fn phase(&self, scene: &Scene<'_, F>) -> HalfPhase<F> {
        match self {
            Self::Apart { phase, .. } => phase.clone(),
            Self::Together(states) => states.phase(scene),
        }
    }

    /// The speed away from the base.
    pub fn speed(&self) -> Interval<F> {
        match self {
            Self::Apart { from: From::Impact(speed), .. } => speed.clone(),
            Self::Apart { .. } => Interval::zero(),
            Self::Together(states) => states.speed(),
        }
    }

    /// The next flight, on `side`, looked at for `horizon`.
    pub fn fly(&self, scene: &Scene<'_, F>, side: Side, horizon: &Interval<F>) -> Flown<F, Self> {
        let (time, phase, from) = match self {
            Self::Together(states) => return states.fly(scene, side, horizon).map(Self::Together),
            Self::Apart { time, phase, from } => (time, phase, from),
        };
        let takeoff = Takeoff { moment: phase.clone(), side, from: from.clone(), horizon: horizon.clone() };
        match scene.motion.fly(scene.excitation, takeoff) {
            Outcome::Landing { interval, speed, .. } if scene.motion.equation.is_linear() => {
                let states = Parallelogram::first(scene, &interval, &speed);
                Flown::Landed(interval, Self::Together(states))
            }
            Outcome::Landing { interval, speed, moment } => {
                let from = From::Impact(&Interval::exactly(scene.eta) * &speed);
                let landed = Self::Apart { time: time + &interval, phase: moment, from };
                Flown::Landed(interval, landed)
            }
            Outcome::Aloft => Flown::Aloft,
            Outcome::Overturned => Flown::Overturned,
            Outcome::Unclear => Flown::Unclear,
        }
    }
}
