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
pub(crate) const SHARE: f64 = 0.4;

/// `exp(x/(2(1 - x))) = exp(1/3)`, rounded up.
pub(crate) const GROWTH: f64 = 1.396;

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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn forcing(acceleration: f64) -> Forcing {
        Forcing { acceleration, jerk: 0.0, snap: 0.0, rounding: (0.0, 0.0) }
    }

    /// How much of the window the flights take at the most, in the words of [`ProofOfRest`].
    fn share_taken(speed: f64, this: f64, fastest: f64, eta: f64) -> f64 {
        let (x, other) = (0.4, 2.0 - this);
        let window = x * this.min(other) / (fastest + 2.0 * speed);
        // The speeds are v, ηv, η²v, ..., each side's a geometric series in η².
        let durations = 2.0 * speed * GROWTH / (1.0 - x) * (1.0 / this + eta / other) / (1.0 - eta * eta);
        durations / window
    }

    proptest! {
        /// Rest is proven up to the speed at which the flights just fit into the window, and not beyond.
        #[test]
        fn rest_is_proven_as_long_as_the_flights_fit_into_the_window(
            this in 0.05..1.95f64, epsilon in 0.01..1.0f64, omega in 0.3..8.0f64, eta in 0.3..0.95f64,
        ) {
            let proof = ProofOfRest::new(&Excitation::new(epsilon, omega), eta);
            let (mut slow, mut fast) = (0.0, 10.0);
            for _ in 0..80 {
                let middle = 0.5 * (slow + fast);
                if share_taken(middle, this, omega * (1.0 + epsilon), eta) <= 1.0 { slow = middle } else { fast = middle }
            }
            prop_assert!(proof.holds(&forcing(-this), 0.999_999 * slow));
            prop_assert!(!proof.holds(&forcing(-this), 1.000_001 * slow));
        }
    }

    /// Without a pull towards the base from both sides there is no rest, however slow the block is.
    #[test]
    fn nothing_rests_on_a_side_that_is_not_held_down() {
        let proof = ProofOfRest::new(&Excitation::new(0.5, 2.0), 0.9);
        for acceleration in [1.0, 0.0, -2.0, -3.0] {
            assert!(!proof.holds(&forcing(acceleration), 0.0) && !proof.holds(&forcing(acceleration), 1e-9));
        }
        assert!(proof.holds(&forcing(-1.0), 0.0));
    }

    /// `exp(1/3)` is rounded up, and not by much.
    #[test]
    fn the_growth_of_the_speeds_is_bounded_from_above() {
        assert!((0.0..5e-4).contains(&(GROWTH - (1.0f64 / 3.0).exp())));
    }
}
