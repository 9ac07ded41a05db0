//! The derivatives of every impact by `a`, `ω` and `η`, by the same series with numbers that carry their derivatives.
//!
//! The impacts are those that the oracle found. A flight's duration `s` is defined by `u(s) = 0`, so its derivative follows from those of `u`
//! at a given `s`: `ds = -du/u'` (the implicit function theorem). They grow without bound towards a grazing impact, `u' = 0`, and do so for a
//! reason.

use contract::Sensitivity;

use crate::{
    dual::{Dual, Scalar},
    flow::Flow,
    forcing::{Excitation, Forcing},
    sequence::Follower,
    takeoff::Takeoff,
    twofold::Twofold,
};

/// Follows the impacts of one case.
pub(crate) struct Derivatives {
    omega: Dual,
    eta: Dual,
    /// `sqrt(2ε + ε²)`.
    cosine: Dual,
    flow: Flow<Dual>,
    /// The time and the speed after the last impact; their values are those of the takeoff.
    time: Dual,
    speed: Dual,
    /// What was found so far.
    pub found: Vec<Sensitivity>,
}

impl Derivatives {
    /// At initiation, where time and speed are zero whatever the case.
    pub fn new(excitation: &Excitation, eta: f64) -> Self {
        let omega = Dual::parameter(excitation.omega, 1);
        let amplitude = Dual::parameter(excitation.amplitude, 0);
        Self {
            omega,
            eta: Dual::parameter(eta, 2),
            // d sqrt(a² - 1) = a da/sqrt(a² - 1)
            cosine: amplitude.chain(excitation.cosine, excitation.amplitude / excitation.cosine),
            flow: Flow::new(omega),
            time: Dual::from(0.0),
            speed: Dual::from(0.0),
            found: Vec::new(),
        }
    }

    /// The duration of a flight that is summed at once, and how much slower it lands than it left.
    fn short(&self, takeoff: &Takeoff, interval: f64) -> (Dual, Dual) {
        let motion = self.flow.after_impact(Dual::from(interval), self.speed, &self.forcing(takeoff, 0.0));
        // h = u/s is zero at the impact whatever the case, and s h' is what is known of its slope.
        let relative = motion.deflated.scaled(-1.0 / motion.slope.value);
        let (s, along) = (relative.chain(interval, interval), relative.scaled(motion.bend.value));
        (s, motion.loss + along)
    }

    /// The same for a flight of any length, in stretches.
    fn long(&self, takeoff: &Takeoff, interval: f64) -> (Dual, Dual) {
        let stretches = (interval / self.flow.longest()).ceil();
        let stretch = interval / stretches;
        let (mut state, mut elapsed) = ((Dual::from(0.0), self.speed), 0.0);
        let mut here = self.forcing(takeoff, elapsed);
        while elapsed + 0.5 * stretch < interval {
            state = self.flow.advance(Dual::from(stretch), state, &here);
            elapsed += stretch;
            here = self.forcing(takeoff, elapsed);
        }
        let (rotation, velocity) = state;
        let s = rotation.chain(interval, -1.0 / velocity.value);
        let along = s.scaled(here.acceleration.value);
        (s, self.speed + Dual { value: velocity.value, ..velocity + along })
    }

    /// The forcing of a flight some time after its start.
    fn forcing(&self, takeoff: &Takeoff, elapsed: f64) -> Forcing<Dual> {
        let time: Twofold = takeoff.time.plus(elapsed);
        let half = takeoff.excitation.half_phase(time);
        let start = Dual { value: time.value(), ..self.time };
        let half = half.with_derivatives((start * self.omega).scaled(0.5));
        Forcing::new(takeoff.sign, half, self.cosine, self.omega)
    }
}

impl Follower for Derivatives {
    #[cold]
    #[inline(never)]
    fn land(&mut self, takeoff: &Takeoff, interval: f64) {
        self.speed.value = takeoff.speed;
        self.time.value = takeoff.time.value();
        let (interval, lost) =
            if interval <= self.flow.longest() { self.short(takeoff, interval) } else { self.long(takeoff, interval) };
        self.time = self.time + interval;
        self.speed = (self.speed - lost) * self.eta;
        // The flight after the impact is on the other side.
        let velocity = self.speed.scaled(-takeoff.sign).by;
        self.found.push(Sensitivity { time: self.time.by, interval: interval.by, velocity });
    }
}
