use twofloat::TwoFloat;

use crate::number::{Number, real};

/// A singular function of `x = ε/ε_c` that vanishes at 1.
#[derive(Debug, Clone, Copy)]
pub(super) enum Power {
    /// `(1 - x)^s`.
    Real(TwoFloat),
    /// Real and imaginary part of `(1 - x)^s`, from the real and imaginary part of `s`.
    Pair(TwoFloat, TwoFloat),
}

/// At `η = 0.75` and 96 terms the exponent with which `H` vanishes at the critical amplitude is right to 2e-4 with the periodic factor, and to
/// 2e-3 without; at 0.8 the coefficients say nothing of it that is not lost among the other powers.
const PERIODIC_BELOW: f64 = 0.78;

impl Power {
    /// The singularities of `H` behind its zero, the weakest first: `1 + jβ + l`, and as `η` falls the periodic factor shows, and needs its
    /// place among them.
    pub(super) fn all(exponent: TwoFloat, log_period: TwoFloat, eta: f64) -> Vec<Self> {
        let power = |j: f64, l: f64| real::<TwoFloat>(1.0 + l) + exponent * j;
        let mut real_ones: Vec<TwoFloat> =
            (1..8).flat_map(|j| (0..4).map(move |l| power(f64::from(j), f64::from(l)))).collect();
        real_ones.sort_by(|a, b| a.rounded().total_cmp(&b.rounded()));
        let (count, pairs) = if eta < PERIODIC_BELOW { (4, 2) } else { (6, 0) };
        let im = (twofloat::consts::PI * 2.0).over(log_period);
        let real_ones = real_ones.into_iter().take(count).rev().map(Self::Real);
        real_ones.chain((0..pairs).map(|j| Self::Pair(power(f64::from(j), 0.0), im))).collect()
    }

    /// Its coefficients in powers of `x`, `terms` of each part.
    pub(super) fn columns(self, terms: usize) -> Vec<Vec<TwoFloat>> {
        match self {
            Self::Real(s) => vec![binomial(s, real(0.0), terms).map(|(re, _)| re).collect()],
            Self::Pair(re, im) => {
                let (re, im) = binomial(re, im, terms).unzip();
                vec![re, im]
            }
        }
    }

    /// Its parts where `ln (1 - x)` is this.
    pub(super) fn values(self, logarithm: f64) -> Vec<f64> {
        match self {
            Self::Real(s) => vec![(s.rounded() * logarithm).exp()],
            Self::Pair(re, im) => {
                let (size, (sin, cos)) = ((re.rounded() * logarithm).exp(), (im.rounded() * logarithm).sin_cos());
                vec![size * cos, size * sin]
            }
        }
    }
}

/// The coefficients of `(1 - x)^s`, `s = re + i im`, as real and imaginary parts.
fn binomial(re: TwoFloat, im: TwoFloat, terms: usize) -> impl Iterator<Item = (TwoFloat, TwoFloat)> {
    let first = (real::<TwoFloat>(1.0), real::<TwoFloat>(0.0));
    let coefficients = (0..).scan(first, move |next, k| {
        // Times (k - s)/(k + 1).
        let (a, b) = (real::<TwoFloat>(f64::from(k)) - re, -im);
        let over = real::<TwoFloat>(f64::from(k) + 1.0);
        let after = ((next.0 * a - next.1 * b).over(over), (next.0 * b + next.1 * a).over(over));
        Some(std::mem::replace(next, after))
    });
    coefficients.take(terms)
}
