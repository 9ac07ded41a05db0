//! `verify --engines`: what the gate makes of an engine.

use std::{fs, path::Path, process::Command};

use chattercheck::engines::starter;

use super::{answering, chattercheck, shell};

/// The Rust starter, which at a word in its environment makes a mistake.
fn faulty(folder: &Path, how: &str, more: &str) {
    let starter = starter::Starter::named("rust").unwrap();
    let build = folder.join("faulty");
    if !build.exists() {
        let fault = "fn fault(how: &str) -> bool { std::env::var(\"FAULT\").is_ok_and(|fault| fault == how) }\n";
        let text =
            starter.text.replace("v: eta * speed,", "v: eta * speed * if fault(\"eta\") { 1.0 + 1e-6 } else { 1.0 },");
        let text = text.replace(
            "fn chatter(epsilon: f64, omega: f64, eta: f64, impacts: usize, until: Option<f64>) -> String {",
            "fn chatter(epsilon: f64, omega: f64, eta: f64, impacts: usize, until: Option<f64>) -> String {
                if fault(\"crash\") && eta > 0.975 { eprintln!(\"eta is too large\"); std::process::exit(9) }",
        );
        let text = text.replace("<= 10.0 =>", "<= 10.0 && !fault(\"decline\") =>");
        let text = text.replace("PI / omega)", "PI / omega) * if fault(\"period\") { 2.0 } else { 1.0 }");
        let text = text.replace("change < 0.1 * weakest", "change < 0.1 * weakest && !fault(\"restless\")");
        assert_eq!(text.matches("fault(").count(), 5);
        fs::write(folder.join("faulty.rs"), text + fault).unwrap();
        let built = Command::new("rustc").args(["-O", "faulty.rs"]).current_dir(folder).status().unwrap();
        assert!(built.success());
    }
    let manifest = format!(
        "[[engine]]\nname = \"mine\"\nrun = [\"./faulty\"]\nmodel = \"linear\"\nenvironment = {{ FAULT = \"{how}\" }}\n\
         tolerance = {{ time = 1e-10, interval = 1e-10, velocity = 1e-10, reason = \"mine\" }}\n{more}"
    );
    fs::write(folder.join("engines.toml"), manifest).unwrap();
}

/// A run of a few cases.
fn verify(folder: &Path, more: &str) -> (i32, String, String) {
    let run = "verify --engines engines.toml --quiet --cases 0 --judge 40 --partition 1/6 --oracles closed-form --json report.json --junit junit.xml";
    chattercheck(folder, &format!("{run} {more}"))
}

fn report(folder: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(folder.join("report.json")).unwrap()).unwrap()
}

/// What the gate makes of an engine that is right, wrong, breaks, or declines everything.
#[test]
fn an_engine_is_put_under_the_gate() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    faulty(folder, "none", "version = { command = [\"echo\", \"mine 1.2.3\"] }\n");
    let (status, out, err) = verify(folder, "--record talk.jsonl");
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("engine       mine (my Rust engine 1, Rust; mine 1.2.3): PASS"), "{out}");
    assert!(out.contains("it claims no errors; granted by the manifest: time 1e-10"), "{out}");
    let right = report(folder);
    let [engine] = right["engines"].as_array().unwrap().as_slice() else { panic!("{right}") };
    assert_eq!(
        (&engine["name"], &engine["receipt"], &engine["verdict"]),
        (&"mine".into(), &"mine 1.2.3".into(), &"pass".into())
    );
    let cases = right["reach"]["cases"].as_u64().unwrap();
    assert_eq!(engine["answered"].as_u64().unwrap() + engine["declined"].as_u64().unwrap(), cases);
    let talk = fs::read_to_string(folder.join("talk.jsonl")).unwrap();
    assert!(talk.lines().count() as u64 > 2 * cases, "{talk}");
    assert!(talk.lines().all(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["engine"] == "mine"));

    // The same report for any number of processes.
    faulty(folder, "none", "version = { command = [\"echo\", \"mine 1.2.3\"] }\nprocesses = 3\n");
    assert_eq!(verify(folder, "").0, 0);
    assert_eq!(report(folder), right);

    faulty(folder, "eta", "");
    let (status, out, err) = verify(folder, "");
    assert_eq!(status, 1);
    for words in [
        "failed cases point to mine",
        "mine is WRONG on velocity, first at impact 1",
        "(off by 1.00e-6, granted 4.50e-10)",
        "nothing is wrong, by the judge and the laws, with closed-form",
        "see it: chattercheck engine ask mine --engines engines.toml --epsilon",
    ] {
        assert!(out.contains(words), "no {words:?} in:\n{out}");
    }
    assert_eq!(report(folder)["engines"][0]["verdict"], "fail");
    // The case is made small, and shows the same when it is run again.
    assert!(err.contains(", granted ") && !err.contains(", claimed "), "{err}");
    let again = err.lines().find_map(|line| line.split_once("run again: chattercheck ")).unwrap().1;
    let (status, out, _) = chattercheck(folder, again);
    assert_eq!(status, 1);
    assert!(out.contains("FAIL: the disagreement is still there"), "{out}");
    let (status, _, err) = chattercheck(folder, again.split(" --engines").next().unwrap());
    assert_eq!(status, 2);
    assert!(err.contains("an engine is found by --engines FILE"), "{err}");

    faulty(folder, "crash", "");
    let (status, out, _) = verify(folder, "");
    assert_eq!(status, 3, "{out}");
    for words in [
        "UNDECIDED: mine broke in ",
        "\nUNDECIDED ",
        "broke        mine: ",
        "mine BROKE: crashed: exit status 9; its error output ends with \"eta is too large\"",
        "next: mend what broke the engine",
    ] {
        assert!(out.contains(words), "no {words:?} in:\n{out}");
    }
    let broke = report(folder);
    assert_eq!((&broke["verdict"], &broke["engines"][0]["verdict"]), (&"undecided".into(), &"undecided".into()));
    assert!(broke["broke"]["mine"]["crashed"].as_u64().unwrap() > 0);
    let junit = fs::read_to_string(folder.join("junit.xml")).unwrap();
    assert!(junit.contains("<error") && !junit.contains("<failure"), "{junit}");

    faulty(folder, "decline", "may-decline = 1.0\n");
    let (status, out, _) = verify(folder, "");
    assert_eq!(status, 1);
    assert!(out.contains("SHORTFALL: mine answered no case"), "{out}");
}

