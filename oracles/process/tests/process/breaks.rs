//! Every way of breaking in mid-talk has its verdict; none hangs.

use contract::Oracle;
use process::{Engine, Verdict};

use crate::common::{case, cases, engine, launch, mark, verdict};

fn check(rows: &[(&str, Verdict)]) {
    std::thread::scope(|threads| {
        for (how, expected) in rows {
            threads.spawn(move || {
                let answer = engine(how).answer(&case(0.9));
                assert_eq!(verdict(&answer), *expected, "{how}: {answer:?}");
                let decline = answer.told().unwrap_err();
                assert!(decline.is_breakdown());
                assert_eq!(decline.reason(), expected.name());
                assert!(decline.to_string().contains(expected.advice()));
            });
        }
    });
}

#[test]
fn every_wrong_line_has_its_verdict() {
    check(&[
        ("garbage", Verdict::Garbage),
        ("empty-line", Verdict::Garbage),
        ("two-objects", Verdict::Garbage),
        ("cut-line", Verdict::HalfLine),
        ("long-line", Verdict::LineTooLong),
        ("ten-million-impacts", Verdict::LineTooLong),
        ("broken-utf8", Verdict::BrokenUtf8),
        ("bare-nan", Verdict::BareNan),
        ("too-large", Verdict::NumberTooLarge),
    ]);
}

#[test]
fn every_wrong_answer_by_the_protocol_has_its_verdict() {
    check(&[
        ("wrong-seq", Verdict::WrongSeq),
        ("no-seq", Verdict::MissingField),
        ("two-in-one", Verdict::TwoAnswers),
        ("none-in-one", Verdict::MissingField),
        ("unknown-field", Verdict::UnknownField),
        ("field-twice", Verdict::FieldTwice),
        ("no-velocity", Verdict::MissingField),
        ("wrong-kind", Verdict::WrongKind),
        ("text-for-number", Verdict::WrongKind),
        ("unequal-columns", Verdict::UnequalColumns),
        ("too-many-impacts", Verdict::TooManyImpacts),
        ("unknown-ending", Verdict::UnknownEnding),
        ("claim-not-announced", Verdict::ClaimNotAnnounced),
        ("claims-negative", Verdict::BadClaim),
        ("claims-nan", Verdict::BadClaim),
        ("claims-short", Verdict::BadClaim),
        ("errors", Verdict::ReportedError),
        ("errors-without-seq", Verdict::ReportedError),
    ]);
}

#[test]
fn every_end_and_every_silence_has_its_verdict() {
    check(&[
        ("silent", Verdict::TimedOut),
        ("half-line", Verdict::HalfLine),
        ("half-line-then-end", Verdict::HalfLine),
        ("flood", Verdict::Flood),
        ("ends", Verdict::EndedMidCase),
        ("exits", Verdict::Crashed),
        ("aborts", Verdict::Crashed),
        ("closes-output", Verdict::ClosedOutput),
        ("closes-input", Verdict::ClosedInput),
    ]);
}

/// The status, the signal and the last words are told.
#[test]
fn a_crash_is_told() {
    let told = engine("exits").history(&case(0.9)).unwrap_err().to_string();
    assert!(
        told.starts_with("crashed: exit status 3; its error output ends with \"assertion failed: phi > 0\""),
        "{told}"
    );
    let told = engine("aborts").history(&case(0.9)).unwrap_err().to_string();
    assert!(told.contains("signal 6 (SIGABRT"), "{told}");
}

/// A crash that does not happen again is no verdict, but it is counted.
#[test]
fn what_breaks_once_is_asked_again() {
    let mut launch = launch("crashes-once");
    launch.run.push(mark().display().to_string());
    let engine = Engine::start(launch, None).unwrap();
    engine.history(&case(0.9)).unwrap();
    assert_eq!(engine.breaks(), 1);
}

#[test]
fn another_engine_after_a_restart_is_noticed() {
    let mut launch = launch("another-after-restart");
    launch.run.push(mark().display().to_string());
    // The first start leaves no mark but the file; the second one finds it.
    let engine = Engine::start(launch, None).unwrap();
    let all = cases(2);
    engine.ask_all(&all);
    assert!(all.iter().any(|case| engine.answer(case).breakdown().is_none()) || engine.breaks() > 0);
}

/// An answer that is wrong by the protocol does not end the talk; the case after it is answered.
#[test]
fn the_talk_goes_on_after_an_error() {
    let engine = engine("crashes-on-bad");
    assert_eq!(verdict(&engine.answer(&case(0.25))), Verdict::Crashed);
    engine.history(&case(0.9)).unwrap();
    let errs = crate::common::engine("errors");
    for case in cases(30) {
        assert_eq!(verdict(&errs.answer(&case)), Verdict::ReportedError);
    }
    assert_eq!(errs.breaks(), 0);
}

/// An engine that always breaks is not started for ever.
#[test]
fn restarts_are_bounded() {
    let mut launch = launch("exits");
    launch.restarts = 4;
    let engine = Engine::start(launch, None).unwrap();
    let verdicts: Vec<Verdict> = cases(6).iter().map(|case| verdict(&engine.answer(case))).collect();
    assert_eq!(verdicts[..3], [Verdict::Crashed; 3]);
    assert_eq!(verdicts[3..], [Verdict::RestartsExhausted; 3]);
    assert_eq!(engine.breaks(), 6);
}

/// Error output without end neither blocks the engine nor fills the memory.
#[test]
fn error_output_is_drained() {
    let engine = engine("floods-stderr");
    engine.history(&case(0.9)).unwrap();
    let _ = engine.answer(&case(0.8));
    let kept = engine.stderr().concat();
    assert!(kept.len() <= 64 * 1024 && kept.contains("the end"), "{}", kept.len());
}
