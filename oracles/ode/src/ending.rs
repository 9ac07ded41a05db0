//! When nothing more has to be integrated: complete chattering, and overturning.

use crate::equation::{Motion, Shape};

/// What share of the pull may change in the window of [`Shape::time_to_rest`].
const X: f64 = 0.4;
/// What all flights in that window may gain together: `exp(X/(2(1-X))) = exp(1/3) < 1.4`.
const GROWTH: f64 = 1.4;

impl Motion {
    /// Whether it is certain, after an impact at `tau` that the block leaves with the speed `w`, that infinitely many impacts follow and
    /// accumulate while neither sign of flight is favoured by the excitation (`|f| < 1`).
    pub fn comes_to_rest(&self, eta: f64, tau: f64, w: f64) -> bool {
        let pulls = Pulls { own: self.excess(1.0, tau), other: -self.excess(-1.0, tau), rounding: 0.0 };
        self.shape.time_to_rest(eta, &pulls, w, |_| Some(self.omega * self.a)).is_some()
    }
}

/// What holds the block down after an impact, `1 + i f` and `1 - i f` for the side `i` that it leaves to, and what they may be off by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pulls {
    pub own: f64,
    pub other: f64,
    pub rounding: f64,
}

impl Shape {
    /// The least and the most time in which, after an impact that the block leaves with the speed `w`, infinitely many impacts follow and accumulate while the
    /// ground still holds it down; `None` where that is not certain. `steepest` bounds `|f'|` over so long a window from the impact on, unless `f` jumps in it.
    ///
    /// In a window of length `r` the acceleration towards the base, over [`Shape::gain`], changes for each sign of flight by `d = r L` at the most. `L` bounds how
    /// fast it does: `|f'|`, and for the rotation, which stays below `v T/4` in a flight of duration `T` and speed `v`, twice [`Shape::sensitivity`] times the
    /// speed. With `x = d/g_min`, `g_min = min(1 - f, 1 + f)`, it stays between `(1-x) g` and `(1+x) g`, so that a flight that leaves with the speed `v` lasts
    /// between `2v/((1+x) g)` and `2v/((1-x) g)` over the gain. About the middle `m` of a flight of `u'' = -A(t)` the speeds at its ends differ by
    /// `(1/T) int_0^{T/2} 2s [A(m+s) - A(m-s)] ds`, which is no more than `L T^2/6` times the gain, or a share `L T/(3 (1-x) g)` of the speed; so all flights in
    /// the window together gain or lose less than the factor `exp(x/(2(1-x)))`. If the geometric sum of their upper bounds ends within the window, the window was
    /// legitimate.
    pub fn time_to_rest(
        &self,
        eta: f64,
        pulls: &Pulls,
        w: f64,
        steepest: impl FnOnce(f64) -> Option<f64>,
    ) -> Option<(f64, f64)> {
        let Pulls { own, other, rounding } = *pulls;
        let (least, most) = (own.min(other), own.max(other));
        if least <= 0.0 {
            return None;
        }
        let sum = |first: f64, second: f64| 2.0 * w / self.gain() * (1.0 / first + eta / second) / (1.0 - eta * eta);
        // The flight of the side that holds the block less comes first, at the worst.
        let window = GROWTH * sum(least, most) / (1.0 - X);
        let share = |steepest: f64| (window * (steepest + 2.0 * self.sensitivity() * w) + rounding) / least;
        // Before the ground is looked at over a long window.
        if share(0.0) > X {
            return None;
        }
        let x = share(steepest(window)?);
        let (flights, gain) = (sum(own, other), (0.5 * x / (1.0 - x)).exp());
        (x <= X).then(|| (flights / gain / (1.0 + x), flights * gain / (1.0 - x)))
    }

    /// The same on still ground, where the energy of the tilt at the balance, `1/2` for Eq. 4 and `(1 - cos alpha)/alpha^2` for Eq. 2, is more
    /// than any flight that lands has: it lands as fast as it left.
    pub fn comes_to_rest_on_still_ground(&self, w: f64) -> bool {
        match *self {
            Self::Slender => w < 1.0,
            Self::Exact { alpha, .. } => w < 2.0 * (0.5 * alpha).sin() / alpha,
        }
    }

    /// A bound on how fast the acceleration towards the base, over [`Shape::gain`], changes with the rotation `u` while `|g| <= 2`:
    /// it is `g - u` for Eq. 4, and `g [cos(alpha u) + tan(alpha) sin(alpha u)] - sin(alpha u)/(sin(alpha) cos(alpha))` for Eq. 2.
    fn sensitivity(&self) -> f64 {
        match *self {
            Self::Slender => 1.0,
            Self::Exact { alpha, sin, cos } => 2.0 * alpha * (1.0 + sin / cos) + alpha / (sin * cos),
        }
    }

    /// Whether no return to the base is possible from the rotation `u = i phi >= 0` with the velocity `du = i phi'` while `|f| <= a`.
    ///
    /// Eq. 4: `z = u + u'` obeys `z' = z - 1 - i f >= z - (1 + a)`, so once above `1 + a` it grows for ever; but a return to `u = 0` needs
    /// `u' <= 0` and with it `z <= 0`.
    ///
    /// Eq. 2: the angle past the balance, `beta = alpha (u - 1)`, obeys `beta'' = sin(beta) - i f tan(alpha) cos(beta)`, which is not
    /// negative for any excitation from `atan(a tan(alpha))` up to a right angle, where the block lies on its side; so moving outwards
    /// from there it gets that far.
    pub fn is_past_return(&self, a: f64, u: f64, du: f64) -> bool {
        match *self {
            Self::Slender => u + du > 1.0 + a,
            Self::Exact { alpha, sin, cos } => du >= 0.0 && alpha * (u - 1.0) >= (a * sin / cos).atan(),
        }
    }
}

