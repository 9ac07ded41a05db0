//! When nothing more has to be integrated: complete chattering, and overturning.

use crate::equation::{Motion, Shape};

impl Motion {
    /// Whether it is certain, after an impact at `tau` that the block leaves with the speed `w`, that infinitely many impacts follow and
    /// accumulate while neither sign of flight is favoured by the excitation (`|f| < 1`).
    ///
    /// On the window `[tau, tau + r]` the excitation stays within `omega a r` of its value, and the rotation `u = |phi|` below the height
    /// `w^2/(2m)` of a flight. With `r` and `w` so small that the two together change the acceleration towards the base by no more than
    /// the share `x` of `g_min = min(1 - f, 1 + f)`, it lies for each sign of flight in `[(1-x) g, (1+x) g]` times [`Motion::gain`].
    /// A flight that leaves with the speed `v` then lasts `2v/m` at the most, and the next one leaves with `q v` at the most,
    /// `q = eta sqrt((1+x)/(1-x))`. If `q < 1` and the geometric sum of these flights ends within the window, the window was legitimate.
    pub fn comes_to_rest(&self, eta: f64, tau: f64, w: f64) -> bool {
        let g_min = self.excess(1.0, tau).min(-self.excess(-1.0, tau));
        if g_min <= 0.0 {
            return false;
        }
        let x = 0.25 * (1.0 - eta * eta);
        let r = 0.5 * x * g_min / (self.omega * self.a);
        let m = self.gain() * (1.0 - x) * g_min;
        let height = 0.5 * w * w / m;
        let q = eta * ((1.0 + x) / (1.0 - x)).sqrt();
        q < 1.0 && self.sensitivity() * height <= 0.5 * x * g_min && 2.0 * w <= r * m * (1.0 - q)
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
