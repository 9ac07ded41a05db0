//! Exact arithmetic to test against: whole multiples of powers of two.

use core::cmp::Ordering;

use dashu_int::IBig;

use crate::directed::Directed;

#[derive(Clone, Debug)]
pub struct Exact(IBig, isize);

impl Exact {
    /// `None` if the end is infinite or not a number.
    pub fn of<F: Directed>(end: &F) -> Option<Self> {
        end.exact_parts().map(|(significand, exponent)| Self(significand, exponent))
    }

    pub fn double(value: f64) -> Self {
        Self::of(&value).unwrap()
    }

    pub fn whole(number: IBig) -> Self {
        Self(number, 0)
    }

    fn at(&self, exponent: isize) -> IBig {
        &self.0 << self.1.abs_diff(exponent)
    }

    pub fn plus(&self, other: &Self) -> Self {
        let exponent = self.1.min(other.1);
        Self(self.at(exponent) + other.at(exponent), exponent)
    }

    pub fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0, self.1 + other.1)
    }

    pub fn negated(&self) -> Self {
        Self(-&self.0, self.1)
    }

    pub fn compare(&self, other: &Self) -> Ordering {
        let exponent = self.1.min(other.1);
        self.at(exponent).cmp(&other.at(exponent))
    }

    pub fn is_negative(&self) -> bool {
        self.0 < IBig::ZERO
    }
}

/// Whether the end is not above the number; an end that is not a number claims nothing.
pub fn not_above<F: Directed>(end: &F, number: &Exact) -> bool {
    Exact::of(end).map_or(!(*end > F::exactly(0.0)), |end| end.compare(number) != Ordering::Greater)
}

pub fn not_below<F: Directed>(end: &F, number: &Exact) -> bool {
    Exact::of(end).map_or(!(*end < F::exactly(0.0)), |end| end.compare(number) != Ordering::Less)
}
