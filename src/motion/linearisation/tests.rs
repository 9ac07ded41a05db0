//! The estimate of what is left, in numbers that are known.

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
