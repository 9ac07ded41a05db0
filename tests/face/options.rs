//! No option is silently ignored: what a method or a command does not use is an error that names both; everything else changes what is printed.

use std::collections::BTreeSet;

use assert_cmd::Command;

const CASE: &str = "--a 1.01 --omega 2 --eta 0.85";

fn run(arguments: &str) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    let output = command.args(arguments.split_whitespace()).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The methods, the choice that is left to the program by name, and none named.
const METHODS: [&str; 10] = [
    "",
    "auto",
    "closed-form",
    "ode",
    "taylor",
    "asymptotic",
    "accumulation",
    "enclosure",
    "printed",
    "closed-form/corrected",
];

/// Options with values that, where they are used, change something.
const OPTIONS: [&str; 11] = [
    "--alpha 0.3",
    "--alpha 0.3 --normalisation slender",
    "--until 0.2",
    "--model linear",
    "--model nonlinear",
    "--method bdf",
    "--rtol 1e-5",
    "--flights naive",
    "--order 3",
    "--tolerance 1e-14",
    "--impacts 7",
];

#[test]
fn an_option_of_a_case_or_a_method_changes_the_answer_or_is_refused() {
    for command in ["chattering-time", "simulate"] {
        for method in METHODS {
            let oracle = if method.is_empty() { String::new() } else { format!("--oracle {method}") };
            // What is only for the block as it is needs a slenderness to begin with.
            let needs = if ["taylor", "closed-form/corrected"].contains(&method) { "--alpha 0.1" } else { "" };
            let base = |extra: &str| format!("{command} {CASE} --format json {oracle} {extra}");
            let (_, without, _) = run(&base(needs));
            for option in OPTIONS.iter().chain((command == "chattering-time").then_some(&"--digits 30")) {
                let arguments =
                    base(&if option.contains("alpha") { (*option).to_owned() } else { format!("{needs} {option}") });
                let (status, out, err) = run(&arguments);
                let name = option.split_whitespace().next().unwrap().trim_start_matches("--");
                if status == Some(2) {
                    // The equation is named by the model that an oracle solves, too.
                    assert!(
                        err.contains(name) || err.contains("slenderness") || err.contains("declines"),
                        "{arguments}: {err}"
                    );
                    assert!(method.is_empty() || err.contains(method), "{arguments}: {err}");
                } else {
                    // The equation that is solved anyway may be said.
                    let said = name == "model" && out.contains(method);
                    assert!(out != without || said, "{arguments}: ignored");
                }
            }
        }
    }
}

#[test]
fn where_no_method_is_named_the_first_that_uses_everything_is_asked() {
    for (options, oracle) in [
        ("", "closed-form"),
        ("--model linear", "closed-form"),
        ("--alpha 0.1", "taylor"),
        ("--alpha 0.1 --model nonlinear", "taylor"),
        ("--method bdf", "ode/linear/bdf"),
        ("--method bdf --alpha 0.1", "ode/nonlinear/tsit45"),
        ("--rtol 1e-6", "ode/linear/tsit45"),
        ("--order 3", "asymptotic/order-3"),
        ("--order 3 --tolerance 0.1", "asymptotic/order-3"),
        ("--order 3 --alpha 0.1", "accumulation/nonlinear/order-3"),
        ("--digits 20", "enclosure/linear"),
        ("--digits 20 --alpha 0.1", "enclosure/nonlinear"),
    ] {
        let (status, out, err) = run(&format!("chattering-time {CASE} --format json {options}"));
        assert_eq!(status, Some(0), "{options}: {err}");
        let oracle = oracle.replace("nonlinear/tsit45", "nonlinear/bdf");
        assert!(out.contains(&format!("\"oracle\": \"{oracle}\"")), "{options}: {out}");
    }
    for (options, words) in [
        ("--order 3 --digits 20", ["--order 3", "--digits 20"]),
        ("--order 3 --tolerance 0.1 --alpha 0.1", ["--alpha", "--order 3"]),
        ("--alpha 0.1 --model linear", ["--alpha", "--model linear"]),
    ] {
        let (status, out, err) = run(&format!("chattering-time {CASE} {options}"));
        assert_eq!((status, out.as_str(), err.lines().count()), (Some(2), "", 1), "{options}");
        assert!(words.iter().all(|word| err.contains(word)), "{options}: {err}");
    }
}

