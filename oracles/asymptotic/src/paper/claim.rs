use std::f64::consts::PI;

use contract::Uncertainty;

/// What the series claims for its own truncation error: what it knows about itself at an impact, times one calibrated constant for each
/// quantity.
///
/// Eq. 65 keeps one term of every interval, so every relative error starts with `ε` times a coefficient that depends on `η`, `ω` and the
/// impact. Stepping Eq. 4 exactly shows what the coefficient is made of:
///
/// - A constant: the next term of the first flight, `-T_{0;3}/T_{0;1} = 17/60 - 8/(15 ω²)` (Eq. 31 as corrected, see the crate's page).
/// - `r = u/x`, the ratio of the two sums of Eq. 65 up to this impact. It measures how much the odd flights delay the even ones, which
///   changes the forcing that those meet; and the dropped `T_{n;3}` of the even flights grows with it as well.
/// - `1/ω²`: the rotation itself in Eq. 4, `φ'' - φ`, of which the terms kept have nothing. A slow excitation gives it time to act.
///
/// The higher orders sum to a growth near the critical amplitude. The nearness to it is `q = (ω τ/(0.78 π))² + 2 ε/ω²`, of two causes:
///
/// - The exact chattering time reaches `T/2`. At `ω = 8` the two sums have then come to 0.79 of `T/2` for `η = 0.995`, to 0.83 for 0.92 and
///   0.96 for 0.05; somewhat less for smaller `ω`.
/// - For small `ω` the first flight alone becomes critical: it does not return when `sqrt(2 ε) > ω`, roughly, where its growing mode
///   prevails (`B_0 < 0` in Eq. 10).
///
/// Velocities are conditioned like the chattering time near the critical amplitude, `(1 - q)^(β-1)` with `β ≈ 3/5`. The time itself stays
/// bounded where the first is the cause; where the second is, it grows with the first flight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Claim {
    /// `ε (1 + r + (1 - 2ε/ω²)^(β-1)/ω²)`.
    truncation: f64,
    /// `q`, 1 or more where the series says nothing.
    nearness: f64,
    /// Relative rounding error of the recursion.
    rounding: f64,
}

/// The calibrated constants: 1.3 times the largest error met, or more, in 6000 random cases with `η` in [0.05, 0.995], `ω` from 0.02 to 20 and
/// `ε` from 1e-8 to 0.98 of the critical one, over the first 60 impacts of each (`tests/asymptotic/claim.rs`, which measures them again). Largest error
/// over claim there: time 0.76, interval 0.73, velocity 0.67, chattering time 0.76; in the median 0.28, 0.28, 0.30, 0.28.
const TIME: f64 = 0.8;
const INTERVAL: f64 = 5.0;
const VELOCITY: f64 = 2.4;

/// `β - 1` with `β ≈ 3/5`, the exponent with which the chattering time approaches `T/2`.
const GROWTH: f64 = -0.4;

impl Claim {
    /// The claim at an impact with the sums `x` and `u` so far (or at the chattering time, with the whole sums), after `flights` flights.
    pub(crate) fn new(epsilon: f64, omega: f64, x: f64, u: f64, flights: usize) -> Self {
        let rotation = 1.0 / (omega * omega);
        let growing_mode = 2.0 * epsilon * rotation;
        let time_over_half_period = (x + u * epsilon) * epsilon.sqrt() / PI;
        Self {
            truncation: epsilon * (1.0 + u / x + rotation * (1.0 - growing_mode).powf(GROWTH)),
            nearness: (time_over_half_period / 0.78).powi(2) + growing_mode,
            rounding: f64::EPSILON * (8.0 + flights as f64),
        }
    }

    /// Whether the series stands for anything here.
    pub(crate) fn holds(&self) -> bool {
        self.nearness < 1.0
    }

    /// Of the time, relative.
    pub(crate) fn time(&self) -> f64 {
        TIME * self.truncation + self.rounding
    }

