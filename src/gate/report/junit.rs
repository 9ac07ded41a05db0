//! The report as JUnit XML: one test case for each case that was run, so that a CI shows which failed.

use std::{collections::HashSet, fmt::Display};

use quick_junit::{NonSuccessKind, Report as Xml, TestCase, TestCaseStatus, TestSuite};

use super::{Report, failure_text};
use crate::{
    cases::generate::Named,
    gate::{responses, shortfall::Shortfall, verdict::Verdict},
};

/// The JUnit document of a run over `cases`.
///
/// # Errors
/// When a name can't be written as XML.
pub fn junit(report: &Report, cases: &[Named]) -> Result<String, quick_junit::SerializeError> {
    let mut xml = Xml::new("chattercheck");
    let mut suite = TestSuite::new("verify");
    let left_out: HashSet<&String> = report.left_out.iter().collect();
    for named in cases {
        let name = named.to_string();
        let status = match report.failures.iter().find(|failure| failure.name == name) {
            Some(failure) if failure.is_breakdown() => unsuccessful(NonSuccessKind::Error, &failure_text(failure)),
            Some(failure) => unsuccessful(NonSuccessKind::Failure, &failure_text(failure)),
            None if left_out.contains(&name) => TestCaseStatus::skipped(),
            None => TestCaseStatus::success(),
        };
        suite.add_test_case(TestCase::new(name, status));
    }
    xml.add_test_suite(suite);
    if let Some(of) = &report.responses {
        xml.add_test_suite(suite_of_responses(of));
    }
    let mut whole = TestSuite::new("verify as a whole");
    let status = as_a_whole(&report.shortfalls, Shortfall::verdict);
    whole.add_test_case(TestCase::new("shortfalls", status));
    xml.add_test_suite(whole);
    xml.to_string()
}

/// What is wrong with a run as a whole; an interruption is an error and no failure.
fn as_a_whole<S: Display>(shortfalls: &[S], verdict: impl Fn(&S) -> Verdict) -> TestCaseStatus {
    let said = shortfalls.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    match Verdict::of(0, shortfalls.iter().map(verdict)) {
        Verdict::Pass => TestCaseStatus::success(),
        Verdict::Undecided => unsuccessful(NonSuccessKind::Error, &said),
        Verdict::Fail => unsuccessful(NonSuccessKind::Failure, &said),
    }
}

/// With the text in the message and inside the element: one CI shows the one, another the other.
fn unsuccessful(kind: NonSuccessKind, text: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(kind);
    status.set_message(text.lines().take(2).collect::<Vec<_>>().join(" "));
    status.set_description(text);
    status
}

/// One test case for each whole response, and one for the run of them as a whole.
fn suite_of_responses(report: &responses::Report) -> TestSuite {
    let mut suite = TestSuite::new("whole responses");
    for name in &report.tally.names {
        let failed = report.failures.iter().find(|failed| failed.name == *name);
        let status =
            failed.map_or_else(TestCaseStatus::success, |failed| unsuccessful(NonSuccessKind::Failure, &failed.text()));
        suite.add_test_case(TestCase::new(name.clone(), status));
    }
    for name in &report.tally.left_out {
        suite.add_test_case(TestCase::new(name.clone(), TestCaseStatus::skipped()));
    }
    let status = as_a_whole(&report.shortfalls, responses::Shortfall::verdict);
    suite.add_test_case(TestCase::new("shortfalls of the responses", status));
    suite
}
