//! What goes wrong around the program changes no verdict: pipes that close, disks that are full, files that are in the way.
#![cfg(unix)]

use std::{
    fs,
    path::Path,
    process::{Command, Output, Stdio},
};

const GREEN: &str = "verify --cases 0 --partition 1/40 --quiet --oracles closed-form,ode/linear/tsit45";
/// The naive mode of the ODE oracle is known to lose the sequence.
const RED: &str = "verify --cases 0 --partition 19/40 --quiet --oracles closed-form,ode/linear/tsit45/naive";
const ANSWER: &str = "chattering-time --a 1.03 --omega 2 --eta 0.92";

/// Runs the program in `folder` by a shell, which closes and redirects.
fn shell(folder: &Path, arguments: &str) -> Output {
    let line = format!("\"$PROGRAM\" {arguments}");
    let mut command = Command::new("sh");
    command.args(["-c", &line]).env("PROGRAM", env!("CARGO_BIN_EXE_chattercheck")).current_dir(folder);
    command.stdin(Stdio::null()).output().unwrap()
}

fn status(folder: &Path, arguments: &str) -> i32 {
    let output = shell(folder, arguments);
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!stderr.contains("panicked"), "{arguments}: {stderr}");
    output.status.code().unwrap()
}

#[test]
fn a_stderr_that_is_full_or_closed_changes_no_status() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, expected) in [
        (GREEN, 0),
        (RED, 1),
        (ANSWER, 0),
        ("chattering-time --a 1", 2),
        ("simulate --a 1.03 --omega 2 --eta 0.92", 0),
        ("nonsense", 2),
    ] {
        for end in ["2> /dev/full", "2>&-", "2>&1 >/dev/null | head -c 0"] {
            let piped = end.contains('|');
            let found = status(folder.path(), &format!("{arguments} {end}"));
            assert_eq!(found, if piped { 0 } else { expected }, "{arguments} {end}");
        }
    }
}

#[test]
fn a_stdout_that_is_full_is_an_error_and_a_reader_that_has_gone_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let program = env!("CARGO_BIN_EXE_chattercheck");
    let long_table = format!("response {}/data/scenes/paper_fig_9.toml", env!("CARGO_MANIFEST_DIR"));
    for (arguments, expected) in [
        (GREEN, 3),
        (RED, 1),
        (ANSWER, 3),
        ("simulate --a 1.03 --omega 2 --eta 0.92", 3),
        ("simulate --a 1.03 --omega 2 --eta 0.92 --format json", 3),
        ("oracles", 3),
        ("tolerances", 3),
        ("scene --schema", 3),
        ("--help", 3),
        ("--version", 3),
        ("verify --help", 3),
        // More than a pipe holds.
        (&long_table, 3),
    ] {
        let output = shell(folder.path(), &format!("{arguments} > /dev/full"));
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(expected), "{arguments}: {stderr}");
        assert!(stderr.contains("cannot write to stdout"), "{arguments}: {stderr}");
        // A reader that reads nothing: the status stays that of the verdict.
        let gone = format!("{{ {program} {arguments}; echo $? > status; }} | true");
        let output = Command::new("sh").args(["-c", &gone]).current_dir(folder.path()).output().unwrap();
        let told = fs::read_to_string(folder.path().join("status")).unwrap();
        assert_eq!(told.trim(), if expected == 1 { "1" } else { "0" }, "{arguments}");
        assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"), "{arguments}");
        assert!(["0", "1"].contains(&status(folder.path(), &format!("{arguments} >&-")).to_string().as_str()));
    }
}

#[test]
fn a_report_that_cannot_be_written_hides_no_verdict() {
    let folder = tempfile::tempdir().unwrap();
    for option in ["--json", "--junit"] {
        assert_eq!(status(folder.path(), &format!("{GREEN} {option} /dev/full")), 3);
        assert_eq!(status(folder.path(), &format!("{RED} {option} /dev/full")), 1);
        assert!(
            String::from_utf8_lossy(&shell(folder.path(), &format!("{RED} {option} /dev/full")).stdout)
                .contains("FAIL")
        );
        // The disk is full for so much: the file may be no longer than a block. What was there stays.
        let old = folder.path().join("report");
        fs::write(&old, "old").unwrap();
        for (arguments, expected) in [(GREEN, 3), (RED, 1)] {
            let limited = format!("trap '' XFSZ; ulimit -f 1; \"$PROGRAM\" {arguments} {option} report");
            let mut command = Command::new("sh");
            command
                .args(["-c", &limited])
                .env("PROGRAM", env!("CARGO_BIN_EXE_chattercheck"))
                .current_dir(folder.path());
            let output = command.output().unwrap();
            let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(expected), "{arguments} {option}: {stderr}");
            assert!(
                stderr.contains("cannot write report") && !stderr.contains("tmp") && !stderr.contains("out:"),
                "{stderr}"
            );
            assert_eq!(fs::read_to_string(&old).unwrap(), "old");
        }
        assert_eq!(status(folder.path(), &format!("{GREEN} {option} report")), 0);
        assert_ne!(fs::read_to_string(&old).unwrap(), "old");
    }
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(left.iter().all(|name| name == "report" || name == "chattercheck-replays"), "{left:?}");
}

