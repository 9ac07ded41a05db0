//! The report, and an answer, as one HTML file that needs nothing else: no network, no other file.
//!
//! Without its script everything is there to be read; the script filters and sorts the table of cases, and opens the case that a link leads to. What comes from
//! outside (names of engines, what they said) is escaped by the templates; should anything slip through, the policy of the page runs no script but its own, by
//! its hash, and loads nothing.
//!
//! The same report gives the same page, byte for byte: it holds no measured times. A run of a million cases gives a page of a few megabytes:
//! what failed is shown, and of the rest an even sample; the page says so.

mod answer;
mod case;
mod cases;
mod digits;
mod engines;
mod exercised;
mod head;
mod map;
mod profile;
mod responses;
mod sample;
mod scale;
mod wrong;

pub use answer::{Answer, answer};
use maud::{DOCTYPE, Markup, html};

use crate::{
    cases::{generate::Named, toml_error::is_control},
    gate::{
        outcome::Outcomes,
        report::{self, Report, listed},
        verdict::Verdict,
    },
};
use sample::Sample;

/// The page of a run over `cases`. Replay files go to the folder of this name, if there are any.
pub fn html(report: &Report, cases: &[Named], outcomes: &Outcomes, replays: Option<&str>) -> String {
    let sample = Sample::of(|| listed(report, cases, outcomes));
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (head::head(&format!("{}: chattercheck", report.verdict), None))
            body {
                a .skip href="#cases" { "to the cases" }
                (verdict(report, replays))
                main {
                    (wrong::section(report, &sample))
                    (engines::section(report))
                    (map::section(&sample))
                    (cases::section(report, &sample))
                    (responses::section(report))
                    (exercised::section(report))
                }
                footer {
                    "chattercheck " (report.version) ", seed " (report.seed)
                    ". The same seed gives the same page, on any number of threads."
                }
                (head::script())
            }
        }
    };
    without_controls(&page.into_string())
}

/// What came out, and what to do next.
fn verdict(report: &Report, replays: Option<&str>) -> Markup {
    let sentence = report::verdict(report);
    let said = sentence.split_once(": ").map_or(sentence.as_str(), |(_, said)| said);
    html! {
        header .(class(report.verdict)) {
            p .product { "chattercheck" }
            h1 { span .badge { (report.verdict.to_string()) } " " (said) }
            p { strong { "Next: " } (with_code(&report::next(report, replays))) }
        }
    }
}

/// A sentence in which commands stand between ticks.
fn with_code(said: &str) -> Markup {
    html! {
        @for (place, piece) in said.split('`').enumerate() {
            @if place % 2 == 1 { code { (piece) } } @else { (piece) }
        }
    }
}

/// The class of what has this verdict.
fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "passed",
        Verdict::Undecided => "broke",
        Verdict::Fail => "wrong",
    }
}

/// Letters that a reader would not see, or that turn the direction of reading, are none of a page.
fn without_controls(page: &str) -> String {
    let is_kept = |c: char| matches!(c, '\n' | '\t') || !(is_control(c) || matches!(c, '\u{2028}' | '\u{2029}'));
    page.chars().map(|c| if is_kept(c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}