/// Who follows the block for longer than was asked for answers another question, at the first look and in the gate.
#[test]
fn impacts_after_the_end_of_the_time_are_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    faulty(folder, "period", "");
    let (status, out, _) = chattercheck(folder, "engine check engines.toml");
    assert_eq!(status, 1, "{out}");
    assert!(out.contains("WRONG rocking") && out.contains("ok    rest"), "{out}");
    let case = "[[case]]\nname = \"incomplete\"\na = 1.06\nomega = 2\neta = 0.92\nimpacts = 12\n";
    fs::write(folder.join("case.toml"), case).unwrap();
    let run = "verify --engines engines.toml --quiet --cases 0 --case-file case.toml";
    let (status, out, _) = chattercheck(folder, run);
    assert_eq!(status, 1, "{out}");
    for words in [
        "mine breaks \"no impact comes after the time that was asked for\" at impact 10: time 2.",
        "mine is WRONG on ending, first at impact 10",
        "right to impact 9,",
        "endings: 0 of 1 right",
    ] {
        assert!(out.contains(words), "no {words:?} in:\n{out}");
    }
    faulty(folder, "none", "");
    assert_eq!(chattercheck(folder, run).0, 0);
}

/// An engine that can't know that a block comes to rest may say so in its manifest; else it is told at the first look.
#[test]
fn an_engine_that_never_concludes_rest_is_told_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (manifest, is_told) in [("", true), ("never-at-rest = true\n", false)] {
        faulty(folder, "restless", manifest);
        let (status, out, _) = chattercheck(folder, "engine check engines.toml");
        assert_eq!((status, out.contains("never-at-rest = true in the manifest says so")), (0, is_told), "{out}");
        let (status, out, _) = verify(folder, "");
        let short =
            ["closed-form and mine: no chattering time was compared", "next: the engine has to end with \"at-rest\""];
        assert_eq!(status, i32::from(is_told), "{out}");
        assert!(short.iter().all(|short| out.contains(short) == is_told), "{out}");
    }
}

/// What nearly anything would have passed is said not to have been compared, in a short run too.
#[test]
fn a_wide_tolerance_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("case.toml"), "[[case]]\nname = \"one\"\na = 1.03\nomega = 2\neta = 0.92\n").unwrap();
    let run = "verify --engines engines.toml --quiet --cases 0 --case-file case.toml";
    for (how, is_told) in [("none", false), ("eta", true)] {
        faulty(folder, how, "");
        let manifest = fs::read_to_string(folder.join("engines.toml")).unwrap();
        let wide = if is_told {
            manifest.replace("interval = 1e-10", "interval = 0.3").replace("time = 1e-10", "time = 1e-6")
        } else {
            manifest
        };
        fs::write(folder.join("engines.toml"), wide.replace("velocity = 1e-10", "velocity = 1e-3")).unwrap();
        let (status, out, _) = chattercheck(folder, run);
        assert_eq!((status, out.contains("claim so little")), (i32::from(is_told), is_told), "{out}");
    }
}

