//! A run in parts is the run in one piece, byte for byte; and parts that are not the parts of one run are not merged.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    sync::LazyLock,
    thread,
    time::Duration,
};

/// The naive mode of the ODE oracle is known to lose the sequence.
const RED: &str =
    "verify --cases 12 --seed 3 --judge 50 --responses 12 --quiet --oracles closed-form,taylor,ode/linear/tsit45/naive";

/// A few cases, of which one goes wrong.
const FEW: &str =
    "verify --cases 0 --case-file mine.toml --responses 2 --quiet --oracles closed-form,taylor,ode/linear/tsit45/naive";

fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chattercheck"));
    command.args(arguments.split_whitespace()).current_dir(folder);
    command
}

fn chattercheck(folder: &Path, arguments: &str) -> (i32, String, String) {
    let output = command(folder, arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// Runs every part of a run.
fn run_parts(folder: &Path, run: &str, parts: usize, out: &str) {
    for part in 1..=parts {
        let (status, text, err) = chattercheck(folder, &format!("{run} --partition {part}/{parts} --out {out}"));
        assert!(status < 2 && text.contains(&format!("part         {part} of {parts}: {out}/part-")), "{text}{err}");
    }
}

/// A folder with own cases, and the parts of the run of them in `parts`.
static PARTS: LazyLock<tempfile::TempDir> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let case = |(name, epsilon): (&str, &str)| {
        format!("[[case]]\nname = {name:?}\nepsilon = {epsilon}\nomega = 3.0\neta = 0.8\nalpha = 0.2\nimpacts = 30\n")
    };
    let cases = [("one", "0.01"), ("two", "0.02"), ("three", "1e-6"), ("still", "-0.5")].map(case).concat();
    fs::write(folder.path().join("mine.toml"), cases).unwrap();
    run_parts(folder.path(), FEW, 3, "parts");
    folder
});

/// A copy of that folder, to be spoiled.
fn parts() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("parts")).unwrap();
    for name in ["mine.toml", "parts/part-1-of-3.jsonl", "parts/part-2-of-3.jsonl", "parts/part-3-of-3.jsonl"] {
        fs::copy(PARTS.path().join(name), folder.path().join(name)).unwrap();
    }
    folder
}

#[test]
fn merged_parts_are_the_run_in_one_piece() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let one = chattercheck(folder, &format!("{RED} --full --json one.json --summary one.md --junit one.xml"));
    assert_eq!(one.0, 1);
    assert!(one.1.contains("FAILED ") && one.1.contains("12 random"), "{}", one.1);
    for parts in [3, 7] {
        let out = format!("of-{parts}");
        run_parts(folder, RED, parts, &out);
        let merged =
            chattercheck(folder, &format!("merge {out} --full --json all.json --summary all.md --junit all.xml"));
        assert_eq!((merged.0, merged.2.as_str()), (1, ""), "{parts}");
        assert!(merged.1 == one.1, "{parts}:\n{}\n{}", one.1, merged.1);
        assert!(read("all.json") == read("one.json") && read("all.md") == read("one.md"), "{parts}");
        // But for the times that were measured.
        let untimed = |name: &str| {
            let text = read(name);
            let pieces = text.split(" time=\"");
            pieces
                .map(|piece| piece.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').to_owned())
                .collect::<String>()
        };
        assert!(untimed("all.xml") == untimed("one.xml"), "{parts}");
        let times = |name: &str| read(name).matches(" time=\"").count();
        assert_eq!(times("all.xml"), times("one.xml"));
    }
    // Replay files of parts bear their names.
    let replays = fs::read_dir(folder.join("chattercheck-replays")).unwrap();
    let names: Vec<String> = replays.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert!(names.iter().any(|name| name.contains("-of-7-")), "{names:?}");
}

/// Where everything is as it should be, the merge says what the run says, wherever the parts are.
#[test]
fn a_few_own_cases_are_dealt_too() {
    let folder = parts();
    let folder = folder.path();
    let one = chattercheck(folder, FEW);
    assert_eq!(chattercheck(folder, "merge parts"), (1, one.1.clone(), String::new()));
    // As CIs lay them down, each in a folder of its own; what is beside them is no matter.
    fs::create_dir(folder.join("parts/second")).unwrap();
    fs::rename(folder.join("parts/part-2-of-3.jsonl"), folder.join("parts/second/part-2-of-3.jsonl")).unwrap();
    fs::write(folder.join("parts/notes.txt"), "x").unwrap();
    assert_eq!(chattercheck(folder, "merge parts").1, one.1);
    // More parts than there is to do: the empty ones are parts, too.
    run_parts(folder, FEW, 9, "many");
    assert_eq!(chattercheck(folder, "merge many").1, one.1);
}

