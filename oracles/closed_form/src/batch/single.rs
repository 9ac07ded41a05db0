//! The flights that the lanes leave to the scalar code, which knows what to do with every flight.

use contract::{Ending, Loss};

use crate::{
    flow::Flow,
    forcing::{Excitation, Forcing, HalfPhase},
    rest::ProofOfRest,
    takeoff::{Outcome, Takeoff},
    twofold::{Split, Twofold},
};

use super::{lanes::Lanes, state::Blocks};

/// A case after an impact, or at its start.
pub(super) struct Single {
    excitation: Excitation,
    proof: ProofOfRest,
    omega: f64,
    eta: f64,
    time: Twofold,
    speed: Twofold,
    sign: f64,
    half: HalfPhase,
    forcing: Forcing,
    interval: f64,
    complete: bool,
}

/// Why a sequence goes on no longer, and whether the impact after the last flight belongs to it.
pub(super) struct Finished {
    pub ending: Ending,
    pub listed: bool,
}

impl Single {
    /// A case at the start of a flight.
    pub fn new<L: Lanes>(blocks: &Blocks<L>, sign: f64, lane: usize) -> Self {
        let [epsilon, omega, eta] = [blocks.epsilon, blocks.omega, blocks.eta].map(|of| of.lane(lane));
        let [time, speed] =
            [blocks.time, blocks.speed].map(|of| Twofold { high: of.high.lane(lane), low: of.low.lane(lane) });
        let excitation = Excitation::new(epsilon, omega);
        let half = if time == Twofold::ZERO { HalfPhase { sin: 0.0, cos: 1.0 } } else { excitation.half_phase(time) };
        let forcing = excitation.forcing(sign, half);
        let proof = ProofOfRest::new(&excitation, eta);
        let complete = blocks.complete.lane(lane) == 1.0;
        Self { excitation, proof, omega, eta, time, speed, sign, half, forcing, interval: 0.0, complete }
    }

    /// One flight; and how the sequence ends, if it does. The same as in `sequence`, without the claims.
    pub fn fly(&mut self) -> Option<Finished> {
        let half_period = core::f64::consts::PI / self.omega;
        let takeoff = Takeoff {
            excitation: &self.excitation,
            flow: &Flow::new(self.omega),
            time: self.time,
            sign: self.sign,
            speed: self.speed.value(),
            forcing: self.forcing,
            guess: None,
            horizon: half_period - self.time.value(),
        };
        let unlisted = |ending| Some(Finished { ending, listed: false });
        let landing = match takeoff.fly() {
            Outcome::Landing(landing) => landing,
            Outcome::Aloft => return unlisted(Ending::Incomplete),
            Outcome::Overturned => return unlisted(Ending::Overturned),
            Outcome::Stuck => return unlisted(Ending::Lost(Loss::SolverFailed)),
        };
        self.time = self.time.plus(landing.interval);
        self.half = self.excitation.half_phase(self.time);
        let now = self.time.value();
        if self.half.cos <= 0.0 || now >= half_period {
            return unlisted(Ending::Incomplete);
        }
        self.speed = self.speed.plus(-landing.loss).times(Split::new(self.eta));
        self.sign = -self.sign;
        self.forcing = self.excitation.forcing(self.sign, self.half);
        self.interval = landing.interval;
        let departure = self.speed.value();
        if !(landing.interval > 0.0 && departure >= 0.0 && now.is_finite()) {
            return unlisted(Ending::Lost(Loss::NotFinite));
        }
        self.complete = self.complete || self.proof.holds(&self.forcing, departure);
        let ending = if self.complete { Ending::AtRest } else { Ending::Lost(Loss::NotFinite) };
        (departure < crate::sequence::SLOWEST).then_some(Finished { ending, listed: true })
    }

    /// Time, interval and velocity of the last impact.
    pub fn impact(&self) -> [f64; 3] {
        [self.time.value(), self.interval, self.sign * self.speed.value()]
    }

    /// Puts what the flight has changed back into the lane of the case.
    pub fn put_into<L: Lanes>(&self, blocks: &mut Blocks<L>, lane: usize) {
        let Blocks { time, speed, sin, cos, .. } = blocks;
        for (place, value) in [
            (&mut time.high, self.time.high),
            (&mut time.low, self.time.low),
            (&mut speed.high, self.speed.high),
            (&mut speed.low, self.speed.low),
            (&mut sin.high, self.half.sin),
            (&mut sin.low, 0.0),
            (&mut cos.high, self.half.cos),
            (&mut cos.low, 0.0),
            (&mut blocks.acceleration, self.forcing.acceleration),
            (&mut blocks.jerk, self.forcing.jerk),
            (&mut blocks.complete, if self.complete { 1.0 } else { 0.0 }),
        ] {
            place.set_lane(lane, value);
        }
    }
}
