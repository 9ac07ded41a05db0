//! When nothing more has to be integrated: complete chattering, and overturning.

use crate::equation::{Motion, Shape};

impl Motion {
    /// Whether it is certain, after an impact at `tau` that the block leaves with the speed `w`, that infinitely many impacts follow and
    /// accumulate while neither sign of flight is favoured by the excitation (`|f| < 1`).
    ///
    /// Take a window of length `r = x g_min/L`, with `g_min = min(1 - f, 1 + f)` and `L` a bound on how fast the acceleration towards the
    /// base changes, over [`Motion::gain`]: `omega a`, and for the rotation, which stays below `v T/4` in a flight of duration `T` and speed
    /// `v`, [`Motion::sensitivity`] times the speed. On it the acceleration for each sign of flight stays above `(1-x) g` times the gain.
    /// A flight that leaves with the speed `v` lasts `2v/((1-x) g)` over the gain at the most and comes back with `v exp(L T/(2(1-x) g))`
    /// at the most, so that all flights in the window together gain less than the factor `exp(x/(2(1-x)))`. If the geometric sum of their
    /// bounds ends within the window, the window was legitimate.
    pub fn comes_to_rest(&self, eta: f64, tau: f64, w: f64) -> bool {
        const X: f64 = 0.4;
        const GROWTH: f64 = 1.4; // exp(1/3) < 1.4
        let (right, left) = (self.excess(1.0, tau), -self.excess(-1.0, tau));
        let (least, most) = (right.min(left), right.max(left));
        if least <= 0.0 {
            return false;
        }
        let r = X * least / (self.omega * self.a + 2.0 * self.sensitivity() * w);
        // The flight of the side that holds the block less comes first, at the worst.
        let flights = 2.0 * w / self.gain() * (1.0 / least + eta / most) / (1.0 - eta * eta);
        GROWTH * flights <= (1.0 - X) * r
    }

    /// A bound on how fast the acceleration towards the base, over [`Motion::gain`], changes with the rotation `u` while `|g| <= 2`:
    /// it is `g - u` for Eq. 4, and `g [cos(alpha u) + tan(alpha) sin(alpha u)] - sin(alpha u)/(sin(alpha) cos(alpha))` for Eq. 2.
    fn sensitivity(&self) -> f64 {
        match self.shape {
            Shape::Slender => 1.0,
            Shape::Exact { alpha, sin, cos } => 2.0 * alpha * (1.0 + sin / cos) + alpha / (sin * cos),
        }
    }

    /// Whether no return to the base is possible from the rotation `u = i phi >= 0` with the velocity `du = i phi'`.
    ///
    /// Eq. 4: `z = u + u'` obeys `z' = z - 1 - i f >= z - (1 + a)`, so once above `1 + a` it grows for ever; but a return to `u = 0` needs
    /// `u' <= 0` and with it `z <= 0`.
    ///
    /// Eq. 2: the angle past the balance, `beta = alpha (u - 1)`, obeys `beta'' = sin(beta) - i f tan(alpha) cos(beta)`, which is not
    /// negative for any excitation from `atan(a tan(alpha))` up to a right angle, where the block lies on its side; so moving outwards
    /// from there it gets that far.
    pub fn is_past_return(&self, u: f64, du: f64) -> bool {
        match self.shape {
            Shape::Slender => u + du > 1.0 + self.a,
            Shape::Exact { alpha, sin, cos } => du >= 0.0 && alpha * (u - 1.0) >= (self.a * sin / cos).atan(),
        }
    }
}
