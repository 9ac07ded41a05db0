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

/// A report or a record over what is read, or over another file of the run, would be the end of it: the manifest, the cases, the files that an engine is made of.
#[test]
fn no_report_is_written_over_another_file_of_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let manifest = "[[engine]]\nname = \"mine\"\nrun = [\"sh\", \"engine.sh\"]\nversion = { command = [\"sh\", \"version.sh\"] }\n\
                    model = \"linear\"\n";
    let case = "[[case]]\nname = \"one\"\na = 1.03\nomega = 2\neta = 0.92\n";
    let read = [
        ("engines.toml", manifest),
        ("case.toml", case),
        ("other.toml", &case.replace("one", "other")),
        ("engine.sh", "exit 5"),
        ("version.sh", "echo 1"),
    ];
    for (file, text) in read {
        fs::write(folder.path().join(file), text).unwrap();
    }
    let run = "verify --quiet --engines engines.toml --cases 0 --case-file case.toml --case-file other.toml";
    let refused = |option: &str, file: &str, record: &str, words: &str| {
        let (status, out, err) = chattercheck(folder.path(), &format!("{run} {record} --{option} {file}"));
        assert_eq!((status, out.as_str(), err.lines().count()), (2, "", 1), "{option} {file}: {err}");
        assert!(err.contains(&format!("{option} = {file}")) && err.contains(words), "{err}");
    };
    for option in ["json", "junit", "html", "summary", "record"] {
        for (file, _) in read {
            refused(option, &format!("./{file}"), "", "another file than one that is read");
        }
    }
    for option in ["json", "junit", "html", "summary"] {
        refused(option, "talk.jsonl", "--record talk.jsonl", "another file than that of --record");
    }
    for (file, text) in read {
        assert_eq!(fs::read_to_string(folder.path().join(file)).unwrap(), text, "{file}");
    }
    // The tables of the charts have the names that rows of peers may have.
    fs::write(folder.path().join("peers.csv"), "").unwrap();
    let (status, _, err) = chattercheck(folder.path(), "chart --only work-precision --out . --peers peers.csv");
    assert_eq!(status, 2);
    assert!(err.contains("peers = peers.csv is outside the allowed range: a file outside of --out"), "{err}");
}
