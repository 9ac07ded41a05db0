//! The resummed series, up to the critical amplitude.

use crate::{effort::pick, exact};
use asymptotic::{
    Asymptotic, Expansion, Order, RESUMMED_TERMS, Resummed, approach, coefficients, exponent_of_coefficients, ratios,
    scaled_tail,
};
use contract::{Case, Oracle};

fn resummed(omega: f64, eta: f64, terms: usize) -> Resummed {
    Resummed::new(&Expansion::new(omega, eta, terms, 0).unwrap()).unwrap()
}

/// `ω`, `η` and `a_cr - 1` of the certified table.
fn certified() -> Vec<(f64, f64, f64)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/reference/critical_amplitudes.csv");
    let table = std::fs::read_to_string(path).unwrap();
    let rows = table.lines().skip(1).map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        // The leading 1 is taken off before the rounding to a double.
        let epsilon = fields[2].replacen("1.", "0.", 1).parse().unwrap();
        (fields[0].parse().unwrap(), fields[1].parse().unwrap(), epsilon)
    });
    rows.collect()
}

/// One of each restitution, at another frequency each, when quick; all of the table, when full.
fn some() -> Vec<(f64, f64, f64)> {
    let each = pick("one of so many pairs of the table", 7, 1);
    certified().into_iter().step_by(each).collect()
}

#[test]
fn the_critical_amplitude_from_the_coefficients_alone() {
    for (omega, eta, critical) in some() {
        for (terms, most) in [(30, 1e-4), (RESUMMED_TERMS, 1e-5)] {
            let estimate = resummed(omega, eta, terms).critical_epsilon();
            let error = (estimate.value - critical).abs();
            println!("{omega} {eta} {terms}: {:e} of {:e}", error / critical, estimate.uncertainty / critical);
            assert!(error < most * critical, "{omega} {eta}, {terms} terms: {:e}", error / critical);
            assert!(
                error < estimate.uncertainty,
                "{omega} {eta}, {terms} terms: {:e} claims {:e}",
                error,
                estimate.uncertainty
            );
        }
        let expansion = Expansion::new(omega, eta, 60, 0).unwrap();
        let last = *ratios(expansion.coefficients(), approach(eta).exponent).last().unwrap();
        assert!((last.biased / critical - 1.0).abs() < 1e-2 && 1.0 / last.ratio > critical, "{last:?}");
    }
}

#[test]
fn it_holds_up_to_the_critical_amplitude() {
    for (omega, eta, critical) in some() {
        let resummed = resummed(omega, eta, RESUMMED_TERMS);
        for (share, most) in [(0.5, 1e-10), (0.9, 1e-10), (0.99, 1e-6), (0.999, 1e-4)] {
            let epsilon = share * critical;
            let truth = exact::chattering_time(epsilon, omega, eta).unwrap();
            let estimate = resummed.chattering_time(epsilon).unwrap();
            let error = (estimate.value - truth).abs();
            println!("{omega} {eta} at {share}: {:e} of {:e}", error / truth, estimate.uncertainty / truth);
            assert!(error < most * truth, "{omega} {eta} at {share}: {:e}", error / truth);
            assert!(
                error < estimate.uncertainty.max(1e-12 * truth),
                "{omega} {eta} at {share}: {:e} claims {:e}",
                error,
                estimate.uncertainty
            );
        }
        assert_eq!(resummed.chattering_time(1.001 * critical), None);
        assert_eq!(resummed.chattering_time(10.0 * critical), None);
    }
}

#[test]
fn where_the_papers_series_is_off_by_15_percent() {
    let (omega, eta, critical) = *certified().iter().find(|row| (row.0, row.1) == (2.0, 0.92)).unwrap();
    let paper = coefficients(eta).unwrap();
    for (share, of_paper, most) in [(0.99, 0.12, 1e-6), (0.999, 0.15, 1e-4)] {
        let epsilon = share * critical;
        let truth = exact::chattering_time(epsilon, omega, eta).unwrap();
        let by_paper = paper.chattering_time(epsilon, omega);
        assert!((1.0 - by_paper / truth - of_paper).abs() < 0.03, "{}", 1.0 - by_paper / truth);
        let oracle = Asymptotic::new().with_order(Order::Resummed).unwrap();
        let history = oracle.history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).unwrap();
        let error = history.chattering_time.unwrap().value / truth - 1.0;
        assert!(error.abs() < most, "{error:e} at {share}");
    }
}

