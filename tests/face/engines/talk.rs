//! `engine check` and `engine ask`: what is wrong with an engine, and what was said.

use super::{answering, chattercheck, shell};

#[test]
fn what_is_wrong_is_said_in_words() {
    for (script, more, expected, words) in [
        (
            answering(r#""history":{"time":[0.5],"velocity":[0.1],"ending":"at-rest"}"#),
            "",
            1,
            &[
                "WRONG rest",
                "mine is WRONG on interval, first at impact 1: 0.5, proven 0.8",
                "hint  errors",
                "hint  intervals",
                "hint  decline",
            ][..],
        ),
        (
            answering(r#""decline":{"reason":"on holiday"}"#),
            "tolerance = { interval = 1e-9, reason = \"mine\" }",
            4,
            &[
                "hint  rest      declines an easy case",
                "on holiday (of a run it may decline 0.5: may-decline)",
                "hint  receipt",
                "hint  errors    it claims none, and the manifest's tolerance leaves out time and velocity",
                "NONE  answers   none of the easy cases was answered",
                "next: let it answer one",
            ],
        ),
        (
            "echo cannot find libm.so >&2; exit 3".to_owned(),
            "",
            3,
            &["BROKE start     ended at the start: exit status 3", "        | cannot find libm.so", "next: mend that"],
        ),
        (
            "echo Loading...; sleep 60".to_owned(),
            "",
            3,
            &["garbage on standard output: \"Loading...\". Standard output is for answers only"],
        ),
        ("sleep 60".to_owned(), "start-timeout = 0.2\n", 3, &["no answer at the start: nothing in 0.2 s"]),
        (
            answering(""),
            "version = { command = [\"echo\", \"mine 2.0\"], pattern = \"mine 1.*\" }",
            3,
            &["another version: \"mine 1.*\" is wanted, echo mine 2.0 prints \"mine 2.0\""],
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        shell(folder.path(), &script, more);
        let (status, out, err) = chattercheck(folder.path(), "engine check engines.toml");
        assert_eq!((status, err.as_str()), (expected, ""), "{out}");
        for word in words {
            assert!(out.contains(word), "no {word:?} in:\n{out}");
        }
    }
}

#[test]
fn both_sides_of_the_talk_are_shown() {
    let folder = tempfile::tempdir().unwrap();
    shell(folder.path(), &answering(r#""decline":{"reason":"on holiday","why":"until Monday"}"#), "");
    let ask = |flags: &str| chattercheck(folder.path(), &format!("engine ask mine {flags}"));
    let (status, out, _) = ask("--a 1.03 --omega 2 --eta 0.92 --impacts 7");
    assert_eq!(status, 0);
    let lines: Vec<&str> = out.lines().collect();
    let starts = [
        "> {\"cmd\":\"start\",",
        "< {\"version\":1,",
        "> {\"cmd\":\"case\",\"seq\":1,\"model\":\"linear\",\"epsilon\":0.03",
        "< {\"seq\":1,\"decline\":{\"reason\":\"on holiday\",\"why\":\"until Monday\"}}",
        "> {\"cmd\":\"stop\"}",
        "mine: declined: on holiday: until Monday",
    ];
    assert_eq!(lines.len(), starts.len(), "{out}");
    assert!(lines.iter().zip(starts).all(|(line, start)| line.starts_with(start)), "{out}");
    for (flags, words) in [
        ("--a 1.03 --omega 2 --eta 0.92 --alpha 0.1", "--alpha 0.1: mine does not use it, its model is linear"),
        ("--a 1.03 --omega 2 --eta 0.92 --model nonlinear", "--model nonlinear: the model of mine is linear"),
        ("--a 1.03 --omega 2 --eta 0.92 --engines none.toml", "none.toml: cannot be read"),
    ] {
        let (status, _, err) = ask(flags);
        assert_eq!(status, 2, "{flags}");
        assert!(err.contains(words), "{err}");
    }
    let (status, _, err) = chattercheck(folder.path(), "engine ask mien --a 1.03 --omega 2 --eta 0.92");
    assert_eq!(status, 2);
    assert!(err.contains("engines.toml: there is no engine \"mien\" in it; there are mine"), "{err}");
    shell(folder.path(), "exit 7", "");
    let (status, out, _) = ask("--a 1.03 --omega 2 --eta 0.92");
    assert_eq!(status, 3);
    assert!(out.contains("mine: ended at the start: exit status 7"), "{out}");
}
