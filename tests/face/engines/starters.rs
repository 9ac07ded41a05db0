//! The starters, as they stand.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
};

use chattercheck::engines::starter;

use super::chattercheck;

/// Whether this machine has a program.
fn has(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Writes a starter and builds it, if the machine can; whether it could.
fn begin(language: &str, folder: &Path) -> bool {
    let starter = starter::Starter::named(language).unwrap();
    let (program, _) = starter.build.map_or(("", ""), |build| build.split_once(' ').unwrap());
    let needs = match language {
        "octave" => "octave-cli",
        "python" => "python3",
        "julia" => "julia",
        _ => program,
    };
    if !has(needs) {
        println!("NOT TRIED: this machine has no {needs}: the {language} starter");
        return false;
    }
    let (status, out, err) = chattercheck(folder, &format!("engine new {language} {language}"));
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    if let Some(build) = starter.build {
        assert!(out.contains(&format!("build it: (cd {language} && {build})")), "{out}");
        let built = Command::new("sh").args(["-c", build]).current_dir(folder.join(language)).status().unwrap();
        assert!(built.success(), "{build}");
    }
    true
}

/// Every starter whose language the machine has is ready as it stands, and right to ten digits and more.
#[test]
fn the_starters_are_ready() {
    let folder = tempfile::tempdir().unwrap();
    for starter in starter::ALL {
        let language = starter.language;
        if !begin(language, folder.path()) {
            // At least a compiler for Rust is there.
            assert_ne!(language, "rust");
            continue;
        }
        let (status, out, err) = chattercheck(folder.path(), &format!("engine check {language}/engines.toml"));
        assert_eq!((status, err.as_str()), (0, ""), "{out}");
        assert_eq!(out.lines().filter(|line| line.starts_with("  ok ")).count(), 10, "{out}");
        for right in out.lines().filter_map(|line| line.split_once("right to ")) {
            let digits: u32 = right.1.split(' ').next().unwrap().parse().unwrap();
            assert!(digits >= 10, "{language}: {out}");
        }
        assert!(out.contains("12 impacts, at rest") && out.contains("9 impacts, incomplete"), "{out}");
        assert!(out.contains("0 impacts, never rocks") && out.contains("declines a nonlinear case"), "{out}");
    }
}

#[test]
fn nothing_is_written_over() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("mine")).unwrap();
    fs::write(folder.path().join("mine/engine.py"), "my work").unwrap();
    let (status, _, err) = chattercheck(folder.path(), "engine new python mine");
    assert_eq!(status, 2);
    assert!(err.contains("mine/engine.py is there already"), "{err}");
    assert_eq!(fs::read_to_string(folder.path().join("mine/engine.py")).unwrap(), "my work");
    assert!(!folder.path().join("mine/engines.toml").exists());
    let (status, _, err) = chattercheck(folder.path(), "engine new perl mine");
    assert_eq!(status, 2);
    assert!(err.contains("language = perl") && err.contains("python, c, cpp, julia, octave, rust"), "{err}");
}
