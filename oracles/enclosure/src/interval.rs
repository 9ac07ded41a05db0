//! Intervals that contain every result that their operands allow.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::directed::Directed;

/// The numbers from `lower` to `upper`. An interval with an end that is not a number contains everything and proves nothing.
#[derive(Clone, Debug)]
pub struct Interval<F> {
    pub lower: F,
    pub upper: F,
}

impl<F: Directed> Interval<F> {
    /// The one number.
    pub fn exactly(value: f64) -> Self {
        Self { lower: F::exactly(value), upper: F::exactly(value) }
    }

    /// The one number that an end is.
    pub fn at(end: &F) -> Self {
        Self { lower: end.clone(), upper: end.clone() }
    }

    /// `n`, which has to be below 2^53.
    pub fn whole(n: usize) -> Self {
        Self::exactly(n as f64)
    }

    pub fn zero() -> Self {
        Self::exactly(0.0)
    }

    /// From `lower` to `upper`.
    pub fn between(lower: f64, upper: f64) -> Self {
        Self { lower: F::exactly(lower), upper: F::exactly(upper) }
    }

    /// From `-bound` to `bound`.
    pub fn within(bound: f64) -> Self {
        Self::between(-bound, bound)
    }

    /// The same interval, or the next wider one, with ends of another format.
    pub fn convert<G: Directed>(&self) -> Interval<G> {
        Interval::between(self.lower.double_below(), self.upper.double_above())
    }

    pub fn is_positive(&self) -> bool {
        self.lower > F::exactly(0.0) && self.upper >= self.lower
    }

    pub fn is_negative(&self) -> bool {
        self.upper < F::exactly(0.0) && self.lower <= self.upper
    }

    fn is_zero(&self) -> bool {
        let zero = F::exactly(0.0);
        self.lower == zero && self.upper == zero
    }

    /// Whether every number of this interval is below every one of the other.
    pub fn is_below(&self, other: &Self) -> bool {
        self.lower <= self.upper && self.upper < other.lower && other.lower <= other.upper
    }

    /// A double inside, or next to, the interval.
    pub fn middle(&self) -> f64 {
        let (lower, upper) = (self.lower.double_below(), self.upper.double_above());
        lower + 0.5 * (upper - lower)
    }

    /// A number of the interval's own format inside it, as an interval.
    pub fn centre(&self) -> Self {
        let half = F::exactly(0.5);
        let sum = self.lower.plus_below(&self.upper).times_below(&half);
        // The rounding of the sum could lead out of a thin interval.
        let inside = if sum >= self.lower && sum <= self.upper { sum } else { self.lower.clone() };
        Self { lower: inside.clone(), upper: inside }
    }

    /// A bound on every magnitude in the interval.
    pub fn magnitude(&self) -> f64 {
        let (lower, upper) = (self.lower.double_below().abs(), self.upper.double_above().abs());
        // f64::max would drop what is not a number.
        if lower >= upper {
            lower
        } else if upper > lower {
            upper
        } else {
            f64::NAN
        }
    }

    /// A bound on the width, from above.
    pub fn width(&self) -> f64 {
        self.upper.plus_above(&self.lower.negated()).double_above()
    }

    /// A bound on the width relative to the smallest magnitude, from above; not finite if the interval contains zero.
    pub fn relative_width(&self) -> f64 {
        let absolute = self.absolute();
        if absolute.is_positive() { (self.width() / absolute.lower.double_below()).next_up() } else { f64::INFINITY }
    }

    /// What both contain, if each is known to contain the number that is wanted.
    pub fn and(&self, other: &Self) -> Self {
        let lower = if other.lower > self.lower { &other.lower } else { &self.lower };
        let upper = if other.upper < self.upper { &other.upper } else { &self.upper };
        Self { lower: lower.clone(), upper: upper.clone() }
    }

    /// The shortest interval that contains both.
    pub fn or(&self, other: &Self) -> Self {
        // Also where an end is not a number.
        let lower = if other.lower >= self.lower { &self.lower } else { &other.lower };
        let upper = if other.upper <= self.upper { &self.upper } else { &other.upper };
        let any =
            |one: &F, two: &F, end: &F| if one.partial_cmp(two).is_some() { end.clone() } else { F::exactly(f64::NAN) };
        Self { lower: any(&self.lower, &other.lower, lower), upper: any(&self.upper, &other.upper, upper) }
    }

