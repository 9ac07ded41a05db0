//! Lanes in the registers of an instruction set: two of the baseline (by the crate `wide`), and four or eight of one that is found at run
//! time (by the crate `pulp`, whose functions can only be called with a proof that the machine has it).

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use pulp::{Simd, bytemuck};
use wide::f64x2;

use super::lanes::{Lanes, by_splitting};

/// Two lanes, with what every machine of the target has.
#[derive(Clone, Copy)]
pub(super) struct Two(f64x2);

impl Two {
    pub const ZERO: Self = Self(f64x2::ZERO);
}

/// As many lanes as a register of the instruction set `S` holds.
#[derive(Clone, Copy)]
pub(super) struct Found<S: Simd> {
    simd: S,
    of: S::f64s,
}

impl<S: Simd> Found<S> {
    #[inline(always)]
    pub fn zero(simd: S) -> Self {
        Self { simd, of: simd.splat_f64s(0.0) }
    }
}

/// The mask of [`Found`].
#[derive(Clone, Copy)]
pub(super) struct FoundMask<S: Simd> {
    simd: S,
    of: S::m64s,
}

macro_rules! operators {
    ($($operator:ident $function:ident $found:ident),*) => { $(
        impl $operator for Two {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        }

        impl<S: Simd> $operator for Found<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self { of: self.simd.$found(self.of, other.of), ..self }
            }
        }
    )* };
}
operators!(Add add add_f64s, Sub sub sub_f64s, Mul mul mul_f64s, Div div div_f64s);

impl Neg for Two {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> Neg for Found<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { of: self.simd.neg_f64s(self.of), ..self }
    }
}

impl Lanes for Two {
    const COUNT: usize = 2;

    type Mask = f64x2;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        Self(f64x2::splat(value))
    }

    #[inline(always)]
    fn residue(self, factor: Self, product: Self) -> Self {
        by_splitting(self, factor, product)
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.fast_max(other.0))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.fast_min(other.0))
    }

    #[inline(always)]
    fn below(self, other: Self) -> f64x2 {
        self.0.simd_lt(other.0)
    }

    #[inline(always)]
    fn select(self, mask: f64x2, other: Self) -> Self {
        Self(mask.select(self.0, other.0))
    }

    #[inline(always)]
    fn any(mask: f64x2) -> bool {
        mask.any()
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self.0.as_array().get(lane).copied().unwrap_or(f64::NAN)
    }

    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: f64) {
        if let Some(place) = self.0.as_mut_array().get_mut(lane) {
            *place = value;
        }
    }
}

impl<S: Simd> Lanes for Found<S> {
    const COUNT: usize = size_of::<S::f64s>() / size_of::<f64>();

    type Mask = FoundMask<S>;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        Self { of: self.simd.splat_f64s(value), ..self }
    }

    #[inline(always)]
    fn residue(self, factor: Self, product: Self) -> Self {
        Self { of: self.simd.mul_add_f64s(self.of, factor.of, self.simd.neg_f64s(product.of)), ..self }
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self { of: self.simd.mul_add_f64s(self.of, factor.of, term.of), ..self }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self { of: self.simd.sqrt_f64s(self.of), ..self }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self { of: self.simd.abs_f64s(self.of), ..self }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self { of: self.simd.max_f64s(self.of, other.of), ..self }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self { of: self.simd.min_f64s(self.of, other.of), ..self }
    }

    #[inline(always)]
    fn below(self, other: Self) -> FoundMask<S> {
        FoundMask { simd: self.simd, of: self.simd.less_than_f64s(self.of, other.of) }
    }

    #[inline(always)]
    fn select(self, mask: FoundMask<S>, other: Self) -> Self {
        Self { of: self.simd.select_f64s(mask.of, self.of, other.of), ..self }
    }

    #[inline(always)]
    fn any(mask: FoundMask<S>) -> bool {
        mask.simd.first_true_m64s(mask.of) < Self::COUNT
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        bytemuck::cast_slice(core::slice::from_ref(&self.of)).get(lane).copied().unwrap_or(f64::NAN)
    }

    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: f64) {
        if let Some(place) = bytemuck::cast_slice_mut(core::slice::from_mut(&mut self.of)).get_mut(lane) {
            *place = value;
        }
    }
}

macro_rules! mask_operators {
    ($($operator:ident $function:ident $found:ident),*) => { $(
        impl<S: Simd> $operator for FoundMask<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self { of: self.simd.$found(self.of, other.of), ..self }
            }
        }
    )* };
}
mask_operators!(BitAnd bitand and_m64s, BitOr bitor or_m64s);

impl<S: Simd> Not for FoundMask<S> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self { of: self.simd.not_m64s(self.of), ..self }
    }
}
