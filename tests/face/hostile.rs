//! Hostile input gets one line that says what is wrong, status 2, and no panic: numbers that are none, files that are something else, endless texts.

use std::{
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// Words of a programmer, which mean nothing to who wrote a scene.
const JARGON: [&str; 14] = [
    "f64",
    "i64",
    "u64",
    "usize",
    "variant",
    "target type",
    "struct",
    "invalid digit",
    "expected ",
    "sequence",
    "literal",
    "panicked",
    "stream did not",
    "RUST_BACKTRACE",
];

/// Runs the program, which has to refuse in one plain line with all of `words`; the line.
fn refused<Argument: Into<OsString> + Clone>(arguments: &[Argument], words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_chattercheck"))
        .args(arguments.iter().cloned().map(Into::into))
        .output()
        .unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!((output.status.code(), output.stdout.len(), stderr.lines().count()), (Some(2), 0, 1), "{stderr}");
    assert!(stderr.chars().count() < 700 && !stderr.trim_end().contains(char::is_control), "{stderr:?}");
    let jargon = JARGON.iter().find(|word| stderr.contains(**word));
    assert!(jargon.is_none(), "{jargon:?}: {stderr}");
    assert!(words.iter().all(|word| stderr.contains(word)), "{words:?}: {stderr}");
    stderr
}

#[test]
fn what_is_not_a_number_or_not_the_one_that_is_typed_is_refused() {
    let long = "9".repeat(100_000);
    for value in [
        "1,03",
        "1e400",
        "1e-400",
        "−1",
        "0x1p0",
        "1_000",
        " ",
        "",
        "NaN",
        "-inf",
        "1.03f",
        "١",
        "1.03e",
        "9e99",
        "1.03\n",
        "\u{1b}[31m1",
        &long,
    ] {
        for flag in ["--a", "--omega", "--eta", "--alpha", "--until"] {
            let mut arguments = vec!["chattering-time", flag, value];
            let others = [("--a", "1.01"), ("--omega", "2"), ("--eta", "0.9")];
            arguments
                .extend(others.into_iter().filter(|(name, _)| *name != flag).flat_map(|(name, value)| [name, value]));
            // A frequency or a time of 9e99 is for the method to refuse.
            if value == "9e99" && flag == "--until" {
                continue;
            }
            refused(&arguments, &[flag.trim_start_matches('-')]);
        }
    }
    for (flag, value) in [
        ("--impacts", "1.5"),
        ("--impacts", "18446744073709551616"),
        ("--impacts", "-1"),
        ("--digits", "99999999999999999999"),
        ("--digits", "1e3"),
        ("--order", "-1"),
        ("--order", "1e3"),
        ("--order", "99999999999999999999"),
        ("--rtol", "0"),
        ("--tolerance", "nan"),
        ("--oracle", "\u{1b}[31mred"),
        ("--oracle", ""),
        ("--oracle", &long),
        ("--format", "xml"),
        ("--normalisation", "slender"),
    ] {
        let case = ["chattering-time", "--a", "1.01", "--omega", "2", "--eta", "0.9"];
        refused(&[&case[..], &[flag, value]].concat(), &[flag.trim_start_matches('-')]);
    }
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/paper_fig_9.toml");
    let prose = concat!(env!("CARGO_MANIFEST_DIR"), "/LICENSE-MIT");
    for (command, option, value, range) in [
        ("verify", "--cases", "1e6", "0 to 1000000"),
        ("verify", "--cases", "-1", "0 to 1000000"),
        ("verify", "--cases", "99999999999999999999", "0 to 1000000"),
        ("verify", "--responses", "-1", "0 to 1000000"),
        ("verify", "--responses", "99999999999999999999", "0 to 1000000"),
        ("verify", "--judge", "99999999999999999999", "all, or N >= 1"),
        ("verify", "--partition", "1/99999999999999999999", "1 <= K <= N"),
        ("verify", "--partition", "-1/3", "1 <= K <= N"),
        ("verify", "--partition", "1", "1 <= K <= N"),
        ("verify", "--oracles", ",", "oracles = (empty)"),
        ("verify", "--oracles", "", "oracles"),
        ("verify", "--seed", "1.5", "0 to 18446744073709551615"),
        ("response", "--steps", "-1", "1 to 1000000"),
        ("response", "--to", "1e300", "up to the end of the response"),
        ("response", "--condition", "eq76", "condition = eq76 is outside"),
        ("diagnose", "--grid", "1e3", "1 to 200"),
        ("diagnose", "--eta", "0.9,,0.8", "eta"),
        ("diagnose", "--eta", "0.9, 2", "eta = 2"),
        ("chart", "--peers", "/dev/null", "peers"),
        ("chart", "--peers", prose, "share, epsilon, family"),
    ] {
        let mut arguments = vec![command, option, value];
        match command {
            "response" => arguments.push(scene),
            "verify" => {}
            _ => arguments.push("--out=none"),
        }
        refused(&arguments, &[option.trim_start_matches('-'), range]);
    }
    let one = ["chattering-time", "--omega", "2", "--eta", "0.9"];
    refused(&one, &["--a <A>", "--epsilon", "--scene FILE"]);
    assert!(!Path::new("none").exists());
}

const SCENE: &str = "[block]\nhalf_width = 0.2\nhalf_height = 1.1\nrestitution = 0.9\n[ground]\namplitude = { g = 0.19 }\nfrequency = { hz = 1.5 }\n";

#[test]
fn a_scene_that_is_none_is_refused_by_every_command_that_reads_one() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, bytes: &[u8]| -> PathBuf {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let mut noise = Vec::new();
    noise.extend((0..5000_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 13) as u8));
    let mut files = vec![
        put("empty", b""),
        put("binary", &noise),
        put("utf-16", &SCENE.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>()),
        put("brackets", &vec![b'['; 10_000_000]),
        put("deep", format!("a = {}", "[".repeat(100_000)).as_bytes()),
        put("dotted", "a.".repeat(100_000).as_bytes()),
        put("long", format!("title = \"{}\"", "x".repeat(1 << 20)).as_bytes()),
        put("json", br#"{ "block": { "half_width": 0.2 } }"#),
        put("cr", SCENE.replace('\n', "\r").as_bytes()),
        put("twice", format!("{SCENE}{SCENE}").as_bytes()),
        folder.path().to_owned(),
        folder.path().join("not-there"),
        PathBuf::from("/dev/null"),
        PathBuf::new(),
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("loop", folder.path().join("loop")).unwrap();
        files.push(folder.path().join("loop"));
    }
    for file in &files {
        let file = file.as_os_str();
        for command in ["scene", "response", "plan", "replay"] {
            refused(&[OsString::from(command), file.to_owned()], &[]);
        }
        for command in ["chattering-time", "simulate"] {
            refused(&[OsString::from(command), "--scene".into(), file.to_owned()], &[]);
        }
    }
}

#[test]
fn a_scene_as_other_systems_write_it_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let plain = folder.path().join("plain");
    fs::write(&plain, SCENE).unwrap();
    let answer = |path: &Path| {
        let output = Command::new(env!("CARGO_BIN_EXE_chattercheck")).arg("scene").arg(path).output().unwrap();
        assert!(output.status.success());
        output.stdout
    };
    for (name, text) in [("bom", format!("\u{feff}{SCENE}")), ("crlf", SCENE.replace('\n', "\r\n"))] {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        assert_eq!(answer(&path), answer(&plain), "{name}");
    }
}