/// Of a scene as of a case: whoever follows the block, an option changes the answer or is refused, and then both are named.
#[test]
fn an_option_of_a_scene_changes_the_answer_or_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let quick = folder.path().join("quick.toml");
    std::fs::write(&quick, QUICK).unwrap();
    let quick = quick.to_str().unwrap();
    let of_response = [
        "--closing series",
        "--closing impacts",
        "--condition eq77",
        "--velocity-threshold 1e-3",
        "--termination velocity --velocity-threshold 1e-3",
        "--termination chattering",
        "--digits 20",
        "--from 0.1",
        "--to 0.2",
        "--steps 7",
        "--svg -",
        "--impacts 3",
    ];
    let of_all = ["--method bdf", "--rtol 1e-5", "--until 0.5"];
    for (command, options) in [
        (format!("response {quick}"), [&of_all[..], &of_response].concat()),
        (
            format!("chattering-time --scene {quick}"),
            [&of_all[..], &["--flights naive", "--order 3", "--tolerance 1e-3", "--digits 20"]].concat(),
        ),
        (
            format!("simulate --scene {quick}"),
            [&of_all[..], &["--flights naive", "--order 3", "--tolerance 1e-3"]].concat(),
        ),
    ] {
        for method in ["auto", "closed-form", "ode", "taylor", "accumulation", "printed", "enclosure"] {
            let model = if method == "taylor" { "nonlinear" } else { "linear" };
            let base = format!("{command} --model {model} --oracle {method} --format json");
            let (status, without, err) = run(&base);
            if status == Some(2) {
                assert!(err.contains(method) && err.contains("declines"), "{base}: {err}");
                continue;
            }
            for option in &options {
                let (status, out, err) = run(&format!("{base} {option}"));
                let name = option.split_whitespace().next().unwrap().trim_start_matches("--");
                // What an option is by default may be said.
                let said = *option == "--closing impacts";
                match status {
                    Some(2) => assert!(
                        err.lines().count() == 1 && (err.contains(name) || err.contains("declines")),
                        "{base} {option}: {err}"
                    ),
                    _ => assert!(out != without || said, "{base}: ignores {option}"),
                }
            }
        }
    }
}

/// A stocky block overturns where the slender one comes to rest, and below its own threshold it does not rock at all.
#[test]
fn the_slenderness_that_is_given_is_that_of_the_answer() {
    let (_, out, _) = run("chattering-time --a 1.01 --omega 2 --eta 0.92 --alpha 1.57");
    assert!(out.contains("overturned"), "{out}");
    let (_, out, _) = run("chattering-time --a 1.02 --omega 2 --eta 0.92 --alpha 0.5 --normalisation slender");
    assert!(out.contains("does not rock"), "{out}");
    let (status, _, err) = run("chattering-time --a 1.01 --omega 2 --eta 0.92 --alpha 1.57 --oracle closed-form");
    assert!(status == Some(2) && err.contains("alpha = 1.57") && err.contains("closed-form"), "{err}");
}

/// What the other commands do with each of their options: an option that changes what is printed (`Used`, against the command without it), or one that
/// is refused together with others, naming words.
enum Then {
    Used,
    Refused(&'static [&'static str]),
}

const QUICK: &str = "[block]\nradius = 1.0\nslenderness = 0.2\nrestitution = 0.6\n\n[ground]\npulse = \"one-sine\"\namplitude = { over-threshold = 1.02 }\nfrequency = { omega = 2 }\n";
const PULSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/one_sine.toml");
const SWEEP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/sweeps/few.toml");
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/paper_fig_9.toml");

