//! Cases of users' own: which run, beside which others; the list of what would run; and a run in which nothing does.

use std::{fs, path::Path, process::Command};

const CASES: &str = r#"
[[case]]
name = "my block"
why = "the one in the lab"
a = 1.03
omega = 2.0
eta = 0.92
alpha = 0.1

[[case]]
name = "weak"
epsilon = 1e-6
omega = 3
eta = 0.8
alpha = 0.2
impacts = 30
"#;

fn chattercheck(folder: &Path, arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    let output = command.args(arguments.split_whitespace()).current_dir(folder).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), CASES).unwrap();
    fs::write(folder.path().join("more.toml"), CASES.replace("my block", "other").replace("weak", "weaker")).unwrap();
    folder
}

/// Each by its name and the flags that ask for it again.
#[test]
fn the_list_has_every_case_of_the_run_and_the_flags_ask_for_it() {
    let folder = folder();
    let list = |arguments: &str| {
        let (status, out, err) = chattercheck(folder.path(), &format!("verify --list {arguments}"));
        assert_eq!((status, err.as_str()), (0, ""), "{arguments}");
        out.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let mine = list("--cases 0 --case-file mine.toml");
    assert_eq!(
        mine,
        [
            "own/my block\t--epsilon 0.030000000000000027 --omega 2.0 --eta 0.92 --impacts 60 --alpha 0.1 --normalisation threshold",
            "own/weak\t--epsilon 1e-6 --omega 3.0 --eta 0.8 --impacts 30 --alpha 0.2 --normalisation threshold",
        ]
    );
    let flags = mine[1].split('\t').nth(1).unwrap();
    let (status, out, _) = chattercheck(folder.path(), &format!("simulate {flags} --oracle taylor"));
    assert_eq!((status, out.lines().count()), (0, 32));
    // Beside the others, first.
    let all = list("--cases 3 --seed 7 --case-file mine.toml --case-file more.toml");
    let without = list("--cases 3 --seed 7");
    assert_eq!((&all[4..], all[3].split('\t').next()), (&without[..], Some("own/weaker")));
    assert!(without.len() > 200 && without != list("--cases 3 --seed 8"));
    // The shares of a run are the run.
    let mut shares: Vec<String> =
        (1..=3).flat_map(|part| list(&format!("--cases 3 --seed 7 --partition {part}/3"))).collect();
    shares.sort_by_key(|line| without.iter().position(|other| other == line));
    assert_eq!(shares, without);
}

/// With `--cases 0` they are all that is run: each is judged, and the run has to prove nothing else.
#[test]
fn own_cases_alone_are_a_run() {
    let folder = folder();
    let run = "verify --quiet --cases 0 --case-file mine.toml --oracles closed-form,taylor --json report.json";
    let (status, out, err) = chattercheck(folder.path(), run);
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    assert!(out.starts_with("PASS: 2 oracles agree on 2 cases") && out.contains("2 own\n"), "{out}");
    let report: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("report.json")).unwrap()).unwrap();
    assert_eq!((&report["judged"]["cases"], &report["reach"]["by_generator"]["own"]), (&2.into(), &2.into()));
    let (status, out, _) =
        chattercheck(folder.path(), &run.replace("closed-form,taylor", "closed-form,ode/linear/tsit45/naive"));
    assert!(status == 1 && out.contains("FAILED own/weak"), "{out}");
}

#[test]
fn what_is_wrong_with_a_file_is_named_with_its_line() {
    let folder = folder();
    for (text, told) in [
        (CASES.replace("eta = 0.92", "eta = 1.20"), "mine.toml: line 7: eta = 1.20 is outside the allowed range: "),
        (CASES.replace("weak", "my block"), "mine.toml: line 11: name = \"my block\" is that of the case in line 3"),
        (CASES.replace("alpha = 0.1", "colour = 3"), "mine.toml: line 8: colour is not known here"),
        ("# none\n".to_owned(), "mine.toml: no case is in it"),
        ("a = 1.03".to_owned(), "mine.toml: line 1: a is not known here"),
    ] {
        fs::write(folder.path().join("mine.toml"), text).unwrap();
        let (status, out, err) = chattercheck(folder.path(), "verify --cases 0 --case-file mine.toml");
        assert_eq!((status, out.as_str(), err.lines().count()), (2, "", 1), "{err}");
        assert!(err.contains(told), "{err}");
    }
    let twice = "verify --case-file more.toml --case-file ./more.toml";
    let (status, _, err) = chattercheck(folder.path(), twice);
    assert!(
        status == 2 && err.contains("./more.toml: line 3: name = \"other\" is that of a case in more.toml"),
        "{err}"
    );
    let (status, _, err) = chattercheck(folder.path(), "verify --case-file none.toml");
    assert!(status == 2 && err.contains("cannot read none.toml"), "{err}");
}

#[test]
fn a_share_without_anything_in_it_ran_nothing() {
    let folder = folder();
    for list in ["", "--list"] {
        let (status, out, err) =
            chattercheck(folder.path(), &format!("verify --cases 0 --case-file mine.toml --partition 3/3 {list}"));
        assert_eq!((status, out.as_str(), err.lines().count()), (4, "", 1), "{list}");
        assert!(err.contains("nothing of the run falls to part 3/3"), "{err}");
    }
}
