//! When infinitely many impacts are sure to follow, and to accumulate while the forcing still holds the block down.

use crate::forcing::{Excitation, Forcing};

/// Take a window of length `r = x g/L` after an impact, with `g` the smaller of `1 ± f` and `L` a bound on how fast the pull towards the
/// base changes: `ωa`, and `2v` for the rotation itself, which a flight of speed `v` and duration `T` keeps below `vT/4`. In the window the
/// pull of each side stays above `1 - x` of what it is now. A flight that leaves with speed `v` then lasts at most `2v/((1 - x) g)`, and lands
/// with at most `v exp(LT/(2(1 - x) g))`; so all flights in the window together add less than the factor `exp(x/(2(1 - x)))` to the speeds
/// `v η^k`. If the sum of the bounds on their durations fits into the window, the bounds hold for all of them.
pub(crate) struct ProofOfRest {
    /// `ωa`.
    fastest: f64,
    eta: f64,
    /// `x (1 - x)(1 - η²)/(2 exp(x/(2(1 - x))))`.
    room: f64,
}

/// `x`.
const SHARE: f64 = 0.4;

/// `exp(x/(2(1 - x))) = exp(1/3)`, rounded up.
const GROWTH: f64 = 1.396;

impl ProofOfRest {
    pub fn new(excitation: &Excitation, eta: f64) -> Self {
        let room = SHARE * (1.0 - SHARE) * (1.0 - eta * eta) / (2.0 * GROWTH);
        Self { fastest: excitation.omega * excitation.amplitude, eta, room }
    }

    /// Whether it works after an impact that is left with `speed`, to the side whose forcing is given.
    pub fn holds(&self, forcing: &Forcing, speed: f64) -> bool {
        // (1 - f) + (1 + f) = 2
        let this = -forcing.acceleration;
        let other = 2.0 - this;
        // 2v exp(...)(1/this + η/other)/((1 - x)(1 - η²)) <= r, without its quotients
        let flights = speed * (other + self.eta * this) * (self.fastest + 2.0 * speed);
        this > 0.0 && other > 0.0 && flights <= self.room * this.min(other) * this * other
    }
}