/// Cases that an engine can't be asked are no refusals of it: what they lack is said.
#[test]
fn a_case_without_a_slenderness_is_not_declined_by_the_engine() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let script = answering(r#""decline":{"reason":"on holiday"}"#).replace(r#"["linear"]"#, r#"["nonlinear"]"#);
    shell(folder, &script, "");
    let manifest = fs::read_to_string(folder.join("engines.toml")).unwrap();
    fs::write(folder.join("engines.toml"), manifest.replace("\"linear\"", "\"nonlinear\"")).unwrap();
    fs::write(folder.join("case.toml"), "[[case]]\nname = \"bare\"\na = 1.06\nomega = 2\neta = 0.92\n").unwrap();
    let (status, out, _) =
        chattercheck(folder, "verify --engines engines.toml --quiet --cases 0 --case-file case.toml");
    assert_eq!(status, 1, "{out}");
    for words in [
        "0 cases answered, 1 not asked, for they have no slenderness (alpha)",
        "SHORTFALL: mine was asked nothing: none of 1 cases has a slenderness",
        "give the cases a slenderness: alpha",
    ] {
        assert!(out.contains(words), "no {words:?} in:\n{out}");
    }
    assert!(!out.contains("1 declined"), "{out}");
}

/// A known failure turns no run red, until it no longer fails: then the line to delete is named.
#[test]
fn known_failures_are_strict() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let known = "known = [\n    { class = \"velocity\", reason = \"eta is rounded\" },\n]\n";
    faulty(folder, "eta", known);
    let (_, out, _) = verify(folder, "");
    assert!(out.contains("known        mine: velocity: failed in"), "{out}");
    assert!(!out.contains("mine is WRONG on velocity"), "{out}");
    // A run that is green but for what is known says so at its head.
    fs::write(folder.join("case.toml"), "[[case]]\nname = \"one\"\na = 1.03\nomega = 2\neta = 0.92\n").unwrap();
    let one = "verify --engines engines.toml --quiet --cases 0 --case-file case.toml --summary summary.md";
    let (status, out, _) = chattercheck(folder, one);
    assert_eq!(status, 0, "{out}");
    assert!(out.starts_with("PASS: 2 oracles agree on 0 of 1 cases; 1 fail as is known"), "{out}");
    assert!(out.contains("PASS, 1 cases answered, 1 wrong as is known"), "{out}");
    let summary = fs::read_to_string(folder.join("summary.md")).unwrap();
    assert!(summary.contains("| **PASS** | 1 | 0 | 1 | 0 | 0 |"), "{summary}");
    faulty(folder, "none", known);
    let (status, out, _) = verify(folder, "");
    assert_eq!(status, 1, "{out}");
    assert!(out.contains("SHORTFALL: a known failure no longer shows in "), "{out}");
    assert!(out.contains("cases: mine: velocity; delete it: engines.toml, line 8"), "{out}");
    assert_eq!(report(folder)["engines"][0]["verdict"], "fail");
}

#[test]
fn an_engine_that_does_not_start_leaves_no_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    shell(folder, "echo no licence >&2; exit 5", "");
    let (status, out, err) = verify(folder, "");
    assert_eq!((status, out.as_str()), (3, ""));
    assert!(
        err.contains("mine: ended at the start: exit status 5; its error output ends with \"no licence\""),
        "{err}"
    );
    for (arguments, words) in [
        ("--only mien", "there is no engine \"mien\" in it"),
        ("--engines none.toml", "none.toml: cannot be read"),
        ("--record -", "record = - is outside the allowed range: a file"),
        (
            "--record ./engines.toml",
            "record = ./engines.toml is outside the allowed range: it has to be another file than one that is read",
        ),
    ] {
        let arguments = format!(
            "verify --quiet --cases 0 {} {arguments}",
            if arguments.contains("--engines") { "" } else { "--engines engines.toml" }
        );
        let (status, _, err) = chattercheck(folder, &arguments);
        assert_eq!(status, 2, "{arguments}: {err}");
        assert!(err.contains(words), "{err}");
    }
    let (status, _, err) = chattercheck(folder, "verify --only mine");
    assert_eq!(status, 2);
    assert!(err.contains("--engines"), "{err}");
    fs::write(folder.join("engines.toml"), "[[engine]]\nname = \"taylor\"\nrun = [\"sh\"]\nmodel = \"linear\"\n")
        .unwrap();
    let (status, _, err) = verify(folder, "");
    assert_eq!(status, 2);
    assert!(err.contains("\"taylor\" is the name of an oracle"), "{err}");
}

