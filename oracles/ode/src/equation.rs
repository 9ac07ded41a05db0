//! The equations of motion: Eq. 4 for the slender block, Eq. 2 for the block as it is.
//!
//! Both are written with `g = i + f`, what is left of gravity (in units of its threshold) once the excitation is taken off: it is small
//! or zero near initiation and near half a period, where `i` and `f` cancel, so it is never formed as their sum.

use contract::{Case, Decline, Normalisation, Slenderness};

use crate::Equation;
use crate::forcing::{Change, Forcing, Wave};

/// The frequency ratios that the integration is offered for: outside, one of the two time scales is lost beside the other.
const OMEGA: core::ops::RangeInclusive<f64> = 1e-6..=1e6;
/// Below this distance to the threshold the rotations, of the order of `eps^3`, approach the smallest double.
const LEAST_EPSILON: f64 = 1e-60;

/// An equation of motion with its excitation `f = a sin(omega tau + psi)`, `sin(psi) = 1/a` (Eq. 12).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Motion {
    /// The amplitude, in units of the threshold of this equation.
    pub a: f64,
    pub omega: f64,
    /// `delta = pi/2 - psi`, so that `f = a cos(omega tau - delta)` and `a cos(delta) = 1`.
    delta: f64,
    pub shape: Shape,
}

/// What distinguishes the two equations.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Shape {
    /// Eq. 4.
    Slender,
    /// Eq. 2, for a block of slenderness `alpha`.
    Exact { alpha: f64, sin: f64, cos: f64 },
}

impl Motion {
    /// The motion of `case` under `equation`; `None` when the excitation never exceeds the threshold of Eq. 1.
    pub fn new(case: &Case, equation: Equation) -> Result<Option<Self>, Decline> {
        let (shape, epsilon) = match (equation, case.slenderness()) {
            (Equation::Linear, _) => (Shape::Slender, case.epsilon()),
            (Equation::Nonlinear, None) => return Err(Decline::NeedsSlenderness),
            (Equation::Nonlinear, Some(slenderness)) => {
                (Shape::exact(slenderness.alpha()), threshold_excess(case.epsilon(), slenderness).0)
            }
        };
        if epsilon <= 0.0 {
            return Ok(None);
        }
        let omega = case.omega();
        if !OMEGA.contains(&omega) {
            return Err(Decline::OutOfRange { field: "omega", value: omega, allowed: "1e-6 <= omega <= 1e6" });
        }
        if epsilon < LEAST_EPSILON {
            let allowed = "above the threshold by 1e-60 or more";
            return Err(Decline::OutOfRange { field: "epsilon", value: case.epsilon(), allowed });
        }
        let a = 1.0 + epsilon;
        // cos(delta) = 1/a, by the half angle: 1 - 1/a = epsilon/a = 2 sin^2(delta/2).
        let delta = 2.0 * (epsilon / (2.0 * a)).sqrt().asin();
        Ok(Some(Self { a, omega, delta, shape }))
    }

    /// `i + f(tau)` as a product, which keeps its relative accuracy where the sum would cancel:
    /// `f - 1 = a [cos(2y - delta) - cos(delta)]` and `f + 1 = a [cos(2y - delta) + cos(delta)]` with `y = omega tau/2`.
    pub fn excess(&self, i: f64, tau: f64) -> f64 {
        let y = 0.5 * self.omega * tau;
        if i < 0.0 {
            2.0 * self.a * y.sin() * (self.delta - y).sin()
        } else {
            2.0 * self.a * y.cos() * (self.delta - y).cos()
        }
    }

    /// The excitation seen from the start of a flight of sign `i` at `tau`.
    pub fn forcing(&self, i: f64, tau: f64) -> Forcing<'static> {
        let (sin, cos) = (self.omega * tau - self.delta).sin_cos();
        let wave = Wave { value: self.a * cos, quadrature: -self.a * sin, half_omega: 0.5 * self.omega };
        Forcing { excess: self.excess(i, tau), change: Change::Wave(wave) }
    }

    /// The time at which the excitation is the mirror image of its start, `T/2 = pi/omega`.
    pub fn half_period(&self) -> f64 {
        core::f64::consts::PI / self.omega
    }
}

impl Shape {
    /// Of the block as it is, of slenderness `alpha`.
    pub fn exact(alpha: f64) -> Self {
        let (sin, cos) = alpha.sin_cos();
        Self::Exact { alpha, sin, cos }
    }