#[test]
fn the_exponent_is_that_of_the_bounce_that_repeats_itself() {
    for (eta, exponent) in [(0.5, 0.61164202947), (0.7, 0.603208061465), (0.8, 0.601267147722), (0.92, 0.600177835493)]
    {
        assert!((approach(eta).exponent - exponent).abs() < 1e-11, "{eta}: {}", approach(eta).exponent);
    }
    assert!((approach(0.9999).exponent - 0.6).abs() < 1e-6);
    assert!((approach(0.5).log_period - 1.3470873).abs() < 1e-7);
}

#[test]
fn too_few_terms_are_refused() {
    assert!(Resummed::new(&Expansion::new(2.0, 0.92, 15, 0).unwrap()).is_err());
}

#[test]
fn the_exponent_from_the_coefficients_is_that_of_the_formula() {
    let check = |(omega, eta, critical): (f64, f64, f64)| {
        let estimate = exponent_of_coefficients(omega, eta, critical).unwrap();
        let error = (estimate.value - approach(eta).exponent).abs();
        println!("{omega} {eta}: exponent {} off by {error:e} of {:e}", estimate.value, estimate.uncertainty);
        assert!(error < estimate.uncertainty, "{omega} {eta}: {error:e} claims {:e}", estimate.uncertainty);
        if omega > 1.0 {
            assert!(error < 5e-4 && estimate.uncertainty < 1.4e-3, "{omega} {eta}: {error:e}");
        }
    };
    // Some seconds each at the largest restitution.
    some().into_iter().for_each(check);
}

/// The claims outside of the table: random frequencies and restitutions, up to just below the critical amplitude; and above it, no value.
#[test]
fn the_claims_hold_for_random_cases() {
    let mut uniform = exact::uniform(0x9E37_79B9_7F4A_7C15);
    let mut worst = 0.0_f64;
    for _ in 0..pick("random pairs that are resummed", 8, 40) {
        let (omega, eta) = (0.5 * 200_f64.powf(uniform().powi(2)), 0.5 + 0.48 * uniform());
        let critical = exact::critical(omega, eta);
        let resummed = resummed(omega, eta, RESUMMED_TERMS);
        for _ in 0..20 {
            let epsilon = critical * (1.0 - 10.0_f64.powf(-3.5 * uniform()));
            let truth = exact::chattering_time(epsilon, omega, eta).unwrap();
            let estimate = resummed.chattering_time(epsilon).unwrap();
            worst = worst.max((estimate.value - truth).abs() / estimate.uncertainty.max(1e-11 * truth));
        }
        for above in [1.0002, 1.001, 1.01, 1.1, 2.0, 10.0] {
            let value = resummed.chattering_time(above * critical);
            assert!(
                value.is_none_or(|value| value.value + value.uncertainty >= std::f64::consts::PI / omega),
                "{value:?}"
            );
        }
    }
    println!("error over claim: {worst}");
    assert!(worst < 1.0, "{worst}");
}

#[test]
fn where_it_was_not_calibrated_it_declines() {
    for (omega, eta) in [(0.4, 0.9), (2.0, 0.49), (2.0, 0.985)] {
        let decline = Resummed::new(&Expansion::new(omega, eta, 20, 0).unwrap()).unwrap_err();
        assert_eq!(decline.reason(), "out of range", "{omega} {eta}");
    }
}

/// Scaled by what a branch point at `a_cr` with the known exponent makes of them, the coefficients vary slowly: their last ten by less than a tenth.
#[test]
fn the_scaled_coefficients_vary_slowly() {
    for (omega, eta, critical) in some() {
        let tail = scaled_tail(&Expansion::new(omega, eta, 60, 0).unwrap(), critical);
        let last = &tail[tail.len() - 10..];
        let fold = |of: fn(f64, f64) -> f64, start| last.iter().fold(start, |one, other: &f64| of(one, *other));
        let (least, most) = (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY));
        println!("{omega} {eta}: {} from {least} to {most}", tail.len());
        assert!(tail.len() == 60 && most < 0.0 && least / most < 1.1, "{omega} {eta}: {least} to {most}");
    }
}
