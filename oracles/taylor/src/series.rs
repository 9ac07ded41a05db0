//! The Taylor series of one step of a flight, by the usual recurrences.

use crate::equation::{Block, Forcing};

/// The highest order of a series.
pub const ORDER: usize = 24;

/// Coefficients `c_0, c_1, ...` of a polynomial.
#[derive(Debug, Clone, Copy)]
pub struct Series {
    coefficients: [f64; ORDER + 1],
    len: usize,
}

/// The units of a flight: `s = T ξ`, `u = P χ`.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// `T`.
    pub time: f64,
    /// `P/T`, the unit of velocity. `P` itself may underflow, and may.
    pub velocity: f64,
}

impl Series {
    /// The series without coefficients.
    pub fn new() -> Self {
        Self { coefficients: [0.0; ORDER + 1], len: 0 }
    }

    /// Adds the next coefficient. What is beyond the highest order is left off.
    pub fn push(&mut self, value: f64) {
        if let Some(slot) = self.coefficients.get_mut(self.len) {
            *slot = value;
            self.len += 1;
        }
    }

    /// The coefficients from `skip` on.
    pub fn from(&self, skip: usize) -> &[f64] {
        self.coefficients.get(skip..self.len).unwrap_or(&[])
    }

    /// Coefficient `k` of the product with `other`: `Σ_{j<=k} a_j b_{k-j}`.
    fn product(&self, other: &Self, k: usize) -> f64 {
        self.coefficients.iter().zip(other.coefficients.iter().take(k + 1).rev()).map(|(a, b)| a * b).sum()
    }

    /// The last of the coefficients.
    fn last(&self) -> f64 {
        self.from(0).last().copied().unwrap_or(0.0)
    }
}

impl Default for Series {
    fn default() -> Self {
        Self::new()
    }
}

/// The value and the derivative of a polynomial at `x` (Horner).
pub fn evaluate(coefficients: &[f64], x: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(p, d), c| (p * x + c, d * x + p))
}

/// The series of `χ(ξ)` from the state `χ, dχ/dξ` under `forcing`, to order `order`.
///
/// With `σ = sin(αPχ)/(αP)`, `C = cos(αPχ)` and `G(ξ)`, the equation of [`crate::equation`] in these units is
/// `χ'' = (T²/cos α)(σ - sin²(α) Gσ) - (T²/P) K G C`, and `σ' = C χ'`, `C' = -(αP)² σ χ'`.
pub fn expand(block: &Block, forcing: &Forcing, scale: &Scale, state: (f64, f64), order: usize) -> Series {
    let Scale { time, velocity } = *scale;
    let angle = block.alpha * velocity * time;
    let curvature = time * time / block.cos_alpha;
    let weight = time / velocity * block.slope;

    // G_0 = 1 + i f, G_k = i f^(k) (ωT)^k/k!, with f'' = -f in x.
    let mut gravity = Series::new();
    gravity.push(forcing.gravity);
    let (mut this, mut next, mut power) = (forcing.slope, -forcing.value, 1.0);
    let step = block.omega * time;
    for k in 1..order.min(ORDER) {
        power *= step / count(k);
        gravity.push(this * power);
        (this, next) = (next, -this);
    }

    let z = angle * state.0;
    let mut chi = Series::new();
    chi.push(state.0);
    chi.push(state.1);
    let mut rate = Series::new();
    rate.push(state.1);
    let mut sin = Series::new();
    sin.push(if z.abs() < 1e-5 { state.0 * (1.0 - z * z / 6.0) } else { z.sin() / angle });
    let mut cos = Series::new();
    cos.push(z.cos());
    for k in 0..order.min(ORDER) - 1 {
        if k > 0 {
            let (s, c) = (rate.product(&cos, k - 1), rate.product(&sin, k - 1));
            sin.push(s / count(k));
            cos.push(-angle * angle * c / count(k));
        }
        let pull = curvature * (sin.last() - block.sin2_alpha * gravity.product(&sin, k));
        let second = pull - weight * gravity.product(&cos, k);
        rate.push(second / count(k + 1));
        chi.push(second / (count(k + 1) * count(k + 2)));
    }
    chi
}

/// A small count as a double.
#[allow(clippy::cast_precision_loss)]
fn count(k: usize) -> f64 {
    k as f64
}

#[cfg(test)]
mod tests;