    /// `phi''` of Eq. 4 or Eq. 2, where `g = i + f`.
    ///
    /// Eq. 4 is `phi'' = phi - i - f` as it stands. In Eq. 2, with `u_g''/g = tan(alpha) f`, the terms that do not vanish with `phi` and
    /// `g` cancel exactly, which leaves `phi'' = [sin(alpha phi) - g sin(alpha) cos(alpha (i - phi))] / (alpha cos(alpha))`.
    #[inline]
    pub fn acceleration(&self, i: f64, g: f64, phi: f64) -> f64 {
        match *self {
            Self::Slender => phi - g,
            Self::Exact { alpha, sin, cos } => {
                let (s, c) = (alpha * phi).sin_cos();
                (s - g * sin * (cos * c + i * sin * s)) / (alpha * cos)
            }
        }
    }

    /// `d phi''/d phi`, the Jacobian that the implicit methods need.
    pub fn stiffness(&self, i: f64, g: f64, phi: f64) -> f64 {
        match *self {
            Self::Slender => 1.0,
            Self::Exact { alpha, sin, cos } => {
                let (s, c) = (alpha * phi).sin_cos();
                (c - g * sin * (i * sin * c - cos * s)) / cos
            }
        }
    }

    /// `phi''/(-g)` at `phi = 0`: 1 for Eq. 4, `sin(alpha)/alpha` for Eq. 2.
    pub fn gain(&self) -> f64 {
        match *self {
            Self::Slender => 1.0,
            Self::Exact { alpha, sin, .. } => sin / alpha,
        }
    }
}

/// `a - 1` in units of tan(alpha), the threshold of Eq. 1, where the amplitude `a alpha` of Eq. 5 is `a alpha cot(alpha)`; and its rounding, relative, which is
/// large next to the threshold, where nearly all of it cancels.
pub fn threshold_excess(epsilon: f64, slenderness: Slenderness) -> (f64, f64) {
    let alpha = slenderness.alpha();
    match slenderness.normalisation() {
        Normalisation::Threshold => (epsilon, 0.0),
        Normalisation::Slender => {
            let lost = alpha_cot_alpha_minus_one(alpha);
            let excess = epsilon * (1.0 + lost) + lost;
            (excess, 2.0 * f64::EPSILON * (1.0 + lost.abs() / excess.abs()))
        }
    }
}

