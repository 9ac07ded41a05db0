//! The wide tables of a report: every pair, every claim, every law.

use comfy_table::{CellAlignment, Table, presets};

use super::{Report, profiles};
use crate::{
    gate::{counting::WorstFigure, ladder::Ladder, laws::Law, responses},
    measure::observables::Observable,
};

/// Everything that the tables say.
pub fn full(report: &Report) -> String {
    let mut out = format!(
        "Worst figure of each pair: the difference, and how much of the allowance it used. Allowed is the sum of what the two claim,\n\
         and across models the model gap. Intervals, velocities and ratios are relative. wide: impacts with claims so wide that nearly\n\
         anything would pass; close: cases nearer to a_cr than the claims can tell; red: cases in which the two disagree.\n{}\n\n",
        pairs(report)
    );
    out += &format!(
        "What each oracle claims in multiples of its true error, by the judge, on {} cases ({} asked): the median, and the\n\
         smallest (below 1 the claim is too small).\n{}\n\n",
        report.judged.cases,
        report.judged.asked,
        claims(report)
    );
    for (ladder, held) in ladders(report) {
        out += &format!("{ladder}: {held}\n");
    }
    for law in Law::ALL {
        let breaks = |failure: &&super::FailedCase| failure.findings.iter().any(|finding| finding.breaks(law));
        let broken = report.failures.iter().filter(breaks).count();
        let held = if broken == 0 { "holds in every history".to_owned() } else { format!("BROKEN in {broken} cases") };
        out += &format!("{}: {held}\n", law.says());
    }
    for engine in &report.engines {
        if let Some(profile) = &engine.profile {
            out += &format!("\n{}", profiles::tables(&engine.engine.name, profile));
        }
    }
    if let Some(of) = &report.responses {
        out += "\nWhole responses, each method against the plain follower.\n";
        out += &responses::methods_text(of);
    }
    out
}

fn pairs(report: &Report) -> String {
    const COLUMNS: [(Observable, &str); 5] = [
        (Observable::Interval, "interval"),
        (Observable::Velocity, "velocity"),
        (Observable::ImpactTime, "time"),
        (Observable::IntervalRatio, "ratio"),
        (Observable::ChatteringTime, "tau_ch"),
    ];
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    table.set_header(
        ["pair", "cases", "impacts", "wide", "close", "red"].into_iter().chain(COLUMNS.map(|(_, head)| head)),
    );
    for pair in &report.pairs {
        let wide = format!("{:.0}%", 100.0 * pair.vacuous as f64 / pair.impacts.max(1) as f64);
        let count = |count: usize| count.to_string();
        let counts =
            [count(pair.compared), count(pair.impacts), wide, count(pair.too_close), count(pair.disagreements)];
        let figures = COLUMNS.map(|(observable, _)| pair.worst.get(&observable).map_or("-".to_owned(), figure));
        let name = format!("{} : {}", pair.oracles[0], pair.oracles[1]);
        table.add_row(std::iter::once(name).chain(counts).chain(figures));
    }
    right_but_first(&mut table);
    table.to_string()
}

fn claims(report: &Report) -> String {
    const COLUMNS: [(Observable, &str); 4] = [
        (Observable::Interval, "interval"),
        (Observable::Velocity, "velocity"),
        (Observable::ImpactTime, "time"),
        (Observable::ChatteringTime, "tau_ch"),
    ];
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    table.set_header(["oracle", "numbers"].into_iter().chain(COLUMNS.map(|(_, head)| head)));
    for (oracle, claims) in &report.judged.claims {
        let numbers: usize = claims.values().map(|figure| figure.numbers).sum();
        let figures = COLUMNS.map(|(observable, _)| {
            claims.get(&observable).map_or("-".to_owned(), |f| format!("{} > {}", factor(f.median), factor(f.smallest)))
        });
        table.add_row([oracle.clone(), numbers.to_string()].into_iter().chain(figures));
    }
    right_but_first(&mut table);
    table.to_string()
}

/// A factor to two digits.
fn factor(value: f64) -> String {
    if (0.095..99.5).contains(&value) { format!("{value:.1}") } else { format!("{value:.0e}") }
}

fn right_but_first(table: &mut Table) {
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
        column.set_cell_alignment(CellAlignment::Right);
    }
    if let Some(names) = table.column_mut(0) {
        names.set_cell_alignment(CellAlignment::Left);
    }
}

fn figure(worst: &WorstFigure) -> String {
    format!("{:.0e} {:2.0}%", worst.figure.difference, 100.0 * worst.share)
}

fn ladders(report: &Report) -> Vec<(&'static str, String)> {
    Ladder::ALL
        .into_iter()
        .filter_map(|ladder| {
            let mine: Vec<_> = report.ladders.iter().filter(|descent| descent.ladder == ladder).collect();
            let orders = mine.iter().filter_map(|descent| descent.order);
            let (low, high) = orders.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), o| (l.min(o), h.max(o)));
            let held = mine.iter().filter(|descent| descent.holds()).count();
            (!mine.is_empty())
                .then(|| (ladder.says(), format!("{held} of {} ladders, order {low:.3} to {high:.3}", mine.len())))
        })
        .collect()
}
