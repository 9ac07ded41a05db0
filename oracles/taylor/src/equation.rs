//! Eq. 2 in the form that does not cancel.
//!
//! With `f = a sin(ωτ + ψ)`, `sin ψ = 1/a` (Eq. 12), Eq. 2 is `φ'' = -(1/α)[sin(α(i - φ)) + tan(α) f cos(α(i - φ))]`. Write `u = iφ`,
//! the distance from the base, and `G = 1 + i f`, the acceleration towards the base. From
//! `sin(αφ) = i sin(α) cos(α(i - φ)) - cos(α) sin(α(i - φ))`,
//!
//! `u'' = [sin(αu) - G sin(α) cos(α(1 - u))]/(α cos α) = [sin(αu)(1 - G sin²α) - G sin(α) cos(α) cos(αu)]/(α cos α)`.
//!
//! Both terms vanish with `u` and `G`, so nothing is lost in a late flight (`u → 0`) or near initiation (`G → 0` for `i = -1`).

use contract::{Normalisation, Slenderness};

/// The constants of one problem.
#[derive(Debug, Clone, Copy)]
pub struct Block {
    /// The frequency ratio `ω`.
    pub omega: f64,
    /// The coefficient of restitution `η` (Eq. 13).
    pub eta: f64,
    /// The slenderness angle `α`.
    pub alpha: f64,
    /// `a`, in multiples of the threshold of Eq. 1; 0 on still ground.
    pub amplitude: f64,
    /// `q = a cos ψ = sqrt(ε(2 + ε))`.
    pub q: f64,
    /// `K = sin(α)/α`.
    pub slope: f64,
    /// `cos α`.
    pub cos_alpha: f64,
    /// `sin² α`.
    pub sin2_alpha: f64,
}

/// The forcing at one moment, seen from one side.
#[derive(Debug, Clone, Copy)]
pub struct Forcing {
    /// `G = 1 + i f`.
    pub gravity: f64,
    /// `i f`.
    pub value: f64,
    /// `i df/dx`, with `x = ωτ`.
    pub slope: f64,
}

impl Block {
    /// The block whose excitation is `1 + epsilon` times the threshold of Eq. 1.
    pub fn new(epsilon: f64, omega: f64, eta: f64, alpha: f64) -> Self {
        let (sin, cos) = alpha.sin_cos();
        Self {
            omega,
            eta,
            alpha,
            amplitude: 1.0 + epsilon,
            q: (epsilon * (2.0 + epsilon)).sqrt(),
            slope: sin / alpha,
            cos_alpha: cos,
            sin2_alpha: sin * sin,
        }
    }

    /// The same block on ground that has come to rest.
    pub fn on_still_ground(self) -> Self {
        Self { amplitude: 0.0, ..self }
    }

    /// The forcing at `τ = tau`, for the flight of sign `side`. With `x = ωτ`: `f = q sin x + cos x`, hence
    /// `1 - f = 2 sin(x/2)[sin(x/2) - q cos(x/2)]` and `1 + f = 2 cos(x/2)[cos(x/2) + q sin(x/2)]`.
    pub fn forcing(&self, side: f64, tau: f64) -> Forcing {
        if self.amplitude == 0.0 {
            return Forcing { gravity: 1.0, value: 0.0, slope: 0.0 };
        }
        let (sh, ch) = (0.5 * self.omega * tau).sin_cos();
        let (sin, cos) = (2.0 * sh * ch, (ch - sh) * (ch + sh));
        let gravity = if side < 0.0 { 2.0 * sh * (sh - self.q * ch) } else { 2.0 * ch * (ch + self.q * sh) };
        Forcing { gravity, value: side * (self.q * sin + cos), slope: side * (self.q * cos - sin) }
    }

    /// Whether no return is possible from the rotation `u` with velocity `w`, both counted away from the base.
    ///
    /// With `β = α(u - 1)` the angle past the balance, Eq. 2 is `β'' = sin β - i f tan(α) cos β`, which is not negative for
    /// `tan β >= a tan α`, `β < π/2`. From there the block turns on to lie on its side, at `β = π/2 - α`.
    pub fn overturned(&self, u: f64, w: f64) -> bool {
        w >= 0.0 && self.alpha * (u - 1.0) >= (self.amplitude * self.alpha.tan()).atan()
    }

    /// Whether infinitely many impacts are certain to follow one after which the block leaves with speed `w` at `tau`.
    ///
    /// The way of section 8 of the theory notes. While `0 < G < 2` and `u < 1`, the acceleration towards the base differs from
    /// `K G` by at most `u/cos α + K G α²u²/2 <= 2 κ K u`, with `κ = α/(sin α cos α)`. In a window `r = x min(G)/(ωa + 4κw)`
    /// it therefore keeps `1 - x` of `K G`, as no flight that leaves with at most `1.4 w` rises above `0.7 w Δτ`. Over a flight
    /// of length `Δτ` it varies by at most `K (ωa + 4κw) Δτ`, which multiplies the speed by at most
    /// `sqrt(M/m) <= exp((M - m)/(2m))`; over all flights of the window that makes `exp(x/(2(1 - x))) < 1.4` for `x = 0.4`.
    /// Hence the flights last at most `1.4/(1 - x)` times their geometric sum, and all fit into the window when that is below `r`.
    pub fn certainly_rests(&self, tau: f64, w: f64) -> bool {
        const X: f64 = 0.4;
        let (ga, gb) = (self.forcing(1.0, tau).gravity, self.forcing(-1.0, tau).gravity);
        let (low, high) = (ga.min(gb), ga.max(gb));
        if low <= 0.0 || low.is_nan() {
            return false;
        }
        let kappa = 1.0 / (self.slope * self.cos_alpha);
        let window = X * low / (self.omega * self.amplitude + 4.0 * kappa * w);
        let sum = 2.0 * w * (1.0 / low + self.eta / high) / ((1.0 - self.eta * self.eta) * self.slope);
        1.4 * sum <= (1.0 - X) * window
    }
}

/// `a - 1` in multiples of the threshold of Eq. 1, and the relative rounding error that it carries.
///
/// Under the slender normalisation the amplitude is `a α/tan α` thresholds, so this is `[ε α cos α - (sin α - α cos α)]/sin α`.
pub fn excess(epsilon: f64, slenderness: Slenderness) -> (f64, f64) {
    let alpha = slenderness.alpha();
    match slenderness.normalisation() {
        Normalisation::Threshold => (epsilon, 0.0),
        Normalisation::Slender => {
            let (sin, cos) = alpha.sin_cos();
            let (gain, loss) = (epsilon * alpha * cos, sin_less_x_cos(alpha));
            let difference = gain - loss;
            (difference / sin, f64::EPSILON * (1.0 + loss / difference.abs()))
        }
    }
}

/// `sin x - x cos x = Σ (-1)^(k+1) 2k x^(2k+1)/(2k+1)!`, for `0 < x < π/2`.
fn sin_less_x_cos(x: f64) -> f64 {
    let mut power = x;
    let mut sum = 0.0;
    for k in 1..=16_u32 {
        let k2 = f64::from(2 * k);
        power *= -x * x / (k2 * (k2 + 1.0));
        sum -= k2 * power;
    }
    sum
}

#[cfg(test)]
mod tests;