    /// From zero (or the lower end, if that is below) to the upper end.
    pub fn down_to_zero(&self) -> Self {
        let zero = F::exactly(0.0);
        // Also where the lower end is not a number.
        let lower = if self.lower > zero { zero } else { self.lower.clone() };
        Self { lower, upper: self.upper.clone() }
    }

    /// The shortest interval with zero in it that contains this one.
    pub fn with_zero(&self) -> Self {
        let zero = F::exactly(0.0);
        let upper = if self.upper < zero { zero } else { self.upper.clone() };
        Self { lower: self.down_to_zero().lower, upper }
    }

    /// The same, where it is known that the number is not below zero.
    pub fn not_below_zero(&self) -> Self {
        let zero = || F::exactly(0.0);
        let end = |end: &F| if *end < zero() { zero() } else { end.clone() };
        Self { lower: end(&self.lower), upper: end(&self.upper) }
    }

    pub fn squared(&self) -> Self {
        // The product of two independent numbers can be negative; a square can't.
        (self * self).not_below_zero()
    }

    /// The square root; not a number if the interval reaches below zero.
    pub fn root(&self) -> Self {
        Self { lower: self.lower.root_below(), upper: self.upper.root_above() }
    }

    pub fn absolute(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }
}

impl<F: Directed> Neg for &Interval<F> {
    type Output = Interval<F>;

    fn neg(self) -> Interval<F> {
        Interval { lower: self.upper.negated(), upper: self.lower.negated() }
    }
}

impl<F: Directed> Add for &Interval<F> {
    type Output = Interval<F>;

    fn add(self, other: Self) -> Interval<F> {
        Interval { lower: self.lower.plus_below(&other.lower), upper: self.upper.plus_above(&other.upper) }
    }
}

impl<F: Directed> Sub for &Interval<F> {
    type Output = Interval<F>;

    fn sub(self, other: Self) -> Interval<F> {
        self + &-other
    }
}

impl<F: Directed> Mul for &Interval<F> {
    type Output = Interval<F>;

    fn mul(self, other: Self) -> Interval<F> {
        if self.is_zero() || other.is_zero() {
            return Interval::zero();
        }
        let zero = F::exactly(0.0);
        let (a, b) = (self, other);
        // Which ends make the least and the greatest product.
        if a.lower >= zero {
            let (low, high) =
                (if b.lower >= zero { &a.lower } else { &a.upper }, if b.upper >= zero { &a.upper } else { &a.lower });
            Interval { lower: low.times_below(&b.lower), upper: high.times_above(&b.upper) }
        } else if a.upper <= zero {
            let (low, high) =
                (if b.upper >= zero { &a.lower } else { &a.upper }, if b.lower >= zero { &a.upper } else { &a.lower });
            Interval { lower: low.times_below(&b.upper), upper: high.times_above(&b.lower) }
        } else if b.lower >= zero {
            Interval { lower: a.lower.times_below(&b.upper), upper: a.upper.times_above(&b.upper) }
        } else if b.upper <= zero {
            Interval { lower: a.upper.times_below(&b.lower), upper: a.lower.times_above(&b.lower) }
        } else {
            Interval {
                lower: least(a.lower.times_below(&b.upper), a.upper.times_below(&b.lower)),
                upper: greatest(a.lower.times_above(&b.lower), a.upper.times_above(&b.upper)),
            }
        }
    }
}

impl<F: Directed> Div for &Interval<F> {
    type Output = Interval<F>;

    /// The quotient; not a number if the divisor contains zero.
    fn div(self, other: Self) -> Interval<F> {
        let zero = F::exactly(0.0);
        let (a, b) = (self, other);
        if b.is_positive() {
            let (low, high) =
                (if a.lower >= zero { &b.upper } else { &b.lower }, if a.upper >= zero { &b.lower } else { &b.upper });
            Interval { lower: a.lower.over_below(low), upper: a.upper.over_above(high) }
        } else if b.is_negative() {
            &-a / &-b
        } else {
            let none = F::exactly(f64::NAN);
            Interval { lower: none.clone(), upper: none }
        }
    }
}

/// The lesser of two; not a number if one is not.
fn least<F: Directed>(one: F, two: F) -> F {
    match one.partial_cmp(&two) {
        Some(core::cmp::Ordering::Greater) => two,
        Some(_) => one,
        None => F::exactly(f64::NAN),
    }
}

fn greatest<F: Directed>(one: F, two: F) -> F {
    match one.partial_cmp(&two) {
        Some(core::cmp::Ordering::Less) => two,
        Some(_) => one,
        None => F::exactly(f64::NAN),
    }
}
