//! The command that tells the version.

use std::time::Duration;

use contract::Model;
use process::{Launch, Verdict, version};

fn told(script: &str) -> Result<Vec<String>, (Verdict, String)> {
    let mut launch = Launch::new("fake", ["fake"], Model::Linear);
    launch.start_timeout = Duration::from_millis(if script.contains("sleep") { 200 } else { 20_000 });
    let command = ["sh", "-c", script].map(str::to_owned);
    version(&launch, &command).map_err(|broke| (broke.verdict, broke.to_string()))
}

#[test]
fn what_it_prints_is_the_receipt() {
    assert_eq!(told("echo; echo fake 1.2; printf 'of today'").unwrap(), ["fake 1.2", "of today"]);
    assert_eq!(told("echo fake 1.2 >&2").unwrap(), ["fake 1.2"], "some print it as an error");
}

#[test]
fn a_version_that_is_not_told_is_a_breakdown() {
    for (script, words) in [
        ("exit 3", "exit status 3"),
        ("echo no licence >&2; exit 1", "no licence"),
        ("true", "it prints nothing"),
        ("sleep 60", "it did not end in 0.2 s"),
        ("yes", "it prints more than a version"),
        ("head -c 100000 /dev/zero", "it prints more than a version"),
    ] {
        let (verdict, told) = told(script).unwrap_err();
        assert_eq!(verdict, Verdict::NoVersion, "{script}");
        assert!(told.contains(words), "{script}: {told}");
    }
    let launch = Launch::new("fake", ["fake"], Model::Linear);
    assert_eq!(version(&launch, &["no-such-program".to_owned()]).unwrap_err().verdict, Verdict::NoSuchProgram);
}