#[test]
fn an_option_of_a_command_is_used_or_refused() {
    use Then::{Refused, Used};
    let rows: &[(&str, &str, Then)] = &[
        ("critical-amplitude --omega 2 --eta 0.5", "--format json", Used),
        ("plan SCENE", "--tolerance 1e-3", Used),
        ("plan SCENE", "--format json", Used),
        ("plan PULSE", "--tolerance 0.3", Used),
        ("plan PULSE", "--format json", Used),
        ("scene SCENE", "--format json", Used),
        ("scene SCENE", "--schema", Refused(&["--schema", "FILE"])),
        ("scene --schema", "--format text", Refused(&["--schema", "--format"])),
        ("response SCENE", "--model nonlinear", Used),
        ("response SCENE", "--termination chattering", Used),
        ("response SCENE", "--termination velocity", Refused(&["velocity-threshold"])),
        ("response SCENE --termination velocity", "--velocity-threshold 1e-3", Used),
        (
            "response SCENE",
            "--velocity-threshold 1e-3",
            Refused(&["velocity-threshold = 1e-3", "--termination velocity"]),
        ),
        ("response SCENE --termination chattering", "--condition eq77 --until 0.5", Used),
        ("response SCENE", "--condition eq77", Refused(&["condition", "--termination chattering"])),
        ("response SCENE --format json", "--closing series", Used),
        (
            "response SCENE --termination chattering",
            "--closing series",
            Refused(&["closing = series", "--termination exact"]),
        ),
        ("response PULSE --oracle enclosure --format json", "--digits 20", Used),
        ("response SCENE", "--digits 20", Refused(&["digits = 20", "--oracle enclosure"])),
        ("response PULSE --oracle enclosure", "--format csv", Refused(&["format = csv"])),
        ("response PULSE --oracle enclosure", "--svg -", Refused(&["--svg"])),
        ("response PULSE --oracle enclosure", "--steps 7", Refused(&["steps = 7"])),
        (
            "response PULSE --oracle enclosure",
            "--termination velocity",
            Refused(&["termination = velocity", "enclosure"]),
        ),
        ("response PULSE --oracle auto", "--format json", Used),
        ("response PULSE --oracle auto", "--rtol 1e-5", Refused(&["rtol = 1e-5", "auto", "--oracle ode"])),
        ("verify --list", "--quiet", Refused(&["--list", "--quiet"])),
        ("response SCENE", "--until 0.5", Used),
        ("response SCENE", "--until 0.2s", Used),
        ("response SCENE", "--format text", Used),
        ("response SCENE", "--svg -", Used),
        ("response SCENE", "--html -", Used),
        ("response SCENE --svg -", "--html -", Refused(&["html = -", "--svg"])),
        ("response SCENE --svg -", "--format csv", Refused(&["format = csv", "--svg"])),
        ("response SCENE", "--from 0.5", Used),
        ("response SCENE", "--to 0.5", Used),
        ("response SCENE", "--steps 7", Used),
        ("response SCENE", "--format json", Used),
        ("response SCENE --format json", "--impacts 3", Used),
        ("response SCENE", "--impacts 3", Refused(&["impacts = 3", "--format json"])),
        ("response SCENE", "--oracle ode", Used),
        ("response SCENE", "--oracle taylor", Refused(&["model = linear", "taylor"])),
        ("response PULSE", "--oracle ode", Used),
        ("response PULSE", "--method bdf", Used),
        ("response PULSE --oracle ode", "--rtol 1e-5", Used),
        ("response PULSE --oracle taylor", "--rtol 1e-5", Refused(&["rtol = 1e-5", "taylor", "--oracle ode"])),
        ("response PULSE", "--oracle ode --rtol 1", Refused(&["rtol = 1 ", "1e-13 <= rtol <= 1e-2"])),
        ("response PULSE", "--oracle closed-form", Refused(&["model = nonlinear", "closed-form"])),
        (
            "response PULSE --model linear",
            "--oracle asymptotic",
            Refused(&["asymptotic/paper declines", "from impact to impact", "--oracle auto", "closed-form"]),
        ),
        ("response PULSE", "--oracle ode/nonlinear/tsit45/naive", Refused(&["naive declines", "one clock"])),
        ("criterion PULSE", "--oracle ode", Used),
        ("criterion PULSE", "--method bdf", Used),
        ("overturning PULSE", "--oracle ode --rtol 1", Refused(&["rtol = 1 "])),
        ("criterion SCENE", "--model nonlinear", Used),
        ("criterion SCENE", "--until 0.5", Used),
        ("scene PULSE", "--format json", Used),
        ("chattering-time --scene PULSE", "--model linear", Used),
        ("chattering-time --scene PULSE", "--until 0.1", Used),
        ("chattering-time --scene PULSE", "--oracle ode", Used),
        ("chattering-time --scene PULSE", "--oracle enclosure", Used),
        ("chattering-time --scene PULSE --oracle enclosure", "--digits 30", Used),
        ("chattering-time --scene PULSE --oracle enclosure", "--until 0.1", Used),
        ("chattering-time --scene PULSE --oracle enclosure", "--impacts 5", Refused(&["impacts = 5", "scene"])),
        (
            "chattering-time --scene PULSE --oracle enclosure",
            "--rtol 1e-5",
            Refused(&["rtol = 1e-5", "enclosure", "--oracle ode"]),
        ),
        ("chattering-time --scene PULSE", "--impacts 5", Refused(&["impacts = 5", "scene"])),
        ("chattering-time --scene PULSE", "--tolerance 1e-3", Refused(&["tolerance = 1e-3", "auto"])),
        ("chattering-time --scene PULSE", "--digits 30", Refused(&["digits = 30", "auto"])),
        ("simulate --scene PULSE", "--impacts 5", Used),
        ("simulate --scene PULSE", "--order 5", Refused(&["order = 5", "auto"])),
        ("criterion SCENE", "--format json", Used),
        ("criterion SCENE", "--to-scale 1.001", Used),
        ("criterion SCENE", "--to-scale 0.5", Refused(&["to-scale = 0.5", "above 1"])),
        ("overturning QUICK --from 0.9 --to 1.2", "--model linear", Used),
        ("overturning QUICK --from 0.9 --to 1.2", "--format json", Used),
        ("overturning PULSE", "--from 3 --to 2", Refused(&["to = 2", "above --from"])),
        ("overturning PULSE", "--by size", Refused(&["--by", "scale"])),
        ("response SCENE --format json", "--from 0.5", Refused(&["from = 0.5", "--format csv"])),
        ("response SCENE --format json", "--to 0.5", Refused(&["to = 0.5", "--format csv"])),
        ("response SCENE --format json", "--steps 7", Refused(&["steps = 7", "--format csv"])),
        ("chattering-time", "--scene SCENE --alpha 0.1", Refused(&["--scene", "--alpha"])),
        ("chattering-time", "--scene SCENE --normalisation slender", Refused(&["--normalisation"])),
        (
            "chattering-time --a 1.01 --omega 2 --eta 0.9",
            "--normalisation slender",
            Refused(&["normalisation = slender", "alpha"]),
        ),
        ("chattering-time --a 1.01 --omega 2 --eta 0.9", "--epsilon 0.01", Refused(&["--epsilon", "--a"])),
        ("chattering-time --scene SCENE", "--impacts 5", Refused(&["impacts = 5", "auto"])),
        ("chattering-time --scene SCENE", "--until 5", Refused(&["until = 5", "auto"])),
        ("chattering-time --scene SCENE", "--digits 5", Used),
        ("chattering-time --scene SCENE", "--model nonlinear", Used),
        ("simulate --scene SCENE", "--model nonlinear", Used),
        ("simulate --scene SCENE --model nonlinear", "--oracle ode", Used),
        ("simulate --scene SCENE", "--oracle taylor", Refused(&["model = linear", "taylor", "--model nonlinear"])),
        (
            "simulate --scene SCENE --model nonlinear",
            "--oracle closed-form",
            Refused(&["model = nonlinear", "closed-form"]),
        ),
        ("simulate --scene SCENE", "--tolerance 1e-3", Refused(&["tolerance = 1e-3", "--oracle asymptotic"])),
        (
            "chattering-time --a 1.01 --omega 2 --eta 0.9 --oracle closed-form",
            "--tolerance 1e-3",
            Refused(&["tolerance = 1e-3", "--oracle asymptotic or auto"]),
        ),
        ("sweep SWEEP --out -", "--partition 2/3", Used),
        ("sweep SWEEP --out -", "--partition 4/3", Refused(&["partition = 4/3"])),
        // What does not depend on how many there are is the same, so only that it is looked at.
        ("sweep SWEEP --out -", "--threads 0", Refused(&["threads = 0", "1 to 1024"])),
        ("sweep SWEEP --out -", "--svg map.svg", Refused(&["svg = map.svg", "--out"])),
        ("sweep SWEEP --out -", "--x a", Refused(&["--svg"])),
        ("sweep SWEEP --out -", "--y a", Refused(&["--svg"])),
        ("sweep SWEEP --out -", "--column tau_ch", Refused(&["--svg"])),
        ("sweep SWEEP --out -", "--log-colour", Refused(&["--svg"])),
        ("sweep SWEEP --out -", "--redraw", Refused(&["--svg"])),
        ("sweep SWEEP --out none.csv --svg - --redraw", "--threads 2", Refused(&["--redraw", "--threads"])),
        ("sweep SWEEP --out none.csv --svg - --redraw", "--partition 1/2", Refused(&["--redraw", "--partition"])),
        ("verify", "--oracles closed-form,closed-form", Refused(&["oracles = closed-form", "each once"])),
        ("verify", "--oracles ode,ode/linear/bdf", Refused(&["oracles = ode/linear/bdf", "each once"])),
        ("verify", "--oracles closed-form", Refused(&["oracles = closed-form", "two oracles"])),
        ("verify", "--responses 3 --oracles asymptotic", Refused(&["responses = 3", "--oracles"])),
        ("verify", "--responses 1000001", Refused(&["responses = 1000001", "1000000"])),
        ("verify", "--profile out", Refused(&["--engines"])),
        ("verify", "--partition 0/2", Refused(&["partition = 0/2"])),
        ("verify --list", "--cases 3", Used),
        ("verify --list", "--seed 3", Used),
        ("verify --list", "--partition 1/3", Used),
        ("verify --list", "--responses 3", Refused(&["--list", "--responses"])),
        ("verify --list", "--oracles ode", Refused(&["--list", "--oracles"])),
        ("verify --list", "--engines none.toml", Refused(&["--list", "--engines"])),
        ("verify --list", "--only mine", Refused(&["--list", "--only"])),
        ("verify --list", "--record talk.jsonl", Refused(&["--list", "--record"])),
        ("verify --list", "--json -", Refused(&["--list", "--json"])),
        ("verify --list", "--junit -", Refused(&["--list", "--junit"])),
        ("verify --list", "--replays none", Refused(&["--list", "--replays"])),
        ("verify --list", "--out none", Refused(&["--list", "--out"])),
        ("verify --out none", "--json -", Refused(&["--out", "--json"])),
        ("verify --out none", "--junit -", Refused(&["--out", "--junit"])),
        ("verify --out none", "--summary -", Refused(&["--out", "--summary"])),
        ("verify --out none", "--full", Refused(&["--out", "--full"])),
        ("verify --list", "--full", Refused(&["--list", "--full"])),
        ("chattering-time --omega 2 --eta 0.9", "--am 2", Refused(&["'--am' found; a similar argument exists: '--a'"])),
        ("verify --cases 1 --json -", "--full", Refused(&["--full", "stdout"])),
        ("verify --cases 1 --junit -", "--full", Refused(&["--full", "stdout"])),
        ("verify --cases 1 --summary -", "--format github", Refused(&["--format github", "stdout"])),
        ("verify --json same.out", "--summary same.out", Refused(&["summary = same.out", "--json"])),
        ("verify --html -", "--full", Refused(&["--full", "stdout"])),
        ("verify --json same.out", "--html ./same.out", Refused(&["html = ./same.out", "--json"])),
        ("verify --junit -", "--summary -", Refused(&["summary = -", "--junit"])),
        ("response SCENE --until 1", "--to 2", Refused(&["to = 2", "end of the response"])),
        (
            "chattering-time --a 1.2 --omega 2 --eta 0.92 --oracle printed",
            "--until 20",
            Refused(&["printed declines", "half a period"]),
        ),
        (
            "simulate --a 1.2 --omega 2 --eta 0.92 --oracle printed",
            "--until 20",
            Refused(&["printed declines", "half a period"]),
        ),
        ("verify", "--judge -1", Refused(&["judge = -1"])),
        ("chart --out /tmp", "--only atlas --peers none.csv", Refused(&["peers", "--only work-precision"])),
        ("diagnose --out /tmp", "--eta 0.9,0.9", Refused(&["eta", "once"])),
        ("diagnose --out /tmp", "--omega 9", Refused(&["omega = 9"])),
        ("diagnose --out /tmp", "--grid 0", Refused(&["grid = 0"])),
    ];
    // A search is 400 responses: of a block that soon comes to rest.
    let folder = tempfile::tempdir().unwrap();
    let quick = folder.path().join("quick.toml");
    std::fs::write(&quick, QUICK).unwrap();
    for (command, option, then) in rows {
        let [command, option] = [command, option].map(|text| {
            text.replace("SCENE", SCENE)
                .replace("PULSE", PULSE)
                .replace("SWEEP", SWEEP)
                .replace("QUICK", quick.to_str().unwrap())
        });
        let (status, out, err) = run(&format!("{command} {option}"));
        match then {
            Used => {
                assert_eq!(status, Some(0), "{command} {option}: {err}");
                assert_ne!(out, run(&command).1, "{command}: ignores {option}");
            }
            Refused(words) => {
                assert_eq!((status, out.as_str(), err.lines().count()), (Some(2), "", 1), "{command} {option}: {err}");
                assert!(words.iter().all(|word| err.contains(word)), "{command} {option}: {err}");
            }
        }
    }
}

