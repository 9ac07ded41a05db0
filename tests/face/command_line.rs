//! The commands: their formats, their exit status, and what bad input gets.

use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn chattercheck(arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    command.args(arguments.split_whitespace());
    command
}

/// Runs a command that has to succeed and returns what it printed.
fn stdout(arguments: &str) -> String {
    let output = chattercheck(arguments).assert().success().get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

fn json(arguments: &str) -> Value {
    serde_json::from_str(&stdout(arguments)).unwrap()
}

/// Runs a command that has to be refused: status 2, nothing on stdout, one line on stderr that has all of `words`.
fn refused(arguments: &str, words: &[&str]) {
    let assert = chattercheck(arguments).assert().code(2);
    let output = assert.get_output();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.stdout.is_empty(), "{arguments}: something on stdout");
    assert_eq!(stderr.lines().count(), 1, "{arguments}: {stderr}");
    for word in words {
        assert!(stderr.contains(word), "{arguments}: `{word}` is missing in: {stderr}");
    }
    assert!(!stderr.contains("panicked"), "{arguments}: {stderr}");
}

#[test]
fn chattering_time_by_every_oracle() {
    let exact = 1.125947676933812;
    let case = "--a 1.03 --omega 2 --eta 0.92 --format json";
    for (oracle, digits) in [
        ("closed-form", 1e-14),
        ("ode", 1e-9),
        ("ode --method bdf", 1e-4),
        ("printed --impacts 80", 1e-13),
        ("asymptotic", 0.05),
    ] {
        let answer = json(&format!("chattering-time {case} --oracle {oracle}"));
        let found = answer["tau_ch"].as_f64().unwrap();
        let claimed = answer["uncertainty"].as_f64().unwrap();
        assert!((found - exact).abs() <= digits, "{oracle}: {found}");
        assert!((found - exact).abs() <= claimed, "{oracle}: {found} claims {claimed:e}");
        assert_eq!(answer["complete"], true);
        assert!((answer["half_period_fraction"].as_f64().unwrap() / found - 2.0 / std::f64::consts::PI).abs() < 1e-12);
    }
    let nonlinear = json(&format!("chattering-time {case} --oracle ode --alpha 0.2"));
    let relative = nonlinear["tau_ch"].as_f64().unwrap() / exact - 1.0;
    assert!((1e-4..1.5e-4).contains(&relative.abs()), "{relative}");
    let slender = json(&format!("chattering-time {case} --oracle ode --alpha 0.2 --normalisation slender"));
    let earlier = 1.0 - slender["tau_ch"].as_f64().unwrap() / exact;
    assert!((0.33..0.35).contains(&earlier), "{earlier}");
}

/// A time of which its oracle knows nothing is not shown as if it were known.
#[test]
fn a_time_that_may_be_off_by_any_amount_is_not_known() {
    let case = "chattering-time --a 1.03 --omega 2 --eta 0.92 --oracle ode --method bdf --rtol 1e-2";
    let text = chattercheck(case).assert().code(1).get_output().stdout.clone();
    let text = String::from_utf8(text).unwrap();
    assert!(
        text.contains("not known: ode/linear/bdf") && !text.contains("complete") && !text.contains("inf"),
        "{text}"
    );
    let json = chattercheck(&format!("{case} --format json")).assert().code(1).get_output().stdout.clone();
    let answer: Value = serde_json::from_slice(&json).unwrap();
    assert_eq!((&answer["complete"], &answer["uncertainty"]), (&Value::Null, &Value::Null));
    assert!(answer["ending"].as_str().unwrap().starts_with("unsure"), "{answer}");
}

