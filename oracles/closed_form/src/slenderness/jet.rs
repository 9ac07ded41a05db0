//! Numbers that are power series in `μ = 2(1/cos α - 1)`, as far as they are followed: to `μ³`.

use core::ops::{Add, Mul, Sub};

/// The value at `μ = 0`, and the coefficients of `μ`, `μ²` and `μ³`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet(pub [f64; 4]);

impl Jet {
    /// The highest power.
    pub const ORDER: usize = 3;
    pub const ZERO: Self = Self([0.0; 4]);
    pub const ONE: Self = Self([1.0, 0.0, 0.0, 0.0]);
    /// `1/cos α = 1 + μ/2`.
    pub const SECANT: Self = Self([1.0, 0.5, 0.0, 0.0]);
    /// `m = sin²α = 1 - 1/(1 + μ/2)²`.
    pub const SQUARED_SINE: Self = Self([0.0, 1.0, -0.75, 0.5]);

    /// The value at `μ = 0`.
    pub fn value(self) -> f64 {
        let [value, ..] = self.0;
        value
    }

    /// The coefficients of `μ`, `μ²` and `μ³`.
    pub fn shifts(self) -> [f64; 3] {
        let [_, first, second, third] = self.0;
        [first, second, third]
    }

    /// This without its value at `μ = 0`.
    pub fn shift(self) -> Self {
        let [_, first, second, third] = self.0;
        Self([0.0, first, second, third])
    }

    /// This times a plain number.
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|coefficient| factor * coefficient))
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c, d], [w, x, y, z]) = (self.0, other.0);
        Self([a + w, b + x, c + y, d + z])
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other.scaled(-1.0)
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a, b, c, d], [w, x, y, z]) = (self.0, other.0);
        Self([a * w, a * x + b * w, a * y + b * x + c * w, a * z + b * y + c * x + d * w])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Products and sums of series are those of their values at any `μ`, but for the power that is cut off.
        #[test]
        fn sums_and_products_are_those_of_the_values(
            x in prop::array::uniform4(-1.0..1.0f64), y in prop::array::uniform4(-1.0..1.0f64), mu in 1e-3..1e-2f64,
        ) {
            let at = |Jet([a, b, c, d]): Jet| a + mu * (b + mu * (c + mu * d));
            let (one, other) = (Jet(x), Jet(y));
            prop_assert!((at(one * other) - at(one) * at(other)).abs() <= 4.0 * mu.powi(4));
            prop_assert!((at(one + other) - at(one) - at(other)).abs() <= 1e-15);
            prop_assert!((at(one - other) - at(one) + at(other)).abs() <= 1e-15);
        }
    }

    /// `1/cos α` and `sin²α` in powers of `μ = 2(1/cos α - 1)`.
    #[test]
    fn the_slenderness_in_powers_of_its_parameter() {
        for alpha in [0.05f64, 0.1] {
            let mu = 2.0 * (1.0 / alpha.cos() - 1.0);
            let at = |Jet([a, b, c, d]): Jet| a + mu * (b + mu * (c + mu * d));
            assert!((at(Jet::SECANT) - 1.0 / alpha.cos()).abs() < 1e-15);
            assert!((at(Jet::SQUARED_SINE) - alpha.sin().powi(2)).abs() < mu.powi(4));
        }
    }
}
