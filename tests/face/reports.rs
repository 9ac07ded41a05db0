//! The files that a run writes for machines and for the pages of a CI.

use std::{fs, path::Path, process::Command};

fn chattercheck(folder: &Path, arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    let output = command.args(arguments.split_whitespace()).current_dir(folder).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// A few cases, with an oracle that is known to lose the sequence.
const RED: &str =
    "verify --quiet --cases 0 --responses 0 --partition 1/6 --oracles closed-form,ode/linear/tsit45/naive";

#[test]
fn github_is_told_what_is_wrong_and_obeys_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let (status, out, _) = chattercheck(folder.path(), &format!("{RED} --format github --summary summary.md"));
    assert_eq!(status, 1);
    let lines: Vec<&str> = out.lines().collect();
    let word = lines[0].strip_prefix("::stop-commands::").unwrap();
    assert!(lines[1].starts_with("FAIL: "), "{out}");
    let end = lines.iter().position(|line| *line == format!("::{word}::")).unwrap();
    let (report, commands) = (&lines[1..end], &lines[end + 1..]);
    assert!(report.iter().any(|line| line.starts_with("FAILED ")), "{out}");
    assert!((1..=10).contains(&commands.len()), "{out}");
    for command in commands {
        assert!(command.starts_with("::error title=") && command.contains("naive"), "{out}");
    }
    let summary = fs::read_to_string(folder.path().join("summary.md")).unwrap();
    assert!(summary.starts_with("## chattercheck: FAIL\n") && summary.contains("chattercheck-replays"), "{summary}");
    let (_, out, _) = chattercheck(folder.path(), &format!("{RED} --summary -"));
    assert_eq!(out, summary, "on stdout, in place of the text");
}

/// A report over what is read, or over another file of the run, would be the end of it.
#[test]
fn no_report_is_written_over_another_file_of_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let manifest = "[[engine]]\nname = \"mine\"\nrun = [\"sh\"]\nmodel = \"linear\"\n";
    fs::write(folder.path().join("engines.toml"), manifest).unwrap();
    for option in ["json", "junit", "html", "summary"] {
        for (file, words) in [("./engines.toml", "the one that is read"), ("talk.jsonl", "that of --record")] {
            let run = format!("verify --quiet --engines engines.toml --record talk.jsonl --{option} {file}");
            let (status, out, err) = chattercheck(folder.path(), &run);
            assert_eq!((status, out.as_str(), err.lines().count()), (2, "", 1), "{err}");
            assert!(err.contains(&format!("{option} = {file}")) && err.contains(words), "{err}");
        }
    }
    assert_eq!(fs::read_to_string(folder.path().join("engines.toml")).unwrap(), manifest);
}
