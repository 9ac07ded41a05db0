//! `chattercheck judge`: lists of impacts as people have them, and what is no list.

use std::{fs, path::PathBuf};

use assert_cmd::Command;
use serde_json::Value;

const CASE: &str = "--a 1.03 --omega 2 --eta 0.92";

/// What the command says of a file with this in it: its status, its stdout and its stderr.
fn judge(arguments: &str, list: &str) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file: PathBuf = folder.path().join("times.csv");
    fs::write(&file, list).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    let output = command.arg("judge").args(arguments.split_whitespace()).arg(&file).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn simulated(arguments: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    String::from_utf8(command.arg("simulate").args(arguments.split_whitespace()).output().unwrap().stdout).unwrap()
}

#[test]
fn what_simulate_prints_is_right_where_it_is_and_wrong_from_where_it_goes_wrong() {
    let list = simulated(CASE);
    let (status, text, note) = judge(CASE, &list);
    assert_eq!((status, text.lines().next()), (0, Some("RIGHT: all 60 impacts, within 0.001 of an interval")));
    assert!(note.contains("not looked at: n, interval, sign"), "{note}");
    let (status, text, _) = judge("--a 1.031 --omega 2 --eta 0.92", &list);
    assert!(status == 1 && text.starts_with("WRONG at impact 1: "), "{text}");
    // The twentieth impact is left out.
    let without: Vec<&str> = list.lines().enumerate().filter(|(n, _)| *n != 21).map(|(_, line)| line).collect();
    let (status, text, _) = judge(&format!("{CASE} --format json"), &without.join("\n"));
    let answer: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((status, &answer["right_impacts"], &answer["first_wrong"]["kind"]), (1, &19.into(), &"missed".into()));
    assert!(answer["digits"].as_f64().unwrap() > 14.0 && answer["judge"] == "enclosure/linear", "{text}");
    // The block as it is.
    let nonlinear = format!("{CASE} --alpha 0.3");
    assert_eq!(judge(&nonlinear, &simulated(&nonlinear)).0, 0);
    assert_eq!(judge(&nonlinear, &list).0, 1);
    // The same case as a scene; one whose motion ends is more than a case.
    let scene = |name: &str| format!("--scene {}/data/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    assert_eq!(judge(&scene("paper_fig_9"), &list).0, 0);
    let (status, _, err) = judge(&scene("found/one_sine_pulse"), "time\n1\n9\n");
    assert!(status == 2 && err.contains("time = 9") && err.contains("half a period"), "{err}");
}

#[test]
fn a_tolerance_decides_what_is_right_and_nothing_told_is_no_success() {
    let impact = simulated(CASE).lines().nth(2).unwrap().split(',').nth(1).unwrap().parse::<f64>().unwrap();
    let off = format!("time\n{}\n", impact * 1.002);
    assert_eq!(judge(CASE, &off).0, 1);
    assert_eq!(judge(&format!("{CASE} --tolerance 0.01"), &off).0, 0);
    let (status, text, _) = judge(CASE, "time\n0\n1\n");
    assert_eq!((status, text.lines().next()), (3, Some("NOTHING CAN BE JUDGED")));
}

#[test]
fn what_is_no_list_is_refused_with_line_and_field() {
    for (list, words) in [
        ("", &["times.csv", "columns"][..]),
        ("t\n0.1\n", &["columns = t ", "time (or tau)"]),
        ("time\n", &["impacts = 0", "1 to 1000000"]),
        ("time\n0.36\nabc\n", &["line 3", "time = abc", "finite"]),
        ("time\n0.36\n\"\"\n", &["line 3", "time = ", "finite"]),
        ("time\nnan\n", &["line 2", "time = nan", "finite"]),
        ("time\n-1\n", &["line 2", "time = -1", "0 or more"]),
        ("time,velocity\n0.36,inf\n", &["line 2", "velocity = inf", "finite"]),
        ("time,velocity\n0.36\n", &["line 2", "columns = 1", "2"]),
        ("time,tau\n0.36,0.36\n", &["tau", "twice"]),
    ] {
        let (status, out, err) = judge(CASE, list);
        assert_eq!((status, out.as_str(), err.lines().count()), (2, "", 1), "{list:?}: {err}");
        assert!(words.iter().all(|word| err.contains(word)), "{list:?}: {err}");
    }
    for (options, words) in [
        ("--tolerance 0.5", &["tolerance = 0.5", "1e-12 to 0.25"][..]),
        ("--model foo", &["model = foo"]),
        ("--alpha 0.1 --model linear", &["alpha", "linear"]),
    ] {
        let (status, _, err) = judge(&format!("{CASE} {options}"), "time\n0.36\n");
        assert!(status == 2 && words.iter().all(|word| err.contains(word)), "{options}: {err}");
    }
}
