//! The table of cases, to be filtered and sorted. Without the script it is a table.

use std::collections::BTreeSet;

use maud::{Markup, html};

use super::{
    case::unfolded,
    digits::short,
    sample::{Fates, Sample, Shown},
};
use crate::gate::{
    finding::Finding,
    report::{Fate, Report},
};

/// The columns: how each is sorted by, and whether a narrow screen has room for it.
const COLUMNS: [(&str, &str, bool); 8] = [
    ("case", "text", true),
    ("verdict", "number", true),
    ("concerns", "text", true),
    ("impact", "number", false),
    ("a − 1", "number", false),
    ("ω", "number", false),
    ("η", "number", false),
    ("α", "number", false),
];

pub(super) fn section(report: &Report, sample: &Sample) -> Markup {
    html! {
        section #cases {
            h2 { "Cases" }
            p .note { "The worst come first; a click on the head of a column sorts by it." }
            @if !sample.is_whole() { p { (not_all(sample)) } }
            (controls(report, sample))
            p #count role="status" aria-live="polite" { (sample.shown.len()) " cases" }
            div .scroll tabindex="0" role="region" aria-label="cases" {
                table .cases {
                    thead { tr {
                        @for (name, sorts, is_narrow) in COLUMNS {
                            th scope="col" aria-sort="none" data-sorts=(sorts) .wide[!is_narrow] { button type="button" { (name) } }
                        }
                    } }
                    @for shown in &sample.shown { (row(shown)) }
                }
            }
        }
    }
}

/// What is not shown.
fn not_all(sample: &Sample) -> String {
    let left_out = sample.counts.iter().filter(|(_, (shown, all))| shown < all);
    let said = left_out.map(|(fate, (shown, all))| match fate {
        Fates::Wrong | Fates::Broke => format!("the first {shown} of {all} that {}", fate.phrase()),
        _ => format!("{shown} of {all} that {}, evenly spaced", fate.phrase()),
    });
    format!(
        "Not every case is shown: {}. The report in JSON names every one that failed.",
        said.collect::<Vec<_>>().join("; ")
    )
}

fn controls(report: &Report, sample: &Sample) -> Markup {
    let generators: BTreeSet<_> = sample.shown.iter().map(|shown| shown.case.named.generator).collect();
    html! {
        form #filters role="search" aria-label="cases" hidden {
            label { "Text " input type="search" name="text" placeholder="name, finding, …" autocomplete="off"; }
            label { "Verdict "
                select name="verdict" {
                    option value="" { "all" }
                    @for (fate, (shown, _)) in &sample.counts { option value=(fate.class()) { (fate.says()) " (" (shown) ")" } }
                }
            }
            label { "Generator "
                select name="generator" {
                    option value="" { "all" }
                    @for generator in generators { option { (generator.name()) } }
                }
            }
            label { "Concerns "
                select name="concerns" {
                    option value="" { "all" }
                    @for oracle in &report.oracles { option { (oracle) } }
                }
            }
            button type="button" name="unfold" { "unfold all" }
            button type="reset" { "reset" }
        }
    }
}

fn row(shown: &Shown) -> Markup {
    let Shown { case, fate, place } = shown;
    let kind = Fates::from(fate);
    let concerned = case.concerned();
    let impact = case.failure.and_then(|failure| failure.findings.iter().map(Finding::impact).filter(|n| *n > 0).min());
    let parameters = &case.named.case;
    let alpha = parameters.slenderness().map(|slenderness| slenderness.alpha());
    let number = |value: Option<f64>| {
        html! { td .number .wide data-value=[value.map(|value| format!("{value:?}"))] { @if let Some(value) = value { (short(value)) } } }
    };
    html! {
        tbody #{ "case-" (place) } data-verdict=(kind.class()) data-generator=(case.named.generator.name())
            data-concerns=(concerned.join(" ")) {
            tr {
                th scope="row" { a href={ "#case-" (place) } { (case.name) } }
                td data-value=(kind as u8) { span .fate .(kind.class()) { (kind.says()) } }
                td { (concerned.join(", ")) }
                td .number .wide data-value=[impact] { @if let Some(impact) = impact { (impact) } }
                (number(Some(parameters.epsilon())))
                (number(Some(parameters.omega())))
                (number(Some(parameters.eta())))
                (number(alpha))
            }
            @if let Some(failure) = case.failure {
                tr .more { td colspan=(COLUMNS.len()) { (unfolded(failure)) } }
            } @else if !matches!(fate, Fate::Passed) {
                tr .more { td colspan=(COLUMNS.len()) { (fate.to_string()) } }
            }
        }
    }
}
