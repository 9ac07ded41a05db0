//! The Taylor series of a stretch of a flight on the nonlinear equation, with coefficients that are power series in `m = sin²α`.
//!
//! With `u = iφ` and `G = 1 + i f`, Eq. 2 under threshold normalisation is
//! `u'' = [sin(αu)(1 - G sin²α) - G sin(α) cos(α) cos(αu)]/(α cos α)`. For `w = (α/sin α) u` it depends on the slenderness through `m` alone:
//!
//! ```text
//! w'' = σ (1 - m G)/sqrt(1 - m) - G C      σ = sin(sqrt(m) w)/sqrt(m)   C = cos(sqrt(m) w)
//!     = w - G - m [(1/2 + i f) w - G w²/2 + w³/6] + O(m²)
//! ```
//!
//! and for `m = 0` it is Eq. 4. In the units `T` of time and `V` of velocity, `w = V T χ`, it becomes
//! `χ'' = T² σ (1 - m G)/sqrt(1 - m) - (T/V) G C` with `σ' = C χ'` and `C' = -m (V T)² σ χ'`.

use super::jet::Jet;

/// The units of time and velocity. That of the rotation, their product, may underflow, and may.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    pub time: f64,
    pub velocity: f64,
}

/// The coefficients of `χ` by the powers of time, from `χ` and `χ'` at the start and those of `G`, of which there are as many as will be used.
pub(crate) fn expand(units: Units, (rotation, velocity): (Jet, Jet), pull: &[Jet]) -> Vec<Jet> {
    let Units { time, velocity: speed } = units;
    let small = Jet::SQUARED_SINE.scaled((speed * time) * (speed * time));
    let z = (small * rotation * rotation).scaled(-1.0);
    // Exact: z³ is of the order m³.
    let mut sine = vec![rotation * (Jet::ONE + z.scaled(1.0 / 6.0) * (Jet::ONE + z.scaled(1.0 / 20.0)))];
    let mut cosine = vec![Jet::ONE + z.scaled(0.5) * (Jet::ONE + z.scaled(1.0 / 12.0))];
    let (mut series, mut rate) = (vec![rotation, velocity], vec![velocity]);
    for k in 0..pull.len() {
        let n = k as f64;
        if k > 0 {
            let (sine_next, cosine_next) = (product(&rate, &cosine, k - 1), small * product(&rate, &sine, k - 1));
            sine.push(sine_next.scaled(1.0 / n));
            cosine.push(cosine_next.scaled(-1.0 / n));
        }
        let risen = sine.last().copied().unwrap_or(Jet::ZERO) - Jet::SQUARED_SINE * product(pull, &sine, k);
        let acceleration = (Jet::SECANT * risen).scaled(time * time) - product(pull, &cosine, k).scaled(time / speed);
        rate.push(acceleration.scaled(1.0 / (n + 1.0)));
        series.push(acceleration.scaled(1.0 / ((n + 1.0) * (n + 2.0))));
    }
    series
}

/// The coefficient of the power `k` of a product of two series.
fn product(one: &[Jet], other: &[Jet], k: usize) -> Jet {
    let pairs = one.iter().zip(other.iter().take(k + 1).rev());
    pairs.fold(Jet::ZERO, |sum, (x, y)| sum + *x * *y)
}

/// A polynomial and its derivative (Horner's rule).
pub(crate) fn evaluate(coefficients: &[Jet], at: Jet) -> (Jet, Jet) {
    let start = (Jet::ZERO, Jet::ZERO);
    coefficients.iter().rev().fold(start, |(value, slope), coefficient| (value * at + *coefficient, slope * at + value))
}
