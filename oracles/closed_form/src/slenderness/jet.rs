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
