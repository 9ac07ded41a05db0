//! When the ground acceleration of a sinusoid passes the threshold of rocking: once in each half period, to one side and the other by turns.

use std::f64::consts::{FRAC_PI_2, PI};

use contract::Case;

/// The moments at which the ground acceleration reaches the threshold, growing: the initiations of a block that rests there.
///
/// Counted in half periods from such a moment on the ground motion is always the same but for its sign, so everything that starts there from rest is
/// one case and its mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobes {
    /// `a cos ψ = sqrt(ε(2 + ε))` (Eq. 24).
    cosine: f64,
    omega: f64,
    /// The last such moment that is not after `τ = 0`.
    first: f64,
    /// Whether the ground then accelerates to the negative side.
    mirrored: bool,
}

/// One lobe of the excitation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobe {
    /// When it reaches the threshold, `τ`.
    pub start: f64,
    /// 1 if the ground accelerates to the positive side there, -1 for its mirror image.
    pub mirror: f64,
}

impl Lobes {
    /// Those of `a sin(ωτ + phase)`, with `a = 1 + ε` above the threshold; without a phase the first is at `τ = 0`.
    pub fn new(case: &Case, phase: Option<f64>) -> Self {
        let (epsilon, omega) = (case.epsilon(), case.omega());
        let cosine = (epsilon * (2.0 + epsilon)).max(0.0).sqrt();
        let Some(phase) = phase else { return Self { cosine, omega, first: 0.0, mirrored: false } };
        // sin ψ = 1/a and a cos ψ = cosine: ψ = π/2 - atan(cosine).
        let past = phase - (FRAC_PI_2 - cosine.atan());
        let turns = (past / PI).floor();
        Self { cosine, omega, first: -(past - turns * PI) / omega, mirrored: turns.rem_euclid(2.0) != 0.0 }
    }

    /// Half a period of the excitation, `T/2 = π/ω`.
    pub fn half_period(&self) -> f64 {
        PI / self.omega
    }

    /// How long the ground acceleration stays above the threshold, each time.
    fn above(&self) -> f64 {
        2.0 * self.cosine.atan() / self.omega
    }

    /// Lobe `k`; number 0 is the one that is in force at `τ = 0`.
    fn lobe(&self, k: f64) -> Lobe {
        let odd = k.rem_euclid(2.0) != 0.0;
        Lobe { start: self.first + k * self.half_period(), mirror: if odd == self.mirrored { 1.0 } else { -1.0 } }
    }

    /// The lobe that a block at rest at `tau` starts to rock in, and when: at once if the ground acceleration is above the threshold.
    pub fn departure(&self, tau: f64) -> (Lobe, f64) {
        let k = ((tau - self.first) / self.half_period()).floor();
        let lobe = self.lobe(k);
        let since = tau - lobe.start;
        if since < self.above() { (lobe, tau.max(lobe.start)) } else { (self.lobe(k + 1.0), self.lobe(k + 1.0).start) }
    }

    /// The ground acceleration at `tau`, in multiples of the threshold: `cos x + sin x sqrt(ε(2 + ε))` with `x` the phase since a lobe's start.
    pub fn acceleration(&self, tau: f64) -> f64 {
        let (sin, cos) = (self.omega * (tau - self.first)).sin_cos();
        (if self.mirrored { -1.0 } else { 1.0 }) * (cos + self.cosine * sin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        /// The acceleration is the sinusoid, and at each lobe's start it is the threshold, growing in size.
        #[test]
        fn lobes_start_where_the_sinusoid_reaches_the_threshold(
            epsilon in 1e-3..2.0f64, omega in 0.3..8.0f64, phase in -20.0..20.0f64, tau in 0.0..30.0f64,
        ) {
            let lobes = Lobes::new(&Case::from_epsilon(epsilon, omega, 0.9).unwrap(), Some(phase));
            let f = |tau: f64| (1.0 + epsilon) * (omega * tau + phase).sin();
            prop_assert!((lobes.acceleration(tau) - f(tau)).abs() < 1e-11);
            let (lobe, start) = lobes.departure(tau);
            prop_assert!(start >= tau && start <= tau + lobes.half_period() * (1.0 + 1e-12));
            prop_assert!((lobe.mirror * f(lobe.start) - 1.0).abs() < 1e-11);
            prop_assert!(lobe.mirror * f(lobe.start + 1e-4) > 1.0);
            if start > tau {
                prop_assert_eq!(start, lobe.start);
                prop_assert!(f(tau).abs() < 1.0 + 1e-11);
            } else {
                prop_assert!(lobe.mirror * f(tau) > 1.0 - 1e-11);
            }
        }
    }

    #[test]
    fn without_a_phase_the_first_lobe_starts_at_once() {
        let lobes = Lobes::new(&Case::from_epsilon(0.03, 2.0, 0.9).unwrap(), None);
        let first = Lobe { start: 0.0, mirror: 1.0 };
        assert_eq!(lobes.departure(0.0), (first, 0.0));
        assert_eq!(lobes.departure(0.1), (first, 0.1));
        let (lobe, start) = lobes.departure(1.0);
        assert_eq!((lobe.mirror, start), (-1.0, lobes.half_period()));
        assert_relative_eq!(lobes.acceleration(0.0), 1.0);
    }
}
