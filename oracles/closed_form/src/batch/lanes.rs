//! Several doubles that are computed with at once, one in each lane. A lane knows nothing of the others: its bits are those that a double
//! alone would have.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// What is asked of lanes. Every operation but [`Lanes::mul_add`] is one of IEEE 754, rounded once, in each lane.
///
/// Nothing here, and nothing that is computed with it, may be a closure: one that the compiler leaves out of line is compiled without the
/// instruction set that its caller was chosen for.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many there are.
    const COUNT: usize;

    /// A truth in each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// `value` in every lane.
    fn splat(self, value: f64) -> Self;

    /// `self · factor - product`, rounded once.
    fn residue(self, factor: Self, product: Self) -> Self;

    /// `self · factor + term`, rounded once where the instruction set can, and else twice.
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// The square root.
    fn sqrt(self) -> Self;

    /// The absolute value.
    fn abs(self) -> Self;

    /// The larger of two.
    fn max(self, other: Self) -> Self;

    /// The smaller of two.
    fn min(self, other: Self) -> Self;

    /// Where this is below the other.
    fn below(self, other: Self) -> Self::Mask;

    /// This where the mask holds, and the other elsewhere.
    fn select(self, mask: Self::Mask, other: Self) -> Self;

    /// Whether a mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;

    /// What is in one lane; not a number if there is no such lane.
    fn lane(&self, lane: usize) -> f64;

    /// Puts a value into one lane, if there is such a lane.
    fn set_lane(&mut self, lane: usize, value: f64);

    /// This times a number.
    #[inline(always)]
    fn by(self, factor: f64) -> Self {
        self * self.splat(factor)
    }

    /// This plus a number.
    #[inline(always)]
    fn plus(self, term: f64) -> Self {
        self + self.splat(term)
    }
}

/// One lane: the scalar path.
impl Lanes for f64 {
    const COUNT: usize = 1;

    type Mask = bool;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        value
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
        self.sqrt()
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn below(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn select(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        if lane == 0 { *self } else { f64::NAN }
    }

    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: f64) {
        if lane == 0 {
            *self = value;
        }
    }
}

/// A sum of two, as `twofold` has it.
#[derive(Clone, Copy)]
pub(super) struct Twofold<L> {
    pub high: L,
    pub low: L,
}

impl<L: Lanes> Twofold<L> {
    /// This plus a term. Where the term is the larger one, its own rounding error is lost, and no more.
    #[inline(always)]
    pub fn plus(self, term: L) -> Self {
        let high = self.high + term;
        Self { high, low: self.low + (term - (high - self.high)) }
    }

    /// This less a term, in the same way.
    #[inline(always)]
    pub fn less(self, term: L) -> Self {
        let high = self.high - term;
        Self { high, low: self.low - (term + (high - self.high)) }
    }

    /// This where the mask holds, and the other elsewhere.
    #[inline(always)]
    pub fn select(self, mask: L::Mask, other: Self) -> Self {
        Self { high: self.high.select(mask, other.high), low: self.low.select(mask, other.low) }
    }

    /// This times a factor.
    #[inline(always)]
    pub fn times(self, factor: L) -> Self {
        let high = self.high * factor;
        Self { high, low: self.low.mul_add(factor, self.high.residue(factor, high)) }
    }

    /// The nearest number.
    #[inline(always)]
    pub fn value(self) -> L {
        self.high + self.low
    }
}

/// The error of a product without a fused multiply-add (Dekker). Both ways are exact, so both give the same bits.
#[inline(always)]
pub(super) fn by_splitting<L: Lanes>(x: L, y: L, product: L) -> L {
    let ((x1, x2), (y1, y2)) = (split(x), split(y));
    ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2
}

/// A double as a sum of two of 26 bits each (Veltkamp).
#[inline(always)]
fn split<L: Lanes>(x: L) -> (L, L) {
    let scaled = x.by(134_217_729.0); // 2^27 + 1
    let high = scaled - (scaled - x);
    (high, x - high)
}

/// `N` times the lanes, whose computations do not wait for each other.
#[derive(Clone, Copy)]
pub(super) struct Many<L, const N: usize>(pub [L; N]);

/// The mask of [`Many`].
#[derive(Clone, Copy)]
pub(super) struct ManyMasks<M, const N: usize>([M; N]);

