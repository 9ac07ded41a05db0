//! The Taylor series of a stretch of a flight on the nonlinear equation, with coefficients that are power series in `μ = 2(1/cos α - 1)`.
//!
//! With `u = iφ` and `G = 1 + i f`, Eq. 2 under threshold normalisation is
//! `u'' = [sin(αu)(1 - G sin²α) - G sin(α) cos(α) cos(αu)]/(α cos α)`. For `w = (α/sin α) u` it depends on the slenderness through
//! `m = sin²α = 1 - 1/(1 + μ/2)²` alone:
//!
//! ```text
//! w'' = (1 + μ/2) σ (1 - m G) - G C      σ = sin(sqrt(m) w)/sqrt(m)   C = cos(sqrt(m) w)
//!     = w - G - μ [(1/2 + i f) w - G w²/2 + w³/6] + O(μ²)
//! ```
//!
//! and for `μ = 0` it is Eq. 4. In the units `T` of time and `V` of velocity, `w = V T χ`, it becomes
//! `χ'' = (1 + μ/2) T² σ (1 - m G) - (T/V) G C` with `σ' = C χ'` and `C' = -m (V T)² σ χ'`.

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
    // The sine and cosine of sqrt(m) V T χ; exact, as z⁴ is of the order μ⁴.
    let [mut first, mut second] = [Jet::ONE; 2];
    for divisors in [[42.0, 30.0], [20.0, 12.0], [6.0, 2.0]] {
        let [of_sine, of_cosine] = divisors;
        first = Jet::ONE + z.scaled(1.0 / of_sine) * first;
        second = Jet::ONE + z.scaled(1.0 / of_cosine) * second;
    }
    let (mut sine, mut cosine) = (vec![rotation * first], vec![second]);
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
