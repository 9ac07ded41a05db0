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

/// The value and the derivative of a polynomial at `x`: Horner's rule in `x²` for the even and the odd powers, which do not wait for one another.
pub fn evaluate(coefficients: &[f64], x: f64) -> (f64, f64) {
    let z = x * x;
    let (pairs, rest) = coefficients.as_chunks::<2>();
    let last = rest.first().copied().unwrap_or(0.0);
    let (mut even, mut odd, mut even_slope, mut odd_slope) = (last, 0.0, 0.0, 0.0);
    for [of_even, of_odd] in pairs.iter().rev() {
        even_slope = even_slope * z + even;
        odd_slope = odd_slope * z + odd;
        even = even * z + of_even;
        odd = odd * z + of_odd;
    }
    (even + x * odd, odd + 2.0 * (x * even_slope + z * odd_slope))
}

/// How many coefficients a series gets.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// Its order at most.
    pub most: usize,
    /// It ends with two terms below this part of its value or slope at the start, at twice the unit of time.
    pub negligible: f64,
}

/// The products with the rate of change of two series at once, `Σ_{j<=k} r_j a_{k-j}`, term by term as they come.
///
/// What a new term adds is added to all coefficients that it is in: sums that do not wait for one another.
struct Products {
    rate: [f64; ORDER + 1],
    of: [[f64; 2]; ORDER + 1],
    sums: [[f64; 2]; ORDER + 1],
}

impl Products {
    fn new() -> Self {
        Self { rate: [0.0; ORDER + 1], of: [[0.0; 2]; ORDER + 1], sums: [[0.0; 2]; ORDER + 1] }
    }

    /// Adds the coefficients `k` of the rate and of the two series, where all those before are, to the sums up to `last`.
    fn add(&mut self, k: usize, last: usize, speed: f64, new: [f64; 2]) {
        let before = self.of.iter().zip(&self.rate).take(k);
        let sums = self.sums.get_mut(k..=last).unwrap_or_default();
        for (sum, (old, rate)) in sums.iter_mut().zip(before) {
            *sum = [sum[0] + (speed * old[0] + rate * new[0]), sum[1] + (speed * old[1] + rate * new[1])];
        }
        if let Some(sum) = self.sums.get_mut(2 * k) {
            *sum = [sum[0] + speed * new[0], sum[1] + speed * new[1]];
        }
        if let (Some(rate), Some(of)) = (self.rate.get_mut(k), self.of.get_mut(k)) {
            (*rate, *of) = (speed, new);
        }
    }

    /// The coefficients `k`, once all terms up to it are added.
    fn at(&self, k: usize) -> [f64; 2] {
        self.sums.get(k).copied().unwrap_or_default()
    }
}

/// The series of `χ(ξ)` from the state `χ, dχ/dξ` under `forcing`, with so many `terms`.
///
/// With `σ = sin(αPχ)/(αP)`, `C = cos(αPχ)` and `G(ξ)`, the equation of [`crate::equation`] in these units is
/// `χ'' = (T²/cos α) σ - G D`, `D = (T²/cos α) sin²(α) σ + (T²/P) K C`, and `σ' = C χ'`, `C' = -(αP)² σ χ'`.
pub fn expand(block: &Block, forcing: &Forcing, scale: &Scale, state: (f64, f64), terms: Terms) -> Series {
    let order = terms.most.min(ORDER);
    // G_0 = 1 + i f, G_k = i f^(k) (ωT)^k/k!, with f'' = -f in x.
    let mut gravity = Series::new();
    gravity.push(forcing.gravity);
    let (mut this, mut next, mut power) = (forcing.slope, -forcing.value, 1.0);
    let step = block.omega * scale.time;
    for k in 1..order {
        power *= step * inverse(k);
        gravity.push(this * power);
        (this, next) = (next, -this);
    }
    expand_under(block, &gravity, scale, state, terms)
}

/// The same under any `G(ξ)`, given by its coefficients in these units.
#[inline]
pub fn expand_under(block: &Block, gravity: &Series, scale: &Scale, state: (f64, f64), terms: Terms) -> Series {
    let Scale { time, velocity } = *scale;
    let angle = block.alpha * velocity * time;
    let curvature = time * time / block.cos_alpha;
    let weight = time / velocity * block.slope;
    let order = terms.most.min(ORDER);
    let negligible = terms.negligible * state.0.abs().max(state.1.abs());

    let z = angle * state.0;
    let mut chi = Series::new();
    chi.push(state.0);
    chi.push(state.1);
    let (mut products, mut pulled) = (Products::new(), [0.0; ORDER + 1]);
    let sine = if z.abs() < 1e-5 { state.0 * (1.0 - z * z / 6.0) } else { z.sin() / angle };
    let (mut rate, mut waves) = (state.1, [sine, z.cos()]);
    let mut stretch = 4.0;
    for k in 0..order - 1 {
        if k > 0 {
            let [of_sine, of_cosine] = products.at(k - 1);
            waves = [of_cosine * inverse(k), -angle * angle * of_sine * inverse(k)];
        }
        products.add(k, order, rate, waves);
        let [sine, cosine] = waves;
        let weighed = curvature * block.sin2_alpha * sine + weight * cosine;
        let sums = pulled.get_mut(k..).unwrap_or_default();
        sums.iter_mut().zip(gravity.from(0)).for_each(|(sum, pull)| *sum += weighed * pull);
        let second = curvature * sine - sums.first().copied().unwrap_or(0.0);
        rate = second * inverse(k + 1);
        let (before, coefficient) = (chi.last(), rate * inverse(k + 2));
        chi.push(coefficient);
        if k > 1 && coefficient.abs() * stretch <= negligible && 0.5 * before.abs() * stretch <= negligible {
            break;
        }
        stretch *= 2.0;
    }
    chi
}

/// `1/k` for a small count.
fn inverse(k: usize) -> f64 {
    INVERSES.get(k).copied().unwrap_or(0.0)
}

/// `1/k`, and 0 for `k = 0`. Made by the compiler, which would refuse an index out of bounds.
#[allow(clippy::indexing_slicing)]
const INVERSES: [f64; ORDER + 2] = {
    let mut inverses = [0.0; ORDER + 2];
    let mut k = 1;
    while k < inverses.len() {
        inverses[k] = 1.0 / k as f64;
        k += 1;
    }
    inverses
};

#[cfg(test)]
mod tests;
