//! What a run exercised: what was run, what every oracle and every pair did, and how narrow it was.

use maud::{Markup, html};

use crate::{
    gate::{
        pair::Pair,
        report::{Report, exercised, narrow_and_left_out},
    },
    measure::observables::Observable,
};

/// How many pairs are listed.
const MOST: usize = 300;

/// The figures of a pair.
const FIGURES: [(Observable, &str); 5] = [
    (Observable::Interval, "interval"),
    (Observable::Velocity, "velocity"),
    (Observable::ImpactTime, "time"),
    (Observable::IntervalRatio, "ratio"),
    (Observable::ChatteringTime, "τ_ch"),
];

pub(super) fn section(report: &Report) -> Markup {
    html! {
        section #exercised {
            h2 { "What was exercised" }
            dl .facts {
                @for (head, said) in exercised(report).into_iter().chain(narrow_and_left_out(report)) {
                    dt { (head) } dd { (said) }
                }
            }
            (oracles(report))
            (pairs(report))
        }
    }
}

fn oracles(report: &Report) -> Markup {
    html! {
        details {
            summary { (report.oracles.len()) " oracles" }
            div .scroll tabindex="0" role="region" aria-label="oracles" {
                table {
                    thead { tr { th scope="col" { "oracle" } th scope="col" { "answered" } th scope="col" { "declined" } } }
                    tbody {
                        @for oracle in &report.oracles {
                            @let reasons = report.declines.get(oracle);
                            @let reasons = reasons.into_iter().flatten().map(|(reason, count)| format!("{count} {reason}"));
                            tr {
                                th scope="row" { (oracle) }
                                td .number { (report.answered.get(oracle).copied().unwrap_or(0)) }
                                td { (reasons.collect::<Vec<_>>().join(", ")) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn pairs(report: &Report) -> Markup {
    let figure = |pair: &Pair, observable: &Observable| {
        let worst = pair.worst.get(observable)?;
        Some(format!("{:.0e} · {:.0} %", worst.figure.difference, 100.0 * worst.share))
    };
    html! {
        details {
            summary { (report.pairs.len()) " pairs: the worst difference of each, and how much it used of what is allowed" }
            div .scroll tabindex="0" role="region" aria-label="pairs" {
                table {
                    thead { tr {
                        th scope="col" { "pair" }
                        th scope="col" { "cases" }
                        th scope="col" { "impacts" }
                        th scope="col" { "disagree" }
                        @for (_, head) in FIGURES { th scope="col" { (head) } }
                    } }
                    tbody {
                        @for pair in report.pairs.iter().take(MOST) {
                            tr {
                                th scope="row" { (pair.oracles.join(" : ")) }
                                td .number { (pair.compared) }
                                td .number { (pair.impacts) }
                                td .number { (pair.disagreements) }
                                @for (observable, _) in &FIGURES { td .number { (figure(pair, observable).unwrap_or_default()) } }
                            }
                        }
                    }
                }
            }
            @if report.pairs.len() > MOST { p { "and " (report.pairs.len() - MOST) " more" } }
        }
    }
}