#[test]
fn what_is_not_one_run_is_not_merged() {
    type Spoil = fn(&Path, &Path);
    let spoils: &[(&str, Spoil, &[&str])] = &[
        (
            "a gap",
            |_, parts| fs::remove_file(parts.join("part-2-of-3.jsonl")).unwrap(),
            &["part 2 of 3 is missing: run it with the options of the others and --partition 2/3 --out parts"],
        ),
        (
            "an overlap",
            |_, parts| _ = fs::copy(parts.join("part-2-of-3.jsonl"), parts.join("part-9-of-9.jsonl")).unwrap(),
            &["parts/part-9-of-9.jsonl: it is part 2 of 3, and so is parts/part-2-of-3.jsonl; delete one of them"],
        ),
        (
            "another seed",
            |folder, parts| replace(folder, parts, &format!("{FEW} --seed 2 --partition 2/3")),
            &[
                "parts/part-2-of-3.jsonl: it is of another run than parts/part-1-of-3.jsonl: seed: 2 here, 1 there",
                "part 2 of 3 is missing",
            ],
        ),
        (
            "other options",
            |folder, parts| replace(folder, parts, &format!("{} --partition 2/3", FEW.replace("taylor,", ""))),
            &["parts/part-2-of-3.jsonl: it is of another run", "oracles: closed-form,ode/linear/tsit45/naive here"],
        ),
        (
            "other parts",
            |folder, parts| {
                run_parts(folder, FEW, 2, "two");
                fs::copy(folder.join("two/part-2-of-2.jsonl"), parts.join("part-2-of-2.jsonl")).unwrap();
            },
            &["parts/part-2-of-2.jsonl: it is of another run", "partition: of 2 here, of 3 there"],
        ),
        (
            "a truncated file",
            |_, parts| {
                let text = fs::read(parts.join("part-2-of-3.jsonl")).unwrap();
                fs::write(parts.join("part-2-of-3.jsonl"), &text[..text.len() - 100]).unwrap();
            },
            &[
                "parts/part-2-of-3.jsonl: it ends before its end",
                "delete it and run this part again",
                "part 2 of 3 is missing",
            ],
        ),
        (
            "a flipped byte",
            |_, parts| {
                let mut text = fs::read(parts.join("part-2-of-3.jsonl")).unwrap();
                text[1000] ^= 1;
                fs::write(parts.join("part-2-of-3.jsonl"), text).unwrap();
            },
            &["parts/part-2-of-3.jsonl: it is damaged", "checksum"],
        ),
        (
            "a file of another version",
            |_, parts| {
                let path = parts.join("part-2-of-3.jsonl");
                let lines = chattercheck::stored::read(&path, "part").unwrap();
                let old = lines.iter().map(|line| line.replace(env!("CARGO_PKG_VERSION"), "0.0.9")).collect::<Vec<_>>();
                fs::remove_file(&path).unwrap();
                chattercheck::stored::put(&path, "part", &old).unwrap();
            },
            &["parts/part-2-of-3.jsonl: version 0.0.9 wrote it, this is version"],
        ),
        (
            "something else",
            |_, parts| fs::write(parts.join("part-2-of-3.jsonl"), "{}\n").unwrap(),
            &["parts/part-2-of-3.jsonl: it is something else"],
        ),
    ];
    for (what, spoil, told) in spoils {
        let folder = parts();
        let folder = folder.path();
        spoil(folder, &folder.join("parts"));
        let (status, out, err) = chattercheck(folder, "merge parts --json all.json");
        assert_eq!((status, out.as_str()), (2, ""), "{what}: {err}");
        assert!(told.iter().all(|words| err.contains(words)), "{what}: {err}");
        assert!(!folder.join("all.json").exists());
    }
    let folder = parts();
    assert_eq!(chattercheck(folder.path(), "merge .").0, 1);
    let (status, _, err) = chattercheck(folder.path(), "merge parts --json parts/part-1-of-3.jsonl");
    assert!(
        status == 2 && err.contains("json = parts/part-1-of-3.jsonl") && err.contains("a part of the run"),
        "{err}"
    );
    fs::create_dir(folder.path().join("empty")).unwrap();
    let (status, _, err) = chattercheck(folder.path(), "merge empty");
    assert!(status == 4 && err.contains("nothing ran"), "{err}");
    let (status, _, err) = chattercheck(folder.path(), "merge nowhere");
    assert!(status == 2 && err.contains("nowhere"), "{err}");
}

