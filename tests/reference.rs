//! The oracles against values with many digits (`data/reference`), and those against the command that made them.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::expect_used)]

use std::path::{Path, PathBuf};

use chattercheck::{
    observables::Observed,
    panel::{self, OdeSettings},
    reference::{ImpactRow, TimeRow},
};
use contract::{Case, Oracle};
use serde::de::DeserializeOwned;

fn table<Row: DeserializeOwned>(name: &str) -> Vec<Row> {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/reference").join(name);
    csv::Reader::from_path(path).unwrap().deserialize().map(Result::unwrap).collect()
}

fn value(decimal: &str) -> f64 {
    assert!(decimal.len() > 45, "{decimal} has too few digits");
    decimal.parse().unwrap()
}

fn oracle(name: &str) -> Box<dyn Oracle> {
    panel::one(name, &OdeSettings::default(), "linear").unwrap()
}

fn case(epsilon: f64, omega: f64, eta: f64, impacts: usize) -> Case {
    Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(impacts).unwrap()
}

#[test]
fn the_closed_form_has_the_first_40_impacts_to_the_last_digit() {
    let rows: Vec<ImpactRow> = table("linear_impacts.csv");
    assert!(rows.len() >= 300, "{}", rows.len());
    for row in rows {
        let history = oracle("closed-form").history(&case(row.epsilon, row.omega, row.eta, row.n)).unwrap();
        let impact = history.impacts[row.n - 1];
        let off = |found: f64, decimal: &str| (found / value(decimal) - 1.0).abs();
        let errors =
            [off(impact.time, &row.tau), off(impact.interval, &row.interval), off(impact.velocity, &row.velocity)];
        assert!(errors[0] <= 4e-15, "{row:?}: time off by {:e}", errors[0]);
        assert!(errors[1] <= 1e-12 && errors[2] <= 1e-12, "{row:?}: {errors:?}");
        let claims = impact.uncertainty;
        // Half a unit in the last place is the reference's own, when it becomes a double.
        let own = 0.5 * f64::EPSILON;
        assert!(errors[0] * impact.time <= claims.time + own * impact.time, "{row:?} {claims:?}");
        assert!(errors[1] <= claims.interval + own && errors[2] <= claims.velocity + own, "{row:?} {claims:?}");
    }
}

#[test]
fn every_oracle_claims_no_less_than_it_errs_in_the_chattering_time() {
    let rows: Vec<TimeRow> = table("linear_chattering_times.csv");
    assert!(rows.len() >= 40, "{}", rows.len());
    for row in rows {
        for name in ["closed-form", "ode", "asymptotic"] {
            let case = case(row.epsilon, row.omega, row.eta, 600);
            let Ok(history) = oracle(name).history(&case) else { continue };
            let time = Observed::new(&case, history).chattering_time.unwrap();
            let error = (time.value - value(&row.tau_ch)).abs();
            assert!(error <= time.uncertainty, "{name}, {row:?}: off by {error:e}, claims {:e}", time.uncertainty);
            assert!(name != "closed-form" || error < 1e-13, "{row:?}: off by {error:e}");
        }
    }
}

#[test]
fn the_tables_are_what_the_command_makes() {
    // One case of the tables, made again: all of them would take minutes.
    let printed = panel::printed();
    let rows: Vec<ImpactRow> = table("linear_impacts.csv");
    let row = rows.iter().find(|row| row.n == 5).unwrap();
    let impact = printed.decimals(&case(row.epsilon, row.omega, row.eta, 5)).unwrap().swap_remove(4);
    // A shorter history is computed with shorter numbers, so the very last digits shown may differ.
    let same = |one: &str, two: &str| one.bytes().zip(two.bytes()).take(50).all(|(one, two)| one == two);
    assert!(
        same(&impact.time, &row.tau) && same(&impact.interval, &row.interval) && same(&impact.velocity, &row.velocity)
    );
}
