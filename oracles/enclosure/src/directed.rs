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
