//! Every operation of every format against exact arithmetic: the bounds hold, and they are close.

use core::cmp::Ordering;

use proptest::prelude::*;

use super::{
    exact::{Exact, not_above, not_below},
    nearest::Nearest,
};
use crate::{digits::Digits, directed::Directed, twofold::Twofold};

/// Whether all bounds hold for a pair.
fn holds<F: Directed>(x: &F, y: &F) -> bool {
    let (Some(a), Some(b)) = (Exact::of(x), Exact::of(y)) else { return true };
    let sum = a.plus(&b);
    let product = a.times(&b);
    // q <= a/b where q b <= a, or the reverse for a negative divisor.
    let against = |quotient: &F, below: bool| {
        let Some(q) = Exact::of(quotient) else { return true };
        let order = q.times(&b).compare(&a);
        order == Ordering::Equal || (order == Ordering::Less) == (below != b.is_negative())
    };
    let root_holds = a.is_negative() || {
        let squared = |root: F| Exact::of(&root).map(|r| (r.is_negative(), r.times(&r)));
        squared(x.root_below()).is_none_or(|(negative, square)| negative || square.compare(&a) != Ordering::Greater)
            && squared(x.root_above())
                .is_none_or(|(negative, square)| !negative && square.compare(&a) != Ordering::Less)
    };
    not_above(&x.plus_below(y), &sum)
        && not_below(&x.plus_above(y), &sum)
        && not_above(&x.times_below(y), &product)
        && not_below(&x.times_above(y), &product)
        && against(&x.over_below(y), true)
        && against(&x.over_above(y), false)
        && root_holds
        && (!x.double_below().is_finite() || Exact::double(x.double_below()).compare(&a) != Ordering::Greater)
        && (!x.double_above().is_finite() || Exact::double(x.double_above()).compare(&a) != Ordering::Less)
        && x.partial_cmp(y) == Some(a.compare(&b))
}

/// Whether the bounds are as close as the format promises, for numbers far from the ends of the range.
fn is_close<F: Directed>(x: &F, y: &F) -> bool {
    let unit = (2.0_f64).powi(3 - F::BITS as i32);
    let near = |below: F, above: F| {
        let size = above.double_above().abs().max(below.double_below().abs());
        above.plus_above(&below.negated()).double_above() <= unit * size
    };
    near(x.times_below(y), x.times_above(y))
        && near(x.over_below(y), x.over_above(y))
        && x.plus_above(y).plus_above(&x.plus_below(y).negated()).double_above()
            <= unit * (x.double_above().abs() + y.double_above().abs())
        && (*x < F::exactly(0.0) || near(x.root_below(), x.root_above()))
}

/// A number with more bits than a double, if the format has them.
fn number<F: Directed>(high: f64, low: f64) -> F {
    F::exactly(high).plus_below(&F::exactly(high * low * f64::EPSILON))
}

fn significand() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1.0..2.0_f64, 1 => Just(1.0), 1 => Just(2.0 - f64::EPSILON), 1 => Just(1.0 + f64::EPSILON)]
}

/// `exponents` bounds the power of two.
fn double(exponents: i32) -> impl Strategy<Value = f64> {
    (significand(), -exponents..=exponents, any::<bool>())
        .prop_map(|(s, e, minus)| if minus { -s } else { s } * (2.0_f64).powi(e))
}

fn any_size() -> impl Strategy<Value = f64> {
    prop_oneof![6 => double(40), 3 => double(500), 1 => double(1020), 1 => Just(0.0), 1 => Just(f64::MAX), 1 => Just(5e-324)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn bounds_hold(x in any_size(), xl in -1.0..1.0_f64, y in any_size(), yl in -1.0..1.0_f64) {
        prop_assert!(holds::<f64>(&x, &y));
        prop_assert!(holds::<Twofold>(&number(x, xl), &number(y, yl)));
        prop_assert!(holds::<Digits<64>>(&number(x, xl), &number(y, yl)));
        prop_assert!(holds::<Digits<128>>(&number(x, xl), &number(y, yl)));
        prop_assert!(holds::<Digits<192>>(&number(x, xl), &number(y, yl)));
    }

    #[test]
    fn bounds_hold_where_terms_cancel(x in double(40), xl in -1.0..1.0_f64, yl in -1.0..1.0_f64) {
        let y: Twofold = number(-x, yl);
        prop_assert!(holds::<Twofold>(&number(x, xl), &y));
        prop_assert!(holds::<f64>(&x, &(-x * (1.0 + xl * 1e-10))));
        prop_assert!(holds::<Digits<128>>(&number(x, xl), &number(-x, yl)));
    }

    #[test]
    fn bounds_are_close(x in double(200), xl in -1.0..1.0_f64, y in double(200), yl in -1.0..1.0_f64) {
        prop_assert!(is_close::<f64>(&x, &y));
        prop_assert!(is_close::<Twofold>(&number(x, xl), &number(y, yl)));
        prop_assert!(is_close::<Digits<128>>(&number(x, xl), &number(y, yl)));
        prop_assert!(is_close::<Digits<384>>(&number(x, xl), &number(y, yl)));
    }
}

#[test]
fn doubles_survive_the_way_to_every_format_and_back() {
    for x in [0.0, -0.0, 1.0, -1.5, 0.1, 5e-324, -5e-324, 1e-310, f64::MIN_POSITIVE, f64::MAX, f64::MIN] {
        for back in [
            [Digits::<128>::exactly(x).double_below(), Digits::<128>::exactly(x).double_above()],
            [Twofold::exactly(x).double_below(), Twofold::exactly(x).double_above()],
        ] {
            assert_eq!(back, [x, x]);
        }
    }
}

#[test]
fn numbers_beyond_the_doubles_are_bounded() {
    let least = Digits::<128>::exactly(5e-324);
    let smaller = least.times_below(&least);
    assert!(smaller.double_below() <= 0.0 && smaller.double_above() >= 5e-324);
    let greatest = Digits::<128>::exactly(f64::MAX);
    let greater = greatest.times_above(&greatest);
    assert!(greater.double_below() <= f64::MAX && greater.double_above() == f64::INFINITY);
    assert!(greater.negated().double_below() == f64::NEG_INFINITY);
}

#[test]
fn what_is_not_a_number_is_never_less_nor_greater() {
    fn check<F: Directed>() {
        let zero = F::exactly(0.0);
        for none in [
            F::exactly(f64::NAN),
            zero.over_below(&zero),
            F::exactly(1.0).over_above(&zero),
            F::exactly(-1.0).root_below(),
        ] {
            for other in [zero.clone(), F::exactly(1.0)] {
                for result in [
                    none.plus_below(&other),
                    none.times_above(&other),
                    other.times_below(&none),
                    none.over_above(&F::exactly(2.0)),
                    other.over_below(&none),
                    none.root_above(),
                ] {
                    assert!(result.partial_cmp(&zero).is_none() || !result.double_below().is_finite(), "{result:?}");
                }
            }
        }
    }
    check::<Twofold>();
    check::<Digits<128>>();
}

/// The control: rounding to the nearest is found out.
#[test]
fn rounding_to_the_nearest_fails_the_test_of_the_bounds() {
    let broken =
        (1..200).filter(|&n| !holds(&Nearest(1.0 + f64::from(n) / 7.0), &Nearest(f64::from(n) / 11.0))).count();
    assert!(broken > 150, "only {broken} of 199");
}
