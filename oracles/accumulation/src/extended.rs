//! Numbers of the digits of two doubles, for one purpose: where `f` is next to ±1, the pull `1 ∓ f` that is left keeps its digits.

use std::{
    f64::consts::{FRAC_PI_2, LN_2},
    ops::{Add, Div, Mul, Neg, Sub},
};

/// The unrounded sum of two doubles, the second below the last digit of the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extended {
    high: f64,
    low: f64,
}

/// How many steps of a series are done with all digits; what is left of it is so small that doubles do.
const STEPS: u32 = 8;
/// The same for the exponential, whose series has every power.
const STEPS_OF_EXP: u32 = 14;

impl Extended {
    const HALF_PI: Self = Self { high: FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
    const LN_2: Self = Self { high: LN_2, low: 2.319_046_813_846_299_6e-17 };

    /// A double.
    pub const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// The double next to it.
    pub fn rounded(self) -> f64 {
        self.high
    }

    /// The square root of a double above 0.
    pub fn root(of: f64) -> Self {
        let root = of.sqrt();
        Self { high: root, low: -root.mul_add(root, -of) / (2.0 * root) }
    }

    /// The sine, and the cosine as a double.
    pub fn sin_cos(self) -> (Self, f64) {
        let turns = (self.high / FRAC_PI_2).round();
        let rest = self - Self::HALF_PI * Self::new(turns);
        let square = rest * rest;
        let (sin, cos) = rest.high.sin_cos();
        match turns.rem_euclid(4.0) {
            0.0 => (rest * alternating(square, 2.0), cos),
            1.0 => (alternating(square, 1.0), -sin),
            2.0 => (-(rest * alternating(square, 2.0)), -cos),
            _ => (-alternating(square, 1.0), sin),
        }
    }

    /// `exp(-x)`, for `x >= 0`.
    pub fn exp_of_minus(self) -> Self {
        let halvings = (self.high / LN_2).round();
        let rest = self - Self::LN_2 * Self::new(halvings);
        // exp(-r) = 1 - r(1 - r/2 (1 - r/3 (...))), the innermost ones in doubles.
        let innermost = (STEPS_OF_EXP + 1..=20).rev().fold(1.0, |sum, k| 1.0 - rest.high / f64::from(k) * sum);
        let sum = (1..=STEPS_OF_EXP)
            .rev()
            .fold(Self::new(innermost), |sum, k| Self::new(1.0) - rest * sum / Self::new(f64::from(k)));
        // In two factors, as the first alone may be below all doubles where the product is not.
        let half = (0.5 * halvings).floor();
        let scale = |by: f64| Self::new((-by).exp2());
        sum * scale(half) * scale(halvings - half)
    }
}

/// `1 - z/(n(n+1)) (1 - z/((n+2)(n+3)) (...))`: of the sine over its argument for `n = 2`, of the cosine for `n = 1`, with `z` the square of the argument.
fn alternating(square: Extended, first: f64) -> Extended {
    let divisor = |step: u32| {
        let n = first + 2.0 * f64::from(step);
        n * (n + 1.0)
    };
    let innermost = (STEPS..12).rev().fold(1.0, |sum, step| 1.0 - square.high / divisor(step) * sum);
    (0..STEPS)
        .rev()
        .fold(Extended::new(innermost), |sum, step| Extended::new(1.0) - square * sum / Extended::new(divisor(step)))
}

/// A sum of two of which the first is not the smaller one.
fn ordered(high: f64, low: f64) -> Extended {
    let sum = high + low;
    Extended { high: sum, low: low - (sum - high) }
}

impl Add for Extended {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let back = sum - self.high;
        let lost = (self.high - (sum - back)) + (other.high - back);
        ordered(sum, lost + (self.low + other.low))
    }
}

impl Neg for Extended {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Extended {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let lost = self.high.mul_add(other.high, -product);
        ordered(product, lost + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Extended {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * Self::new(quotient);
        ordered(quotient, rest.high / other.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_is(found: Extended, (high, low): (f64, f64)) {
        let off = (found - Extended { high, low }).rounded();
        assert!(off.abs() < 1e-29, "{found:?} is off by {off:e}");
    }

    #[test]
    fn functions_have_the_digits_of_two_doubles() {
        // By mpmath with 60 digits, as the double next to it and what is left of it.
        assert_is(Extended::new(0.7).sin_cos().0, (0.644_217_687_237_691, 2.874_056_792_733_875_5e-18));
        assert_is(Extended::new(0.8).sin_cos().0, (0.717_356_090_899_522_8, 1.185_141_972_071_668_4e-18));
        assert_is(Extended::new(1234.5).sin_cos().0, (0.145_395_650_522_936_43, -1.072_207_631_651_658_6e-17));
        assert_is(Extended::new(1.3).exp_of_minus(), (0.272_531_793_034_012_6, -1.682_962_743_518_440_8e-18));
        assert_is(Extended::root(3.0), (1.732_050_807_568_877_2, 1.003_508_422_180_690_3e-16));
    }

    #[test]
    fn the_squares_of_sine_and_cosine_are_one() {
        for k in -60..60_i32 {
            let angle = Extended::new(f64::from(k) * 0.37);
            let ((sin, cosine), (cos, _)) = (angle.sin_cos(), (angle + Extended::HALF_PI).sin_cos());
            let off = (sin * sin + cos * cos - Extended::new(1.0)).rounded();
            assert!(off.abs() < 1e-29 && (cosine - cos.rounded()).abs() < 2e-16, "{k}: {off:e}");
        }
    }
}
