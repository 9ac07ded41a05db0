//! What the outside sees of an interval: exact ends, as doubles or as decimals, rounded outward.

use core::cmp::Ordering;

use dashu_int::{IBig, Sign, UBig};

use crate::{directed::Directed, interval::Interval};

/// Two numbers between which the true value is proven to lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    lower: Exact,
    upper: Exact,
    doubles: (f64, f64),
}

/// `significand 2^exponent`.
#[derive(Clone, Debug, PartialEq)]
struct Exact {
    significand: IBig,
    exponent: isize,
}

impl Bounds {
    /// The bounds that an interval is; `None` if an end is not a number.
    pub(crate) fn new<F: Directed>(interval: &Interval<F>) -> Option<Self> {
        let exact = |end: &F| end.exact_parts().map(|(significand, exponent)| Exact { significand, exponent });
        let (lower, upper) = (exact(&interval.lower)?, exact(&interval.upper)?);
        let doubles = (interval.lower.double_below(), interval.upper.double_above());
        (interval.lower <= interval.upper).then_some(Self { lower, upper, doubles })
    }

    /// A double that is not above the true value.
    pub fn lower(&self) -> f64 {
        self.doubles.0
    }

    /// A double that is not below the true value.
    pub fn upper(&self) -> f64 {
        self.doubles.1
    }

    /// The double in the middle, and a bound on its distance from the true value.
    pub fn middle(&self) -> (f64, f64) {
        let (lower, upper) = self.doubles;
        let middle = lower + 0.5 * (upper - lower);
        // Between neighbouring doubles the middle is one of them; between others its own rounding is less than the bound is rounded up.
        (middle, (middle - lower).next_up().max((upper - middle).next_up()))
    }

    /// Bounds with `digits` digits after the decimal point: the lower rounded down, the upper rounded up.
    pub fn decimals(&self, digits: u32) -> [String; 2] {
        [self.lower.decimal(digits, false), self.upper.decimal(digits, true)]
    }

    /// How many digits after the decimal point it takes to write the bounds with `digits` significant ones.
    pub fn places(&self, digits: u32) -> u32 {
        let magnitude = self.doubles.0.abs().max(self.doubles.1.abs());
        let leading = if magnitude > 0.0 { magnitude.log10().floor() } else { 0.0 };
        (f64::from(digits) - 1.0 - leading).max(0.0) as u32
    }

    /// The true value rounded down to `digits` significant digits; `None` if the bounds do not settle them.
    pub fn settled(&self, digits: u32) -> Option<String> {
        let places = self.places(digits);
        let (lower, upper) = (self.lower.decimal(places, false), self.upper.decimal(places, false));
        (lower == upper).then_some(lower)
    }

    /// Whether a decimal number, such as `-12.5`, lies within. `None` if it is not one.
    pub fn contains(&self, decimal: &str) -> Option<bool> {
        let (whole, fraction) = decimal.split_once('.').unwrap_or((decimal, ""));
        let digits: IBig = format!("{whole}{fraction}").parse().ok()?;
        let scale = IBig::from(10).pow(fraction.len());
        let below = self.lower.compare(&digits, &scale) != Ordering::Greater;
        Some(below && self.upper.compare(&digits, &scale) != Ordering::Less)
    }

    /// Whether all of `other` lies within.
    pub fn contain(&self, other: &Self) -> bool {
        let order = |one: &Exact, two: &Exact| {
            let shift = one.exponent.min(two.exponent);
            one.shifted(shift).cmp(&two.shifted(shift))
        };
        order(&self.lower, &other.lower) != Ordering::Greater && order(&self.upper, &other.upper) != Ordering::Less
    }

    /// Bounds on how much later this is than another time.
    pub fn since(&self, earlier: &Self) -> Self {
        let (lower, upper) = (self.lower.less(&earlier.upper), self.upper.less(&earlier.lower));
        let double = |end: &Exact| crate::digits::Digits::<64>::from_parts(end.significand.clone(), end.exponent);
        let doubles = (double(&lower).double_below(), double(&upper).double_above());
        Self { lower, upper, doubles }
    }

    /// The width, rounded up.
    pub fn width(&self) -> f64 {
        let shift = self.lower.exponent.min(self.upper.exponent);
        let difference = self.upper.shifted(shift) - self.lower.shifted(shift);
        crate::digits::Digits::<64>::from_parts(difference, shift).double_above()
    }
}

impl Exact {
    /// The significand of the same number with an exponent that is not greater.
    fn shifted(&self, exponent: isize) -> IBig {
        &self.significand << self.exponent.abs_diff(exponent)
    }

    /// The exact difference.
    fn less(&self, other: &Self) -> Self {
        let exponent = self.exponent.min(other.exponent);
        Self { significand: self.shifted(exponent) - other.shifted(exponent), exponent }
    }

    /// How the number compares with `numerator/denominator`, `denominator > 0`.
    fn compare(&self, numerator: &IBig, denominator: &IBig) -> Ordering {
        let mine = &self.significand * denominator;
        match self.exponent >= 0 {
            true => (mine << self.exponent.unsigned_abs()).cmp(numerator),
            false => mine.cmp(&(numerator << self.exponent.unsigned_abs())),
        }
    }

    fn decimal(&self, digits: u32, up: bool) -> String {
        let scaled = &self.significand * IBig::from(10).pow(digits as usize);
        let shift = self.exponent.unsigned_abs();
        let integer = match (self.exponent >= 0, up) {
            (true, _) => scaled << shift,
            // Shifting to the right rounds towards minus infinity.
            (false, false) => scaled >> shift,
            (false, true) => -(-scaled >> shift),
        };
        let (sign, magnitude) = integer.into_parts();
        let text = format!("{:0>width$}", magnitude.to_string(), width = digits as usize + 1);
        let (whole, fraction) = text.split_at(text.len() - digits as usize);
        let minus = if sign == Sign::Negative && magnitude != UBig::ZERO { "-" } else { "" };
        let point = if digits > 0 { "." } else { "" };
        format!("{minus}{whole}{point}{fraction}")
    }
}
