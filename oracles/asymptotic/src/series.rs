use crate::number::{Number, real};

/// A power series in `ε`, truncated: `terms` coefficients, that of `ε⁰` first. Operations keep as many terms as the shorter operand has.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Series<T>(pub(crate) Vec<T>);

impl<T: Number> Series<T> {
    pub(crate) fn constant(value: T, terms: usize) -> Self {
        let mut series = Self(vec![T::zero(); terms]);
        if let Some(first) = series.0.first_mut() {
            *first = value;
        }
        series
    }

    /// `√(2 + ε) = √2 (1 + ε/2)^(1/2)`, with `ε` counted in `unit`.
    pub(crate) fn root_of_two_plus_epsilon(terms: usize, unit: T) -> Self {
        let ratio = |k: usize| unit * real::<T>(1.5 - k as f64).over(real(2.0 * k as f64));
        let first = real::<T>(2.0).root();
        Self((1..).scan(first, |next, k| Some(std::mem::replace(next, *next * ratio(k)))).take(terms).collect())
    }

    pub(crate) fn terms(&self) -> usize {
        self.0.len()
    }

    /// The coefficient of `ε⁰`.
    pub(crate) fn leading(&self) -> T {
        self.0.first().copied().unwrap_or(T::zero())
    }

    /// The first terms alone, or more of them, of which nothing is known yet.
    pub(crate) fn with_terms(&self, terms: usize) -> Self {
        let mut series = self.0.clone();
        series.resize(terms, T::zero());
        Self(series)
    }

    /// The series times `ε`.
    pub(crate) fn shifted(&self) -> Self {
        let known = self.terms();
        Self(std::iter::once(T::zero()).chain(self.0.iter().copied()).take(known).collect())
    }

    pub(crate) fn scaled(&self, factor: T) -> Self {
        Self(self.0.iter().map(|&term| term * factor).collect())
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(&a, &b)| a + b).collect())
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(&a, &b)| a - b).collect())
    }

    /// Adds a multiple of another series.
    pub(crate) fn add(&mut self, factor: T, other: &Self) {
        for (sum, &term) in self.0.iter_mut().zip(&other.0) {
            *sum = sum.plus_product(factor, term);
        }
    }

    /// The product (Cauchy).
    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = vec![T::zero(); self.terms().min(other.terms())];
        for (k, &a) in self.0.iter().enumerate() {
            // Powers of a series without a constant term begin with zeros.
            if a.rounded() == 0.0 {
                continue;
            }
            for (sum, &b) in product.iter_mut().skip(k).zip(&other.0) {
                *sum = sum.plus_product(a, b);
            }
        }
        Self(product)
    }

    /// The quotient, by a series that has a constant term.
    pub(crate) fn over(&self, other: &Self) -> Self {
        let mut quotient: Vec<T> = Vec::with_capacity(self.terms());
        let Some((&first, rest)) = other.0.split_first() else { return Self(quotient) };
        for &term in self.0.iter().take(other.terms()) {
            let known = quotient.iter().rev().zip(rest);
            let next = known.fold(term, |left, (&q, &b)| left.plus_product(-q, b)).over(first);
            quotient.push(next);
        }
        Self(quotient)
    }

    /// A real power of a series that begins with 1: with `b = a^s`, `k b_k = Σ_j (s j - (k - j)) a_j b_{k-j}`.
    pub(crate) fn power(&self, exponent: T) -> Self {
        let mut power: Vec<T> = Vec::with_capacity(self.terms());
        let Some((_, rest)) = self.0.split_first() else { return Self(power) };
        power.push(T::one());
        for k in 1..self.terms() {
            let products = (1..=k).zip(rest).zip(power.iter().rev());
            let sum = products
                .fold(T::zero(), |sum, ((j, &a), &b)| sum + (exponent * real(j as f64) - real((k - j) as f64)) * a * b);
            power.push(sum.over(real(k as f64)));
        }
        Self(power)
    }
}

#[cfg(test)]
mod tests {
    use twofloat::TwoFloat;

    use super::*;

    fn series(terms: &[f64]) -> Series<TwoFloat> {
        Series(terms.iter().map(|&term| term.into()).collect())
    }

    fn assert_close(a: &Series<TwoFloat>, b: &Series<TwoFloat>) {
        assert_eq!(a.terms(), b.terms());
        for (a, b) in a.0.iter().zip(&b.0) {
            assert!((*a - *b).abs().hi() < 1e-29, "{a} is not {b}");
        }
    }

    #[test]
    fn division_undoes_multiplication() {
        let (a, b) = (series(&[0.3, -1.0, 2.5, 0.7, 1.0]), series(&[1.5, 0.2, -0.4, 3.0, -1.0]));
        assert_close(&a.times(&b).over(&b), &a);
        assert_close(&a.plus(&b).minus(&b), &a);
        assert_close(&a.shifted(), &series(&[0.0, 0.3, -1.0, 2.5, 0.7]));
    }

    #[test]
    fn the_root_squared_is_two_plus_epsilon() {
        let root = Series::<TwoFloat>::root_of_two_plus_epsilon(12, 1.0.into());
        let mut expected = series(&[0.0; 12]);
        expected.0[0] = 2.0.into();
        expected.0[1] = 1.0.into();
        assert_close(&root.times(&root), &expected);
        let relative = series(&[1.0, 0.5, 0.0, 0.0]).power(0.5.into());
        assert_close(&relative.scaled(root.leading()), &root.with_terms(4));
    }
}
