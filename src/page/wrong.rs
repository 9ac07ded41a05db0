//! What is wrong, grouped by its cause.

use maud::{Markup, html};

use super::sample::Sample;
use crate::gate::{
    failure::by_cause,
    report::{FailedCase, Report, cut, headline},
};

/// How many cases of a cause are linked to.
const LINKED: usize = 12;
/// How many causes and shortfalls are listed.
const MOST: usize = 50;
/// The letters of what is said of one.
const LONGEST: usize = 600;

pub(super) fn section(report: &Report, sample: &Sample) -> Markup {
    let of_responses = report.responses.iter().flat_map(|of| &of.shortfalls).map(ToString::to_string);
    let shortfalls: Vec<String> = report.shortfalls.iter().map(ToString::to_string).chain(of_responses).collect();
    let causes = by_cause(&report.failures, FailedCase::cause);
    if shortfalls.is_empty() && causes.is_empty() {
        return html! {};
    }
    html! {
        section #wrong {
            h2 { "What is wrong" }
            @if !shortfalls.is_empty() {
                ul .shortfalls {
                    @for shortfall in shortfalls.iter().take(MOST) { li .wrong { strong { "The run as a whole: " } (shortfall) } }
                    @if shortfalls.len() > MOST { li { "and " (shortfalls.len() - MOST) " more" } }
                }
            }
            ol .causes {
                @for (cause, group) in causes.iter().take(MOST) {
                    li {
                        p { strong { (group.len()) " of " (report.failures.len()) " failed cases" } " point to " strong { (cause.to_string()) } }
                        @if let Some(first) = group.first() { p .finding { (cut(&headline(first), LONGEST, " ")) } }
                        p .links { (links(group, sample)) }
                    }
                }
            }
            @if causes.len() > MOST { p { "and " (causes.len() - MOST) " other causes" } }
        }
    }
}

/// Links to the first cases of a cause.
fn links(group: &[&FailedCase], sample: &Sample) -> Markup {
    let shown = group.iter().filter_map(|failure| Some((&failure.name, sample.place_of(&failure.name)?)));
    html! {
        @for (name, place) in shown.take(LINKED) { a href={ "#case-" (place) } { (name) } " " }
        @if group.len() > LINKED { "and " (group.len() - LINKED) " more" }
    }
}
