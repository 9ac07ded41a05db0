//! The estimate of what is left, in numbers that are known.

use contract::{Normalisation, Slenderness};

use super::*;

/// 3/2 of the second and third terms, more as they fall more slowly, and no bound where they do not fall.
#[test]
fn what_is_left_is_the_next_terms_and_more_where_they_fall_slowly() {
    assert_eq!(left(0.5, [1.0, 2.0, 4.0], 0.0), 1.5 * (0.5 + 0.5));
    assert_eq!(left(0.5, [9.0, 2.0, 4.0], 0.25), 1.5 * (0.5 + 0.5) * 16.0 / 9.0);
    for ratio in [0.5, 3.0, f64::NAN] {
        assert_eq!(left(0.5, [1.0, 2.0, 4.0], ratio), f64::INFINITY);
    }
}

/// Over `g α` the linear amplitude is `a α/tan α`, and `ε` is what is left of it beyond 1. By the series of the quotient `ε` has a thousand times as many
/// digits, and the claims hold what the plain quotient loses.
#[test]
fn rounding_the_threshold_is_claimed() {
    let stepper = crate::panel::stepper();
    let mut beyond = 0;
    for k in 0..40 {
        let alpha = 0.05 + 0.003 * f64::from(k);
        let square = alpha * alpha;
        // 1 - α/tan α
        let less = square
            * (1.0 / 3.0
                + square
                    * (1.0 / 45.0
                        + square
                            * (2.0 / 945.0
                                + square
                                    * (1.0 / 4725.0
                                        + square * (2.0 / 93_555.0 + square * (1_382.0 / 638_512_875.0))))));
        // 1e-5 beyond the threshold, as near as a double to the slender one comes.
        let slender = (1e-5 + less) / (1.0 - less);
        let slenderness = Slenderness::new(alpha, Normalisation::Slender).unwrap_or_else(|invalid| panic!("{invalid}"));
        let case = |epsilon: f64| {
            let case = Case::from_epsilon(epsilon, 2.0, 0.9).and_then(|case| case.with_max_impacts(20));
            case.unwrap_or_else(|invalid| panic!("{invalid}"))
        };
        let asked = case(slender).with_slenderness(slenderness);
        let Ok((_, found)) = threshold::linear(stepper.as_ref(), &asked, slenderness) else { panic!("declined") };
        let exact = case(slender - less * (1.0 + slender));
        let Ok(truth) = stepper.history(&exact) else { panic!("declined") };
        for (found, truth) in found.impacts.iter().zip(&truth.impacts) {
            let off = (found.interval / truth.interval - 1.0).abs();
            let own = truth.uncertainty.interval;
            assert!(off <= found.uncertainty.interval + own, "{alpha}: {off:e} {found:?}");
            beyond += usize::from(off > 1e-12);
        }
    }
    assert!(beyond > 100, "what the quotient loses is seen: {beyond}");
}

#[test]
fn the_largest_coefficients_are_kept_and_a_lost_one_is_not_taken_for_small() {
    let largest = Largest::default().with([1.0, -3.0, 0.5]).with([-2.0, 1.0, 0.25]);
    assert_eq!(largest.0, [2.0, 3.0, 0.5]);
    assert_eq!(largest.ratio(0.1), 0.1 * 1.5);
    assert_eq!(Largest::default().ratio(0.1), 0.0);
    let lost = largest.with([f64::NAN; 3]);
    assert!(lost.with([1.0; 3]).0.iter().all(|coefficient| coefficient.is_nan()));
    assert_eq!(ratio(&[largest, Largest([1.0, 4.0, 0.0])], 0.5), 2.0);
    assert!(ratio(&[largest, lost, largest], 0.5).is_nan());
}
