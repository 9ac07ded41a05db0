//! The forcing of Eq. 4 at one instant, seen from one side of the base.

use crate::{
    dual::{Dual, Scalar},
    twofold::{Split, Twofold},
};

/// The excitation `f(τ) = a sin(ωτ + ψ)` with the phase of Eq. 12, as `a sin ψ = 1` and `a cos ψ = sqrt(2ε + ε²)` (Eq. 24):
/// the phase itself is never formed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Excitation {
    pub amplitude: f64,
    pub omega: f64,
    /// `a cos ψ = sqrt(ε(2 + ε))`.
    pub cosine: f64,
    epsilon: f64,
    half_omega: Split,
}

/// What drives the distance from the base, `u = i φ`, at one instant: `u'' = u - 1 - i f` and the derivatives of its forcing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Forcing<T = f64> {
    /// `-1 - i f`: the acceleration at the base; negative towards it.
    pub acceleration: T,
    /// `-i f'`.
    pub jerk: T,
    /// `-i f'' = i ω² f`.
    pub snap: T,
    /// Bounds on the rounding errors of `acceleration` and `jerk`, in units of the unit round-off.
    pub rounding: (f64, f64),
}

/// The sine and cosine of half the phase that has passed since initiation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HalfPhase<T = f64> {
    pub sin: T,
    pub cos: T,
}

impl Excitation {
    pub fn new(epsilon: f64, omega: f64) -> Self {
        Self {
            amplitude: 1.0 + epsilon,
            omega,
            cosine: (epsilon * (2.0 + epsilon)).sqrt(),
            epsilon,
            half_omega: Split::new(0.5 * omega),
        }
    }

    /// Half the phase at `time`; the error of rounding `ωτ/2` is put back.
    pub fn half_phase(&self, time: Twofold) -> HalfPhase {
        let phase = time.times(self.half_omega);
        let (sin, cos) = phase.high.sin_cos();
        HalfPhase { sin: sin + phase.low * cos, cos: cos - phase.low * sin }
    }

    /// The forcing on the side `sign` of the base.
    pub fn forcing(&self, sign: f64, half: HalfPhase) -> Forcing {
        Forcing::new(sign, half, self.cosine, self.omega)
    }

    /// `sup(-1 - i f) = a - 1`, over both signs and all times.
    pub fn largest_acceleration(&self) -> f64 {
        self.epsilon
    }
}

impl<T: Scalar> Forcing<T> {
    /// The forcing on the side `sign` of the base, with `cosine = sqrt(2ε + ε²)`.
    ///
    /// With `x = ωτ`: `f = sin x sqrt(2ε + ε²) + cos x`, so in half angles both `f - 1` and `f + 1` factor, and neither
    /// cancels where it vanishes identically (at initiation and at `T/2`).
    #[inline]
    pub fn new(sign: f64, half: HalfPhase<T>, cosine: T, omega: T) -> Self {
        let HalfPhase { sin, cos } = half;
        let (factor, one, other) = if sign < 0.0 {
            (sin.scaled(2.0), cosine * cos, -sin) // f - 1
        } else {
            (cos.scaled(-2.0), cos, cosine * sin) // -(1 + f)
        };
        let acceleration = factor * (one + other);
        // f'/ω = sqrt(2ε + ε²) cos x - sin x
        let (rate, other_rate) = (cosine * (cos - sin) * (cos + sin), sin.scaled(2.0) * cos);
        let size = |x: T| x.value().abs();
        Self {
            acceleration,
            jerk: omega.scaled(-sign) * (rate - other_rate),
            snap: -(omega * omega) * (T::from(1.0) + acceleration),
            rounding: (
                1.5 * size(factor) * (size(one) + size(other)),
                1.5 * omega.value() * (size(rate) + size(other_rate)),
            ),
        }
    }
}

