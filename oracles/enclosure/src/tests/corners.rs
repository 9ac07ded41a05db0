//! Every composite operation at the very ends of its operands, where rounding in the wrong direction is a double too little, and no more.

use core::cmp::Ordering;

use proptest::prelude::*;

use super::exact::{Exact, not_above, not_below};
use crate::{digits::Digits, directed::Directed, interval::Interval, twofold::Twofold};

/// An interval whose ends have more bits than a double, if the format has them.
fn interval<F: Directed>([low, high, fine]: [f64; 3]) -> Interval<F> {
    let end = |value: f64| F::exactly(value).plus_below(&F::exactly(value * fine * f64::EPSILON));
    let (one, other) = (end(low), end(high));
    if one <= other { Interval { lower: one, upper: other } } else { Interval { lower: other, upper: one } }
}

fn ends<F: Directed>(of: &Interval<F>) -> Option<[Exact; 2]> {
    Some([Exact::of(&of.lower)?, Exact::of(&of.upper)?])
}

fn contains<F: Directed>(of: &Interval<F>, number: &Exact) -> bool {
    not_above(&of.lower, number) && not_below(&of.upper, number)
}

/// Whether `q` is at most (or at least) `a/b`.
fn on_its_side<F: Directed>(q: &F, a: &Exact, b: &Exact, side: Ordering) -> bool {
    Exact::of(q).is_none_or(|q| {
        let order = q.times(b).compare(a);
        order == Ordering::Equal || (order == side) != b.is_negative()
    })
}

/// The results from every pair of ends are inside.
fn holds<F: Directed>(a: &Interval<F>, b: &Interval<F>) -> Result<(), TestCaseError> {
    let (Some(xs), Some(ys)) = (ends(a), ends(b)) else { return Ok(()) };
    let (sum, difference, product, quotient) = (a + b, a - b, a * b, a / b);
    for x in &xs {
        for y in &ys {
            prop_assert!(contains(&sum, &x.plus(y)), "sum");
            prop_assert!(contains(&difference, &x.plus(&y.negated())), "difference");
            prop_assert!(contains(&product, &x.times(y)), "product");
            if b.is_positive() || b.is_negative() {
                prop_assert!(on_its_side(&quotient.lower, x, y, Ordering::Less), "quotient, lower");
                prop_assert!(on_its_side(&quotient.upper, x, y, Ordering::Greater), "quotient, upper");
            }
        }
        prop_assert!(contains(&a.squared(), &x.times(x)), "square");
        prop_assert!(contains(&-a, &x.negated()) && contains(&a.absolute(), x) != a.is_negative(), "sign");
        prop_assert!(contains(&a.convert::<f64>(), x) && contains(&a.down_to_zero(), x), "conversion");
        prop_assert!(not_below(&a.magnitude(), x) && not_below(&a.magnitude(), &x.negated()), "magnitude");
        if a.is_positive() {
            let root = a.root();
            let square = |end: &F| Exact::of(end).map(|end| end.times(&end));
            prop_assert!(
                square(&root.lower).is_none_or(|square| square.compare(x) != Ordering::Greater),
                "root, lower"
            );
            let upper = square(&root.upper).is_none_or(|square| square.compare(&xs[1]) != Ordering::Less);
            prop_assert!(upper, "root, upper");
        }
    }
    let width = xs[1].plus(&xs[0].negated());
    prop_assert!(not_below(&a.width(), &width), "width");
    if a.is_positive() {
        let claimed = Exact::double(a.relative_width()).times(&xs[0]);
        prop_assert!(claimed.compare(&width) != Ordering::Less, "relative width");
    }
    Ok(())
}

/// Signs of both ends: positive, negative, around zero, from or up to zero, one number, zero.
fn operand() -> impl Strategy<Value = [f64; 3]> {
    let size = || (1.0..2.0_f64, -30..30_i32).prop_map(|(s, e)| s * (2.0_f64).powi(e));
    let ends = (size(), size()).prop_flat_map(|(one, other)| {
        prop_oneof![
            Just([one, other]),
            Just([-one, -other]),
            Just([-one, other]),
            Just([0.0, other]),
            Just([-one, 0.0]),
            Just([one, one]),
            Just([0.0, 0.0]),
        ]
    });
    (ends, -1.0..1.0_f64).prop_map(|([one, other], fine)| [one, other, fine])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn ends_are_rounded_outward(a in operand(), b in operand()) {
        holds::<f64>(&interval(a), &interval(b))?;
        holds::<Twofold>(&interval(a), &interval(b))?;
        holds::<Digits<64>>(&interval(a), &interval(b))?;
        holds::<Digits<192>>(&interval(a), &interval(b))?;
    }
}
