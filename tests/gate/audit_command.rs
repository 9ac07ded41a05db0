//! What `verify` prints and writes is what it did: cases, status, verdicts, replay files, and the commands that it prints to see a failure.

use std::{fs, path::Path};

use assert_cmd::Command;
use chattercheck::{
    gate::{
        judge::Judges,
        partition::{Partition, cost_of_case},
        run,
    },
    panel,
};
use serde_json::Value;

fn chattercheck(arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    command.args(arguments.split_whitespace());
    command
}

/// Runs `verify` in a folder: its status, what it printed, its JSON report, and its JUnit file.
fn verify(arguments: &str, folder: &Path) -> (i32, String, Value, String) {
    let [json, junit, replays] = ["report.json", "junit.xml", "replays"].map(|name| folder.join(name));
    let mut command = chattercheck(&format!("verify --quiet {arguments} --json"));
    let output = command.arg(&json).arg("--junit").arg(&junit).arg("--replays").arg(&replays).output().unwrap();
    let [json, junit] = [json, junit].map(|path| fs::read_to_string(path).unwrap());
    let text = String::from_utf8(output.stdout).unwrap();
    (output.status.code().unwrap(), text, serde_json::from_str(&json).unwrap(), junit)
}

/// The names of the cases of a part of the run.
fn share(partition: Partition) -> Vec<String> {
    let all = run::cases(&run::Selection { cases: 50, seed: 5 }, panel::stepper().as_ref());
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 10, closing: None };
    let costs: Vec<f64> =
        all.iter().enumerate().map(|(place, named)| cost_of_case(named, judges.asks(place, named))).collect();
    partition.of(all, &costs).iter().map(ToString::to_string).collect()
}

#[test]
fn of_a_green_share_every_case_is_accounted_for() {
    let folder = tempfile::tempdir().unwrap();
    let oracles = "closed-form,taylor,asymptotic/paper";
    let (status, text, report, junit) =
        verify(&format!("--cases 50 --responses 10 --seed 5 --partition 2/3 --oracles {oracles}"), folder.path());
    let share = share(Partition { part: 2, parts: 3 });
    assert_eq!(report["reach"]["cases"], share.len());
    // Each case, each response, and the two runs as a whole.
    let responses: Vec<&str> =
        report["responses"]["names"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    assert!((1..10).contains(&responses.len()), "{responses:?}");
    assert_eq!(junit.matches("<testcase").count(), share.len() + responses.len() + 2);
    assert!(responses.iter().all(|name| junit.contains(&format!("\"{name}\""))), "{junit}");
    let named: Vec<String> = super::audit::junit_cases(&junit).into_iter().map(|(name, _)| name).collect();
    assert!(share == named[..share.len()], "every case is in the JUnit file, in order");
    assert_eq!((status, &report["verdict"]), (0, &Value::from("pass")));
    assert!(text.starts_with(&format!("PASS: 3 oracles agree on {} cases", share.len())), "{text}");
    assert!(!junit.contains("<failure") && !folder.path().join("replays").exists());
}

/// One random case more is one random case more.
#[test]
fn as_many_random_cases_as_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    for asked in [7, 8] {
        let (_, _, report, _) =
            verify(&format!("--cases {asked} --judge 1000 --oracles closed-form,taylor"), folder.path());
        assert_eq!(report["reach"]["by_generator"]["random"], asked);
        assert_eq!(report["accounted"]["handed"], report["accounted"]["examined"]);
    }
}

/// A share that is small is not red for being small; it says what it can't judge.
#[test]
fn a_small_share_is_green_and_says_what_it_can_not_judge() {
    let folder = tempfile::tempdir().unwrap();
    let (status, text, report, _) = verify("--cases 10 --partition 7/90", folder.path());
    assert_eq!((status, report["shortfalls"].as_array().unwrap().len()), (0, 0), "{text}");
    assert!(text.contains("not judged") && text.contains("too few cases"), "{text}");
    assert!(!text.contains("Worst figure of each pair") && text.lines().count() < 40, "{text}");
    let (_, full, ..) = verify("--cases 10 --partition 7/90 --full", folder.path());
    assert!(full.contains("Worst figure of each pair") && full.lines().count() > text.lines().count() + 50, "{full}");
}

/// Whatever is printed of a failure leads back to it.
#[test]
fn of_a_red_run_the_replays_and_the_commands_show_the_same_again() {
    let folder = tempfile::tempdir().unwrap();
    let (status, text, report, junit) =
        verify("--cases 30 --oracles closed-form,ode/linear/tsit45/naive", folder.path());
    assert_eq!((status, &report["verdict"]), (1, &Value::from("fail")));
    let failures = report["failures"].as_array().unwrap();
    assert!(
        text.starts_with(&format!("FAIL: {} of {} cases failed", failures.len(), report["reach"]["cases"])),
        "{text}"
    );
    assert_eq!(
        junit.matches("<failure").count(),
        failures.len() + usize::from(!report["shortfalls"].as_array().unwrap().is_empty())
    );
    // Replays: of distinct cases, smaller than what they come from, and each shows what it says.
    let mut found_in = Vec::new();
    for entry in fs::read_dir(folder.path().join("replays")).unwrap() {
        let path = entry.unwrap().path();
        let replay: toml::Table = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let finding = replay["finding"].as_str().unwrap().to_owned();
        let again = Command::new(env!("CARGO_BIN_EXE_chattercheck")).arg("replay").arg(&path).assert().code(1);
        let printed = String::from_utf8(again.get_output().stdout.clone()).unwrap();
        assert_eq!(printed.matches(&finding).count(), 2, "found then and now: {printed}");
        let name = replay["found_in"].as_str().unwrap().to_owned();
        let of_run = failures.iter().find(|failure| failure["name"] == name.as_str()).unwrap();
        let digits = |value: String| value.bytes().filter(u8::is_ascii_digit).count();
        for field in ["epsilon", "omega", "eta"] {
            let small = digits(format!("{:e}", replay["case"][field].as_float().unwrap()));
            let large = digits(format!("{:e}", of_run["case"][field].as_f64().unwrap()));
            assert!(small <= large, "{field} of {name}");
        }
        assert!(
            replay["case"]["impacts"].as_integer().unwrap() < of_run["case"]["impacts"].as_i64().unwrap(),
            "{name}"
        );
        assert!(!found_in.contains(&name), "{name} twice");
        found_in.push(name);
    }
    assert!(found_in.len() >= 2);
    // Commands: the two histories differ where and as the finding says.
    let failure = failures.iter().find(|failure| failure["findings"][0].get("refuted").is_some()).unwrap();
    let disagreement = &failure["findings"][0]["refuted"]["disagreement"];
    let impact = disagreement["figure"]["impact"].as_u64().unwrap() as usize;
    let column = disagreement["observable"].as_str().unwrap().replace("impact-time", "tau");
    let commands = failure["see"].as_array().unwrap();
    assert_eq!(commands.len(), 2);
    let values: Vec<String> = commands
        .iter()
        .map(|command| {
            let command = command.as_str().unwrap().strip_prefix("chattercheck ").unwrap();
            let output = chattercheck(&format!("{command} --format json")).assert().success();
            let history: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
            format!("{:?}", history["impacts"][impact][column.as_str()].as_f64().unwrap())
        })
        .collect();
    assert_eq!(values[0], disagreement["values"][1].as_str().unwrap(), "the first command shows what is wrong");
    assert_ne!(values[0], values[1], "the second shows another value");
    assert!(text.contains(commands[0].as_str().unwrap()) || text.contains("likewise"), "{text}");
}