    /// Of an impact at `time`.
    pub(crate) fn uncertainty(&self, time: f64) -> Uncertainty {
        let growth = (1.0 - self.nearness).powf(GROWTH);
        Uncertainty {
            time: self.time() * time,
            interval: INTERVAL * self.truncation * growth + self.rounding,
            velocity: VELOCITY * self.truncation * growth + self.rounding,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The relative claim of a time, in units of that at the same `ε` for a fast excitation and `u = 0`.
    fn compared(epsilon: f64, omega: f64, x: f64, u: f64) -> f64 {
        Claim::new(epsilon, omega, x, u, 0).time() / Claim::new(epsilon, 1e9, x, 0.0, 0).time()
    }

    fn is_near(a: f64, b: f64) -> bool {
        (a / b - 1.0).abs() < 1e-6
    }

    #[test]
    fn each_cause_of_truncation_adds_its_part() {
        let (epsilon, x) = (1e-8, 5.0);
        assert!(is_near(Claim::new(epsilon, 1e9, x, 0.0, 0).time(), TIME * epsilon));
        // The odd flights delay the even ones.
        assert!(is_near(compared(epsilon, 1e9, x, 3.0 * x), 4.0));
        // The rotation itself.
        assert!(is_near(compared(epsilon, 0.5, x, 0.0), 5.0) && is_near(compared(epsilon, 2.0, x, x), 2.25));
        // The growing mode of the first flight: 1 - 2ε/ω² = 1/32, to the power β - 1 = -2/5 it is 4.
        let (epsilon, omega) = (31.0 / 64.0 * 1e-4, 1e-2);
        let claim = Claim::new(epsilon, omega, 1e-3, 0.0, 0);
        assert!(is_near(claim.time(), TIME * epsilon * (1.0 + 4e4)), "{claim:?}");
    }

    #[test]
    fn it_grows_towards_the_critical_amplitude_and_ends_there() {
        // (x + u ε) ε^(1/2) is ω τ, which comes to 0.78 π.
        let at = |share: f64| Claim::new(0.01, 1e3, 0.5 * share * 0.78 * PI / 0.1, 50.0 * share * 0.78 * PI / 0.1, 0);
        assert!(at(0.999).holds() && !at(1.001).holds());
        // q = 31/32: to the power -2/5 its distance from 1 is 4 times as much as at 0.
        let claim = at((31.0_f64 / 32.0).sqrt());
        let uncertainty = claim.uncertainty(7.0);
        assert!(is_near(uncertainty.time, 7.0 * claim.time()) && is_near(claim.time(), TIME * claim.truncation));
        assert!(is_near(uncertainty.interval, 4.0 * INTERVAL * claim.truncation), "{uncertainty:?}");
        assert!(is_near(uncertainty.velocity, 4.0 * VELOCITY * claim.truncation), "{uncertainty:?}");
        // The first flight alone does not return where 2 ε = ω².
        let slow = |share: f64| Claim::new(0.5e-8 * share, 1e-4, 1e-9, 0.0, 0);
        assert!(slow(0.999).holds() && !slow(1.001).holds());
        // Both together.
        assert!(Claim::new(0.5 * 0.45e-2, 0.1, 0.7 * 0.78 * PI / (0.5_f64 * 0.45e-2).sqrt(), 0.0, 0).holds());
        assert!(!Claim::new(0.5 * 0.55e-2, 0.1, 0.7 * 0.78 * PI / (0.5_f64 * 0.55e-2).sqrt(), 0.0, 0).holds());
    }

    /// At the least what rounding does in so many flights.
    #[test]
    fn rounding_is_claimed_however_small_the_excitation() {
        for flights in [0, 60, 1000] {
            let claim = Claim::new(1e-40, 2.0, 10.0, 60.0, flights);
            let least = f64::EPSILON * (8.0 + flights as f64);
            let Uncertainty { time, interval, velocity } = claim.uncertainty(0.5);
            assert!(is_near(time, 0.5 * least) && is_near(interval, least) && is_near(velocity, least));
        }
    }
}