/// `alpha cot(alpha) - 1 = -alpha^2/(3 - alpha^2/(5 - alpha^2/(7 - ..)))`, Lambert's fraction for the tangent: nothing cancels in it.
fn alpha_cot_alpha_minus_one(alpha: f64) -> f64 {
    let x = alpha * alpha;
    let tail = (1..=15).rev().fold(33.0, |tail, k| f64::from(2 * k + 1) - x / tail);
    -x / tail
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(case: &Case, equation: Equation) -> Motion {
        Motion::new(case, equation).unwrap_or(None).unwrap_or_else(|| panic!("{case:?} rocks"))
    }

    fn case(a: f64, omega: f64) -> Case {
        Case::from_amplitude(a, omega, 0.9).unwrap_or_else(|e| panic!("{e}"))
    }

    fn slender(alpha: f64, normalisation: Normalisation) -> Slenderness {
        Slenderness::new(alpha, normalisation).unwrap_or_else(|e| panic!("{e}"))
    }

    /// The excitation as printed: `a sin(omega tau + psi)` with `psi = asin(1/a)` (Eqs 4 and 12).
    fn printed(a: f64, omega: f64, tau: f64) -> f64 {
        a * (omega * tau + (1.0 / a).asin()).sin()
    }

    #[test]
    fn linear_acceleration_is_eq_4_as_printed() {
        let motion = motion(&case(1.3, 1.7), Equation::Linear);
        for (i, tau, s, phi) in [(-1.0, 0.0, 0.3, -0.2), (1.0, 0.4, 0.9, 0.5), (-1.0, 2.0, 0.01, -1e-4)] {
            let expected = phi - i - printed(1.3, 1.7, tau + s);
            let found = motion.shape.acceleration(i, motion.forcing(i, tau).at(s), phi);
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }

    #[test]
    fn nonlinear_acceleration_is_eq_2_as_printed() {
        for (alpha, normalisation) in [
            (0.2, Normalisation::Threshold),
            (0.7, Normalisation::Threshold),
            (1.25, Normalisation::Threshold),
            (1.5, Normalisation::Threshold),
            (0.3, Normalisation::Slender),
        ] {
            let motion = motion(&case(1.3, 1.7).with_slenderness(slender(alpha, normalisation)), Equation::Nonlinear);
            let ground = match normalisation {
                Normalisation::Threshold => 1.3 * alpha.tan(),
                Normalisation::Slender => 1.3 * alpha,
            };
            for (i, tau, s, phi) in [(-1.0, 0.0, 0.3, -0.2), (1.0, 0.4, 0.9, 0.5), (-1.0, 2.0, 0.01, -1e-4)] {
                // Rocking starts when u_g''/g reaches tan(alpha) (Eq. 1).
                let psi = (alpha.tan() / ground).asin();
                let ug = ground * (1.7 * (tau + s) + psi).sin();
                let angle: f64 = alpha * (i - phi);
                let expected = -(angle.sin() + ug * angle.cos()) / alpha;
                let g = motion.forcing(i, tau).at(s);
                let found = motion.shape.acceleration(i, g, phi);
                assert!((found - expected).abs() < 1e-13, "{found} {expected}");
                let h = 1e-6;
                let slope =
                    (motion.shape.acceleration(i, g, phi + h) - motion.shape.acceleration(i, g, phi - h)) / (2.0 * h);
                assert!((motion.shape.stiffness(i, g, phi) - slope).abs() < 1e-8, "{slope}");
            }
        }
    }

    #[test]
    fn excess_keeps_its_digits_where_the_sum_cancels() {
        let motion = motion(&case(1.0001, 2.0), Equation::Linear);
        let (first, _) = motion.forcing(-1.0, 0.0).derivatives();
        assert_eq!(motion.excess(-1.0, 0.0), 0.0);
        assert!((motion.excess(-1.0, 1e-30) / (first * 1e-30) - 1.0).abs() < 1e-12);
        // The mirror image, half a period later; f = -1 there, and the sum of the two would be rounding.
        assert!(motion.excess(1.0, motion.half_period()).abs() < 1e-15);
        assert!((motion.excess(1.0, 0.3) - (1.0 + printed(1.0001, 2.0, 0.3))).abs() < 1e-14);
    }

    #[test]
    fn slender_normalisation_has_its_own_threshold() {
        for alpha in [1e-6, 1e-3, 0.05, 0.2, 0.8, 1.5] {
            let direct = alpha / f64::tan(alpha) - 1.0;
            let found = alpha_cot_alpha_minus_one(alpha);
            assert!((found - direct).abs() < 3e-16 * (1.0 + direct.abs()), "{alpha}: {found} {direct}");
        }
        let below = case(1.01, 2.0).with_slenderness(slender(0.2, Normalisation::Slender));
        assert!(matches!(Motion::new(&below, Equation::Nonlinear), Ok(None)));
    }

    #[test]
    fn the_derivatives_of_the_excitation_are_those_of_its_values() {
        for (omega, tau) in [(0.7, 0.3), (2.0, 0.0), (5.0, 1.1)] {
            let motion = motion(&case(1.3, omega), Equation::Linear);
            assert!((motion.half_period() * omega / core::f64::consts::PI - 1.0).abs() < 1e-15);
            for i in [1.0, -1.0] {
                let forcing = motion.forcing(i, tau);
                let (slope, curvature) = forcing.derivatives();
                let h = 1e-4;
                let (before, at, after) = (forcing.at(-h), forcing.at(0.0), forcing.at(h));
                assert!(((after - before) / (2.0 * h) - slope).abs() < 1e-6 * omega.powi(3), "{omega} {tau}");
                assert!(
                    ((after - 2.0 * at + before) / (h * h) - curvature).abs() < 1e-5 * omega.powi(4),
                    "{omega} {tau}"
                );
                assert_eq!(at, motion.excess(i, tau));
            }
        }
    }

    #[test]
    fn the_gain_is_the_acceleration_that_the_excess_makes_on_the_base() {
        let block = |alpha| {
            motion(&case(1.3, 1.7).with_slenderness(slender(alpha, Normalisation::Threshold)), Equation::Nonlinear)
        };
        for motion in [motion(&case(1.3, 1.7), Equation::Linear), block(0.2), block(1.1)] {
            for g in [-0.4, 0.1, 2.0] {
                for i in [1.0, -1.0] {
                    assert!((motion.shape.acceleration(i, g, 0.0) + motion.shape.gain() * g).abs() < 1e-15, "{g} {i}");
                }
            }
        }
    }

    #[test]
    fn what_is_integrated_has_its_limits() {
        let of = |epsilon: f64, omega: f64| {
            let case = Case::from_epsilon(epsilon, omega, 0.9).unwrap_or_else(|e| panic!("{e}"));
            Motion::new(&case, Equation::Linear).map(|motion| motion.is_some())
        };
        for (epsilon, omega) in [(1e-60, 2.0), (0.03, 1e-6), (0.03, 1e6), (1e9, 2.0)] {
            assert_eq!(of(epsilon, omega), Ok(true), "{epsilon} {omega}");
        }
        assert_eq!((of(0.0, 2.0), of(-0.5, 1e-9)), (Ok(false), Ok(false)));
        for (epsilon, omega, expected) in
            [(0.99e-60, 2.0, "epsilon"), (0.03, 0.99e-6, "omega"), (0.03, 1.01e6, "omega")]
        {
            assert!(matches!(of(epsilon, omega), Err(Decline::OutOfRange { field, .. }) if field == expected));
        }
    }
}