#[test]
fn what_stands_in_the_way_is_said_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("folder")).unwrap();
    fs::write(at("file"), "here").unwrap();
    std::os::unix::fs::symlink("loop", at("loop")).unwrap();
    std::os::unix::fs::symlink("nowhere/at-all", at("dangling")).unwrap();
    std::os::unix::fs::symlink("file", at("link")).unwrap();
    for (options, words) in [
        ("--json both --junit both", "junit = both"),
        ("--json both --junit ./both", "another file"),
        ("--json both --junit folder/../both", "another file"),
        ("--json file --junit link", "another file"),
        ("--json - --junit -", "another file"),
        ("--json folder", "cannot write folder"),
        ("--json loop", "cannot write loop"),
        ("--json dangling", "cannot write dangling"),
        ("--json file/report", "cannot write file/report"),
        ("--json no/such/folder", "cannot write no/such/folder"),
        ("--json ''", "--json"),
        ("--replays file", "replays = file"),
        ("--replays file/under", "replays = file/under"),
        ("--replays /proc/none", "replays = /proc/none"),
        ("--replays loop", "replays = loop"),
        ("--json /proc/x", "cannot write /proc/x"),
    ] {
        // A million cases would take hours: it is found out before.
        let output = shell(folder.path(), &format!("verify --quiet --cases 1000000 {options}"));
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{options}: {stderr}");
        assert!(stderr.contains(words) && stderr.lines().count() == 1, "{options}: {stderr}");
        assert!(!stderr.contains("at path") && !stderr.contains(".tmp"), "{options}: {stderr}");
    }
    for command in ["paper", "chart", "diagnose", "reference"] {
        for out in ["file", "file/under", "loop", "/proc/none", "''"] {
            let output = shell(folder.path(), &format!("{command} --out {out}"));
            let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(2), "{command} {out}: {stderr}");
            assert!(stderr.lines().count() == 1 && stderr.contains("out"), "{command} {out}: {stderr}");
        }
    }
    assert_eq!(fs::read_to_string(at("file")).unwrap(), "here");
}

/// The program in the midst of a run that takes minutes, once it can be told to stop.
#[cfg(target_os = "linux")]
fn in_the_midst(folder: &Path, arguments: &str) -> std::process::Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    command.args(arguments.split(' ')).current_dir(folder).stdin(Stdio::null());
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let catches = || {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        u64::from_str_radix(mask.trim(), 16).unwrap() & (1 << (15 - 1)) != 0
    };
    while !catches() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    std::thread::sleep(std::time::Duration::from_millis(500));
    child
}

#[cfg(target_os = "linux")]
fn signal(child: &std::process::Child, name: &str) {
    assert!(Command::new("kill").args([name, &child.id().to_string()]).status().unwrap().success());
}

#[test]
#[cfg(target_os = "linux")]
fn a_run_that_is_interrupted_says_what_it_found_so_far() {
    for (name, oracles, expected) in [
        ("-TERM", "closed-form,ode/linear/tsit45", 3),
        ("-INT", "closed-form,ode/linear/tsit45", 3),
        ("-TERM", "closed-form,ode/linear/tsit45/naive", 1),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let arguments = format!("verify --cases 40000 --responses 1000 --quiet --oracles {oracles} --json j --junit x");
        let child = in_the_midst(folder.path(), &arguments);
        signal(&child, name);
        let output = child.wait_with_output().unwrap();
        let (stdout, stderr) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
        assert_eq!(output.status.code(), Some(expected), "{stdout}{stderr}");
        assert!(stdout.contains("SHORTFALL: interrupted after") && stdout.contains("partial"), "{stdout}");
        let report: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(folder.path().join("j")).unwrap()).unwrap();
        let number = |pointer: &str| report.pointer(pointer).unwrap().as_u64().unwrap();
        let (handed, examined) = (number("/accounted/handed/cases"), number("/accounted/examined/cases"));
        let left_out = report["left_out"].as_array().unwrap().len() as u64;
        assert!(examined > 0 && left_out > 0 && examined + left_out == handed, "{examined} {left_out} {handed}");
        assert_eq!(report["shortfalls"][0]["kind"], "interrupted");
        let xml = fs::read_to_string(folder.path().join("x")).unwrap();
        assert_eq!(xml.matches("<skipped").count() as u64, left_out + 1000);
        assert!(expected != 1 || fs::read_dir(folder.path().join("chattercheck-replays")).unwrap().count() > 0);
    }
}