/// Puts the part of another run in the place of the second.
fn replace(folder: &Path, parts: &Path, run: &str) {
    let (status, _, err) = chattercheck(folder, &format!("{run} --out other"));
    assert!(status < 2, "{err}");
    fs::rename(folder.join("other/part-2-of-3.jsonl"), parts.join("part-2-of-3.jsonl")).unwrap();
}

/// What is there, whole and of the same request, is not done again; anything else is refused and left as it is.
#[test]
fn a_part_that_is_there_is_not_run_again_or_written_over() {
    let folder = parts();
    let folder = folder.path();
    let path = folder.join("parts/part-3-of-3.jsonl");
    let before = fs::read(&path).unwrap();
    let again = format!("{FEW} --partition 3/3 --out parts");
    let (status, out, err) = chattercheck(folder, &again);
    assert!(err.contains("parts/part-3-of-3.jsonl is there, whole and of this request: not run again"), "{err}");
    fs::rename(&path, folder.join("first")).unwrap();
    assert_eq!(chattercheck(folder, &again), (status, out, String::new()), "as the first time");
    fs::copy(folder.join("first"), &path).unwrap();
    let (status, out, err) = chattercheck(folder, &format!("{again} --seed 2"));
    assert_eq!((status, out.as_str(), err.lines().count()), (2, "", 1), "{err}");
    assert!(err.contains("seed: 1 there, 2 asked"), "{err}");
    assert_eq!(fs::read(&path).unwrap(), before);
    fs::write(&path, &before[..before.len() / 2]).unwrap();
    let (status, _, err) = chattercheck(folder, &again);
    assert!(status == 2 && err.contains("is not written over") && err.contains("ends before its end"), "{err}");
    assert_eq!(fs::read(&path).unwrap().len(), before.len() / 2);
}

fn names(folder: &Path) -> Vec<PathBuf> {
    fs::read_dir(folder).map(|all| all.map(|entry| entry.unwrap().path()).collect()).unwrap_or_default()
}

/// Killed while it runs, it leaves nothing under the name of a part. That a file is never half there is for the tests of `stored` to see.
#[test]
fn what_is_killed_leaves_no_half_part() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = "verify --cases 50 --judge 5 --responses 0 --quiet --oracles closed-form,taylor --out parts";
    let mut child = command(folder, run).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    thread::sleep(Duration::from_millis(400));
    assert!(child.try_wait().unwrap().is_none(), "too short to be killed");
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(names(&folder.join("parts")).iter().all(|path| !path.ends_with("part-1-of-1.jsonl")));
}

/// An interruption leaves none either: a part is of all its cases.
#[test]
fn what_is_interrupted_is_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = "verify --cases 50 --judge 5 --responses 0 --quiet --oracles closed-form,taylor --out parts";
    let child = command(folder, run).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    thread::sleep(Duration::from_millis(400));
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &pid]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let out = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(3), "{out}");
    assert!(out.contains("this part is not kept"), "{out}");
    assert_eq!(names(&folder.join("parts")), Vec::<PathBuf>::new());
}

/// Two processes that run the same part at once: both are well, and there is one whole file.
#[test]
fn two_may_run_the_same_part_at_once() {
    let folder = parts();
    let folder = folder.path();
    let run = format!("{FEW} --partition 2/3 --out at-once");
    let both = [0; 2].map(|_| command(folder, &run).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap());
    let both = both.map(|child| child.wait_with_output().unwrap());
    assert_eq!(both[0].status.code(), both[1].status.code());
    assert!(both[0].status.code().unwrap() < 2, "{both:?}");
    assert_eq!(names(&folder.join("at-once")), [folder.join("at-once/part-2-of-3.jsonl")]);
    fs::rename(folder.join("at-once/part-2-of-3.jsonl"), folder.join("parts/part-2-of-3.jsonl")).unwrap();
    assert_eq!(chattercheck(folder, "merge parts").0, 1);
}
