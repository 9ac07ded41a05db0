//! The critical amplitude: the interpolant and the short fits, against certified values and direct stepping.

use std::path::Path;

use chattercheck::{
    measure::critical::{self, INTERPOLATION_ERROR, Term},
    panel,
    studies::reference::{self, CriticalRow},
};
use contract::Oracle;
use proptest::{
    prelude::*,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};
use serde::de::DeserializeOwned;

fn table<Row: DeserializeOwned>(name: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/reference").join(name);
    csv::Reader::from_path(path).unwrap().deserialize().map(Result::unwrap).collect()
}

fn stepper() -> Box<dyn Oracle> {
    panel::select("closed-form").unwrap().remove(0)
}

fn interpolated(omega: f64, eta: f64) -> f64 {
    critical::interpolated(omega, eta).unwrap()
}

#[test]
fn the_interpolant_lies_between_the_certified_amplitudes() {
    let rows: Vec<CriticalRow> = table("critical_amplitudes.csv");
    assert_eq!(rows.len(), 30);
    for row in rows {
        let [complete, incomplete] = [&row.complete, &row.incomplete].map(|decimal| decimal.parse::<f64>().unwrap());
        let found = 1.0 + interpolated(row.omega, row.eta);
        let error = INTERPOLATION_ERROR;
        assert!(found >= complete - error && found <= incomplete + error, "{found} in {row:?}");
    }
}

#[test]
fn the_interpolant_is_direct_stepping_to_the_last_digits() {
    let stepper = stepper();
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[76; 32]);
    let config = Config { cases: 100, failure_persistence: None, ..Config::default() };
    // Even in omega for one half, and in 1/omega for the other: the change is fastest at low frequencies.
    let omega = prop_oneof![0.5..8.0_f64, (0.125..2.0_f64).prop_map(f64::recip)];
    let eta = prop_oneof![3 => 0.5..0.98_f64, 1 => 0.9..0.98_f64];
    let run = TestRunner::new_with_rng(config, rng).run(&(omega, eta), |(omega, eta)| {
        let (below, _) = critical::bracket(stepper.as_ref(), omega, eta).unwrap().unwrap();
        let off = interpolated(omega, eta) - below;
        prop_assert!(off.abs() <= INTERPOLATION_ERROR, "off by {off:e} at {omega}, {eta}");
        Ok(())
    });
    run.unwrap();
    for (omega, eta) in [(0.5, 0.5), (0.5, 0.98), (8.0, 0.5), (8.0, 0.98)] {
        let (below, _) = critical::bracket(stepper.as_ref(), omega, eta).unwrap().unwrap();
        assert!((interpolated(omega, eta) - below).abs() <= INTERPOLATION_ERROR, "corner {omega}, {eta}");
    }
}

#[test]
fn the_interpolant_refuses_what_is_outside_its_range() {
    let below_half = 0.5_f64.next_down();
    for (omega, eta, field, value) in [
        (below_half, 0.9, "omega", "0.49999999999999994"),
        (8.5, 0.9, "omega", "8.5"),
        (f64::NAN, 0.9, "omega", "NaN"),
        (2.0, below_half, "eta", "0.49999999999999994"),
        (2.0, 0.99, "eta", "0.99"),
        (2.0, f64::INFINITY, "eta", "inf"),
    ] {
        let invalid = critical::interpolated(omega, eta).unwrap_err();
        assert_eq!((invalid.field, invalid.value.as_str()), (field, value));
        assert!(invalid.allowed.contains("<=") && invalid.allowed.contains(field), "{invalid}");
    }
}

#[test]
fn the_table_of_the_interpolant_is_what_the_command_makes() {
    let rows: Vec<Term> = table("critical_interpolant.csv");
    let made = reference::critical_interpolant(|| ()).unwrap();
    assert_eq!(rows.len(), made.len());
    for (row, made) in rows.iter().zip(made) {
        assert_eq!((row.omega_degree, row.eta_degree), (made.omega_degree, made.eta_degree));
        // The cosines of another machine may differ in the last bit.
        assert!((row.coefficient - made.coefficient).abs() < 1e-15, "{row:?}, made again {made:?}");
    }
}

/// The largest error of a fit on a grid of `omega` from `least_omega` to 8 (even in `1/omega`) and `eta` from `least_eta` to 0.98.
fn largest_error(fit: impl Fn(f64, f64) -> f64, least_omega: f64, least_eta: f64) -> f64 {
    let even = |from: f64, to: f64, n: u32| (0..=n).map(move |k| from + (to - from) * f64::from(k) / f64::from(n));
    let omegas = even(1.0 / least_omega, 0.125, 80).map(f64::recip);
    let errors = omegas.flat_map(|omega| {
        even(least_eta, 0.98, 120)
            .map(|eta| (fit(omega, eta) - 1.0 - interpolated(omega, eta)).abs())
            .collect::<Vec<_>>()
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn the_fits_err_as_documented_and_less_than_those_of_the_paper() {
    let eq77 = |_, eta| critical::eq77(eta);
    for (name, measured, documented) in [
        ("Eq. 76", largest_error(critical::eq76, 0.5, 0.5), 1.14e-2),
        ("fit", largest_error(critical::fit, 0.5, 0.5), 2.52e-6),
        ("Eq. 76", largest_error(critical::eq76, 0.5, 0.75), 5.52e-3),
        ("fit", largest_error(critical::fit, 0.5, 0.75), 2.51e-6),
        ("Eq. 77", largest_error(eq77, 0.5, 0.75), 2.80e-2),
        ("short fit", largest_error(critical::short_fit, 0.5, 0.75), 3.74e-4),
        ("Eq. 77", largest_error(eq77, 0.5, 0.5), 5.90e-2),
        ("short fit", largest_error(critical::short_fit, 0.5, 0.5), 3.74e-4),
    ] {
        assert!((measured / documented - 1.0).abs() < 0.01, "{name}: {measured:e}, documented {documented:e}");
    }
}

#[test]
fn no_fit_of_eta_alone_can_be_nearer_than_half_of_what_omega_changes() {
    let least_possible = 0.5 * (interpolated(8.0, 0.75) - interpolated(0.5, 0.75));
    assert!((least_possible - 1.4e-2).abs() < 1e-4, "{least_possible:e}");
}
