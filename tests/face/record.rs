//! The tables under `data/record` that can be made again in a moment are what the program prints; the others are of this version of it.

use std::collections::{BTreeMap, BTreeSet};

use assert_cmd::Command;
use chattercheck::{
    faults::catalogue::{catalogue, of_engines},
    gate::run,
    panel,
};

use super::pages::read;

/// The rows of the tables in a page, each without the spaces around its cells.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let table = text.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    table.map(|row| row.split(" | ").map(str::trim).collect()).collect()
}

#[test]
fn the_tolerance_table_is_the_one_in_force() {
    let output = Command::new(env!("CARGO_BIN_EXE_chattercheck")).arg("tolerances").assert().success();
    let printed = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let kept = read("data/record/tolerances.md");
    assert!(kept.ends_with(&printed), "put what `chattercheck tolerances` prints into data/record/tolerances.md");
}

#[test]
fn the_full_run_is_of_this_program_and_its_cases() {
    let kept = read("data/record/verify.md");
    assert!(kept.contains(concat!("chattercheck ", env!("CARGO_PKG_VERSION"))), "the run is of another version");
    for oracle in panel::default() {
        assert!(kept.contains(oracle.name()), "the run lacks {}", oracle.name());
    }
    let selection = run::Selection { cases: run::Selection::DEFAULT_CASES, seed: 1 };
    let cases = run::cases(&selection, panel::stepper().as_ref()).len();
    assert!(kept.contains(&format!("{cases} cases")), "the run is not of the {cases} cases of today");
    assert!(kept.contains("\nPASS"));
}

#[test]
fn the_detection_floor_has_every_planted_fault_and_none_escapes() {
    let kept = read("data/record/detection_floor.md");
    let measured: BTreeSet<(&str, &str)> = rows(&kept).iter().skip(2).map(|row| (row[0], row[1])).collect();
    let oracles = panel::default();
    let mistakes = catalogue(oracles.iter().map(|oracle| (oracle.name(), oracle.model())));
    let planted: BTreeSet<(&str, &str)> =
        mistakes.iter().map(|mistake| (mistake.name, mistake.oracle.as_str())).collect();
    assert_eq!(measured, planted, "run `chattercheck detection-floor --format markdown` again");
    assert!(!kept.contains("ESCAPES"));
}

#[test]
fn the_exponents_in_the_guide_are_those_measured() {
    let guide = read("src/guide/asymptotics.md");
    let shown: Vec<Vec<&str>> = rows(&guide).into_iter().skip(2).collect();
    assert!(shown.len() >= 7);
    let csv = std::fs::File::open(super::pages::root().join("data/record/diagnose/exponents.csv")).unwrap();
    let measured: Vec<BTreeMap<String, f64>> =
        csv::Reader::from_reader(csv).deserialize().map(Result::unwrap).collect();
    for row in shown {
        let found = measured.iter().find(|found| found["eta"] == row[0].parse::<f64>().unwrap()).unwrap();
        let coefficients = format!("{:.4} ± {:.4}", found["coefficients"], found["coefficients_uncertainty"]);
        let expected = [format!("{:.6}", found["formula"]), format!("{:.6}", found["stepping"]), coefficients];
        assert_eq!(row[1..], expected, "eta = {}", row[0]);
    }
}

#[test]
fn the_confusion_matrix_has_every_mistake_of_an_engine_and_none_is_taken_for_another() {
    let kept = read("data/record/explained.md");
    let planted: BTreeSet<(&str, &str)> = rows(&kept).iter().skip(2).map(|row| (row[0], row[1])).collect();
    let mistakes = of_engines();
    let known: BTreeSet<(&str, &str)> = mistakes.iter().map(|fault| (fault.name, fault.oracle.as_str())).collect();
    assert_eq!(planted, known, "run `chattercheck confusion --format markdown` again");
    assert!(!kept.contains("MISNAMED"));
    let missed = rows(&kept).iter().filter(|row| row[3] == "MISSED").count();
    assert!(10 * missed <= known.len(), "{missed} are missed");
}
