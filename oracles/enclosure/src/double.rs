//! Doubles as ends of intervals.

use crate::{digits::Digits, directed::Directed};

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
        Digits::<64>::exactly(*self).exact_parts()
    }
}

/// Zero and one, with which a product is exact.
fn is_unit_or_zero(x: f64) -> bool {
    x == 0.0 || x == 1.0
}
