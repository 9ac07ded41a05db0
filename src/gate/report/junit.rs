//! The report as JUnit XML: one test case for each case that was run, so that a CI shows which failed.

use std::collections::HashSet;

use quick_junit::{NonSuccessKind, Report as Xml, TestCase, TestCaseStatus, TestSuite};

use super::{FailedCase, Report, failure_text};
use crate::{cases::generate::Named, gate::responses};

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
            Some(failure) => failed(failure),
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
    let mut status = TestCaseStatus::success();
    if !report.shortfalls.is_empty() {
        status = TestCaseStatus::non_success(NonSuccessKind::Failure);
        let said: Vec<String> = report.shortfalls.iter().map(ToString::to_string).collect();
        status.set_message(said.join("\n"));
    }
    whole.add_test_case(TestCase::new("shortfalls", status));
    xml.add_test_suite(whole);
    xml.to_string()
}

/// One test case for each whole response, and one for the run of them as a whole.
fn suite_of_responses(report: &responses::Report) -> TestSuite {
    let failure = |text: String| {
        let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
        status.set_message(text);
        status
    };
    let mut suite = TestSuite::new("whole responses");
    for name in &report.names {
        let failed = report.failures.iter().find(|failed| failed.name == *name);
        let status = failed.map_or_else(TestCaseStatus::success, |failed| failure(failed.text()));
        suite.add_test_case(TestCase::new(name.clone(), status));
    }
    for name in &report.left_out {
        suite.add_test_case(TestCase::new(name.clone(), TestCaseStatus::skipped()));
    }
    let short = Some(report.shortfalls.join("\n")).filter(|said| !said.is_empty());
    let status = short.map_or_else(TestCaseStatus::success, failure);
    suite.add_test_case(TestCase::new("shortfalls of the responses", status));
    suite
}

fn failed(failure: &FailedCase) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(failure_text(failure));
    status
}