impl HalfPhase {
    /// The same with derivatives, from those of half the phase.
    pub fn with_derivatives(self, half_phase: Dual) -> HalfPhase<Dual> {
        HalfPhase { sin: half_phase.chain(self.sin, self.cos), cos: half_phase.chain(self.cos, -self.sin) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Numbers from mpmath at 40 digits. Rounding `ωτ/2` alone would cost up to 1e-13 of these.
    #[test]
    fn half_the_phase_is_known_to_a_rounding_however_late_it_is() {
        for (omega, high, low, sin, cos) in [
            (0.3, 12345.678, 3e-13, -0.993_143_528_160_305_3, -0.116_901_379_261_755_62),
            (7.3, 987.654321, -4e-14, -0.999_227_919_439_968_2, -0.039_288_229_938_144_375),
            (1.0, 3.0, 1.1e-16, 0.997_494_986_604_054_4, 0.070_737_201_667_702_86),
            (40.1, 12.3456789, 2e-16, 0.609_125_687_811_021_5, -0.793_073_701_776_039_2),
            (137.0, 1.00901234, -5e-17, 0.002_306_908_978_374_614_3, 0.999_997_339_081_942_5),
            (1e5, 0.0314159, 1e-18, -0.001_326_794_507_460_739_8, 0.999_999_119_807_780_1),
        ] {
            let half = Excitation::new(0.03, omega).half_phase(Twofold { high, low });
            assert_relative_eq!(half.sin, sin, max_relative = 4e-16);
            assert_relative_eq!(half.cos, cos, max_relative = 4e-16);
        }
    }

    /// `sup(-1 - i f) = a - 1`.
    #[test]
    fn no_forcing_is_larger_than_the_largest() {
        let excitation = Excitation::new(0.25, 2.0);
        assert_eq!(excitation.largest_acceleration(), 0.25);
        let at = |k: u32| excitation.forcing(-1.0, excitation.half_phase(Twofold::sum(0.01 * f64::from(k), 0.0)));
        let largest = (0..314).map(|k| at(k).acceleration).fold(0.0, f64::max);
        assert_relative_eq!(largest, 0.25, max_relative = 1e-3);
    }

    /// What rounding does to the factors: 3/2 of each term, in units of the unit round-off, by hand at a quarter of the period.
    #[test]
    fn the_bound_on_rounding_is_that_of_the_terms() {
        let half = HalfPhase { sin: 0.6, cos: 0.8 };
        for (sign, expected) in [
            // 2 · 0.6 (0.75 · 0.8 + 0.6) and 2 (0.75 (0.8 - 0.6)(0.8 + 0.6) + 2 · 0.6 · 0.8)
            (-1.0, (1.5 * 1.2 * 1.2, 1.5 * 2.0 * (0.21 + 0.96))),
            (1.0, (1.5 * 1.6 * (0.8 + 0.45), 1.5 * 2.0 * (0.21 + 0.96))),
        ] {
            let found = Excitation::new(0.25, 2.0).forcing(sign, half).rounding;
            assert_relative_eq!(found.0, expected.0, max_relative = 1e-14);
            assert_relative_eq!(found.1, expected.1, max_relative = 1e-14);
        }
    }

    #[test]
    fn the_factored_forcing_is_the_printed_one() {
        let (epsilon, omega) = (0.03, 2.0);
        let excitation = Excitation::new(epsilon, omega);
        let (a, psi) = (1.0 + epsilon, (1.0f64 / (1.0 + epsilon)).asin());
        for tau in [0.0, 0.1, 0.7, 1.2, 1.57, 3.0] {
            let half = excitation.half_phase(Twofold::sum(tau, 0.0));
            let (f, rate) = (a * (omega * tau + psi).sin(), a * omega * (omega * tau + psi).cos());
            for sign in [-1.0, 1.0] {
                let forcing = excitation.forcing(sign, half);
                assert_relative_eq!(forcing.acceleration, -1.0 - sign * f, epsilon = 1e-15, max_relative = 1e-13);
                assert_relative_eq!(forcing.jerk, -sign * rate, epsilon = 1e-14, max_relative = 1e-13);
                assert_relative_eq!(forcing.snap, sign * omega * omega * f, max_relative = 1e-13);
            }
        }
    }
}
