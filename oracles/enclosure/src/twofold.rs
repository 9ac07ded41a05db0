//! Ends of intervals as unevaluated sums of two doubles: some 30 digits at a small part of the cost of arbitrary precision.
//!
//! The operations and the bounds on their relative errors are those of M. Joldes, J.-M. Muller and V. Popescu, "Tight and rigorous error bounds
//! for basic building blocks of double-word arithmetic", ACM Trans. Math. Softw. 44 (2017) 15: with `u = 2^-53`, 3 u² and little more for the sum
//! (their `AccurateDWPlusDW`), 7 u² for the product (`DWTimesDW1`) and 15 u² + 56 u³ for the quotient (`DWDivDW2`), all below 16 u² = 2^-102, if
//! nothing overflows or underflows. Each result is moved outward by twice that; a product or a quotient that could underflow is only bounded.
//! A sum needs no such care: doubles add without underflow, and where moving would underflow the sum of two of these is exact.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::directed::Directed;

/// `high + low`, where `high` is the double nearest to the sum.
#[derive(Clone, Copy, Debug)]
pub struct Twofold {
    high: f64,
    low: f64,
}

/// What a result is moved by, relative: `2^-101`.
const MOVE: f64 = 1.0 / (1_u128 << 101) as f64;

/// No product or quotient below this is exact enough for the bounds, because its last bits could be below the least double, 2^-1074; nor
/// above its inverse.
const TINY: f64 = 1e-288;

const ZERO: Twofold = Twofold { high: 0.0, low: 0.0 };
const NOT_A_NUMBER: Twofold = Twofold { high: f64::NAN, low: f64::NAN };

impl PartialEq for Twofold {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Twofold {
    /// `high` is a function of the sum that never falls, so it decides unless it is equal.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high)? {
            Ordering::Equal => self.low.partial_cmp(&other.low),
            order => Some(order),
        }
    }
}

/// The sum and its rounding error, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    (sum, (a - (sum - from_b)) + (b - from_b))
}

/// The same where `|a| >= |b|` or `a = 0`.
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The product and its rounding error, exactly (Dekker).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let scaled = 134_217_729.0 * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

impl Twofold {
    fn plus(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (high, error) = fast_two_sum(high, error + low);
        let (high, low) = fast_two_sum(high, low_error + error);
        Self { high, low }
    }

    fn times(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        let (high, low) = fast_two_sum(product, error + cross);
        Self { high, low }
    }

    /// For a dividend that is not tiny: the product of divisor and quotient is of its size.
    fn over(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        // other * quotient
        let (product, error) = two_product(other.high, quotient);
        let (high, low) = fast_two_sum(product, other.low * quotient);
        let (high, low) = fast_two_sum(high, low + error);
        let rest = (self.high - high) + (self.low - low);
        let (high, low) = fast_two_sum(quotient, rest / other.high);
        Self { high, low }
    }

    /// A product or a quotient that is `positive` or else negative, with its error in the direction of `sign`.
    fn bounded(self, positive: bool, sign: f64) -> Self {
        match self.high.abs() {
            high if high < TINY && positive == (sign > 0.0) => Self { high: sign * 2.0 * TINY, low: 0.0 },
            high if high < TINY => ZERO,
            high if high <= 1.0 / TINY => self.moved(sign),
            _ => NOT_A_NUMBER,
        }
    }

    /// Moved by twice the bound on the error of an operation, in the direction of `sign`.
    fn moved(self, sign: f64) -> Self {
        let (high, low) = fast_two_sum(self.high, self.low + sign * (self.high.abs() * MOVE));
        Self { high, low }
    }

    /// Whether both have the same sign.
    fn agrees(self, other: Self) -> bool {
        (self.high > 0.0) == (other.high > 0.0)
    }

    fn is_zero(self) -> bool {
        self.high == 0.0
    }

    fn is_one(self) -> bool {
        self.high == 1.0 && self.low == 0.0
    }

    fn sum(self, other: Self, sign: f64) -> Self {
        if self.is_zero() {
            other
        } else if other.is_zero() {
            self
        } else {
            self.plus(other).moved(sign)
        }
    }

    fn product(self, other: Self, sign: f64) -> Self {
        if self.high.is_nan() || other.high.is_nan() {
            // Also times zero: the interval that has this end may reach anywhere.
            NOT_A_NUMBER
        } else if self.is_zero() || other.is_one() {
            self
        } else if other.is_zero() || self.is_one() {
            other
        } else {
            self.times(other).bounded(self.agrees(other), sign)
        }
    }

    fn quotient(self, other: Self, sign: f64) -> Self {
        if other.is_zero() || other.high.is_nan() {
            NOT_A_NUMBER
        } else if self.is_zero() || other.is_one() {
            self
        } else {
            let positive = self.agrees(other);
            // What is between a tiny number and zero has a quotient between theirs.
            match self.high.abs() < TINY {
                true if positive != (sign > 0.0) => ZERO,
                true => Self { high: TINY.copysign(self.high), low: 0.0 }.over(other).bounded(positive, sign),
                false => self.over(other).bounded(positive, sign),
            }
        }
    }

    /// A root that is checked by its square: not a number if the check fails.
    fn root(self, sign: f64) -> Self {
        if self.is_zero() {
            return self;
        }
        if !(TINY..1.0 / TINY).contains(&self.high) {
            return NOT_A_NUMBER;
        }
        let near = Self { high: self.high.sqrt(), low: 0.0 };
        let half = Self { high: 0.5, low: 0.0 };
        let root = near.plus(self.over(near)).times(half).moved(sign).moved(sign);
        let outside =
            if sign < 0.0 { root.times(root).moved(1.0) <= self } else { root.times(root).moved(-1.0) >= self };
        if outside { root } else { NOT_A_NUMBER }
    }
}

impl Directed for Twofold {
    /// What is left of 106 bits when every result is moved outward.
    const BITS: u32 = 100;

    fn exactly(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    fn negated(&self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    fn plus_below(&self, other: &Self) -> Self {
        self.sum(*other, -1.0)
    }

    fn plus_above(&self, other: &Self) -> Self {
        self.sum(*other, 1.0)
    }

    fn times_below(&self, other: &Self) -> Self {
        self.product(*other, -1.0)
    }

    fn times_above(&self, other: &Self) -> Self {
        self.product(*other, 1.0)
    }

    fn over_below(&self, other: &Self) -> Self {
        self.quotient(*other, -1.0)
    }

    fn over_above(&self, other: &Self) -> Self {
        self.quotient(*other, 1.0)
    }

    fn root_below(&self) -> Self {
        self.root(-1.0)
    }

    fn root_above(&self) -> Self {
        self.root(1.0)
    }

    fn double_below(&self) -> f64 {
        if self.low < 0.0 { self.high.next_down() } else { self.high + 0.0 * self.low }
    }

    fn double_above(&self) -> f64 {
        if self.low > 0.0 { self.high.next_up() } else { self.high + 0.0 * self.low }
    }

    fn exact_parts(&self) -> Option<(IBig, isize)> {
        let ((high, shift), (low, low_shift)) = (self.high.exact_parts()?, self.low.exact_parts()?);
        let least = shift.min(low_shift);
        Some(((high << shift.abs_diff(least)) + (low << low_shift.abs_diff(least)), least))
    }
}
