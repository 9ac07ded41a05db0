//! A number for each side of the block: all that is done for one side is done for the other, and the registers of any machine hold two.

use std::ops::{Add, AddAssign, Mul};

/// A number for the side `i = 1`, and one for `i = -1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair(pub [f64; 2]);

impl Pair {
    /// Nothing.
    pub const ZERO: Self = Self([0.0; 2]);
    /// 1 on both sides.
    pub const ONE: Self = Self([1.0; 2]);

    /// The number of the other side.
    pub fn swapped(self) -> Self {
        let Self([one, other]) = self;
        Self([other, one])
    }

    /// `1/x`.
    pub fn reciprocal(self) -> Self {
        Self(self.0.map(f64::recip))
    }
}

impl Add for Pair {
    type Output = Self;

    #[inline]
    fn add(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a + c, b + d])
    }
}

impl AddAssign for Pair {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for Pair {
    type Output = Self;

    #[inline]
    fn mul(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a * c, b * d])
    }
}

impl Mul<f64> for Pair {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        let Self([a, b]) = self;
        Self([a * factor, b * factor])
    }
}
