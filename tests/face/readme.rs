//! The README's generated parts are what the program says.

use assert_cmd::Command;

fn readme() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap()
}

/// What stands between the markers of a generated part.
fn part(name: &str) -> String {
    let readme = readme();
    let (_, from) = readme.split_once(&format!("<!-- {name}:begin")).unwrap();
    let (inside, _) = from.split_once(&format!("<!-- {name}:end")).unwrap();
    inside.split_once("-->").unwrap().1.trim().to_owned()
}

#[test]
fn the_tolerance_table_is_the_one_in_force() {
    let output = Command::new(env!("CARGO_BIN_EXE_chattercheck")).arg("tolerances").assert().success();
    let table = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    assert_eq!(part("tolerances"), table.trim(), "put the output of `chattercheck tolerances` into the README");
}

#[test]
fn what_the_paper_says_wrongly_is_what_a_run_finds() {
    // That the committed summary is what a run gives is for tests/paper.rs.
    assert_eq!(
        part("paper"),
        include_str!("../../data/paper/summary.md").trim(),
        "put data/paper/summary.md into the README"
    );
}

#[test]
fn the_two_commands_come_first_and_the_run_shown_is_of_this_program() {
    let readme = readme();
    let verify = readme.find("cargo run --release -- verify").unwrap();
    let test = readme.find("cargo test --workspace").unwrap();
    assert!(verify < test && test < 400);
    let run = part("verify");
    assert!(run.contains(concat!("chattercheck ", env!("CARGO_PKG_VERSION"))), "the run shown is of another version");
    for oracle in chattercheck::panel::default() {
        assert!(run.contains(oracle.name()), "the run shown lacks {}", oracle.name());
    }
    assert!(run.contains("PASS"));
}

#[test]
fn every_command_that_the_readme_shows_is_understood() {
    let readme = readme();
    let shown = readme.lines().filter_map(|line| line.strip_prefix("$ chattercheck "));
    let mut count = 0;
    for line in shown {
        let command = line.split_whitespace().next().unwrap();
        let help = Command::new(env!("CARGO_BIN_EXE_chattercheck")).args([command, "--help"]).assert().success();
        let help = String::from_utf8(help.get_output().stdout.clone()).unwrap();
        for flag in line.split_whitespace().filter(|word| word.starts_with("--")) {
            assert!(help.contains(flag), "{command} has no {flag}");
        }
        count += 1;
    }
    assert!(count >= 6);
}
