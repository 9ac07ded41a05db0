//! What the outside sees of an interval.

use core::cmp::Ordering;

use contract::Ending;
use dashu_int::IBig;
use proptest::prelude::*;

use super::exact::{Exact, not_above, not_below};
use crate::{
    Enclosed, EnclosedImpact, bounds::Bounds, digits::Digits, directed::Directed, interval::Interval, twofold::Twofold,
};

fn between(lower: f64, upper: f64) -> Bounds {
    Bounds::new(&Interval::<f64>::between(lower, upper)).unwrap()
}

#[test]
fn decimals_are_rounded_outward() {
    assert_eq!(between(0.125, 0.125).decimals(2), ["0.12", "0.13"]);
    assert_eq!(between(-0.125, 0.125).decimals(2), ["-0.13", "0.13"]);
    assert_eq!(between(-0.125, -0.125).decimals(2), ["-0.13", "-0.12"]);
    assert_eq!(between(-0.001, 0.0).decimals(2), ["-0.01", "0.00"]);
    assert_eq!(between(3.0, 4e20).decimals(0), ["3", "400000000000000000000"]);
    assert_eq!(between(0.5, 0.5).decimals(3), ["0.500", "0.500"]);
}

#[test]
fn a_decimal_is_compared_exactly() {
    let tenth = between(0.1, 0.1);
    assert_eq!(tenth.contains("0.1"), Some(false));
    assert_eq!(tenth.contains("0.1000000000000000055511151231257827021181583404541015625"), Some(true));
    assert_eq!(between(-2.5, 1e3).contains("-2.5"), Some(true));
    assert_eq!(between(-2.5, 1e3).contains("-2.50000000000000000000000000001"), Some(false));
    assert_eq!(between(-2.5, 1e3).contains("-0.5"), Some(true));
    assert_eq!(tenth.contains("one"), None);
}

#[test]
fn the_middle_is_within_its_claim_of_both_ends() {
    for (lower, upper) in [(0.1, 0.1), (1.0, 1.0 + f64::EPSILON), (-3.0, 0.2), (1e-300, 1e300)] {
        let (middle, claim) = between(lower, upper).middle();
        assert!(
            middle - claim <= lower
                && upper <= middle + claim
                && claim <= 0.51 * (upper - lower) + 1e-16 * claim + 5e-324 + f64::EPSILON
        );
    }
}

#[test]
fn width_and_nesting_are_exact() {
    let third = |n: f64| &Interval::<Digits<256>>::exactly(1.0) / &Interval::exactly(n);
    let fine = Bounds::new(&third(3.0)).unwrap();
    let coarse = Bounds::new(&(&Interval::<Twofold>::exactly(1.0) / &Interval::exactly(3.0))).unwrap();
    assert!(coarse.contain(&fine) && !fine.contain(&coarse) && fine.contain(&fine));
    assert!(fine.width() > 0.0 && fine.width() < 1e-76 && coarse.width() < 1e-29);
    assert_eq!(between(0.25, 1.0).width(), 0.75);
    assert!(Bounds::new(&Interval::<f64>::between(0.0, f64::INFINITY)).is_none());
}

#[test]
fn places_are_what_the_larger_end_needs() {
    for (lower, upper, digits, places) in [
        (0.5, 0.5, 3, 3),
        (1.5, 1.5, 3, 2),
        (123.4, 123.4, 3, 0),
        (123.4, 123.4, 2, 0),
        (0.00123, 0.00123, 3, 5),
        (-20.0, 0.1, 4, 2),
        (0.1, 20.0, 4, 2),
        (0.0, 0.0, 4, 3),
    ] {
        assert_eq!(between(lower, upper).places(digits), places, "{lower} {upper} {digits}");
    }
}

#[test]
fn digits_are_settled_where_both_ends_have_them() {
    let settled = |lower, upper, digits| between(lower, upper).settled(digits);
    assert_eq!(settled(1.23451, 1.23459, 5).as_deref(), Some("1.2345"));
    assert_eq!(settled(1.23449, 1.23451, 5), None);
    assert_eq!(settled(-1.23459, -1.23451, 5).as_deref(), Some("-1.2346"));
    assert_eq!(settled(0.00251, 0.00259, 2).as_deref(), Some("0.0025"));
}

#[test]
fn ends_that_have_crossed_are_no_bounds() {
    assert!(Bounds::new(&Interval::<f64>::between(1.0, 1.0_f64.next_down())).is_none());
    assert_eq!((between(-2.0, 3.0).lower(), between(-2.0, 3.0).upper()), (-2.0, 3.0));
    let [outer, inner] = [between(-2.0, 3.0), between(-2.0, 2.5)];
    assert!(outer.contain(&inner) && !inner.contain(&outer) && !between(-1.9, 9.0).contain(&inner));
}