/// The same for each of `N`: `$each` with the index `$index`, put into a copy of `$first`.
macro_rules! each {
    ($first:expr, $index:ident, $each:expr) => {{
        let mut all = $first;
        for $index in 0..N {
            all.0[$index] = $each;
        }
        all
    }};
}

macro_rules! operators {
    ($($operator:ident $function:ident),*) => { $(
        #[allow(clippy::indexing_slicing)] // below the length of the array
        impl<L: Lanes, const N: usize> $operator for Many<L, N> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                each!(self, index, self.0[index].$function(other.0[index]))
            }
        }
    )* };
}
operators!(Add add, Sub sub, Mul mul, Div div);

#[allow(clippy::indexing_slicing)] // below the length of the array
impl<L: Lanes, const N: usize> Neg for Many<L, N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        each!(self, index, -self.0[index])
    }
}

#[allow(clippy::indexing_slicing)] // below the length of the array
impl<L: Lanes, const N: usize> Lanes for Many<L, N> {
    const COUNT: usize = N * L::COUNT;

    type Mask = ManyMasks<L::Mask, N>;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        each!(self, index, self.0[index].splat(value))
    }

    #[inline(always)]
    fn residue(self, factor: Self, product: Self) -> Self {
        each!(self, index, self.0[index].residue(factor.0[index], product.0[index]))
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        each!(self, index, self.0[index].mul_add(factor.0[index], term.0[index]))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        each!(self, index, self.0[index].sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        each!(self, index, self.0[index].abs())
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        each!(self, index, self.0[index].max(other.0[index]))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        each!(self, index, self.0[index].min(other.0[index]))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Self::Mask {
        let first = self.0[0].below(other.0[0]);
        each!(ManyMasks([first; N]), index, self.0[index].below(other.0[index]))
    }

    #[inline(always)]
    fn select(self, mask: Self::Mask, other: Self) -> Self {
        each!(self, index, self.0[index].select(mask.0[index], other.0[index]))
    }

    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        let mut either = mask.0[0];
        for index in 1..N {
            either = either | mask.0[index];
        }
        L::any(either)
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self.0.get(lane / L::COUNT).map_or(f64::NAN, |lanes| lanes.lane(lane % L::COUNT))
    }

    #[inline(always)]
    fn set_lane(&mut self, lane: usize, value: f64) {
        if let Some(lanes) = self.0.get_mut(lane / L::COUNT) {
            lanes.set_lane(lane % L::COUNT, value);
        }
    }
}

macro_rules! mask_operators {
    ($($operator:ident $function:ident),*) => { $(
        #[allow(clippy::indexing_slicing)] // below the length of the array
        impl<M: Copy + $operator<Output = M>, const N: usize> $operator for ManyMasks<M, N> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                each!(self, index, self.0[index].$function(other.0[index]))
            }
        }
    )* };
}
mask_operators!(BitAnd bitand, BitOr bitor);

#[allow(clippy::indexing_slicing)] // below the length of the array
impl<M: Copy + Not<Output = M>, const N: usize> Not for ManyMasks<M, N> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        each!(self, index, !self.0[index])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::registers::Two;

    /// Each lane of several registers is a lane of its own: it can be set, read and compared without the others.
    #[test]
    fn lanes_do_not_touch_each_other() {
        let mut lanes = Many([Two::ZERO; 3]);
        assert_eq!(Many::<Two, 3>::COUNT, 6);
        for lane in 0..6 {
            lanes.set_lane(lane, 1.0 + lane as f64);
        }
        for lane in 0..6 {
            assert_eq!(lanes.lane(lane), 1.0 + lane as f64);
            let this = lanes.below(lanes.splat(1.5 + lane as f64)) & !lanes.below(lanes.splat(0.5 + lane as f64));
            assert!(Many::<Two, 3>::any(this));
            let chosen = lanes.splat(-1.0).select(this, lanes);
            for other in 0..6 {
                assert_eq!(chosen.lane(other), if other == lane { -1.0 } else { 1.0 + other as f64 });
            }
        }
        assert!(lanes.lane(6).is_nan() && !Many::<Two, 3>::any(lanes.below(lanes.splat(1.0))));
    }
}
