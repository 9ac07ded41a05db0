//! Intervals: whatever numbers are taken from the operands, the exact result lies in the result.

use proptest::prelude::*;

use super::exact::{Exact, not_above, not_below};
use crate::{bounds::Bounds, digits::Digits, directed::Directed, interval::Interval, twofold::Twofold};

fn contains<F: Directed>(interval: &Interval<F>, number: &Exact) -> bool {
    not_above(&interval.lower, number) && not_below(&interval.upper, number)
}

/// Two ends, often of different signs, sometimes equal or zero, and a number between them.
fn operand() -> impl Strategy<Value = (f64, f64, f64)> {
    let end = || prop_oneof![6 => -3.0..3.0_f64, 1 => Just(0.0), 1 => -1e-12..1e-12_f64, 1 => Just(1.0)];
    (end(), end(), 0.0..=1.0_f64).prop_map(|(a, b, t)| {
        let (low, high) = (a.min(b), a.max(b));
        (low, high, (low + t * (high - low)).clamp(low, high))
    })
}

fn interior_stays_inside<F: Directed>(
    (a0, a1, x): (f64, f64, f64),
    (b0, b1, y): (f64, f64, f64),
) -> Result<(), TestCaseError> {
    let (a, b) = (Interval::<F>::between(a0, a1), Interval::<F>::between(b0, b1));
    let (x, y) = (Exact::double(x), Exact::double(y));
    prop_assert!(contains(&(&a + &b), &x.plus(&y)));
    prop_assert!(contains(&(&a - &b), &x.plus(&y.times(&Exact::double(-1.0)))));
    prop_assert!(contains(&(&a * &b), &x.times(&y)));
    prop_assert!(contains(&a.squared(), &x.times(&x)));
    prop_assert!(a.squared().lower >= F::exactly(0.0));
    prop_assert!(contains(&a.squared().root().and(&Interval::between(0.0, 9.0)), &x) || x.is_negative());
    prop_assert!(contains(&a.convert::<f64>(), &x));
    prop_assert!(contains(&a.down_to_zero(), &x));
    prop_assert!(contains(&a, &Exact::of(&a.centre().lower).unwrap()));
    prop_assert!(a.magnitude() >= a0.abs().max(a1.abs()) && a.width() >= a1 - a0);
    // The product with the divisor takes the quotient back.
    let quotient = &a / &b;
    if b.is_positive() || b.is_negative() {
        prop_assert!(contains(&(&quotient * &b), &x));
        prop_assert!(quotient.lower <= quotient.upper);
    } else {
        prop_assert!(!quotient.is_positive() && !quotient.is_negative());
    }
    Ok(())
}

/// Quotients of numbers from the operands, against far more digits.
fn quotient_contains<F: Directed>((a0, a1, x): (f64, f64, f64), (b0, b1, y): (f64, f64, f64)) -> bool {
    let quotient = &Interval::<F>::between(a0, a1) / &Interval::between(b0, b1);
    let (x, y) = (Interval::<Digits<512>>::exactly(x), Interval::exactly(y));
    let fine = Bounds::new(&(&x / &y));
    match (Bounds::new(&quotient), fine) {
        (Some(quotient), Some(fine)) => quotient.contain(&fine),
        _ => true,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn interior_numbers_stay_inside(a in operand(), b in operand()) {
        interior_stays_inside::<f64>(a, b)?;
        interior_stays_inside::<Twofold>(a, b)?;
        interior_stays_inside::<Digits<128>>(a, b)?;
        prop_assert!(quotient_contains::<f64>(a, b) && quotient_contains::<Twofold>(a, b) && quotient_contains::<Digits<128>>(a, b));
    }
}

#[test]
fn an_end_that_is_not_a_number_proves_nothing() {
    fn check<F: Directed>() {
        let unknown = Interval::<F>::between(3.0, f64::NAN);
        let below = Interval::<F>::between(f64::NAN, -3.0);
        for known in [
            Interval::between(0.0, 5.0),
            Interval::between(1.0, 2.0),
            Interval::between(-1.0, 1.0),
            Interval::between(-2.0, 0.0),
        ] {
            for unknown in [&unknown, &below] {
                for result in [
                    &known * unknown,
                    unknown * &known,
                    &known / unknown,
                    unknown / &known,
                    &known + unknown,
                    &known - unknown,
                ] {
                    assert!(
                        !result.is_positive() && !result.is_negative() && Bounds::new(&result).is_none(),
                        "{result:?}"
                    );
                }
            }
        }
        assert!(!unknown.is_positive() && !below.is_negative() && !unknown.is_below(&Interval::exactly(9.0)));
        assert!(Bounds::new(&below.down_to_zero()).is_none() && Bounds::new(&unknown.squared()).is_none());
        assert!(Bounds::new(&Interval::<F>::between(-1.0, 4.0).root()).is_none());
        assert!(unknown.magnitude().is_nan() && !(unknown.width() < f64::INFINITY));
        assert_eq!(Interval::<F>::between(-1.0, 1.0).relative_width(), f64::INFINITY);
    }
    check::<f64>();
    check::<Twofold>();
    check::<Digits<128>>();
}

/// What an interval says of itself, exactly where the numbers are few-digited.
#[test]
fn an_interval_knows_its_size() {
    fn check<F: Directed>() {
        let between = Interval::<F>::between;
        let is_near = |found: f64, expected: f64| found >= expected && found <= expected * (1.0 + 1e-15);
        for (lower, upper, width, magnitude) in [
            (2.0, 3.0, 1.0, 3.0),
            (-3.0, -2.0, 1.0, 3.0),
            (-1.0, 0.5, 1.5, 1.0),
            (-0.5, 1.0, 1.5, 1.0),
            (4.0, 4.0, 0.0, 4.0),
        ] {
            let interval = between(lower, upper);
            assert!(is_near(interval.width(), width) || width == 0.0 && interval.width() < 1e-14, "{interval:?}");
            assert_eq!((interval.magnitude(), interval.middle()), (magnitude, 0.5 * (lower + upper)));
            assert_eq!((interval.is_positive(), interval.is_negative()), (lower > 0.0, upper < 0.0));
            let centre = interval.centre();
            assert!(centre.lower == centre.upper && (centre.middle() - interval.middle()).abs() < 1e-14);
            let relative = interval.relative_width();
            assert!(
                lower * upper < 0.0 && relative.is_infinite()
                    || is_near(relative, width / lower.abs().min(upper.abs()))
                    || width == 0.0
            );
        }
        let [low, high] = [between(1.0, 2.0), between(2.0, 3.0)];
        assert!(!low.is_below(&high) && !high.is_below(&low) && low.is_below(&between(2.5, 3.0)));
        let both = low.and(&between(1.5, 7.0));
        assert!(both.lower == F::exactly(1.5) && both.upper == F::exactly(2.0));
        let both = between(1.5, 7.0).and(&low);
        assert!(both.lower == F::exactly(1.5) && both.upper == F::exactly(2.0));
        assert!(
            between(0.0, 0.0).root().upper == F::exactly(0.0)
                && between(0.0, 5.0).down_to_zero().upper == F::exactly(5.0)
        );
        assert!(between(2.0, 5.0).down_to_zero().lower == F::exactly(0.0));
        assert!(between(-2.0, 5.0).down_to_zero().lower == F::exactly(-2.0));
    }
    check::<f64>();
    check::<Twofold>();
    check::<Digits<128>>();
}
