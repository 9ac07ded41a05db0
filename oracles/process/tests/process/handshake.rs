//! The start: what an engine has to say before it is asked anything.

use std::time::Duration;

use contract::{Model, Oracle};
use process::{Engine, Launch, Verdict};

use crate::common::{FAKE, case, engine, launch, refused};

#[test]
fn an_engine_says_who_it_is() {
    let engine = engine("well");
    let welcome = engine.welcome();
    assert_eq!((welcome.name.as_str(), welcome.version.as_str(), welcome.language.as_str()), ("fake", "1.0", "Rust"));
    assert_eq!((welcome.claims, welcome.max_batch), (false, 1));
    assert_eq!((engine.name(), engine.model()), ("fake", Model::Linear));
}

#[test]
fn fields_of_ones_own_and_hexadecimal_floats_are_welcome() {
    engine("start-own-field").history(&case(0.5)).unwrap();
    engine("start-hexadecimal-echo").history(&case(0.5)).unwrap();
}

/// Each way in which a start can fail has its own name.
#[test]
fn every_wrong_start_has_its_verdict() {
    for (how, verdict) in [
        ("start-silent", Verdict::NoAnswerAtStart),
        ("start-ends", Verdict::EndedAtStart),
        ("start-crashes", Verdict::EndedAtStart),
        ("start-garbage", Verdict::Garbage),
        ("start-half-line", Verdict::HalfLine),
        ("start-flood", Verdict::Flood),
        ("start-version-2", Verdict::WrongVersion),
        ("start-no-version", Verdict::MissingField),
        ("start-error", Verdict::ReportedError),
        ("start-no-echo", Verdict::MissingField),
        ("start-short-echo", Verdict::EchoNotExact),
        ("start-no-signed-zero", Verdict::EchoNotExact),
        ("start-six-digits", Verdict::EchoNotExact),
        ("start-no-models", Verdict::MissingField),
        ("start-other-model", Verdict::ModelNotOffered),
        ("start-other-normalisation", Verdict::NormalisationNotOffered),
        ("start-other-ground", Verdict::GroundNotOffered),
        ("start-unknown-field", Verdict::UnknownField),
        ("start-batch-0", Verdict::WrongKind),
    ] {
        let broke = refused(how);
        assert_eq!(broke.verdict, verdict, "{how}: {broke}");
    }
}

/// The line tells what was wrong to somebody who does not know the protocol.
#[test]
fn the_line_tells_what_to_do() {
    let told = refused("start-six-digits").to_string();
    assert!(told.contains("1.7976931348623157e308 was sent, 1.79769e308 came back"), "{told}");
    assert!(told.contains("17 significant digits"), "{told}");
    let told = refused("start-crashes").to_string();
    assert!(
        told.starts_with("ended at the start: exit status 3; its error output ends with \"cannot find libfake.so\""),
        "{told}"
    );
    assert!(refused("start-error").to_string().contains("no licence"));
}

#[test]
fn what_cannot_be_started_is_told() {
    let verdict = |launch: Launch| Engine::start(launch, None).map(drop).unwrap_err().verdict;
    assert_eq!(verdict(Launch::new("none", ["no-such-program-anywhere"], Model::Linear)), Verdict::NoSuchProgram);
    assert_eq!(verdict(Launch::new("none", [env!("CARGO_MANIFEST_PATH")], Model::Linear)), Verdict::CannotStart);
    let mut nowhere = Launch::new("none", [FAKE], Model::Linear);
    nowhere.directory = "no/such/directory".into();
    assert_eq!(verdict(nowhere), Verdict::NoSuchDirectory);
    let mut hurried = launch("well");
    hurried.case_timeout = Duration::ZERO;
    assert_eq!(verdict(hurried), Verdict::BadSetting);
}
