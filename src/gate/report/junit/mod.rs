//! The report as JUnit XML, as GitLab, Jenkins and GitHub read it.
//!
//! There is a suite of the cases, with one test case each; one for each engine, with one test case for each case; one of the whole responses; and one of
//! the run as a whole. What failed has its text in the message and inside the element: one CI shows the one, another the other. What was declined, left out or
//! is known is skipped, and says why. A case over which an engine broke is an error, not a failure.
//!
//! GitLab takes no file above 30 MB: see [`room`] for what is summed up in a large one. Nothing is left out silently.

mod room;
mod suite;

use std::{collections::HashMap, fmt::Display};

use quick_junit::{NonSuccessKind, Report as Xml, TestCaseStatus, TestSuite};

use super::{
    EngineReport, Report, failure_text, headline,
    listed::{Fate, Listed, listed},
};
use crate::{
    cases::generate::Named,
    gate::{outcome::Outcomes, responses, shortfall::Shortfall, verdict::Verdict},
};
use room::Room;
use suite::{Suite, Told};

pub use room::{LARGEST, MOST_LISTED};

/// The JUnit document of a run over `cases`.
///
/// # Errors
/// When it can't be written as XML.
pub fn junit(report: &Report, cases: &[Named], outcomes: &Outcomes) -> Result<String, quick_junit::SerializeError> {
    let responses = report.responses.as_ref().map_or(0, |of| of.tally.names.len() + of.tally.left_out.len());
    let mut room = Room::for_cases(cases.len() * (1 + report.engines.len()) + responses);
    let mut xml = Xml::new("chattercheck");
    xml.add_test_suite(of_cases(report, cases, outcomes, &mut room));
    for engine in &report.engines {
        xml.add_test_suite(of_engine(engine, report, cases, outcomes, &mut room));
    }
    if let Some(of) = &report.responses {
        xml.add_test_suite(of_responses(of, outcomes, &mut room));
    }
    let mut whole = Suite::new("verify as a whole");
    add_shortfalls(&mut whole, "shortfalls", &report.shortfalls, Shortfall::verdict);
    xml.add_test_suite(whole.end());
    xml.to_string()
}

/// The cases, as far as the oracles beside the engines go.
fn of_cases(report: &Report, cases: &[Named], outcomes: &Outcomes, room: &mut Room) -> TestSuite {
    let mut suite = Suite::new("verify");
    for case in listed(report, cases, outcomes) {
        let class = format!("chattercheck.{}", case.named.generator.name());
        let of_engines = || report.engines.iter().filter_map(|of| case.seconds_of(&of.engine.name)).sum::<f64>();
        let seconds = case.outcome.and_then(|outcome| Some((outcome.seconds? - of_engines()).max(0.0)));
        suite.add(&class, &case.name, seconds, told(&case, case.fate_without_engines()), room);
    }
    suite.end()
}

/// The cases as one engine did them.
fn of_engine(
    engine: &EngineReport,
    report: &Report,
    cases: &[Named],
    outcomes: &Outcomes,
    room: &mut Room,
) -> TestSuite {
    let name = &engine.engine.name;
    let mut suite = Suite::new(format!("engine {name}"));
    // To a reader a dot would end a package.
    let class = format!("chattercheck.engine.{}", name.replace('.', "_"));
    for case in listed(report, cases, outcomes) {
        let told = told(&case, case.fate_of(engine));
        suite.add(&class, &format!("{} by {name}", case.name), case.seconds_of(name), told, room);
    }
    suite.end()
}

fn told(case: &Listed, fate: Fate) -> Told {
    match (fate, case.failure) {
        (Fate::Wrong, Some(failure)) => {
            Told::Unsuccessful(NonSuccessKind::Failure, headline(failure), failure_text(failure))
        }
        (Fate::Broke(how), Some(failure)) => {
            Told::Unsuccessful(NonSuccessKind::Error, format!("broke: {how}"), failure_text(failure))
        }
        (Fate::Passed, _) | (Fate::Wrong | Fate::Broke(_), None) => Told::Passed,
        (skipped @ (Fate::LeftOut | Fate::Known(_) | Fate::Declined(_)), _) => {
            Told::Skipped(skipped.word(), skipped.to_string())
        }
    }
}

/// One test case for each whole response.
fn of_responses(report: &responses::Report, outcomes: &Outcomes, room: &mut Room) -> TestSuite {
    const CLASS: &str = "chattercheck.response";
    let mut suite = Suite::new("whole responses");
    let failed: HashMap<&str, &responses::Failed> =
        report.failures.iter().map(|failed| (failed.name.as_str(), failed)).collect();
    for name in &report.tally.names {
        let told = failed.get(name.as_str()).map_or(Told::Passed, |failed| {
            let first = failed.findings.first().map_or_else(String::new, ToString::to_string);
            Told::Unsuccessful(NonSuccessKind::Failure, first, failed.text())
        });
        suite.add(CLASS, name, outcomes.response_seconds(name), told, room);
    }
    for name in &report.tally.left_out {
        suite.add(CLASS, name, None, Told::Skipped(Fate::LeftOut.word(), Fate::LeftOut.to_string()), room);
    }
    add_shortfalls(&mut suite, "shortfalls of the responses", &report.shortfalls, responses::Shortfall::verdict);
    suite.end()
}

/// What is wrong with a run as a whole; an interruption is an error and no failure.
fn add_shortfalls<S: Display>(suite: &mut Suite, name: &str, shortfalls: &[S], verdict: impl Fn(&S) -> Verdict) {
    let said = shortfalls.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    let first = said.lines().next().unwrap_or_default().to_owned();
    let told = match Verdict::of(0, shortfalls.iter().map(verdict)) {
        Verdict::Pass => Told::Passed,
        Verdict::Undecided => Told::Unsuccessful(NonSuccessKind::Error, first, said),
        Verdict::Fail => Told::Unsuccessful(NonSuccessKind::Failure, first, said),
    };
    // There is always room for it.
    suite.add("chattercheck.run", name, None, told, &mut Room::for_cases(1));
}

/// With the text in the message and inside the element.
fn unsuccessful(kind: NonSuccessKind, message: &str, text: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(kind);
    status.set_message(message);
    status.set_type(match kind {
        NonSuccessKind::Failure => "wrong",
        NonSuccessKind::Error => "broke",
    });
    status.set_description(text);
    status
}

/// With the reason in the message and inside the element.
fn skipped(kind: &str, why: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::skipped();
    status.set_message(why);
    status.set_type(kind);
    status.set_description(why);
    status
}
