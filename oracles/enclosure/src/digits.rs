//! Ends of intervals with as many bits as are wanted: arithmetic by `dashu`, which rounds correctly in the direction asked for.

use core::cmp::Ordering;

use dashu_float::{
    Context, FBig, Repr,
    round::{Round, mode},
};
use dashu_int::IBig;

use crate::directed::Directed;

/// A number of `BITS` bits; `None` is not a number (the result of a division by zero, or of the root of a negative number).
#[derive(Clone, Debug)]
pub struct Digits<const BITS: usize>(Option<Repr<2>>);

impl<const BITS: usize> PartialEq for Digits<BITS> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const BITS: usize> PartialOrd for Digits<BITS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.as_ref()?.partial_cmp(other.0.as_ref()?)
    }
}

/// The contexts of both directions.
const fn down<const BITS: usize>() -> Context<mode::Down> {
    Context::new(BITS)
}

const fn up<const BITS: usize>() -> Context<mode::Up> {
    Context::new(BITS)
}

/// What an operation of `dashu` returned, or not a number.
type Returned<R> = dashu_float::FpResult<FBig<R, 2>>;

impl<const BITS: usize> Digits<BITS> {
    fn of<R: Round>(returned: Returned<R>) -> Self {
        Self(returned.ok().map(|rounded| rounded.value().into_repr()).filter(Repr::is_finite))
    }

    fn with<R: Round>(&self, other: &Self, operate: impl Fn(&Repr<2>, &Repr<2>) -> Returned<R>) -> Self {
        match (&self.0, &other.0) {
            (Some(one), Some(two)) => Self::of(operate(one, two)),
            _ => Self(None),
        }
    }

    /// `significand 2^exponent`, rounded up.
    pub fn from_parts(significand: IBig, exponent: isize) -> Self {
        let repr = Repr::new(significand, exponent);
        Self(up::<BITS>().add(&repr, &Repr::zero()).ok().map(|rounded| rounded.value().into_repr()))
    }

    fn is_zero(&self) -> bool {
        self.0.as_ref().is_some_and(|repr| repr.significand().is_zero())
    }

    /// Division by zero is not asked of `dashu`.
    fn divided<R: Round>(&self, other: &Self, operate: impl Fn(&Repr<2>, &Repr<2>) -> Returned<R>) -> Self {
        if other.is_zero() { Self(None) } else { self.with(other, operate) }
    }

    fn rooted<R: Round>(&self, operate: impl Fn(&Repr<2>) -> Returned<R>) -> Self {
        match &self.0 {
            Some(repr) if *self >= Self::exactly(0.0) => Self::of(operate(repr)),
            _ => Self(None),
        }
    }

    /// The nearest double, and whether it is the number itself.
    fn double(&self) -> (f64, bool) {
        match &self.0 {
            None => (f64::NAN, true),
            Some(repr) => repr.to_f64().value_with_exact(),
        }
    }
}

impl<const BITS: usize> Directed for Digits<BITS> {
    const BITS: u32 = BITS as u32;

    fn exactly(value: f64) -> Self {
        Self(FBig::<mode::Zero, 2>::try_from(value).ok().map(FBig::into_repr).filter(Repr::is_finite))
    }

    fn negated(&self) -> Self {
        Self(self.0.clone().map(|repr| -repr))
    }

    fn plus_below(&self, other: &Self) -> Self {
        self.with(other, |one, two| down::<BITS>().add(one, two))
    }

    fn plus_above(&self, other: &Self) -> Self {
        self.with(other, |one, two| up::<BITS>().add(one, two))
    }

    fn times_below(&self, other: &Self) -> Self {
        self.with(other, |one, two| down::<BITS>().mul(one, two))
    }

    fn times_above(&self, other: &Self) -> Self {
        self.with(other, |one, two| up::<BITS>().mul(one, two))
    }

    fn over_below(&self, other: &Self) -> Self {
        self.divided(other, |one, two| down::<BITS>().div(one, two))
    }

    fn over_above(&self, other: &Self) -> Self {
        self.divided(other, |one, two| up::<BITS>().div(one, two))
    }

    fn root_below(&self) -> Self {
        self.rooted(|repr| down::<BITS>().sqrt(repr))
    }

    fn root_above(&self) -> Self {
        self.rooted(|repr| up::<BITS>().sqrt(repr))
    }

    fn double_below(&self) -> f64 {
        match self.double() {
            (value, true) => value,
            (value, false) => value.next_down(),
        }
    }

    fn double_above(&self) -> f64 {
        match self.double() {
            (value, true) => value,
            (value, false) => value.next_up(),
        }
    }

    fn exact_parts(&self) -> Option<(IBig, isize)> {
        self.0.clone().map(Repr::into_parts)
    }
}