/// A new option has to be put into one of the tables above, or named here with the test that uses it.
#[test]
fn every_option_of_every_command_is_known_to_these_tests() {
    let elsewhere = [
        // The commands that take a while: their own tests run them with these.
        "--cases",
        "--case-file",
        "--engines",
        "--record",
        "--full",
        "--seed",
        "--oracles",
        "--json",
        "--junit",
        "--judge",
        "--partition",
        "--replays",
        "--quiet",
        "--out",
        "--only",
        "--peers",
        "--redraw",
        "--grid",
        "--help",
    ];
    let source = include_str!("options.rs");
    let (_, help, _) = run("--help");
    let commands = help.lines().skip_while(|line| !line.starts_with("Commands")).skip(1);
    let commands: Vec<&str> =
        commands.take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next()).collect();
    assert!(commands.len() > 10, "{commands:?}");
    let mut seen = BTreeSet::new();
    for command in commands.into_iter().filter(|command| *command != "help") {
        let (_, help, _) = run(&format!("{command} --help"));
        let words = help.lines().map(str::trim_start).filter(|line| line.starts_with("--") || line.starts_with("-h"));
        for option in words.flat_map(str::split_whitespace).filter(|word| word.starts_with("--")) {
            let option = option.trim_matches([',', '.']);
            assert!(
                elsewhere.contains(&option)
                    || source.contains(&format!("{option} "))
                    || source.contains(&format!("{option}\"")),
                "{command} {option} is in no table"
            );
            seen.insert(option.to_owned());
        }
    }
    assert!(elsewhere.iter().all(|option| seen.contains(*option)), "{seen:?}");
}
