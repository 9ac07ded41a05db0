//! Whole responses in which something was wrong.

use maud::{Markup, html};

use crate::gate::report::Report;

/// How many are shown.
const MOST: usize = 1000;

pub(super) fn section(report: &Report) -> Markup {
    let Some(of) = report.responses.as_ref().filter(|of| !of.failures.is_empty()) else { return html! {} };
    html! {
        section #responses {
            h2 { "Whole responses" }
            p { strong { (of.failures.len()) " of " (of.tally.responses) " failed" } }
            @for failed in of.failures.iter().take(MOST) {
                details .response {
                    summary {
                        (failed.name)
                        @if let Some(first) = failed.findings.first() { ": " (first.to_string()) }
                    }
                    pre { (failed.text()) }
                }
            }
            @if of.failures.len() > MOST { p { "and " (of.failures.len() - MOST) " more; the report in JSON has them" } }
        }
    }
}
