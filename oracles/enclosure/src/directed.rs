//! The ends of intervals: numbers whose operations can be rounded down or up.

use core::fmt::Debug;

/// A number that can be an end of an interval.
///
/// `NaN`, and whatever takes its place in other formats, compares as neither less nor greater, so nothing is ever proven with it.
pub trait Directed: Clone + PartialOrd + Debug + Send + Sync + 'static {
    /// How many bits the significand has.
    const BITS: u32;

    /// The number itself: every format here holds every double.
    fn exactly(value: f64) -> Self;
    /// `-x`, which is exact.
    fn negated(&self) -> Self;
    /// A bound on `x + y` from below.
    fn plus_below(&self, other: &Self) -> Self;
    /// A bound on `x + y` from above.
    fn plus_above(&self, other: &Self) -> Self;
    /// A bound on `x y` from below.
    fn times_below(&self, other: &Self) -> Self;
    /// A bound on `x y` from above.
    fn times_above(&self, other: &Self) -> Self;
    /// A bound on `x/y` from below.
    fn over_below(&self, other: &Self) -> Self;
    /// A bound on `x/y` from above.
    fn over_above(&self, other: &Self) -> Self;
    /// A bound on `sqrt x` from below.
    fn root_below(&self) -> Self;
    /// A bound on `sqrt x` from above.
    fn root_above(&self) -> Self;
    /// A double that is not above the number.
    fn double_below(&self) -> f64;
    /// A double that is not below the number.
    fn double_above(&self) -> f64;
    /// The number as a whole multiple of a power of two, `None` if it is not finite.
    fn exact_parts(&self) -> Option<(dashu_int::IBig, isize)>;
}

/// A double rounds to the nearest, so the exact result lies between the neighbours of what it returns.
impl Directed for f64 {
    const BITS: u32 = 53;

    fn exactly(value: f64) -> Self {
        value
    }

    fn negated(&self) -> Self {
        -self
    }

    fn plus_below(&self, other: &Self) -> Self {
        if *self == 0.0 || *other == 0.0 { self + other } else { (self + other).next_down() }
    }

    fn plus_above(&self, other: &Self) -> Self {
        if *self == 0.0 || *other == 0.0 { self + other } else { (self + other).next_up() }
    }

    fn times_below(&self, other: &Self) -> Self {
        if is_unit_or_zero(*self) || is_unit_or_zero(*other) { self * other } else { (self * other).next_down() }
    }

    fn times_above(&self, other: &Self) -> Self {
        if is_unit_or_zero(*self) || is_unit_or_zero(*other) { self * other } else { (self * other).next_up() }
    }

    fn over_below(&self, other: &Self) -> Self {
        if *self == 0.0 || *other == 1.0 { self / other } else { (self / other).next_down() }
    }

    fn over_above(&self, other: &Self) -> Self {
        if *self == 0.0 || *other == 1.0 { self / other } else { (self / other).next_up() }
    }

    fn root_below(&self) -> Self {
        if *self == 0.0 { 0.0 } else { self.sqrt().next_down() }
    }

    fn root_above(&self) -> Self {
        if *self == 0.0 { 0.0 } else { self.sqrt().next_up() }
    }

    fn double_below(&self) -> f64 {
        *self
    }

    fn double_above(&self) -> f64 {
        *self
    }

    fn exact_parts(&self) -> Option<(dashu_int::IBig, isize)> {
        crate::digits::Digits::<64>::exactly(*self).exact_parts()
    }
}

/// Zero and one, with which a product is exact.
fn is_unit_or_zero(x: f64) -> bool {
    x == 0.0 || x == 1.0
}
