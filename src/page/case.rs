//! A case that failed, unfolded: what was found, the impacts where an answer parts from what is proven, and the commands that show it again.

use maud::{Markup, html};

use super::digits::number;
use crate::{
    gate::{
        finding::Finding,
        parting::{Parting, Row, Seen, Whole},
        report::{FailedCase, cut, finding_text, headline, one_line},
    },
    measure::observables::Observable,
};

/// The letters of one finding, and of the line that a case is folded to.
const LONGEST: usize = 2000;
const LONGEST_LINE: usize = 300;

/// All of it, under its first finding.
pub(super) fn unfolded(failure: &FailedCase) -> Markup {
    html! {
        details {
            summary { (cut(&one_line(&headline(failure)), LONGEST_LINE, " ")) }
            ul .findings { @for finding in &failure.findings { li .(class(finding)) { (cut(&finding_text(finding), LONGEST, " ")) } } }
            @if !failure.sound.is_empty() {
                p { "Nothing is wrong, by the judge and the laws, with " (failure.sound.join(", ")) "." }
            }
            @for judge in &failure.suspect_judges {
                p { "The judge is suspect: those that " (judge) " refutes agree among themselves." }
            }
            @for parting in &failure.partings { (side_by_side(parting)) }
            @if !failure.see.is_empty() {
                p .label { "See it again" }
                @for command in &failure.see { pre .command { code { (command) } } }
            }
        }
    }
}

fn class(finding: &Finding) -> &'static str {
    if finding.is_breakdown() { "broke" } else { "wrong" }
}

/// The impacts of two answers, each with what was answered above what it is held against.
fn side_by_side(parting: &Parting) -> Markup {
    let Parting { answered, against, is_proven, impact, rows } = parting;
    let word = if *is_proven { "proven" } else { "beside" };
    html! {
        figure {
            figcaption {
                strong { (answered.oracle) } " above what "
                @if *is_proven { "is proven by " } @else { "is answered by " }
                strong { (against.oracle) }
                @if let (Some(first), Some(last)) = (rows.first(), rows.last()) {
                    ": impacts " (first.impact) " to " (last.impact) ", by " (answered.impacts.to_string()) " and "
                    (against.impacts.to_string())
                }
                ". Digits are marked where the two part by more than they claim together."
            }
            @if !rows.is_empty() {
                div .scroll tabindex="0" role="region" aria-label={ "impacts of " (answered.oracle) " and " (against.oracle) } {
                    table .impacts {
                        thead { tr {
                            th scope="col" { "n" }
                            th scope="col" { }
                            th scope="col" { "time τ" }
                            th scope="col" { "interval Δτ" }
                            th scope="col" { "velocity φ′" }
                        } }
                        @for row in rows { (impact_rows(row, *impact, word)) }
                    }
                }
            }
            (wholes(answered, against, word))
        }
    }
}

/// One impact in two lines.
fn impact_rows(row: &Row, first_wrong: usize, word: &str) -> Markup {
    let line = |word: &str, seen: Option<Seen>, other: Option<Seen>, marks: bool| {
        html! {
            th scope="row" .who { (word) }
            @match seen {
                None => td colspan="3" .none { "no such impact" },
                Some(seen) => {
                    @for (observable, value) in values(seen) {
                        @let beside = other.and_then(|other| values(other).into_iter().find(|(o, _)| *o == observable)?.1);
                        td { (number(value, beside, marks && row.parts_in.contains(&observable))) }
                    }
                }
            }
        }
    };
    let class = if row.impact == first_wrong { "first-wrong" } else { "" };
    html! {
        tbody .(class) {
            tr {
                th scope="rowgroup" rowspan="2" .n { (row.impact) }
                (line("answered", row.answered, row.against, true))
            }
            tr { (line(word, row.against, row.answered, false)) }
        }
    }
}

fn values(seen: Seen) -> [(Observable, Option<f64>); 3] {
    [(Observable::ImpactTime, seen.time), (Observable::Interval, seen.interval), (Observable::Velocity, seen.velocity)]
}

/// How the two end.
fn wholes(answered: &Whole, against: &Whole, word: &str) -> Markup {
    html! {
        dl .wholes {
            @for (word, whole) in [("answered", answered), (word, against)] {
                dt { (word) }
                dd {
                    (whole.ending) ", " (whole.impacts) " impacts"
                    @if let Some(tau_ch) = whole.tau_ch { ", chattering time " (format!("{tau_ch:?}")) }
                }
            }
        }
    }
}
