//! The ground motion of a case as the harness has it; each oracle has its own.

use std::f64::consts::{FRAC_PI_2, PI};

use contract::{Case, Horizon, Invalid, Motion, Sinusoid, Stretch};

/// `f = a sin(ωτ + ψ)`, the ground acceleration in multiples of the threshold, with time counted from the initiation of the case: where `f` reaches the
/// threshold, growing, `sin ψ = 1/a` (Eq. 12). One that stays below the threshold, `a <= 1`, is counted from where it comes next to it, its peak.
///
/// It is kept as `f = in_phase cos ωτ + quadrature sin ωτ`, so that nothing is lost near the threshold, where `ψ` is near `π/2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Excitation {
    omega: f64,
    /// `a sin ψ`.
    in_phase: f64,
    /// `a cos ψ = sqrt(ε(2 + ε))` (Eq. 24).
    quadrature: f64,
}

impl Excitation {
    /// That of a case.
    pub fn new(case: &Case) -> Self {
        let (epsilon, omega) = (case.epsilon(), case.omega());
        Self { omega, in_phase: case.amplitude().min(1.0), quadrature: (epsilon * (2.0 + epsilon)).max(0.0).sqrt() }
    }

    /// The same as a motion of any kind, for ever.
    ///
    /// # Errors
    /// When the amplitude or the frequency is beyond what a motion may have.
    pub fn motion(&self) -> Result<Motion, Invalid> {
        // The phase of the cosine is rounded, by what the sine makes up for.
        const ROUNDED: f64 = 6.123_233_995_736_766e-17;
        let Self { omega, in_phase, quadrature } = *self;
        let terms = vec![
            Sinusoid { amplitude: in_phase, omega, phase: FRAC_PI_2 },
            Sinusoid { amplitude: quadrature - in_phase * ROUNDED, omega, phase: 0.0 },
        ];
        Motion::sinusoids(vec![Stretch { until: f64::INFINITY, terms }])
    }

    /// `ω`.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// `ψ`.
    pub fn phase(&self) -> f64 {
        self.in_phase.atan2(self.quadrature)
    }

    /// `T/2`.
    pub fn half_period(&self) -> f64 {
        half_period(self.omega)
    }

    /// How long the ground acceleration stays above the threshold, each time.
    pub fn above_threshold(&self) -> f64 {
        2.0 * self.quadrature.atan2(self.in_phase) / self.omega
    }

    /// `f` at the time `tau` since initiation.
    pub fn at(&self, tau: f64) -> f64 {
        let (sin, cos) = (self.omega * tau).sin_cos();
        self.in_phase * cos + self.quadrature * sin
    }

    /// How fast the pull `1 + i f` towards the base changes at the time `tau`, relative to it: `i f'/(1 + i f)` on the sides `i = 1` and `i = -1`.
    pub fn pull_rates(&self, tau: f64) -> [f64; 2] {
        let (sin, cos) = (self.omega * tau).sin_cos();
        // `1 ± cos` by half the angle: nothing cancels where the pull vanishes.
        let (half_sin, half_cos) = (0.5 * self.omega * tau).sin_cos();
        let below = 1.0 - self.in_phase;
        let plus = below + self.in_phase * 2.0 * half_cos * half_cos + self.quadrature * sin;
        let minus = below + self.in_phase * 2.0 * half_sin * half_sin - self.quadrature * sin;
        let rate = self.omega * (self.quadrature * cos - self.in_phase * sin);
        [rate / plus, -rate / minus]
    }
}

/// Half a period of the ground motion, `T/2 = π/ω`.
pub fn half_period(omega: f64) -> f64 {
    PI / omega
}

/// The end of the time that a case is followed, in `τ`.
pub fn horizon(case: &Case) -> f64 {
    match case.horizon() {
        Horizon::HalfPeriod => half_period(case.omega()),
        Horizon::Until(time) => time,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_sinusoid_on_either_side_of_the_threshold() {
        for a in [0.0, 0.3, 0.99, 1.0, 1.0 + 1e-9, 1.5, 40.0] {
            let excitation = Excitation::new(&Case::from_amplitude(a, 2.0, 0.9).unwrap());
            let psi = if a > 1.0 { (1.0_f64 / a).asin() } else { std::f64::consts::FRAC_PI_2 };
            for k in 0..50 {
                let tau = 0.17 * f64::from(k);
                assert!(
                    (excitation.at(tau) - a * (2.0 * tau + psi).sin()).abs() < 1e-14 * (1.0 + 40.0 * a),
                    "{a} {tau}"
                );
            }
            assert!(a == 0.0 || (excitation.phase() - psi).abs() < 1e-7, "{a}");
            assert!((excitation.half_period() - 0.5 * PI).abs() < 1e-15);
            let leaves = excitation.above_threshold();
            assert!(if a > 1.0 { (excitation.at(leaves) - 1.0).abs() < 1e-13 * a * a } else { leaves == 0.0 }, "{a}");
        }
    }
    #[test]
    fn the_pull_changes_as_its_logarithm_does() {
        for a in [0.3, 1.0 + 1e-3, 1.5, 40.0] {
            let excitation = Excitation::new(&Case::from_amplitude(a, 2.0, 0.9).unwrap());
            for k in 0..50 {
                let (tau, step) = (0.17 * (f64::from(k) + 0.5), 1e-5);
                let pull = |side: f64, tau| 1.0 + side * excitation.at(tau);
                for (side, rate) in [1.0, -1.0].into_iter().zip(excitation.pull_rates(tau)) {
                    let slope = (pull(side, tau + step) - pull(side, tau - step)) / (2.0 * step);
                    let off = (rate * pull(side, tau) - slope).abs();
                    assert!(off < 1e-7 * (1.0 + a), "{a} {tau} {side}: {off:e}");
                }
            }
        }
        // Next to the threshold, shortly after initiation: f' = ω q and 1 - f = -ω q τ to leading order, with q = a cos ψ.
        let excitation = Excitation::new(&Case::from_epsilon(1e-20, 1.0, 0.9).unwrap());
        let [_, minus] = excitation.pull_rates(1e-15);
        assert!((minus * 1e-15 - 1.0).abs() < 1e-4, "{minus}");
    }
}
