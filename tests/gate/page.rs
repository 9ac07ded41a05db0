//! The report as one HTML file. That it works in a browser is seen by `tests/browser`.

use chattercheck::{
    gate::{outcome::Outcomes, report::FailedCase},
    page,
};

use super::mixed::{HOSTILE, Mixed, mixed};

fn page_of(mixed: &Mixed) -> String {
    page::html(&mixed.report, &mixed.cases, &mixed.outcomes, Some("replays"))
}

#[test]
fn everything_that_is_wrong_can_be_unfolded() {
    let mixed = mixed("mine");
    let page = page_of(&mixed);
    for words in [
        "<span class=\"badge\">FAIL</span> 4 of 10 cases failed",
        "the smallest cases that still fail go to replays; run them again with <code>chattercheck replay</code>",
        "<strong>2 of 4 failed cases</strong> point to <strong>mine</strong>",
        "data-verdict=\"wrong\" data-generator=\"list\" data-concerns=\"mine\"",
        "<summary>mine is WRONG on velocity, first at impact 1",
        "known: the step is too long",
        "<strong>mine</strong> above what is proven by <strong>enclosure/linear</strong>: impacts 1 to 8",
        "<dt>declined</dt><dd>2 on holiday</dd>",
        "<dt>broke</dt><dd>2 crashed</dd>",
        "<pre class=\"command\"><code>chattercheck ",
    ] {
        assert!(page.contains(words), "no {words} in:\n{page}");
    }
    for fate in ["wrong", "broke", "known", "passed"] {
        assert_eq!(page.matches(&format!("data-verdict=\"{fate}\"")).count(), if fate == "passed" { 4 } else { 2 });
    }
    // Every velocity that is wrong has its digits marked, and no time or interval.
    let failed = mixed.report.failures.iter().filter(|failure| !failure.is_breakdown());
    let rows: usize = failed.flat_map(|failure| &failure.partings).map(|parting| parting.rows.len()).sum();
    assert_eq!((rows, page.matches("<mark>").count()), (16, 16));
}

/// What an engine is called, and what it says, is never markup.
#[test]
fn nothing_from_outside_is_obeyed() {
    let page = page_of(&mixed(HOSTILE));
    assert!(page.contains("&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&quot;'&amp;`|]]&gt;::error::%"));
    assert_eq!((page.matches("<script").count(), page.matches("</script").count()), (1, 1));
    for never in ["\u{2028}", "\u{202e}", "\u{7}", " src=", "<img", "<link", "@import", "url(", "style=\"", "onclick"] {
        assert!(!page.contains(never), "{never:?}");
    }
    assert!(page.contains("default-src 'none'"));
}

/// What is measured is not in it.
#[test]
fn the_same_run_gives_the_same_page() {
    assert!(page_of(&mixed("mine")) == page_of(&mixed("mine")));
}

/// What is shown of many cases of which many failed: the first of those, and an even sample of the others.
#[test]
fn the_page_of_many_cases_is_read_by_a_browser() {
    const CASES: usize = 100_000;
    const FAILED: usize = 30_000;
    let as_failed = |n: usize, wrong: FailedCase| FailedCase {
        name: format!("random/{}", n * 3),
        // As a run keeps them.
        partings: if n < 200 { wrong.partings.clone() } else { Vec::new() },
        ..wrong
    };
    let Mixed { report, cases, .. } = mixed("mine").many(CASES, FAILED, as_failed);
    let page = page::html(&report, &cases, &Outcomes::default(), None);
    assert!(page.len() < 10_000_000, "{} bytes", page.len());
    for words in [
        "random/3<",
        "Not every case is shown: the first 2000 of 30000 that are wrong; 1000 of 70000 that passed, evenly spaced.",
        "The report in JSON names every one that failed.",
        "3000 cases",
    ] {
        assert!(page.contains(words), "no {words}");
    }
    assert_eq!(page.matches("<tbody id=\"case-").count(), 3000);
}
