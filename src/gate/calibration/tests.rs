//! How claims are counted, and what is on record of them.

use super::*;

/// The figures after these claims, errors and widths of the enclosure.
fn figures(of: &[(f64, f64, f64)]) -> ClaimOverError {
    let mut calibration = Calibration::default();
    for (claim, error, unsure) in of {
        calibration.add(Observable::Interval, *claim, *error, *unsure);
    }
    calibration.figures()[&Observable::Interval]
}

/// A class is the sixteenth part of a factor of ten, and is named by its middle.
fn middle(ratio: f64) -> f64 {
    10f64.powf(((16.0 * ratio.log10()).floor() + 0.5) / 16.0)
}

#[test]
fn a_claim_is_counted_in_multiples_of_the_error_that_the_enclosure_can_tell() {
    for (claim, error, unsure, ratio) in [
        (6.0, 2.0, 0.0, 3.0),
        (1.0, 2.0, 0.0, 0.5),
        (6.0, 2.0, 8.0, 1.5), // half of 8 is more than 2
        (6.0, 2.0, 3.0, 3.0),
        (500.0, 1.0, 0.0, 500.0),
        (6.0, 0.0, 0.0, 1e30),
    ] {
        let found = figures(&[(claim, error, unsure)]);
        assert_eq!((found.numbers, found.smallest), (1, ratio), "{claim} {error} {unsure}");
        assert!((found.median / middle(ratio) - 1.0).abs() < 1e-12, "{} for {ratio}", found.median);
        assert!((found.median / ratio).log10().abs() <= 0.5 / 16.0 + 1e-12);
    }
    // What claims nothing, or is not a number, is the smallest of all, and of no class that has a size.
    for claim in [0.0, f64::NAN] {
        let found = figures(&[(claim, 1.0, 0.0), (2.0, 1.0, 0.0), (2.0, 1.0, 0.0)]);
        assert_eq!((found.numbers, found.smallest), (3, 0.0), "{claim}");
        assert!((found.median / middle(2.0) - 1.0).abs() < 1e-12);
        assert_eq!(figures(&[(claim, 1.0, 0.0)]).median, 0.0);
    }
}

/// Of an even number the lower of the two in the middle.
#[test]
fn the_median_has_half_of_the_numbers_below_it() {
    for (claims, median) in [
        (&[1.0, 10.0, 100.0][..], 10.0),
        (&[1.0, 10.0, 100.0, 1000.0], 10.0),
        (&[1.0, 1.0, 1.0, 100.0], 1.0),
        (&[5.0], 5.0),
    ] {
        let of: Vec<_> = claims.iter().map(|claim| (1.001 * claim, 1.0, 0.0)).collect();
        let found = figures(&of);
        assert!((found.median / middle(1.001 * median) - 1.0).abs() < 1e-12, "{claims:?}: {found:?}");
        assert_eq!(
            (found.numbers, found.smallest),
            (claims.len(), 1.001 * claims.iter().copied().fold(f64::INFINITY, f64::min))
        );
    }
}

#[test]
fn the_claims_of_several_cases_are_added_up() {
    let of = |claims: &[f64]| {
        let mut calibration = Calibration::default();
        claims.iter().for_each(|claim| calibration.add(Observable::Velocity, *claim, 1.0, 0.0));
        calibration
    };
    let mut sum = of(&[2.0, 30.0]);
    sum.add_all(of(&[1.5, 2.0, 400.0]));
    assert_eq!(sum.figures(), of(&[2.0, 30.0, 1.5, 2.0, 400.0]).figures());
    assert_eq!((sum.figures()[&Observable::Velocity].numbers, sum.figures()[&Observable::Velocity].smallest), (5, 1.5));
    let mut sum = of(&[1.5]);
    sum.add_all(of(&[2.0]));
    assert_eq!(sum.figures()[&Observable::Velocity].smallest, 1.5);
    let mut none = Calibration::default();
    none.add_all(of(&[1.5, 2.0]));
    assert_eq!(none, of(&[1.5, 2.0]));
}

/// No row of the record is lost, and every oracle of the default panel is on it with every observable that is judged.
#[test]
fn the_record_is_whole() {
    let text = include_str!("../../../data/record/calibration.csv");
    assert_eq!(RECORD.len(), text.lines().count() - 1);
    use Observable::{ChatteringTime, ImpactTime, Interval, Velocity};
    for oracle in crate::panel::default() {
        for observable in [Interval, Velocity, ImpactTime, ChatteringTime] {
            assert!(band(oracle.name(), observable).is_some(), "{} {observable} is not on record", oracle.name());
        }
    }
}

/// Half and double are off the record, and what seeds vary by is not.
#[test]
fn claims_that_are_halved_or_doubled_are_off_the_record() {
    let band = Band { oracle: String::new(), observable: Observable::Interval, recorded: 30.0 };
    let on = [15.0, 18.0, 21.0, 30.0, 44.0, 50.0, 60.0, f64::NAN].map(|median| band.contains(median));
    assert_eq!(on, [false, false, true, true, true, false, false, false]);
}