/// What mistake an engine makes is said in words, and what it is good for; where no mistake explains it, that is said.
#[test]
fn the_mistake_of_an_engine_is_named_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let planted = |words: &str| {
        let run = format!("{:?}, \"engine\", \"planted\", {words}", env!("CARGO_BIN_EXE_chattercheck"));
        let manifest = format!("[[engine]]\nname = \"mine\"\nrun = [{run}]\nmodel = \"linear\"\n");
        fs::write(folder.join("engines.toml"), manifest).unwrap();
    };
    planted("\"none\"");
    let (status, out, err) = verify(folder, "--full");
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("mine: the relative error of its intervals by depth.") && !out.contains("as if"), "{out}");
    let right = report(folder)["engines"][0].clone();
    assert!(right["explanations"].is_null(), "{right}");
    assert_eq!(right["profile"]["right"], right["answered"]);

    // The files have the times, the report has none.
    let whole = report(folder);
    let (status, out, err) = verify(folder, "--profile out");
    assert_eq!(status, 0, "{out}");
    assert_eq!(report(folder), whole);
    let file = |name: &str| fs::read_to_string(folder.join("out").join(name)).unwrap();
    for table in ["depth", "sides", "endings", "speed", "work"] {
        assert!(err.contains(&format!("out/profile_{table}.csv")), "{err}");
        assert!(file(&format!("profile_{table}.csv")).contains("\nmine,") || table == "work");
    }
    for chart in ["depth", "sides", "work"] {
        assert!(file(&format!("profile_{chart}.svg")).starts_with("<svg"));
    }
    assert_eq!(file("profile_work.csv").lines().filter(|row| row.contains(",mine (engine),")).count(), 3);
    let speed = file("profile_speed.csv");
    let row: Vec<&str> = speed.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(row[1], right["profile"]["right"].to_string());
    assert!(row[3].parse::<f64>().unwrap() > 100.0, "{speed}");

    planted("\"eta is off\", \"--size\", \"2e-4\", \"--oracle\", \"closed-form\"");
    let (status, out, _) = verify(folder, "");
    assert_eq!(status, 1);
    let words = "as if the coefficient of restitution were rounded or mistyped: explains ";
    assert!(out.contains(words) && out.contains("(eta is off, relative error: 2.000000e-4)"), "{out}");
    assert!(out.contains("right in ") && out.contains("next to a_cr, in units of a_cr - 1: "), "{out}");
    let wrong = report(folder)["engines"][0].clone();
    assert_eq!(wrong["explanations"][0]["fault"], "eta is off");
    assert_eq!(wrong["explanations"][0]["explained"], wrong["explanations"][0]["of"]);

    shell(folder, &answering(r#""history":{"time":[0.5],"velocity":[0.1],"ending":"at-rest"}"#), "");
    let (status, out, _) = verify(folder, "");
    assert_eq!(status, 1);
    assert!(out.contains("nothing in the catalogue of mistakes explains it"), "{out}");
    assert_eq!(report(folder)["engines"][0]["explanations"], serde_json::json!([]));

    let (status, out, _) = chattercheck(folder, "engine planted");
    assert_eq!(status, 0);
    assert!(out.contains("as if the velocity kept its sign at one impact"), "{out}");
    for (arguments, words) in [("engine planted none --size 1", "fault = none"), ("engine planted x", "fault = x")] {
        let (status, _, err) = chattercheck(folder, arguments);
        assert_eq!(status, 2);
        assert!(err.contains(words) && err.contains("`chattercheck engine planted`"), "{err}");
    }
}

/// What is said of an engine, its profile and what would explain its mistakes too, is the same of parts that are put together; with another manifest they are
/// parts of another run.
#[test]
fn an_engine_in_parts_is_the_engine_in_one_piece() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    faulty(folder, "eta", "");
    let case = |(name, epsilon): (&str, f64)| {
        format!("[[case]]\nname = {name:?}\nepsilon = {epsilon}\nomega = 2.0\neta = 0.85\n")
    };
    fs::write(folder.join("own.toml"), [("one", 0.01), ("two", 0.02), ("three", 0.03)].map(case).concat()).unwrap();
    let run = "verify --engines engines.toml --quiet --cases 0 --case-file own.toml";
    let one = chattercheck(folder, &format!("{run} --full --json one.json"));
    assert!(one.0 == 1 && one.1.contains("as if the coefficient of restitution"), "{}", one.1);
    for part in 1..=2 {
        assert_eq!(chattercheck(folder, &format!("{run} --partition {part}/2 --out parts")).0, 1);
    }
    let all = chattercheck(folder, "merge parts --full --json all.json");
    assert_eq!((all.0, all.1.as_str()), (1, one.1.as_str()), "{}", all.2);
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(read("all.json"), read("one.json"));
    fs::write(folder.join("engines.toml"), read("engines.toml") + "# changed\n").unwrap();
    let (status, _, err) = chattercheck(folder, &format!("{run} --partition 1/2 --out parts"));
    assert!(status == 2 && err.contains("of another request; the manifest of mine: "), "{err}");
}
