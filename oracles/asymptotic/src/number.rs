use std::ops::{Add, Mul, Neg, Sub};

use twofloat::TwoFloat;

/// What the coefficients are computed in: double-doubles, and doubles to see what rounding does.
///
/// There is no `/`: that of `TwoFloat` by a `TwoFloat` (0.8.4) lacks a fused multiplication, and is right to a double's precision only.
pub(crate) trait Number:
    Copy + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + From<f64>
{
    /// Terms of a convergent sum that are smaller than this, relative, are left out.
    const NEGLIGIBLE: f64;

    /// The nearest double.
    fn rounded(self) -> f64;

    /// The quotient.
    fn over(self, divisor: Self) -> Self;

    /// `self + a b`, which is nearly all that a product of series is made of.
    fn plus_product(self, a: Self, b: Self) -> Self;

    /// The square root.
    fn root(self) -> Self;

    /// The natural logarithm.
    fn logarithm(self) -> Self;

    fn zero() -> Self {
        real(0.0)
    }

    fn one() -> Self {
        real(1.0)
    }
}

impl Number for f64 {
    const NEGLIGIBLE: f64 = 1e-18;

    fn rounded(self) -> f64 {
        self
    }

    fn over(self, divisor: Self) -> Self {
        self / divisor
    }

    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    fn root(self) -> Self {
        self.sqrt()
    }

    fn logarithm(self) -> Self {
        self.ln()
    }
}

impl Number for TwoFloat {
    const NEGLIGIBLE: f64 = 1e-34;

    fn rounded(self) -> f64 {
        self.hi()
    }

    fn over(self, divisor: Self) -> Self {
        let first = self.hi() / divisor.hi();
        let left = self - divisor * first;
        TwoFloat::new_add(first, left.hi() / divisor.hi())
    }

    /// With an error of a few units of 2^-106 of the larger of the two terms: where they cancel it is more of the sum than with the operators of
    /// `TwoFloat`, which take twice as long.
    fn plus_product(self, a: Self, b: Self) -> Self {
        let product = TwoFloat::new_mul(a.hi(), b.hi());
        let cross = a.hi() * b.lo() + a.lo() * b.hi();
        let sum = TwoFloat::new_add(self.hi(), product.hi());
        TwoFloat::new_add(sum.hi(), sum.lo() + (self.lo() + (product.lo() + cross)))
    }

    fn root(self) -> Self {
        self.sqrt()
    }

    /// `ln x = 2 artanh ((x - 1)/(x + 1))` by its series, from a root of `x` that is near 1. (That of `TwoFloat` divides, see above.)
    fn logarithm(self) -> Self {
        const HALVINGS: i32 = 5;
        const TERMS: u32 = 16;
        let near_one = (0..HALVINGS).fold(self, |root, _| root.root());
        let t = (near_one - Self::one()).over(near_one + Self::one());
        let square = t * t;
        let terms = (0..TERMS).rev().map(|k| Self::one().over(real(f64::from(2 * k + 1))));
        let sum = terms.fold(Self::zero(), |sum, term| sum * square + term);
        t * sum * f64::from(2 << HALVINGS)
    }
}

/// A double as such a number, exactly.
pub(crate) fn real<T: Number>(value: f64) -> T {
    <T as From<f64>>::from(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_is_as_precise_as_multiplication() {
        for (a, b) in [(0.3, 1.5), (1.0, 3.0), (7.7, -0.2), (1e-20, 3e100)] {
            let (a, b): (TwoFloat, TwoFloat) = (TwoFloat::new_add(a, a * 1e-17), TwoFloat::new_add(b, -b * 3e-17));
            let error = (a.over(b) * b - a).over(a);
            assert!(error.hi().abs() < 1e-31, "{a} over {b}: {error}");
        }
    }

    #[test]
    fn roots_and_logarithms_have_the_digits_of_two_doubles() {
        let two = real::<TwoFloat>(2.0);
        assert!((two.root() * two.root() - two).hi().abs() < 1e-31);
        assert!((two.logarithm() - twofloat::consts::LN_2).hi().abs() < 1e-29);
        let tenth = real::<TwoFloat>(1.0).over(real(10.0));
        assert!((tenth.logarithm() + twofloat::consts::LN_10).hi().abs() < 1e-29);
    }

    #[test]
    fn a_product_is_added_with_the_digits_of_two_doubles() {
        let number = |value: f64, rest: f64| TwoFloat::new_add(value, value * rest * 1e-17);
        for (a, b, c) in [(0.7, 1.3, -2.1), (-5.0, 1e-3, 7.0), (1e10, 3.0, 0.1), (1e-10, 3.0, 0.1)] {
            let (a, b, c) = (number(a, 3.0), number(b, -4.0), number(c, 5.0));
            let error = a.plus_product(b, c) - (a + b * c);
            let size = a.hi().abs().max((b * c).hi().abs());
            assert!(error.hi().abs() < 1e-31 * size, "{a} + {b} {c}: {error}");
        }
    }

    #[test]
    fn doubles_do_what_their_own_operators_do() {
        assert_eq!((6.0_f64.over(1.5), 2.0_f64.root(), 10.0_f64.logarithm()), (4.0, 2_f64.sqrt(), 10_f64.ln()));
        assert_eq!((1.0_f64.plus_product(2.0, 3.5), 0.25_f64.rounded()), (8.0, 0.25));
    }
}