#[test]
fn incomplete_and_absent_rocking_have_no_chattering_time() {
    let incomplete = json("chattering-time --a 1.05 --omega 2 --eta 0.92 --format json");
    assert_eq!((&incomplete["complete"], &incomplete["tau_ch"]), (&Value::Bool(false), &Value::Null));
    let still = json("chattering-time --a 0.9 --omega 2 --eta 0.92 --format json");
    assert_eq!((&still["rocks"], &still["tau_ch"]), (&Value::Bool(false), &Value::Null));
    assert!(stdout("chattering-time --a 0.9 --omega 2 --eta 0.92").contains("does not rock"));
}

#[test]
fn epsilon_is_not_rounded() {
    let tiny = json("chattering-time --epsilon 1e-20 --omega 2 --eta 0.92 --format json");
    let leading = 10.827_447_906_756_6 * 1e-10 / 2.0;
    assert!((tiny["tau_ch"].as_f64().unwrap() / leading - 1.0).abs() < 1e-14);
}

#[test]
fn simulate_prints_initiation_and_the_impacts() {
    let csv = stdout("simulate --a 1.03 --omega 2 --eta 0.92 --impacts 5");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "n,tau,interval,velocity,sign");
    assert_eq!(lines[1], "0,0.0,,0.0,-1");
    assert!(lines[2].starts_with("1,0.487764790632652"), "{}", lines[2]);
    assert!(lines[2].ends_with(",1") && lines[3].ends_with(",-1"));
    assert_eq!(lines.len(), 7);
    let document = json("simulate --a 1.03 --omega 2 --eta 0.92 --impacts 5 --format json");
    assert_eq!(document["impacts"][0]["interval"], Value::Null);
    assert_eq!(document["impacts"].as_array().unwrap().len(), 6);
    // Shortest decimals that come back: the CSV and the JSON hold the same doubles.
    let from_csv: f64 = lines[6].split(',').nth(1).unwrap().parse().unwrap();
    assert_eq!(document["impacts"][5]["tau"].as_f64().unwrap(), from_csv);
    assert_eq!(stdout("simulate --a 0.5 --omega 2 --eta 0.92").lines().count(), 1);
}

/// For impacts `auto` takes flights of the very equation that is asked for: beyond `a_cr`, in either normalisation.
#[test]
fn auto_lists_the_impacts_of_the_equation_that_is_asked_for() {
    for (case, oracle) in [
        ("--a 1.03 --omega 2 --eta 0.92 --alpha 0.2 --normalisation slender", "taylor"),
        ("--a 1.06 --omega 2 --eta 0.9 --alpha 0.5", "taylor"),
        ("--a 1.02 --omega 2 --eta 0.9 --alpha 0.3", "taylor"),
        ("--a 1.02 --omega 2 --eta 0.9", "closed-form"),
        ("--a 0.9 --omega 2 --eta 0.9", "closed-form"),
        ("--a 0.9 --omega 2 --eta 0.9 --alpha 0.3", "taylor"),
    ] {
        let auto = stdout(&format!("simulate {case} --impacts 8 --oracle auto"));
        assert_eq!(auto, stdout(&format!("simulate {case} --impacts 8 --oracle {oracle}")), "{case}");
    }
}

