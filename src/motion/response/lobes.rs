//! When the ground acceleration of a sinusoid passes the threshold of rocking: once in each half period, to one side and the other by turns.

use std::f64::consts::PI;

use contract::Case;

use crate::measure::excitation::Excitation;

/// The moments at which the ground acceleration reaches the threshold, growing: the initiations of a block that rests there.
///
/// Counted in half periods from such a moment on the ground motion is always the same but for its sign, so everything that starts there from rest is
/// one case and its mirror image. A motion that stays below the threshold has its peaks in their place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobes {
    excitation: Excitation,
    /// The last such moment that is not after `τ = 0`.
    first: f64,
    /// Whether the ground then accelerates to the negative side.
    mirrored: bool,
    amplitude: f64,
    /// The phase at `τ = 0`, if it was given.
    phase: Option<f64>,
}

/// One lobe of the excitation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobe {
    /// When it reaches the threshold, `τ`.
    pub start: f64,
    /// 1 if the ground accelerates to the positive side there, -1 for its mirror image.
    pub mirror: f64,
}

impl Lobe {
    /// The time from its start to `tau`, such that its start and that together are `tau` to the last digit where doubles can do that, and never before it.
    pub(super) fn since(&self, tau: f64) -> f64 {
        let since = tau - self.start;
        let exact = [since, since.next_up(), since.next_down()].into_iter().find(|since| self.start + since == tau);
        exact.unwrap_or_else(|| if self.start + since < tau { since.next_up() } else { since })
    }
}

impl Lobes {
    /// Those of `a sin(ωτ + phase)`; without a phase the first is at `τ = 0`.
    pub fn new(case: &Case, phase: Option<f64>) -> Self {
        let excitation = Excitation::new(case);
        let past = phase.map_or(0.0, |phase| phase - excitation.phase());
        let turns = (past / PI).floor();
        // Not -0, which would be printed.
        let first = 0.0 - (past - turns * PI) / case.omega();
        Self { excitation, first, mirrored: turns.rem_euclid(2.0) != 0.0, amplitude: case.amplitude(), phase }
    }

    /// The amplitude `a`.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// Half a period of the excitation, `T/2 = π/ω`.
    pub fn half_period(&self) -> f64 {
        self.excitation.half_period()
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
        if since < self.excitation.above_threshold() {
            (lobe, tau.max(lobe.start))
        } else {
            (self.lobe(k + 1.0), self.lobe(k + 1.0).start)
        }
    }

    /// The ground acceleration at `tau`, in multiples of the threshold: `a sin(ωτ + phase)`.
    pub fn acceleration(&self, tau: f64) -> f64 {
        match self.phase {
            Some(phase) => self.amplitude * (self.excitation.omega() * tau + phase).sin(),
            None => self.excitation.at(tau),
        }
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

    proptest! {
        /// Below the threshold as well, where nothing rocks: the ground moves all the same.
        #[test]
        fn a_motion_below_the_threshold_is_the_sinusoid(a in 0.0..1.0f64, omega in 0.3..8.0f64, phase in -20.0..20.0f64, tau in 0.0..30.0f64) {
            let case = Case::from_amplitude(a, omega, 0.9).unwrap();
            let lobes = Lobes::new(&case, Some(phase));
            prop_assert!((lobes.acceleration(tau) - a * (omega * tau + phase).sin()).abs() < 1e-11);
            // Without a phase it starts as near to the threshold as it comes, as does one above it.
            prop_assert!((Lobes::new(&case, None).acceleration(tau) - a * (omega * tau).cos()).abs() < 1e-11);
        }

        /// A start in the middle of a lobe is that very time.
        #[test]
        fn a_time_in_a_lobe_adds_up(start in -3.0..30.0f64, share in 0.0..1.0f64) {
            let lobe = Lobe { start, mirror: 1.0 };
            let tau = start.max(0.0) + share;
            let sum = start + lobe.since(tau);
            prop_assert!(sum >= tau && sum - tau <= 1e-15);
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
