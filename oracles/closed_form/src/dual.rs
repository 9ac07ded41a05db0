//! Derivatives by forward-mode automatic differentiation: a number that carries its derivatives through the same formulas as a double.

use core::ops::{Add, Mul, Neg, Sub};

/// What the formulas of the motion are evaluated with: a double, or a double with its derivatives.
pub(crate) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + Mul<Output = Self> + From<f64>
{
    /// The number itself.
    fn value(self) -> f64;

    /// This times a plain number.
    fn scaled(self, factor: f64) -> Self;
}

impl Scalar for f64 {
    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn scaled(self, factor: f64) -> f64 {
        factor * self
    }
}

/// A number with its derivatives by the amplitude `a` (equally by `ε = a - 1`), by `ω` and by `η`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    pub value: f64,
    pub by: [f64; 3],
}

impl Dual {
    /// `value`, whose derivatives are `factor` times those of this: the chain rule.
    pub fn chain(self, value: f64, factor: f64) -> Self {
        Self { value, by: self.by.map(|by| factor * by) }
    }

    /// The parameter whose derivative is held at `place`.
    pub fn parameter(value: f64, place: usize) -> Self {
        Self { value, by: core::array::from_fn(|index| if index == place { 1.0 } else { 0.0 }) }
    }

    /// `one self + two other` for the derivatives, with a value of its own.
    fn combine(value: f64, (one, x): (f64, Self), (two, y): (f64, Self)) -> Self {
        let ([x0, x1, x2], [y0, y1, y2]) = (x.by, y.by);
        Self { value, by: [one * x0 + two * y0, one * x1 + two * y1, one * x2 + two * y2] }
    }
}

impl Scalar for Dual {
    fn value(self) -> f64 {
        self.value
    }

    fn scaled(self, factor: f64) -> Self {
        self.chain(factor * self.value, factor)
    }
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, by: [0.0; 3] }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::combine(self.value + other.value, (1.0, self), (1.0, other))
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::combine(self.value - other.value, (1.0, self), (-1.0, other))
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::combine(self.value * other.value, (other.value, self), (self.value, other))
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        self.scaled(-1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn formula<T: Scalar>(x: T, y: T) -> T {
        (x * y - y).scaled(3.0) * x + -(y * y * y)
    }

    proptest! {
        /// Differences of a cubic by central steps are exact but for rounding and the cube of the step.
        #[test]
        fn a_formula_with_duals_gives_its_derivatives(x in -2.0..2.0f64, y in -2.0..2.0f64) {
            let found = formula(Dual::parameter(x, 0), Dual::parameter(y, 2));
            let step = 1e-5;
            let by_x = (formula(x + step, y) - formula(x - step, y)) / (2.0 * step);
            let by_y = (formula(x, y + step) - formula(x, y - step)) / (2.0 * step);
            prop_assert_eq!(found.value(), formula(x, y));
            prop_assert!((found.by[0] - by_x).abs() < 1e-8 && (found.by[2] - by_y).abs() < 1e-8);
            prop_assert_eq!(found.by[1], 0.0);
        }
    }
}