#[cfg(test)]
mod tests {
    use contract::{Case, Normalisation, Slenderness};

    use super::*;
    use crate::Equation;

    fn motion(omega: f64, alpha: Option<f64>) -> Motion {
        let case = Case::from_epsilon(0.25, omega, 0.9).unwrap_or_else(|e| panic!("{e}"));
        let block = Slenderness::new(alpha.unwrap_or(0.1), Normalisation::Threshold).unwrap_or_else(|e| panic!("{e}"));
        let equation = if alpha.is_some() { Equation::Nonlinear } else { Equation::Linear };
        Motion::new(&case.with_slenderness(block), equation).unwrap_or(None).unwrap_or_else(|| panic!("it rocks"))
    }

    /// When the excitation has come down to `f`.
    fn time_at(f: f64, omega: f64) -> f64 {
        (core::f64::consts::PI - (f / 1.25_f64).asin() - 0.8_f64.asin()) / omega
    }

    /// `1.4 (sum of the flights) <= 0.6 r`, `r = 0.4 g_min/L`, where `L` is `omega a` of a fast excitation and twice the sensitivity times the speed
    /// under one that hardly changes.
    #[test]
    fn rest_is_certain_up_to_the_speed_at_which_the_flights_fill_the_window() {
        for alpha in [None, Some(0.2), Some(0.9)] {
            for f in [0.0, 0.5, -0.7] {
                for eta in [0.3, 0.92] {
                    let (least, most) = (1.0 - f64::abs(f), 1.0 + f64::abs(f));
                    let flights =
                        |motion: &Motion| 2.0 / motion.shape.gain() * (1.0 / least + eta / most) / (1.0 - eta * eta);
                    let (fast, slow) = (motion(1e6, alpha), motion(1e-6, alpha));
                    let at_most = 0.6 * 0.4 * least / (1.4 * 1.25e6 * flights(&fast));
                    let tau = time_at(f, 1e6);
                    assert!(
                        fast.comes_to_rest(eta, tau, 0.99 * at_most) && !fast.comes_to_rest(eta, tau, 1.01 * at_most)
                    );
                    let at_most = (0.6 * 0.4 * least / (1.4 * 2.0 * slow.shape.sensitivity() * flights(&slow))).sqrt();
                    let tau = time_at(f, 1e-6);
                    assert!(
                        slow.comes_to_rest(eta, tau, 0.99 * at_most) && !slow.comes_to_rest(eta, tau, 1.01 * at_most)
                    );
                }
            }
        }
        // Past the threshold on either side nothing rests.
        for f in [1.1, -1.1] {
            assert!(!motion(1e-6, None).comes_to_rest(0.5, time_at(f, 1e-6), 1e-12));
        }
    }

    /// The acceleration over the gain changes no faster with the rotation than that, for `|g| <= 2`.
    #[test]
    fn the_sensitivity_bounds_the_slope_of_the_acceleration() {
        assert_eq!(motion(1.0, None).shape.sensitivity(), 1.0);
        for alpha in [0.05, 0.3, 0.8, 1.3_f64] {
            let motion = motion(1.0, Some(alpha));
            let bound = motion.shape.sensitivity();
            let mut largest = 0.0_f64;
            for g in -20..=20 {
                for u in 0..=40 {
                    for i in [1.0, -1.0] {
                        let slope = motion.shape.stiffness(i, 0.1 * f64::from(g), i * 0.05 * f64::from(u))
                            / motion.shape.gain();
                        largest = largest.max(slope.abs());
                    }
                }
            }
            assert!(largest <= bound && bound < 3.0 * largest, "{alpha}: {largest} {bound}");
            // alpha/(sin cos) = 2 alpha/sin(2 alpha)
            let terms = 2.0 * alpha * (1.0 + alpha.tan()) + 2.0 * alpha / (2.0 * alpha).sin();
            assert!((bound / terms - 1.0).abs() < 1e-13, "{alpha}: {bound} {terms}");
        }
    }

    #[test]
    fn past_the_point_of_no_return_is_where_the_excitation_cannot_bring_it_back() {
        let slender = motion(1.0, None);
        for u in [0.5, 1.0, 2.0] {
            assert!(
                slender.shape.is_past_return(1.25, u, 2.26 - u) && !slender.shape.is_past_return(1.25, u, 2.24 - u),
                "{u}"
            );
        }
        for alpha in [0.2, 0.6_f64] {
            let block = motion(1.0, Some(alpha));
            let balance = 1.0 + (1.25 * alpha.tan()).atan() / alpha;
            for du in [0.0, 3.0] {
                assert!(
                    block.shape.is_past_return(1.25, 1.001 * balance, du)
                        && !block.shape.is_past_return(1.25, 0.999 * balance, du)
                );
            }
            assert!(!block.shape.is_past_return(1.25, 1.5 * balance, -0.01));
        }
    }
}
