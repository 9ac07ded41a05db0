//! What the lanes know of their blocks: the cases, where each sequence stands, and the flight that each block is about to make.

use crate::rest::{GROWTH, SHARE};

use super::lanes::{Lanes, Twofold};

/// How many terms of the series are held; see `flow`.
pub(super) const TERMS: usize = 11;

/// The blocks after an impact, each with its case.
#[derive(Clone, Copy)]
pub(super) struct Blocks<L: Lanes> {
    /// 1 where there is a case.
    pub busy: L,
    pub epsilon: L,
    pub omega: L,
    pub eta: L,
    /// `a cos ψ = sqrt(2ε + ε²)`.
    pub cosine: L,
    /// `max(1, ω)`.
    pub rate: L,
    /// `ω²`.
    pub squared: L,
    /// The `q` of `flow`.
    pub series: [L; TERMS],
    /// What `rest` needs of the case: `x (1 - x)(1 - η²)/(2 exp(x/(2(1 - x))))`.
    pub room: L,
    /// Where the first flight ends, nearly.
    pub first: L,
    pub time: Twofold<L>,
    pub speed: Twofold<L>,
    /// Sine and cosine of half the phase.
    pub sin: Twofold<L>,
    pub cos: Twofold<L>,
    /// `-1 - i f` on the side to which the block leaves.
    pub acceleration: L,
    /// `-i f'` there.
    pub jerk: L,
    /// 1 where the rest of the sequence is certain.
    pub complete: L,
    /// Of the flight that each block makes: the speed of the departure, and `-i f''` there.
    pub departure: L,
    pub snap: L,
    /// Where it may end, and the impact that it comes to.
    pub guess: L,
    pub landing: Step<L>,
    /// Where one is found.
    pub found: L::Mask,
    /// Where it is not sure that it is the first one, and everywhere else that the lanes are not made for. Time, speed and `complete` are left there as they
    /// were before the flight, and the rest is for the scalar code to write anew.
    pub unsure: L::Mask,
}

/// Where a flight stands after one step towards its impact.
#[derive(Clone, Copy)]
pub(super) struct Step<L> {
    /// The local time of the impact, as it is known now.
    pub interval: L,
    /// The loss there: how much slower the block lands than it left.
    pub loss: L,
    /// By how much the sine of half the phase has grown there, and its cosine shrunk.
    pub turn: [L; 2],
}

impl<L: Lanes> Step<L> {
    /// This where the mask holds, and the other elsewhere.
    #[inline(always)]
    pub fn select(self, mask: L::Mask, other: Self) -> Self {
        let [sine, cosine] = self.turn;
        let [other_sine, other_cosine] = other.turn;
        Self {
            interval: self.interval.select(mask, other.interval),
            loss: self.loss.select(mask, other.loss),
            turn: [sine.select(mask, other_sine), cosine.select(mask, other_cosine)],
        }
    }
}

impl<L: Lanes> Blocks<L> {
    /// Puts a case at its initiation into a lane.
    pub fn start(&mut self, lane: usize, epsilon: f64, omega: f64, eta: f64) {
        let cosine = (epsilon * (2.0 + epsilon)).sqrt();
        let Self { time, speed, sin, cos, .. } = self;
        for (place, value) in [
            (&mut self.busy, 1.0),
            (&mut self.epsilon, epsilon),
            (&mut self.omega, omega),
            (&mut self.eta, eta),
            (&mut time.high, 0.0),
            (&mut time.low, 0.0),
            (&mut speed.high, 0.0),
            (&mut speed.low, 0.0),
            (&mut sin.high, 0.0),
            (&mut sin.low, 0.0),
            (&mut cos.high, 1.0),
            (&mut cos.low, 0.0),
            (&mut self.acceleration, 0.0),
            (&mut self.jerk, omega * cosine),
            (&mut self.complete, 0.0),
        ] {
            place.set_lane(lane, value);
        }
    }

    /// What depends on the cases only. Done for all lanes when any has a new case, with the same answer for the others.
    #[inline(always)]
    pub fn prepare(&mut self) {
        let (epsilon, omega, eta) = (self.epsilon, self.omega, self.eta);
        let one = omega.splat(1.0);
        self.cosine = (epsilon * epsilon.plus(2.0)).sqrt();
        self.rate = omega.max(one);
        let squared = omega * omega;
        self.squared = squared;
        let mut q = one;
        for series in &mut self.series {
            *series = q;
            q = one - squared * q;
        }
        let room = SHARE * (1.0 - SHARE) / (2.0 * GROWTH);
        self.room = (one - eta * eta).by(room);
        self.first = self.first_interval();
    }

    /// Where the first flight ends: Eq. 31 has `s = 4 sqrt(2ε + ε²)/ω`, and in units of that, `σ`, the next terms of the series are
    /// `0 = 1 - σ + A (σ²/20 - σ³/30) + B (σ⁴/840 - σ⁵/1680) + ...`
    #[inline(always)]
    fn first_interval(&self) -> L {
        let one = self.omega.splat(1.0);
        let unit = self.cosine.by(4.0) / self.omega;
        let square = unit * unit;
        let [_, q, next, ..] = self.series;
        let (a, b) = (q * square, next * square * square);
        let mut sigma = one;
        let mut times = 0;
        while times < 3 {
            times += 1;
            let power = sigma * sigma;
            let by_a = one.by(1.0 / 20.0) - sigma.by(1.0 / 30.0);
            let by_b = one.by(1.0 / 840.0) - sigma.by(1.0 / 1680.0);
            sigma = one + power * (a * by_a + power * b * by_b);
        }
        unit * sigma
    }

    /// Lanes without cases.
    #[inline(always)]
    pub fn idle(zero: L) -> Self {
        let nothing = Twofold { high: zero, low: zero };
        Self {
            busy: zero,
            epsilon: zero,
            omega: zero,
            eta: zero,
            cosine: zero,
            rate: zero,
            squared: zero,
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
            departure: zero,
            snap: zero,
            guess: zero,
            landing: Step { interval: zero, loss: zero, turn: [zero; 2] },
            found: zero.below(zero),
            unsure: zero.below(zero),
        }
    }
}
