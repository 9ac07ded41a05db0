//! A lane that counts its operations: what the arithmetic of an impact is, apart from all that it takes to feed it.

use core::{
    cell::Cell,
    ops::{Add, Div, Mul, Neg, Sub},
};

use super::lanes::Lanes;

/// Operations of floating point.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Operations {
    /// Sums and differences.
    pub sums: u64,
    /// Products.
    pub products: u64,
    /// Products with a sum, in one.
    pub fused: u64,
    /// Quotients and square roots.
    pub quotients: u64,
    /// Comparisons, choices and changes of sign.
    pub choices: u64,
}

impl Operations {
    const NONE: Self = Self { sums: 0, products: 0, fused: 0, quotients: 0, choices: 0 };
}

thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// The operations that this thread has counted; from none again.
pub(super) fn take() -> Operations {
    DONE.replace(Operations::NONE)
}

/// Counts one operation.
fn count(kind: impl FnOnce(&mut Operations) -> &mut u64) {
    let mut done = DONE.get();
    *kind(&mut done) += 1;
    DONE.set(done);
}

/// One lane, with a fused multiply-add.
#[derive(Clone, Copy)]
pub(super) struct Counted(pub f64);

macro_rules! operators {
    ($($operator:ident $function:ident $kind:ident),*) => { $(
        impl $operator for Counted {
            type Output = Self;

            fn $function(self, other: Self) -> Self {
                count(|done| &mut done.$kind);
                Self(self.0.$function(other.0))
            }
        }
    )* };
}
operators!(Add add sums, Sub sub sums, Mul mul products, Div div quotients);

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        count(|done| &mut done.choices);
        Self(-self.0)
    }
}

impl Lanes for Counted {
    const COUNT: usize = 1;

    type Mask = bool;

    fn splat(self, value: f64) -> Self {
        Self(value)
    }

    fn residue(self, factor: Self, product: Self) -> Self {
        count(|done| &mut done.fused);
        Self(self.0.mul_add(factor.0, -product.0))
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        count(|done| &mut done.fused);
        Self(self.0.mul_add(factor.0, term.0))
    }

    fn sqrt(self) -> Self {
        count(|done| &mut done.quotients);
        Self(self.0.sqrt())
    }

    fn abs(self) -> Self {
        count(|done| &mut done.choices);
        Self(self.0.abs())
    }

    fn max(self, other: Self) -> Self {
        count(|done| &mut done.choices);
        Self(Lanes::max(self.0, other.0))
    }

    fn min(self, other: Self) -> Self {
        count(|done| &mut done.choices);
        Self(Lanes::min(self.0, other.0))
    }

    fn below(self, other: Self) -> bool {
        count(|done| &mut done.choices);
        self.0 < other.0
    }

    fn select(self, mask: bool, other: Self) -> Self {
        count(|done| &mut done.choices);
        if mask { self } else { other }
    }

    fn any(mask: bool) -> bool {
        mask
    }

    fn lane(&self, lane: usize) -> f64 {
        self.0.lane(lane)
    }

    fn set_lane(&mut self, lane: usize, value: f64) {
        self.0.set_lane(lane, value);
    }
}
