//! Polynomials in the speed `v` after an impact and in the shift `d` of its time, cut off at a total degree.

use crate::pair::Pair;

/// Coefficients by powers of `d`.
pub type Row<const M: usize> = [Pair; M];

/// `Σ p_mk v^m d^k`, in rows of one power of `v`. Up to which degree they are known is the affair of who uses them; what is beyond is 0.
#[derive(Debug, Clone)]
pub struct Polynomial<const M: usize>([Row<M>; M]);

impl<const M: usize> Polynomial<M> {
    /// 0.
    pub const ZERO: Self = Self([[Pair::ZERO; M]; M]);

    /// `v^m`.
    pub fn power(m: usize) -> Self {
        let mut one = Self::ZERO;
        if let Some(first) = one.row_mut(m, 1).first_mut() {
            *first = Pair::ONE;
        }
        one
    }

    /// The coefficients of `v^m`.
    pub fn row(&self, m: usize) -> &[Pair] {
        self.0.get(m).map_or(&[], |row| row.as_slice())
    }

    /// The first `len` of them.
    pub fn row_mut(&mut self, m: usize, len: usize) -> &mut [Pair] {
        self.0.get_mut(m).and_then(|row| row.get_mut(..len)).unwrap_or_default()
    }

    /// Adds the coefficients of `v^m` of the product of two to `sum`, as far as that goes.
    pub fn add_row_of_product(sum: &mut [Pair], m: usize, one: &Self, other: &Self) {
        for l in 0..=m {
            add_product(sum, one.row(l), other.row(m - l));
        }
    }

    /// The product of two up to `degree`.
    pub fn product(one: &Self, other: &Self, degree: usize) -> Self {
        let mut product = Self::ZERO;
        product.add_product(one, other, degree);
        product
    }

    /// Adds the product of two up to `degree`.
    pub fn add_product(&mut self, one: &Self, other: &Self, degree: usize) {
        for m in 0..=degree {
            Self::add_row_of_product(self.row_mut(m, degree - m + 1), m, one, other);
        }
    }

    /// It times `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|row| row.map(|of| of * factor)))
    }
}

/// Adds the product of two polynomials in `d` to `sum`, as far as that goes.
#[inline]
pub fn add_product(sum: &mut [Pair], one: &[Pair], other: &[Pair]) {
    let len = sum.len();
    for (shift, factor) in one.iter().take(len).enumerate() {
        // Many are: what is of a higher order in the speed, or of every second power.
        if *factor == Pair::ZERO {
            continue;
        }
        let from = sum.get_mut(shift..).unwrap_or_default();
        from.iter_mut().zip(other).for_each(|(sum, term)| *sum += *factor * *term);
    }
}

/// Adds `factor` times a polynomial in `d` to `sum`, as far as that goes.
#[inline]
pub fn add_scaled(sum: &mut [Pair], factor: f64, of: &[Pair]) {
    sum.iter_mut().zip(of).for_each(|(sum, term)| *sum += *term * factor);
}

/// Makes `p^(k)/k!` of a polynomial in `d` to `p^(k+1)/(k+1)!`, by which `s^(k+1)` is multiplied in `p(d + s)`.
pub fn differentiate<const M: usize>(row: &mut Row<M>, k: usize) {
    let over = 1.0 / (k + 1) as f64;
    for j in 0..M {
        let next = row.get(j + 1).copied().unwrap_or(Pair::ZERO);
        if let Some(slot) = row.get_mut(j) {
            *slot = next * ((j + 1) as f64 * over);
        }
    }
}

/// The reciprocal of a polynomial in `d` that is not 0 at `d = 0`, to `len` coefficients.
pub fn reciprocal<const M: usize>(of: &[Pair], len: usize) -> Row<M> {
    let mut inverse = [Pair::ZERO; M];
    let Some((first, rest)) = of.split_first() else { return inverse };
    let first = first.reciprocal();
    for k in 0..len.min(M) {
        let (known, unknown) = inverse.split_at_mut(k);
        let Some(next) = unknown.first_mut() else { break };
        let sum = known.iter().rev().zip(rest).fold(Pair::ZERO, |sum, (known, term)| sum + *known * *term);
        *next = if k == 0 { first } else { first * sum * -1.0 };
    }
    inverse
}