fn scene_file(folder: &Path, block: &str, ground: &str) -> String {
    let path = folder.join("scene.toml");
    let text = format!(
        "title = \"t\"\n[block]\n{block}\n[ground]\n{ground}\nduration = {{ seconds = 10 }}\n[ask]\nmodel = \"nonlinear\"\ntolerance = 1e-4\n"
    );
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_plan_tells_overturning_from_rocking_on_and_says_why_there_is_no_answer() {
    let folder = tempfile::tempdir().unwrap();
    let shelf = "half_width = 0.1\nhalf_height = 1.5\nrestitution = 0.92";
    let strong = "frequency = { hz = 0.3 }\namplitude = { over-threshold = 8.0 }";
    let scene = scene_file(folder.path(), shelf, strong);
    // It does not come to rest in half a period, and what it does then is followed.
    assert!(stdout(&format!("plan {scene}")).contains("by critical-amplitude, then taylor"));
    assert!(stdout(&format!("plan {scene}")).contains("the block overturns"));
    // A phase beyond the threshold has to be followed, and then it is known.
    let scene = scene_file(folder.path(), shelf, &format!("{strong}\nphase = 1.0"));
    let plan = json(&format!("plan {scene} --format json"));
    assert_eq!((&plan["answer"]["complete"], &plan["answer"]["overturned"]), (&false.into(), &true.into()));
    assert!(stdout(&format!("plan {scene}")).contains("the block overturns"));
    // No error is predicted of a time that there is not.
    assert!(plan["candidates"].as_array().unwrap().iter().all(|row| row["errors"].is_null()));
    let scene = scene_file(folder.path(), shelf, "frequency = { hz = 1 }\namplitude = { over-threshold = 1.3 }");
    let rests = stdout(&format!("plan {scene}"));
    assert!(rests.contains("it rests 1") && rests.contains("by critical-amplitude, then taylor"), "{rests}");
    let endless = std::fs::read_to_string(&scene).unwrap().replace("duration = { seconds = 10 }", "");
    std::fs::write(&scene, endless).unwrap();
    assert!(stdout(&format!("plan {scene}")).contains("does not come to rest as long as it is followed"));
    let scene = scene_file(folder.path(), shelf, "frequency = { hz = 1 }\namplitude = { over-threshold = 0.3 }");
    let text = stdout(&format!("plan {scene}"));
    assert!(text.contains("the block never rocks") && text.lines().count() < 13, "{text}");
    let scene = scene_file(folder.path(), shelf, "frequency = { hz = 1e-9 }\namplitude = { over-threshold = 1.01 }");
    refused(&format!("plan {scene}"), &["omega", "1e-3 <= omega <= 1e3"]);
    refused(&format!("chattering-time --scene {scene}"), &["omega", "1e-3 <= omega <= 1e3"]);
}

#[test]
fn past_half_a_period_and_overturning() {
    let past = stdout("simulate --a 1.05 --omega 2 --eta 0.92 --until 3");
    let last: f64 = past.lines().last().unwrap().split(',').nth(1).unwrap().parse().unwrap();
    assert!(last > std::f64::consts::FRAC_PI_2 && last < 3.0, "{last}");
    let over = json("simulate --a 5 --omega 2 --eta 0.92 --until 50 --format json");
    assert_eq!(over["ending"], "overturned");
}

#[test]
fn bad_values_are_refused_with_field_value_and_range() {
    refused("chattering-time --a 1.03 --omega 2 --eta 1.5", &["eta = 1.5", "0 < eta < 1"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0", &["eta = 0", "0 < eta < 1"]);
    refused("chattering-time --a 1.03 --omega 2 --eta NaN", &["eta = NaN"]);
    refused("chattering-time --a 1.03 --omega 0 --eta 0.9", &["omega = 0", "omega > 0"]);
    refused("chattering-time --a 1.03 --omega -2 --eta 0.9", &["omega = -2", "omega > 0"]);
    refused("chattering-time --a inf --omega 2 --eta 0.9", &["a = inf", "0 <= a"]);
    refused("chattering-time --a -1 --omega 2 --eta 0.9", &["a = -1"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --alpha 1.6", &["alpha = 1.6", "pi/2"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --alpha 0.2 --normalisation tan", &["normalisation = tan"]);
    refused("chattering-time --a 1.03 --omega 1e300 --eta 0.9", &["omega", "1e-6 <= omega <= 1e6"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --impacts 0", &["impacts = 0"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --oracle ode --rtol 2", &["rtol = 2"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --oracle ode --model nonlinear", &["slenderness"]);
    refused("chattering-time --a 1.03 --omega 2 --eta 0.9 --oracle magic", &["oracle = magic", "closed-form"]);
    refused("simulate --a 1.03 --omega 2 --eta 0.9 --until -1", &["until = -1"]);
    refused("simulate --a 1.03 --omega x --eta 0.9", &["omega", "x"]);
    refused("simulate --a 1.03 --eta 0.9", &["--omega"]);
    refused("verify --partition 3/2", &["partition = 3/2"]);
    refused("verify --oracles nobody", &["oracles = nobody"]);
    refused("verify --cases -1", &["--cases", "-1"]);
    refused("replay does-not-exist.toml", &["does-not-exist.toml"]);
    refused("verify --json /no/such/folder/report.json", &["/no/such/folder/report.json"]);
    refused("shake", &["shake"]);
}

#[test]
fn replay_files_with_something_wrong_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    let refuse = |text: &str, words: &[&str]| {
        std::fs::write(&path, text).unwrap();
        refused(&format!("replay {}", path.display()), words);
    };
    let good = replay_text();
    refuse("not toml at all", &["replay.toml"]);
    refuse(&good.replace("seed = 1", "seed = 1\ncolour = 3"), &["colour"]);
    refuse(&good.replace("eta = 0.92", "eta = 1.92"), &["eta = 1.92", "0 < eta < 1"]);
    refuse(&good.replace("0x1p+1", "0x1p+2"), &["exact.omega"]);
    refuse(&good.replace("\"0x1p+1\"", "2.0"), &["exact.omega: allowed is the hexadecimal form", "0x1p+1"]);
    refuse(good.split_once(" = \"0x1p+1").unwrap().0, &["exact.omega: not TOML; allowed is the hexadecimal form"]);
    refuse(&good.replace("omega = 2.0", "omega = \"two\""), &[": omega: allowed is a number, omega > 0"]);
    refuse(&good.replace("\"closed-form\"", "\"nobody\""), &["nobody"]);
    std::fs::write(&path, [0xff, 0xfe, 0x00]).unwrap();
    refused(&format!("replay {}", path.display()), &["replay.toml"]);
}

fn replay_text() -> String {
    "version = \"0.1.0\"\nfound_in = \"list/x\"\nseed = 1\noracles = [\"closed-form\", \"ode/linear/tsit45\"]\nfinding = \"seen once\"\n\n\
     [case]\nepsilon = 0.03125\nomega = 2.0\neta = 0.92\nimpacts = 20\n\n\
     [exact]\nepsilon = \"0x1p-5\"\nomega = \"0x1p+1\"\neta = \"0x1.d70a3d70a3d71p-1\"\n"
        .to_owned()
}

#[test]
fn a_replay_of_what_is_mended_passes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    std::fs::write(&path, replay_text()).unwrap();
    let printed = stdout(&format!("replay {}", path.display()));
    assert!(printed.contains("seen once") && printed.contains("PASS"), "{printed}");
}

/// What a file says is said in its place and in one line: it can't pass for a verdict, nor colour the terminal.
#[test]
fn what_a_replay_file_says_can_pass_for_nothing_else() {
    const FORGED: &str = "a\\u001b[31m\\u202e\\nPASS: all well";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    // A naive solver is red on this case.
    let text = replay_text()
        .replace("ode/linear/tsit45", "ode/linear/tsit45/naive")
        .replace("0.03125", "0.03")
        .replace("0x1p-5", "0x1.eb851eb851eb8p-6")
        .replace("0.92", "0.86")
        .replace("0x1.d70a3d70a3d71p-1", "0x1.b851eb851eb85p-1")
        .replace("0.1.0", FORGED)
        .replace("list/x", FORGED)
        .replace("seen once", FORGED);
    std::fs::write(&path, text).unwrap();
    for report in ["", "--json -", "--junit -"] {
        let assert = chattercheck(&format!("replay {} {report}", path.display())).assert().code(1);
        for told in [&assert.get_output().stdout, &assert.get_output().stderr] {
            let told = String::from_utf8(told.clone()).unwrap();
            assert!(!told.contains(['\u{1b}', '\u{202e}']), "{told:?}");
            assert!(!told.lines().any(|line| line.starts_with("PASS")), "{told}");
        }
        let told = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
        assert!(told.contains("PASS: all well"), "{told}");
    }
}

/// Where nothing was compared nothing is mended: the status says so as the text does.
#[test]
fn a_replay_that_compares_nothing_is_red() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    // The series has nothing to say at so large an amplitude.
    let alone = replay_text()
        .replace("\"ode/linear/tsit45\"", "\"asymptotic/paper\"")
        .replace("0.03125", "0.5")
        .replace("0x1p-5", "0x1p-1");
    std::fs::write(&path, alone).unwrap();
    let assert = chattercheck(&format!("replay {}", path.display())).assert().code(1);
    let text = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
    assert!(text.contains("nothing was compared") && text.contains("FAIL: this says nothing"), "{text}");
}

#[test]
fn verify_is_green_deterministic_and_written_for_machines() {
    let folder = tempfile::tempdir().unwrap();
    let run = |threads: &str, name: &str| -> (String, Value, String) {
        let (json, junit) = (folder.path().join(format!("{name}.json")), folder.path().join(format!("{name}.xml")));
        let assert = chattercheck("verify --cases 40 --seed 5 --partition 1/3 --json")
            .arg(&json)
            .arg("--junit")
            .arg(&junit)
            .arg("--html")
            .arg(folder.path().join(format!("{name}.html")))
            .env("RAYON_NUM_THREADS", threads)
            .assert()
            .success();
        let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        let report = serde_json::from_str(&std::fs::read_to_string(json).unwrap()).unwrap();
        (text, report, std::fs::read_to_string(junit).unwrap())
    };
    let (one, two) = (run("1", "one"), run("2", "two"));
    let page = |name: &str| std::fs::read(folder.path().join(format!("{name}.html"))).unwrap();
    assert!(page("one") == page("two"), "the page depends on the number of threads");
    assert_eq!(one.0, two.0);
    assert_eq!(one.1, two.1);
    let report = one.1;
    assert_eq!(report["verdict"], "pass");
    assert_eq!(report["seed"], 5);
    assert_eq!(report["pairs"].as_array().unwrap().len(), 36);
    let cases = report["reach"]["cases"].as_u64().unwrap() as usize;
    let responses = report["responses"]["responses"].as_u64().unwrap() as usize;
    assert_eq!(responses, 100, "a third of 300");
    // One test for each case and each response, and one each for what the run of them falls short of.
    assert_eq!(one.2.matches("<testcase").count(), cases + 1 + responses + 1);
    assert!(one.0.contains("seed 5") && one.0.starts_with("PASS: 9 oracles agree on"));
}

#[test]
fn a_red_gate_has_status_1_and_writes_a_replay_file() {
    // The naive mode of the ODE oracle is known to lose the sequence.
    let folder = tempfile::tempdir().unwrap();
    let replays = folder.path().join("replays");
    let assert = chattercheck("verify --cases 30 --quiet --oracles closed-form,ode/linear/tsit45/naive --replays")
        .arg(&replays)
        .assert()
        .code(1);
    let text = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
    assert!(text.contains("FAILED") && text.contains("ode/linear/tsit45/naive") && text.contains("impact"), "{text}");
    let first = std::fs::read_dir(&replays).unwrap().next().unwrap().unwrap().path();
    chattercheck("replay").arg(&first).assert().code(1);
    assert!(Path::new(&first).extension().is_some_and(|extension| extension == "toml"));
}

#[test]
fn help_names_every_flag() {
    for command in ["verify", "replay", "simulate", "chattering-time", "oracles"] {
        assert!(stdout(&format!("{command} --help")).contains("Usage"), "{command}");
    }
    for flag in ["--cases", "--seed", "--oracles", "--json", "--junit", "--partition"] {
        assert!(stdout("verify --help").contains(flag), "{flag}");
    }
}

#[test]
fn proven_bounds_have_as_many_digits_as_asked_for() {
    let exact = "1.12594767693381208565217523638156801028440831025242995";
    for digits in [1, 17, 30, 50] {
        let command = format!("chattering-time --a 1.03 --omega 2 --eta 0.92 --oracle enclosure --digits {digits}");
        let answer = json(&format!("{command} --format json"));
        let [lower, upper] = ["lower", "upper"].map(|end| answer[end].as_str().unwrap().to_owned());
        // Decimals of one length with one digit before the point are in the order of their letters.
        assert!(lower.as_str() <= &exact[..lower.len()], "{lower}");
        assert!(upper.as_str() > &exact[..upper.len()], "{upper}");
        assert_eq!(lower.trim_start_matches("1.").len(), digits.max(2) - 1, "{lower}");
        assert_eq!(answer["complete"], true);
        assert!(stdout(&command).contains(&lower));
    }
    let nonlinear = json("chattering-time --a 1.03 --omega 2 --eta 0.92 --alpha 0.2 --oracle enclosure --format json");
    assert_eq!(nonlinear["oracle"], "enclosure/nonlinear");
    assert!(nonlinear["lower"].as_str().unwrap().starts_with("1.12608759832481"));
    let incomplete = json("chattering-time --a 1.1 --omega 2 --eta 0.92 --oracle enclosure --format json");
    assert_eq!((&incomplete["complete"], &incomplete["tau_ch"]), (&Value::Bool(false), &Value::Null));
    let resting = json("chattering-time --a 0.9 --omega 2 --eta 0.92 --oracle enclosure --format json");
    assert_eq!((&resting["rocks"], &resting["tau_ch"]), (&Value::Bool(false), &Value::Null));
}

#[test]
fn the_critical_amplitude_is_certified() {
    let answer = json("critical-amplitude --omega 2 --eta 0.92 --format json");
    assert_eq!(answer["certified"], true);
    let [lower, upper] = ["lower", "upper"].map(|end| answer[end].as_str().unwrap().parse::<f64>().unwrap());
    assert!(lower < 1.038_015_538_730_4 && upper > 1.038_015_538_730_3 && upper - lower <= 1e-12, "{lower} {upper}");
    let a_cr = answer["a_cr"].as_f64().unwrap();
    assert!(lower <= a_cr && a_cr <= upper);
    assert!((answer["exponent"].as_f64().unwrap() - 0.60018).abs() < 1e-5);
    assert!((answer["eq76"].as_f64().unwrap() - 1.03732).abs() < 1e-5);
    assert!((answer["eq77"].as_f64().unwrap() - 1.03790).abs() < 1e-5);
    assert!(stdout("critical-amplitude --omega 8 --eta 0.5").contains("proven: complete at 1.1472100813811"));
}

#[test]
fn what_the_judge_is_asked_wrongly_is_refused() {
    refused("critical-amplitude --omega 0 --eta 0.92", &["omega", "0", "100"]);
    refused("critical-amplitude --omega 2 --eta 1", &["eta", "1", "0.98"]);
    refused("critical-amplitude --omega x --eta 0.9", &["omega", "x", "not a number"]);
    let case = "chattering-time --a 1.03 --omega 2 --eta 0.92";
    refused(&format!("{case} --oracle enclosure --digits 0"), &["digits", "0", "1 <= digits <= 100"]);
    refused(&format!("{case} --oracle enclosure --digits 101"), &["digits", "101", "1 <= digits <= 100"]);
    refused(&format!("{case} --oracle enclosure --digits -3"), &["digits", "-3", "1 <= digits <= 100"]);
    refused(&format!("{case} --oracle enclosurex"), &["oracle", "enclosurex", "closed-form"]);
    refused(&format!("{case} --oracle enclosure --rtol 1e-3"), &["rtol", "1e-3", "only with --oracle ode"]);
    refused(&format!("{case} --oracle enclosure --model cubic"), &["model", "cubic", "linear or nonlinear"]);
    refused(&format!("{case} --oracle ode --digits 20"), &["digits", "20", "ode", "only with --oracle enclosure"]);
    refused(&format!("{case} --oracle enclosure --model nonlinear"), &["slenderness"]);
    refused("verify --judge 0", &["judge", "0", "N >= 1"]);
    refused("verify --judge some", &["judge", "some", "all"]);
}

/// Answers that are collected say what they answer, on one line if that is asked.
#[test]
fn json_repeats_the_case_and_goes_on_one_line() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/paper_fig_9.toml");
    let flags = "--epsilon 0.03 --omega 2 --eta 0.92 --alpha 0.2 --normalisation slender";
    for command in [format!("chattering-time {flags}"), format!("simulate {flags} --impacts 3")] {
        let answer = json(&format!("{command} --format json"));
        for (field, value) in [("a", 1.03), ("epsilon", 0.03), ("omega", 2.0), ("eta", 0.92), ("alpha", 0.2)] {
            assert_eq!(answer[field].as_f64(), Some(value), "{command}: {field}");
        }
        assert_eq!(answer["normalisation"], "slender");
    }
    let slender = json("chattering-time --a 1.03 --omega 2 --eta 0.92 --format json");
    assert!(slender["alpha"].is_null() && slender["normalisation"].is_null());
    let critical = json("critical-amplitude --omega 2 --eta 0.5 --format json");
    assert_eq!((critical["omega"].as_f64(), critical["eta"].as_f64()), (Some(2.0), Some(0.5)));
    for command in [
        format!("chattering-time {flags}"),
        format!("simulate {flags} --impacts 3"),
        "critical-amplitude --omega 2 --eta 0.5".to_owned(),
        format!("response {scene}"),
        format!("plan {scene}"),
    ] {
        let line = stdout(&format!("{command} --format json-line"));
        assert!(line.ends_with('\n') && line.lines().count() == 1, "{command}: {line}");
        let one: Value = serde_json::from_str(&line).unwrap();
        assert_eq!(one, json(&format!("{command} --format json")), "{command}");
        assert!(one["omega"].is_f64() && one["eta"].is_f64(), "{command}: {line}");
    }
}

/// With hardly any damping it takes tens of thousands of impacts until a sum can be closed.
#[test]
fn auto_has_an_answer_where_a_method_has_one() {
    let case = "--epsilon 3.0077263922167954e-07 --omega 0.24472332336590433 --eta 0.9995997505111022";
    let answer = json(&format!("chattering-time {case} --oracle auto --format json"));
    let (time, off) = (answer["tau_ch"].as_f64().unwrap(), answer["uncertainty"].as_f64().unwrap());
    assert!((time - 0.2012437096360511).abs() <= off && off < 1e-6, "{time} {off}");
    // Outside of the range where errors are predicted, what the method itself claims is not left out.
    let slow = "--epsilon 0.0001417978457266572 --omega 0.017302943032268064 --eta 0.00025756917988827943";
    let answer = json(&format!("chattering-time {slow} --alpha 0.08229060117756828 --oracle auto --format json"));
    let (time, off) = (answer["tau_ch"].as_f64().unwrap(), answer["uncertainty"].as_f64().unwrap());
    assert!((time - 7.432326206025943).abs() <= off && off < 1e-9, "{time} {off}");
    // What was asked is what the document says, whatever it was turned into.
    let slender = "--a 1.03 --omega 2 --eta 0.9 --alpha 0.1 --normalisation slender --oracle auto --format json";
    let answer = json(&format!("chattering-time {slender}"));
    assert_eq!((answer["a"].as_f64(), answer["normalisation"].as_str()), (Some(1.03), Some("slender")));
}
