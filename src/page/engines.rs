//! The engines of a run, a card each.

use std::collections::BTreeMap;

use maud::{Markup, html};

use super::{class, profile::profile};
use crate::gate::report::{Engine, EngineReport, Granted, Report, explained};

pub(super) fn section(report: &Report) -> Markup {
    if report.engines.is_empty() {
        return html! {};
    }
    html! {
        section #engines {
            h2 { "Engines" }
            div .cards { @for engine in &report.engines { (card(engine, report)) } }
        }
    }
}

fn card(of: &EngineReport, report: &Report) -> Markup {
    let EngineReport {
        engine, answered, declined, broke, wrong, verdict, profile: of_engine, explanations, signs, ..
    } = of;
    let Engine { name, says, receipt, .. } = engine;
    let right = answered.saturating_sub(*wrong);
    html! {
        article .card .(class(*verdict)) {
            h3 { (name) " " span .badge { (verdict.to_string()) } }
            p .says { (says) @if !receipt.is_empty() { " · " (receipt) } }
            (bar(&[("passed", right), ("wrong", *wrong), ("broke", *broke), ("declined", *declined)]))
            div .halves {
                div {
                    @if let Some(found) = explanations {
                        h4 { "What would explain it" }
                        ul .explained { @for line in explained(found).iter().chain(signs) { li { (line) } } }
                    }
                    (facts(of, report))
                }
                @if let Some(found) = of_engine { div { (profile(name, found)) } }
            }
        }
    }
}

/// What it answered and what it is allowed.
fn facts(of: &EngineReport, report: &Report) -> Markup {
    let EngineReport { engine, answered, declined, not_asked, broke, known, wrong, .. } = of;
    let Engine { name, claims, granted, .. } = engine;
    let reasons = |of: Option<&BTreeMap<String, usize>>| {
        let said = of.into_iter().flatten().map(|(reason, count)| format!("{count} {reason}"));
        said.collect::<Vec<_>>().join(", ")
    };
    html! {
            dl {
                dt { "answered" }
                dd { (answered) " cases, " (wrong) " of them wrong" @if *known > 0 { ", " (known) " wrong as is known" } }
                @if *not_asked > 0 { dt { "not asked" } dd { (not_asked) ", for they have no slenderness (alpha)" } }
                @if *declined > 0 { dt { "declined" } dd { (reasons(report.declines.get(name))) } }
                @if *broke > 0 { dt { "broke" } dd { (reasons(report.broke.get(name))) } }
                dt { "errors" }
                dd {
                    @if *claims { "as it claims them" } @else { (grants(granted)) }
                }
                @for known in report.known_failures.iter().filter(|known| known.oracle == *name) {
                    dt { "known" }
                    dd {
                        (known.says) ": failed in " (known.failed) " of " (known.met) " cases: " (known.reason)
                        @if let Some(link) = &known.link { " (" (link) ")" }
                    }
                }
            }
    }
}

fn grants(granted: &Granted) -> Markup {
    let Granted { time, interval, velocity, tau_ch, reason } = granted;
    html! {
        "it claims none; granted by its manifest, times 1 + κ: time " (format!("{time:e}")) ", interval " (format!("{interval:e}"))
        ", velocity " (format!("{velocity:e}")) ", chattering time " (format!("{tau_ch:e}"))
        @if !reason.is_empty() { " (" (reason) ")" }
    }
}

/// Shares of a whole, as a bar.
fn bar(shares: &[(&str, usize)]) -> Markup {
    let all: usize = shares.iter().map(|(_, count)| count).sum();
    let percent = |count: usize| 100.0 * count as f64 / all.max(1) as f64;
    let said = shares.iter().filter(|(_, count)| *count > 0).map(|(word, count)| format!("{count} {word}"));
    let parts = shares.iter().scan(0, |before, (word, count)| {
        let from = percent(*before);
        *before += count;
        Some((*word, from, percent(*count)))
    });
    html! {
        svg .bar viewBox="0 0 100 6" preserveAspectRatio="none" role="img" aria-label=(said.collect::<Vec<_>>().join(", ")) {
            @for (word, from, width) in parts {
                @if width > 0.0 { rect .(word) x=(format!("{from:.3}")) y="0" width=(format!("{width:.3}")) height="6" {} }
            }
        }
    }
}