#[test]
fn a_report_goes_through_links_and_to_stdout() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "old").unwrap();
    std::os::unix::fs::symlink("file", folder.path().join("link")).unwrap();
    assert_eq!(status(folder.path(), &format!("{GREEN} --json link")), 0);
    assert!(fs::symlink_metadata(folder.path().join("link")).unwrap().is_symlink());
    let through: serde_json::Value = serde_json::from_slice(&fs::read(folder.path().join("file")).unwrap()).unwrap();
    for stdout in ["-", "/dev/stdout > printed; cat printed"] {
        let output = shell(folder.path(), &format!("{GREEN} --json {stdout}"));
        let text = String::from_utf8(output.stdout).unwrap();
        let json = text.split_once('{').map(|(_, rest)| format!("{{{rest}")).unwrap();
        let mut documents = serde_json::Deserializer::from_str(&json).into_iter::<serde_json::Value>();
        assert_eq!(documents.next().unwrap().unwrap(), through, "{stdout}");
    }
}

/// A folder with the table of one of the parts of `chart`.
fn folder_with_table() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/record/work_precision/work_precision.csv");
    fs::copy(table, folder.path().join("work_precision.csv")).unwrap();
    folder
}

/// The disk is as full for the files of a study as for those of a report.
#[test]
fn a_study_on_a_full_disk_is_the_fault_of_the_machine() {
    let folder = folder_with_table();
    let limited = "trap '' XFSZ; ulimit -f 1; \"$PROGRAM\" chart --redraw --only work-precision --out .";
    let mut command = Command::new("sh");
    command.args(["-c", limited]).env("PROGRAM", env!("CARGO_BIN_EXE_chattercheck")).current_dir(folder.path());
    let output = command.output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), output.stdout.len()), (Some(3), 0), "{stderr}");
    assert!(stderr.contains("cannot write ./work_") && !stderr.contains("out:"), "{stderr}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// A chart that can't be drawn for want of its table is known before the first one is.
#[test]
fn charts_are_drawn_again_all_or_none() {
    let folder = folder_with_table();
    let output = shell(folder.path(), "chart --redraw --out .");
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{stderr}");
    assert!(stderr.contains("atlas"), "{stderr}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    for (text, words) in
        [("share,epsilon\n1\n", "line 2: columns = 1 are outside the allowed: 2"), ("", "there are none")]
    {
        fs::write(folder.path().join("work_precision.csv"), text).unwrap();
        let output = shell(folder.path(), "chart --redraw --only work-precision --out .");
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && stderr.contains(words), "{stderr}");
    }
}

/// What a run says to run again is its own failure, whatever another run leaves in the same folder.
#[test]
fn runs_do_not_overwrite_the_replays_of_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let replays = folder.path().join("chattercheck-replays");
    let files = || -> std::collections::BTreeMap<_, String> {
        let all = fs::read_dir(&replays).unwrap().map(|entry| entry.unwrap().path());
        all.map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
    };
    assert_eq!(status(folder.path(), RED), 1);
    let first = files();
    assert!(first.keys().any(|path| path.ends_with("seed-1-part-19-of-40-1.toml")), "{first:?}");
    let output = shell(folder.path(), &RED.replace("closed-form,", "ode/linear/tsit45,"));
    assert_eq!(output.status.code(), Some(1));
    let both = files();
    assert!(both.len() > first.len() && first.iter().all(|(path, text)| both.get(path) == Some(text)), "{both:?}");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    let again = told.lines().find_map(|line| line.trim().strip_prefix("run again: chattercheck replay ")).unwrap();
    assert!(!first.contains_key(&folder.path().join(again)), "{told}");
    // The same run again finds what it left.
    assert_eq!(status(folder.path(), RED), 1);
    assert_eq!(files(), both);
}

#[test]
fn partitions_do_not_overwrite_the_replays_of_each_other() {
    let folder = tempfile::tempdir().unwrap();
    for part in 19..=20 {
        let partition = format!("{part}/40");
        assert_eq!(status(folder.path(), &RED.replace("19/40", &partition)), 1);
    }
    let names: Vec<String> = fs::read_dir(folder.path().join("chattercheck-replays"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    for part in ["part-19-of-40", "part-20-of-40"] {
        assert!(names.iter().any(|name| name.contains(part)), "{names:?}");
    }
}

#[test]
fn an_empty_seed_is_none_and_a_wrong_one_is_named() {
    let run = |seed: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
        command.args(GREEN.split_whitespace()).env("CHATTERCHECK_SEED", seed).output().unwrap()
    };
    let told = |output: &Output| String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told(&run("")).contains("seed 1"));
    assert!(told(&run("7")).contains("seed 7"));
    for wrong in ["x", "-1", " ", "1e3", "18446744073709551616"] {
        let output = run(wrong);
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{wrong}: {stderr}");
        assert!(
            stderr.contains(&format!("CHATTERCHECK_SEED = {wrong}")) && stderr.contains("whole number"),
            "{stderr}"
        );
    }
}