#[test]
fn a_scene_with_something_wrong_names_line_field_and_what_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    for (from, to, words) in [
        ("half_width = 0.2", "half_width = true", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = 0,2", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = 0.2 m", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = −0.2", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = 1e400", ["line 2", "half_width", "too large"]),
        ("half_width = 0.2", "half_width = -0.0", ["line 2", "half_width = -0.0", "metres"]),
        ("half_width = 0.2", "half_width = [1]", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = { m = 1 }", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = 2020-01-01", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = ", ["line 2", "half_width", "metres"]),
        ("half_width = 0.2", "half_width = 0.2\nhalf_width = 0.3", ["line 3", "half_width", "twice"]),
        ("half_width = 0.2", "halfwidth = 0.2", ["line 2", "halfwidth", "perhaps half_width"]),
        ("restitution = 0.9", "restitution = \"housener\"", ["line 4", "restitution", "housner"]),
        ("amplitude = { g = 0.19 }", "amplitude = 0.19", ["line 6", "amplitude", "{ g = number }"]),
        ("amplitude = { g = 0.19 }", "amplitude = { g = \"0.19\" }", ["line 6", "amplitude", "{ g = number }"]),
        ("frequency = { hz = 1.5 }", "frequency = \"1.5 Hz\"", ["line 7", "frequency", "{ hz = number }"]),
        ("frequency = { hz = 1.5 }", "frequency = 1.5 Hz", ["line 7", "frequency", "{ hz = number }"]),
        ("[block]", "title = 3\n[block]", ["line 1", "title", "text"]),
        ("[block]", "[[block]]", ["line 1", "block", "table"]),
        ("[ground]", "[ground", ["line 5", "ground", "table"]),
        ("[block]", "block = 3\n[blocks]", ["line 1", "block", "table"]),
        (
            "frequency = { hz = 1.5 }",
            "frequency = { hz = 1.5 }\n[ask]\nimpacts = 1.5",
            ["line 9", "impacts", "1 to 1000000"],
        ),
        ("frequency = { hz = 1.5 }", "frequency = { hz = 1.5 }\n[ask]\nwhat = []", ["line 9", "what", "at least one"]),
        ("frequency = { hz = 1.5 }", "frequency = { hz = 1.5 }\n[ask]\nmodel = 3", ["line 9", "model", "linear"]),
        (
            "frequency = { hz = 1.5 }",
            "frequency = { hz = 1.5 }\n[ask]\nwhat = [\n\"chattering-time\",\n\"foo\"\n]",
            ["line 11: what", "allowed is", "foo"],
        ),
        (
            "half_width = 0.2\nhalf_height = 1.1\nrestitution = 0.9",
            "half_width = 1e-6\nhalf_height = 1e6\nrestitution = \"housner\"",
            ["restitution = 1", "below 1", "slenderness > 6.1e-9"],
        ),
        (
            "frequency = { hz = 1.5 }",
            "frequency = { hz = 1.5 }\n[ask]\ntolerance = \"tight\"",
            ["line 9", "tolerance", "1e-15"],
        ),
    ] {
        assert!(SCENE.contains(from));
        fs::write(&path, SCENE.replace(from, to)).unwrap();
        refused(&["scene", path.to_str().unwrap()], &words);
    }
}

/// A report over the file that is run again would be the end of it.
#[test]
fn a_report_is_not_written_over_the_replay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    std::fs::write(&path, "kept").unwrap();
    let path = path.to_str().unwrap();
    for option in ["--json", "--junit", "--html", "--summary"] {
        refused(&["replay", path, option, path], &[option.trim_start_matches('-'), "replay.toml", "another file"]);
    }
    assert_eq!(std::fs::read_to_string(path).unwrap(), "kept");
}

#[test]
fn a_replay_of_another_version_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("replay.toml");
    fs::write(&path, "version = \"0.0.9\"\nfound_in = \"list/x\"\nfault = \"seen\"\n").unwrap();
    refused(&["replay", path.to_str().unwrap()], &["0.0.9", "not by 0."]);
}
