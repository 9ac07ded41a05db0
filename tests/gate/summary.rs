//! The Markdown summary and the annotations of GitHub.

use chattercheck::gate::{
    failure::Cause,
    finding::Finding,
    report::{self, FailedCase},
    verdict::Verdict,
};

use super::mixed::{HOSTILE, Mixed, mixed};

/// GitHub's limit for the page of a job, in bytes.
const LARGEST: usize = 1 << 20;

#[test]
fn a_summary_says_what_is_wrong_and_what_to_do() {
    let Mixed { report, .. } = mixed("mine");
    assert_eq!(report.verdict, Verdict::Fail);
    let summary = report::summary(&report, Some("replays"));
    for words in [
        "## chattercheck: FAIL\n\nFAIL: 4 of 10 cases failed",
        "| mine | &lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;",
        " | **FAIL** | 6 | 2 | 2 | 2 |",
        "**2 of 4 failed cases point to mine**",
        "```text\nFAILED list/",
        "  mine is WRONG on velocity, first at impact 1",
        "**2 of 4 failed cases point to mine, which broke: crashed**",
        "### What to do next\n\nthe smallest cases that still fail go to replays",
        "### What was exercised\n\n| | |\n| --- | --- |\n| cases | 10 list |",
    ] {
        assert!(summary.contains(words), "no {words:?} in:\n{summary}");
    }
    // Every row of a table has as many cells as its head.
    for line in summary.lines().filter(|line| line.starts_with('|')) {
        let bars = line.replace("\\|", "").matches('|').count();
        assert!([3, 9].contains(&bars), "{line}");
    }
}

/// However much is wrong, and however long it is.
#[test]
fn a_summary_fits_on_the_page_of_a_job() {
    let Mixed { mut report, .. } = mixed("mine");
    let broke = |n: usize, failure: &FailedCase| FailedCase {
        name: HOSTILE.repeat(1000),
        findings: vec![Finding::Broke {
            oracle: format!("{n}{}", HOSTILE.repeat(1000)),
            breakdown: HOSTILE.repeat(1000),
            how: "```".repeat(100_000),
        }],
        ..failure.clone()
    };
    let first = report.failures[0].clone();
    report.failures = (0..50).map(|n| broke(n, &first)).collect();
    report.engines = vec![report.engines[0].clone(); 1000];
    report.oracles = vec![HOSTILE.repeat(1000); 1000];
    let summary = report::summary(&report, Some(&HOSTILE.repeat(10_000)));
    assert!(summary.len() < LARGEST, "{} bytes", summary.len());
    assert!(summary.contains("and 45 other causes, in 45 more cases") && summary.contains("more letters are cut off"));
    assert!(summary.contains("and 950 more engines"));
}

#[test]
fn annotations_are_one_for_a_cause() {
    let Mixed { report, .. } = mixed("mine");
    let annotations = report::annotations(&report);
    let lines: Vec<&str> = annotations.lines().collect();
    assert_eq!(lines.len(), 2, "{annotations}");
    let wrong = "::error title=2 failed cases point to mine::FAILED list/";
    assert!(lines[0].starts_with(wrong) && lines[0].contains("%0A  mine is WRONG on velocity"), "{annotations}");
    let broke = "::warning title=2 failed cases point to mine, which broke%3A crashed".replace(", which", "%2C which");
    assert!(lines[1].starts_with(&broke), "{annotations}");
}

/// GitHub shows ten of a kind.
#[test]
fn annotations_of_many_causes_are_ten() {
    let Mixed { mut report, .. } = mixed("mine");
    let wrong = report.failures.iter().find(|failure| !failure.is_breakdown()).unwrap().clone();
    let by = |n: usize| {
        let mut failure = wrong.clone();
        for finding in &mut failure.findings {
            if let Finding::Refuted { oracle, .. } | Finding::Law { oracle, .. } = finding {
                *oracle = format!("mine-{n:02}");
            }
        }
        assert_eq!(failure.cause(), Cause::Oracles(vec![format!("mine-{n:02}")]));
        failure
    };
    report.failures = (0..25).map(by).collect();
    let annotations = report::annotations(&report);
    let errors: Vec<&str> = annotations.lines().filter(|line| line.starts_with("::error ")).collect();
    assert_eq!((errors.len(), annotations.lines().count()), (10, 10), "{annotations}");
    assert!(errors[9].starts_with("::error title=and 16 more::") && errors[9].contains("mine-24"), "{}", errors[9]);
}
