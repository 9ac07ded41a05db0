//! One case outside of the lanes: how it starts, and the flights that the lanes leave to the scalar code, which knows what to do with every flight.

use contract::{Ending, Loss};

use crate::{
    flight::{Outcome, Takeoff},
    flow::Flow,
    forcing::{Excitation, Forcing, HalfPhase},
    rest::ProofOfRest,
    twofold::{Split, Twofold},
};

use super::{Work, blocks::Blocks, lanes::Lanes, motion::TERMS};

/// A case after an impact, or at its start.
pub(super) struct Single {
    excitation: Excitation,
    proof: ProofOfRest,
    epsilon: f64,
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
    /// A case at initiation, if it rocks.
    pub fn new(work: &Work, case: usize) -> Option<Self> {
        let (epsilon, omega, eta) = (*work.epsilon.get(case)?, *work.omega.get(case)?, *work.eta.get(case)?);
        if epsilon <= 0.0 {
            return None;
        }
        let excitation = Excitation::new(epsilon, omega);
        let (sign, half) = (-1.0, HalfPhase { sin: 0.0, cos: 1.0 });
        let forcing = excitation.forcing(sign, half);
        let proof = ProofOfRest::new(&excitation, eta);
        let (time, speed) = (Twofold::ZERO, Twofold::ZERO);
        Some(Self {
            excitation,
            proof,
            epsilon,
            omega,
            eta,
            time,
            speed,
            sign,
            half,
            forcing,
            interval: 0.0,
            complete: false,
        })
    }

    /// The same case at the start of a later flight.
    pub fn resume(&mut self, time: Twofold, speed: Twofold, sign: f64, complete: bool) {
        (self.time, self.speed, self.sign, self.complete) = (time, speed, sign, complete);
        self.half = if time == Twofold::ZERO { self.half } else { self.excitation.half_phase(time) };
        self.forcing = self.excitation.forcing(sign, self.half);
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
        self.speed = self.speed.plus(-landing.gain).times(Split::new(self.eta));
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

    /// Puts the case into a lane.
    pub fn put_into<L: Lanes>(&self, blocks: &mut Blocks<L>, lane: usize) {
        let (omega, cosine) = (self.omega, self.excitation.cosine);
        let squared = omega * omega;
        let mut q = 1.0;
        for series in &mut blocks.series {
            series.set_lane(lane, q);
            q = 1.0 - squared * q;
        }
        let Blocks { time, speed, sin, cos, .. } = blocks;
        for (place, value) in [
            (&mut blocks.epsilon, self.epsilon),
            (&mut blocks.omega, omega),
            (&mut blocks.eta, self.eta),
            (&mut blocks.cosine, cosine),
            (&mut blocks.half_period, core::f64::consts::PI / omega),
            (&mut blocks.rate, omega.max(1.0)),
            (&mut blocks.room, self.proof.room),
            (&mut blocks.first, first_interval(cosine, omega)),
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

/// Where the first flight ends: Eq. 31 has `s = 4 sqrt(2ε + ε²)/ω`, and in units of that, `σ`, the next terms of the series are
/// `0 = 1 - σ + A (σ²/20 - σ³/30) + B (σ⁴/840 - σ⁵/1680) + ...`
fn first_interval(cosine: f64, omega: f64) -> f64 {
    let unit = 4.0 * cosine / omega;
    let square = unit * unit;
    let q = 1.0 - omega * omega;
    let (a, b) = (q * square, (1.0 - omega * omega * q) * square * square);
    let mut sigma = 1.0 + a * (1.0 / 60.0) + b * (1.0 / 1680.0);
    for _ in 0..2 {
        let power = sigma * sigma;
        sigma = 1.0
            + power * (a * (1.0 / 20.0 - sigma * (1.0 / 30.0)) + power * b * (1.0 / 840.0 - sigma * (1.0 / 1680.0)));
    }
    unit * sigma
}

impl<L: Lanes> Blocks<L> {
    /// Lanes without cases.
    #[inline(always)]
    pub fn idle(zero: L) -> Self {
        let nothing = super::lanes::Twofold { high: zero, low: zero };
        Self {
            busy: zero.below(zero),
            epsilon: zero,
            omega: zero,
            eta: zero,
            cosine: zero,
            half_period: zero,
            rate: zero,
            series: [zero; TERMS],
            room: zero,
            first: zero,
            time: nothing,
            speed: nothing,
            sin: nothing,
            cos: nothing,
            acceleration: zero,
            jerk: zero,
            complete: zero,
        }
    }
}
