//! The oracles against values with many digits (`data/reference`), and those against the command that made them.

use std::path::{Path, PathBuf};

use chattercheck::{
    measure::observables::Observed,
    panel::{self, Settings},
    studies::reference::{CriticalRow, ImpactRow, ProvenImpactRow, ProvenTimeRow, TimeRow},
};
use contract::{Case, Ending, Model, Normalisation, Oracle, Slenderness};
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
    panel::one(name, &Settings::default(), "linear").unwrap()
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

/// A batch has no claims; those of the oracle hold for it.
#[test]
fn a_batch_has_the_first_40_impacts_as_the_closed_form_has_them() {
    use closed_form::batch::{Batch, InstructionSet, Rows, Sequence};
    let rows: Vec<ImpactRow> = table("linear_impacts.csv");
    let column = |of: fn(&ImpactRow) -> f64| rows.iter().map(of).collect::<Vec<_>>();
    let (epsilon, omega, eta) = (column(|row| row.epsilon), column(|row| row.omega), column(|row| row.eta));
    for set in InstructionSet::available() {
        let mut time = vec![0.0; 40 * rows.len()];
        let (mut interval, mut velocity) = (time.clone(), time.clone());
        let mut sequences = vec![Sequence::default(); rows.len()];
        let batch = Batch::new(&epsilon, &omega, &eta, 40).unwrap().with_instruction_set(set);
        let answer =
            Rows { time: &mut time, interval: &mut interval, velocity: &mut velocity, sequences: &mut sequences };
        batch.run(answer).unwrap();
        for (index, row) in rows.iter().enumerate() {
            let history = oracle("closed-form").history(&case(row.epsilon, row.omega, row.eta, row.n)).unwrap();
            let claims = history.impacts[row.n - 1].uncertainty;
            let at = 40 * index + row.n - 1;
            let off = |found: f64, decimal: &str| (found / value(decimal) - 1.0).abs();
            let errors = [off(time[at], &row.tau), off(interval[at], &row.interval), off(velocity[at], &row.velocity)];
            let own = 0.5 * f64::EPSILON;
            assert!(errors[0] * time[at] <= claims.time + own * time[at], "{set:?} {row:?} {claims:?}");
            assert!(
                errors[1] <= claims.interval + own && errors[2] <= claims.velocity + own,
                "{set:?} {row:?} {claims:?}"
            );
        }
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
    let printed = printed::Printed::default();
    let rows: Vec<ImpactRow> = table("linear_impacts.csv");
    let row = rows.iter().find(|row| row.n == 5).unwrap();
    let impact = printed.decimals(&case(row.epsilon, row.omega, row.eta, 5)).unwrap().swap_remove(4);
    // A shorter history is computed with shorter numbers, so the very last digits shown may differ.
    let same = |one: &str, two: &str| one.bytes().zip(two.bytes()).take(50).all(|(one, two)| one == two);
    assert!(
        same(&impact.time, &row.tau) && same(&impact.interval, &row.interval) && same(&impact.velocity, &row.velocity)
    );
}

fn slenderness(alpha: f64, normalisation: &str) -> Slenderness {
    let normalisation = match normalisation {
        "threshold" => Normalisation::Threshold,
        "slender" => Normalisation::Slender,
        other => panic!("{other}"),
    };
    Slenderness::new(alpha, normalisation).unwrap()
}

/// A case of the proven tables.
fn proven(epsilon: f64, omega: f64, eta: f64, alpha: Option<f64>, normalisation: Option<&str>, impacts: usize) -> Case {
    let case = case(epsilon, omega, eta, impacts);
    alpha.zip(normalisation).map_or(case, |(alpha, name)| case.with_slenderness(slenderness(alpha, name)))
}

#[test]
fn no_oracle_claims_less_than_its_distance_from_the_proven_impacts() {
    let rows: Vec<ProvenImpactRow> = table("proven_impacts.csv");
    let linear = rows.iter().filter(|row| row.alpha.is_none() && row.n == 1).count();
    let nonlinear = rows.iter().filter(|row| row.alpha.is_some() && row.n == 1).count();
    assert!(linear >= 100 && nonlinear >= 50, "{linear} linear and {nonlinear} nonlinear cases");
    for row in rows {
        let names = if row.alpha.is_some() {
            ["taylor", "ode/nonlinear/tsit45"]
        } else {
            ["closed-form", "ode/linear/esdirk34"]
        };
        for name in names {
            let case = proven(row.epsilon, row.omega, row.eta, row.alpha, row.normalisation.as_deref(), row.n);
            let history = oracle(name).history(&case).unwrap();
            let Some(impact) = history.impacts.get(row.n - 1) else {
                assert!(name.starts_with("ode"), "{name} lacks an impact: {row:?}");
                continue;
            };
            let values = [&row.tau, &row.interval, &row.velocity].map(|decimal| {
                assert!(decimal.trim_start_matches(['-', '0', '.']).len() >= 24, "{decimal} has too few digits");
                decimal.parse::<f64>().unwrap()
            });
            let found = [impact.time, impact.interval, impact.velocity];
            let claims =
                [impact.uncertainty.time / impact.time, impact.uncertainty.interval, impact.uncertainty.velocity];
            for ((found, value), claim) in found.iter().zip(values).zip(claims) {
                assert!((found / value - 1.0).abs() <= claim + f64::EPSILON, "{name}: {found} for {value} in {row:?}");
            }
        }
    }
}

/// The significant digits of a decimal number.
fn significant(decimal: &str) -> String {
    let mantissa = decimal.split(['e', 'E']).next().unwrap();
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_start_matches('0').to_owned()
}

#[test]
fn the_printed_equations_and_the_enclosure_agree_in_every_proven_digit() {
    let printed: Vec<ImpactRow> = table("linear_impacts.csv");
    let proven: Vec<ProvenImpactRow> = table("proven_impacts.csv");
    let mut compared = 0;
    for row in printed {
        let same = |other: &&ProvenImpactRow| {
            other.alpha.is_none()
                && (other.epsilon, other.omega, other.eta, other.n) == (row.epsilon, row.omega, row.eta, row.n)
        };
        let other = proven.iter().find(same).unwrap();
        for (long, short) in
            [(&row.tau, &other.tau), (&row.interval, &other.interval), (&row.velocity, &other.velocity)]
        {
            let (digits, rounded) = (significant(long), significant(short));
            let kept: i128 = digits[..rounded.len()].parse().unwrap();
            // Rounded down: for a negative number away from zero.
            let expected = if long.starts_with('-') { kept + 1 } else { kept };
            assert!(rounded.len() >= 24, "{short} has too few digits");
            assert_eq!(expected, rounded.parse::<i128>().unwrap(), "{row:?}");
        }
        compared += 1;
    }
    assert!(compared >= 300);
}

#[test]
fn the_endings_are_as_proven() {
    let rows: Vec<ProvenTimeRow> = table("proven_chattering_times.csv");
    let complete = rows.iter().filter(|row| row.tau_ch.is_some()).count();
    assert!(complete >= 150 && complete < rows.len(), "{complete} of {} are complete", rows.len());
    for row in rows {
        let name = if row.alpha.is_some() { "taylor" } else { "closed-form" };
        let case = proven(row.epsilon, row.omega, row.eta, row.alpha, row.normalisation.as_deref(), 1000);
        let observed = Observed::new(&case, oracle(name).history(&case).unwrap());
        let found = observed.chattering_time;
        match row.tau_ch.as_ref().map(|decimal| decimal.parse::<f64>().unwrap()) {
            Some(value) => {
                let time = found.unwrap();
                assert!((time.value - value).abs() <= time.uncertainty + f64::EPSILON * value, "{name} in {row:?}");
            }
            None => assert!(found.is_none(), "{name} in {row:?}"),
        }
    }
}

#[test]
fn the_critical_amplitudes_part_complete_from_incomplete() {
    let rows: Vec<CriticalRow> = table("critical_amplitudes.csv");
    assert_eq!(rows.len(), 30);
    for row in rows {
        let [complete, incomplete] = [&row.complete, &row.incomplete].map(|decimal| decimal.parse::<f64>().unwrap());
        let ending = |a: f64| {
            let case = Case::from_amplitude(a, row.omega, row.eta).unwrap().with_max_impacts(20_000).unwrap();
            oracle("closed-form").history(&case).unwrap().ending
        };
        assert!(incomplete - complete <= 1e-12, "{row:?}");
        // The amplitudes become doubles here, a rounding of 1e-16.
        assert_eq!(ending(complete - 1e-15), Ending::AtRest, "{row:?}");
        assert_eq!(ending(incomplete + 1e-15), Ending::Incomplete, "{row:?}");
        if row.eta <= 0.8 {
            let [again, _] = enclosure::critical_amplitude(row.omega, row.eta).unwrap().amplitude.decimals(18);
            assert_eq!(again, row.complete);
        }
    }
}

#[test]
fn the_proven_tables_are_what_the_command_makes() {
    let rows: Vec<ProvenImpactRow> = table("proven_impacts.csv");
    for row in rows.iter().step_by(97) {
        let model = if row.alpha.is_some() { Model::Nonlinear } else { Model::Linear };
        let case = proven(row.epsilon, row.omega, row.eta, row.alpha, row.normalisation.as_deref(), row.n);
        let enclosed = enclosure::Enclosure::new(model).with_digits(30).unwrap().enclose(&case).unwrap();
        let impact = &enclosed.impacts[row.n - 1];
        let settled = [&impact.time, &impact.interval, &impact.velocity].map(|bounds| bounds.settled(25).unwrap());
        assert_eq!(settled, [&row.tau, &row.interval, &row.velocity].map(Clone::clone), "{row:?}");
    }
}
