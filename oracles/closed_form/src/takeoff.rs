//! What a flight starts with and how it ends, whichever way it is followed.

use crate::{
    flow::Flow,
    forcing::{Excitation, Forcing},
    twofold::Twofold,
};

/// Everything that one flight needs to know.
#[derive(Clone, Copy)]
pub(crate) struct Takeoff<'a> {
    pub excitation: &'a Excitation,
    pub flow: &'a Flow<f64>,
    /// When it starts.
    pub time: Twofold,
    /// `i`, the sign of the rotation.
    pub sign: f64,
    /// The speed away from the base, `i φ'`: zero only at initiation.
    pub speed: f64,
    /// The forcing at the start.
    pub forcing: Forcing,
    /// Where the last flight of the same sign suggests that the impact is, if there was one.
    pub guess: Option<f64>,
    /// How long the flight is followed.
    pub horizon: f64,
}

/// How a flight ends.
pub(crate) enum Outcome {
    Landing(Landing),
    /// It passes the horizon in the air.
    Aloft,
    /// No return is possible.
    Overturned,
    /// The iteration did not end; the sequence is reported as lost. Known to happen just above the threshold of very slow shaking (`ε = 5e-13`, `ω = 2e-6`).
    Stuck,
}

/// The impact, and how it responds to what the flight started with.
pub(crate) struct Landing {
    /// How long the flight lasted.
    pub interval: f64,
    /// `u' + v`: how much slower it lands than it left. Eq. 68, a first-order statement, has it zero.
    pub loss: f64,
    /// `u'` at the impact.
    pub velocity: f64,
    /// `u''` at the impact.
    pub acceleration: f64,
    /// `u'' - 2u'/s` at the impact: zero on a parabola.
    pub off_parabola: f64,
    /// The derivatives of `u` and `u'` by the speed at the start: `sinh` and `cosh` of the interval.
    pub by_speed: (f64, f64),
    /// The derivatives of `u` and `u'` by the time of the start.
    pub by_time: (f64, f64),
    /// The rounding errors of `u/s` and of the loss, absolute, in units of the unit round-off.
    pub rounding: (f64, f64),
}

/// Up to which `max(1, ω) s` two terms of the series of the derivatives are enough.
const SHORT: f64 = 0.25;

impl Takeoff<'_> {
    /// The derivatives of `u` and `u'` at `s` by the speed at the start, and by the time of the start. Errors are carried with them, and
    /// nearly cancel over some long flights, so they have to be right to many digits there.
    #[inline]
    pub fn derivatives(&self, s: f64, velocity: f64, acceleration: f64) -> ((f64, f64), (f64, f64)) {
        let Forcing { acceleration: pull, jerk, snap, .. } = self.forcing;
        let (z, omega) = (s * s, self.excitation.omega);
        let q = 1.0 - omega * omega;
        if s * omega.max(1.0) > SHORT {
            let growth = s.exp();
            let (sinh, cosh) = (0.5 * (growth - 1.0 / growth), 0.5 * (growth + 1.0 / growth));
            // The equation is linear: u_τ = u' - v cosh s - b sinh s, and its derivative.
            let tilt = velocity - self.speed * cosh - pull * sinh;
            return ((sinh, cosh), (tilt, acceleration - self.speed * sinh - pull * cosh));
        }
        let sinh = s * (1.0 + z * (1.0 / 6.0 + z * (1.0 / 120.0)));
        let cosh = 1.0 + z * (0.5 + z * (1.0 / 24.0 + z * (1.0 / 720.0)));
        let tilt = z * (jerk * (0.5 + q * z * (1.0 / 24.0)) + s * snap * (1.0 / 6.0 + q * z * (1.0 / 120.0)));
        let turn = s * (jerk * (1.0 + q * z * (1.0 / 6.0)) + s * snap * (0.5 + q * z * (1.0 / 24.0)));
        ((sinh, cosh), (tilt, turn))
    }
}