/// Two numbers of many bits, the lower first.
fn ends<F: Directed>(a: f64, b: f64) -> Interval<F> {
    let third = |x: f64, above: bool| {
        let (x, three) = (F::exactly(x), F::exactly(3.0));
        if above { x.over_above(&three) } else { x.over_below(&three) }
    };
    Interval { lower: third(a.min(b), false), upper: third(a.max(b), true) }
}

/// A decimal with its point moved behind its last digit.
fn without_point(decimal: &str) -> Exact {
    Exact::whole(decimal.replace('.', "").parse::<IBig>().unwrap())
}

/// Doubles and decimals that are handed out are outside of the exact ends, and the next but one (or the next decimal) is not.
fn outside<F: Directed>(interval: &Interval<F>, digits: u32) -> Result<(), TestCaseError> {
    let bounds = Bounds::new(interval).unwrap();
    let [lower, upper] = [&interval.lower, &interval.upper].map(|end| Exact::of(end).unwrap());
    prop_assert!(not_above(&bounds.lower(), &lower) && not_below(&bounds.lower().next_up().next_up(), &lower));
    prop_assert!(not_below(&bounds.upper(), &upper) && not_above(&bounds.upper().next_down().next_down(), &upper));
    let width = upper.plus(&lower.negated());
    prop_assert!(not_below(&bounds.width(), &width) && not_above(&(bounds.width() * (1.0 - 1e-15)), &width));

    let (middle, claim) = bounds.middle();
    let (middle, claim) = (Exact::double(middle), Exact::double(claim));
    prop_assert!(middle.plus(&claim.negated()).compare(&lower) != Ordering::Greater, "claim, lower");
    prop_assert!(middle.plus(&claim).compare(&upper) != Ordering::Less, "claim, upper");

    let scale = Exact::whole(IBig::from(10).pow(digits as usize));
    let [below, above] = bounds.decimals(digits).map(|decimal| without_point(&decimal));
    let one = Exact::double(1.0);
    let (low, high) = (lower.times(&scale), upper.times(&scale));
    prop_assert!(below.compare(&low) != Ordering::Greater && below.plus(&one).compare(&low) == Ordering::Greater);
    prop_assert!(above.compare(&high) != Ordering::Less && above.plus(&one.negated()).compare(&high) == Ordering::Less);
    Ok(())
}

/// The same of what a history claims: each value is within its claim of both ends, the relative ones of the smaller of the two.
fn claimed<F: Directed>(interval: &Interval<F>) -> Result<(), TestCaseError> {
    let bounds = Bounds::new(interval).unwrap();
    let [lower, upper] = [&interval.lower, &interval.upper].map(|end| Exact::of(end).unwrap());
    let impact = EnclosedImpact { time: bounds.clone(), interval: bounds.clone(), velocity: bounds.clone() };
    let enclosed = Enclosed {
        impacts: vec![impact],
        ending: Ending::AtRest,
        chattering_time: Some(bounds.clone()),
        bits: F::BITS,
    };
    let history = enclosed.history();
    let (impact, total) = (history.impacts[0], history.chattering_time.unwrap());
    let smaller = if lower.is_negative() { upper.negated() } else { lower.clone() };
    let absolute = |claim: f64| Exact::double(claim);
    let relative = |claim: f64| Exact::double(claim).times(&smaller);
    for (value, claim) in [
        (impact.time, absolute(impact.uncertainty.time)),
        (impact.interval, relative(impact.uncertainty.interval)),
        (impact.velocity, relative(impact.uncertainty.velocity)),
        (total.value, absolute(total.uncertainty)),
    ] {
        let value = Exact::double(value);
        prop_assert!(value.plus(&claim.negated()).compare(&lower) != Ordering::Greater, "lower");
        prop_assert!(value.plus(&claim).compare(&upper) != Ordering::Less, "upper");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn what_is_handed_out_is_outside_of_the_exact_ends(
        a in -9.0..9.0_f64, apart in -18..1_i32, exponent in -40..40_i32, digits in 0..40_u32,
    ) {
        let a = a * (2.0_f64).powi(exponent);
        let b = a + a.abs() * (10.0_f64).powi(apart);
        outside::<f64>(&ends(a, b), digits)?;
        outside::<Twofold>(&ends(a, b), digits)?;
        outside::<Digits<128>>(&ends(a, b), digits)?;
        if a != 0.0 && a.signum() == b.signum() {
            claimed::<f64>(&ends(a, b))?;
            claimed::<Twofold>(&ends(a, b))?;
            claimed::<Digits<192>>(&ends(a, b))?;
        }
    }
}
