//! The enclosures contain values of 46 to 60 digits that were made by other methods: `data/reference` for the linear equation,
//! `nonlinear_impacts.csv` (see its head) for the nonlinear one.

use std::collections::BTreeMap;

use contract::{Case, Ending, Model, Normalisation, Slenderness};
use enclosure::{Bounds, Enclosed, Enclosure};

/// A decimal without an exponent.
fn plain(text: &str) -> String {
    let Some((mantissa, exponent)) = text.split_once('e') else { return text.to_owned() };
    let (minus, digits) = mantissa.strip_prefix('-').map_or(("", mantissa), |rest| ("-", rest));
    let zeros = exponent.parse::<i32>().unwrap();
    assert!(zeros < 0);
    let digits = digits.replacen('.', "", 1);
    format!("{minus}0.{}{digits}", "0".repeat(zeros.unsigned_abs() as usize - 1))
}

fn inside(bounds: &Bounds, reference: &str) -> bool {
    bounds.contains(&plain(reference)).expect("a decimal")
}

/// The lines of a table, by case: the columns that name it, and the others.
fn table(text: &str, columns: usize) -> BTreeMap<String, Vec<Vec<String>>> {
    let mut cases: BTreeMap<String, Vec<Vec<String>>> = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        cases.entry(fields[..columns].join(",")).or_default().push(fields[columns..].to_vec());
    }
    cases
}

fn numbers(key: &str) -> Vec<f64> {
    key.split(',').filter_map(|field| field.parse().ok()).collect()
}

/// How many impacts of the rows are there; each has to contain its reference.
fn check(found: &Enclosed, rows: &[Vec<String>], key: &str) -> usize {
    let mut checked = 0;
    for row in rows {
        if row[0] == "ch" {
            assert_eq!(found.ending, Ending::AtRest, "{key}");
            assert!(inside(found.chattering_time.as_ref().unwrap(), &row[1]), "{key}: chattering time");
            continue;
        }
        let n: usize = row[0].parse().unwrap();
        let Some(impact) = found.impacts.get(n - 1) else { continue };
        checked += 1;
        for (what, bounds, reference) in [
            ("tau", &impact.time, &row[1]),
            ("interval", &impact.interval, &row[2]),
            ("velocity", &impact.velocity, &row[3]),
        ] {
            assert!(inside(bounds, reference), "{key}, impact {n}, {what}: {:?} and {reference}", bounds.decimals(60));
        }
    }
    checked
}

fn linear(key: &str, digits: u32, impacts: usize) -> Enclosed {
    let p = numbers(key);
    let case = Case::from_epsilon(p[0], p[1], p[2]).unwrap().with_max_impacts(impacts).unwrap();
    Enclosure::new(Model::Linear).with_digits(digits).unwrap().enclose(&case).expect(key)
}

/// A file of this repository.
fn read(path: &str) -> String {
    std::fs::read_to_string(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn linear_impacts() {
    let cases = table(&read("../../data/reference/linear_impacts.csv"), 3);
    let mut checked = 0;
    for (index, (key, rows)) in cases.iter().enumerate() {
        let deepest = rows.iter().map(|row| row[0].parse::<usize>().unwrap()).max().unwrap();
        checked += check(&linear(key, 17, deepest), rows, key);
        if index % 6 == 0 {
            checked +=
                check(&linear(key, 30, deepest), rows, key) + check(&linear(key, 50, deepest.min(40)), rows, key);
        }
    }
    assert!(cases.len() >= 40 && checked >= 350, "{} cases, {checked} impacts", cases.len());
}

#[test]
fn linear_chattering_times() {
    let cases = table(&read("../../data/reference/linear_chattering_times.csv"), 3);
    for (index, (key, rows)) in cases.iter().enumerate() {
        for digits in if index % 8 == 0 { vec![12, 17, 40] } else { vec![17] } {
            let found = linear(key, digits, 1);
            let time = found.chattering_time.unwrap();
            assert!(inside(&time, &rows[0][0]), "{key} at {digits} digits: {:?}", time.decimals(60));
            assert!(time.width() <= 2.0 * (0.1_f64).powi(digits as i32) * time.upper());
        }
    }
    assert!(cases.len() >= 40);
}

#[test]
fn nonlinear_impacts_and_chattering_times() {
    let cases = table(&read("tests/enclosure/nonlinear_impacts.csv"), 5);
    let mut checked = 0;
    for (key, rows) in &cases {
        let p = numbers(key);
        let normalisation = if key.ends_with("slender") { Normalisation::Slender } else { Normalisation::Threshold };
        let block = Slenderness::new(p[3], normalisation).unwrap();
        let case = Case::from_epsilon(p[0], p[1], p[2]).unwrap().with_slenderness(block).with_max_impacts(20).unwrap();
        for digits in [12, 17, 30] {
            let found = Enclosure::new(Model::Nonlinear).with_digits(digits).unwrap().enclose(&case).expect(key);
            checked += check(&found, rows, key);
        }
    }
    assert!(cases.len() >= 10 && checked >= 180, "{} cases, {checked} impacts", cases.len());
}
