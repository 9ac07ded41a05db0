//! What is known of a block between two flights, and its next flight.

use crate::{
    directed::Directed,
    excitation::{Excitation, HalfPhase},
    flight::{From, Outcome, Takeoff},
    interval::Interval,
    parallelogram::Parallelogram,
    piece::Motion,
    pull::Side,
};

/// The block and the ground.
pub struct Scene<'a, F> {
    pub motion: &'a Motion<F>,
    pub excitation: &'a Excitation<F>,
    /// Both in doubles.
    pub coarse_motion: Motion<f64>,
    pub coarse_excitation: Excitation<f64>,
    pub eta: f64,
}

/// How a flight ends, with what is known of the block then.
pub enum Flown<F, K> {
    /// With an impact after this interval.
    Landed(Interval<F>, K),
    /// It is in the air at the horizon.
    Aloft,
    /// No return is possible.
    Overturned,
    /// Not with these digits.
    Unclear,
}

/// Where in time the block is, and how it takes off next.
pub enum Known<F> {
    /// Time and speed, each by itself.
    Apart { time: Interval<F>, phase: HalfPhase<F>, from: From<F> },
    /// Both together.
    Together(Parallelogram<F>),
}

impl<'a, F: Directed> Scene<'a, F> {
    pub fn new(motion: &'a Motion<F>, excitation: &'a Excitation<F>, (omega, eta): (f64, f64)) -> Self {
        let coarse_excitation = excitation.convert::<f64>();
        let coarse_motion = Motion::new(&coarse_excitation.amplitude, omega, None);
        Self { motion, excitation, coarse_motion, coarse_excitation, eta }
    }
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

impl<F, K> Flown<F, K> {
    fn map<L>(self, known: impl FnOnce(K) -> L) -> Flown<F, L> {
        match self {
            Self::Landed(interval, landed) => Flown::Landed(interval, known(landed)),
            Self::Aloft => Flown::Aloft,
            Self::Overturned => Flown::Overturned,
            Self::Unclear => Flown::Unclear,
        }
    }
}
