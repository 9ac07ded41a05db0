//! The report for people.

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};

use super::{FailedCase, Report, WorstFigure};
use crate::{
    cases::case_file,
    gate::{examine::Finding, laws::Law},
    measure::observables::Observable,
};

/// The whole report.
pub fn text(report: &Report) -> String {
    let mut out = String::new();
    let line = |out: &mut String, text: &str| {
        out.push_str(text);
        out.push('\n');
    };
    let reach = &report.reach;
    let generators: Vec<String> =
        reach.by_generator.iter().map(|(generator, count)| format!("{count} {}", generator.name())).collect();
    line(&mut out, &format!("chattercheck {}, seed {}", report.version, report.seed));
    line(
        &mut out,
        &format!(
            "{} cases ({}), {} oracles, {} impacts",
            reach.cases,
            generators.join(", "),
            report.oracles.len(),
            reach.impacts
        ),
    );
    let endings: Vec<String> = reach.endings.iter().map(|(ending, count)| format!("{count} {ending}")).collect();
    line(&mut out, &format!("histories: {}", endings.join(", ")));
    if let Some(deepest) = reach.deepest_interval {
        line(&mut out, &format!("shortest interval agreed on: {deepest:.1e}"));
    }
    for (name, range) in [("epsilon = a - 1", reach.epsilon), ("omega", reach.omega), ("eta", reach.eta)] {
        if let Some((low, high)) = range {
            line(&mut out, &format!("{name} from {low:.6} to {high:.6}"));
        }
    }
    for (oracle, reasons) in &report.declines {
        let reasons: Vec<String> = reasons.iter().map(|(reason, count)| format!("{count} {reason}")).collect();
        line(&mut out, &format!("declined by {oracle}: {}", reasons.join(", ")));
    }
    line(&mut out, "");
    line(
        &mut out,
        "Worst figure of each pair: the difference, and how much of the allowance it used. Allowed is the sum of what the two claim,\n\
         and across models the model gap. Intervals, velocities and ratios are relative. wide: impacts with claims so wide that nearly\n\
         anything would pass; close: cases nearer to a_cr than the claims can tell; red: cases in which the two disagree.",
    );
    line(&mut out, &pairs(report));
    line(&mut out, "");
    line(&mut out, &cases_of_worst(report));
    line(&mut out, "");
    line(
        &mut out,
        &format!(
            "What each oracle claims in multiples of its true error, by the judge, on {} cases ({} asked): the median, and the\n\
             smallest (below 1 the claim is too small).",
            report.judged.cases, report.judged.asked
        ),
    );
    line(&mut out, &claims(report));
    line(&mut out, "");
    for (ladder, held) in ladders(report) {
        line(&mut out, &format!("{ladder}: {held}"));
    }
    for law in Law::ALL {
        let broken =
            report.failures.iter().filter(|failure| failure.findings.iter().any(|finding| finding.breaks(law))).count();
        let held = if broken == 0 { "holds in every history".to_owned() } else { format!("BROKEN in {broken} cases") };
        line(&mut out, &format!("{}: {held}", law.says()));
    }
    line(&mut out, "");
    for shortfall in &report.shortfalls {
        line(&mut out, &format!("SHORTFALL: {shortfall}"));
    }
    for failure in report.failures.iter().take(SHOWN) {
        line(&mut out, &failure_text(failure));
    }
    if report.failures.len() > SHOWN {
        line(&mut out, &format!("and {} more failed cases, all in the JSON report", report.failures.len() - SHOWN));
    }
    let (failed, short) = (report.failures.len(), report.shortfalls.len());
    let verdict = if report.passes() {
        "PASS: every oracle agrees with every other".to_owned()
    } else {
        format!("FAIL: {failed} of {} cases failed; {short} shortfalls of the run as a whole", reach.cases)
    };
    line(&mut out, &verdict);
    out
}

/// How many failed cases the text shows.
const SHOWN: usize = 10;

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

/// The cases that came nearest to failing, one for each observable.
fn cases_of_worst(report: &Report) -> String {
    let mut out = String::from("Nearest to its allowance:");
    for observable in Observable::OF_AN_IMPACT.into_iter().chain([Observable::ChatteringTime]) {
        let worst = report
            .pairs
            .iter()
            .filter_map(|pair| Some((pair, pair.worst.get(&observable)?)))
            .max_by(|(_, one), (_, two)| one.share.total_cmp(&two.share));
        if let Some((pair, WorstFigure { figure, share, case })) = worst {
            let [one, two] = &pair.oracles;
            let at = if figure.impact > 0 { format!(", impact {}", figure.impact) } else { String::new() };
            let _ = write!(out, "\n  {observable:15} {:3.0} % in {case}{at} ({one} : {two})", 100.0 * share);
        }
    }
    out
}

fn ladders(report: &Report) -> Vec<(&'static str, String)> {
    crate::gate::ladder::Ladder::ALL
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

/// One failed case, as someone has to read it whose run just went red.
pub fn failure_text(failure: &FailedCase) -> String {
    let mut out = format!("FAILED {}", failure.name);
    if let Ok(case) = failure.case.case() {
        let _ = write!(out, "\n  {}", case_file::flags(&case));
    }
    for finding in &failure.findings {
        let _ = write!(out, "\n  {}", finding_text(finding));
    }
    if !failure.confirmed.is_empty() {
        let _ = write!(out, "\n  the judge confirms {}", failure.confirmed.join(", "));
    }
    if let Some(suspect) = suspect(&failure.findings) {
        let _ = write!(out, "\n  in every failing pair: {suspect}");
    }
    out
}

/// The one oracle that is in all of several failing pairs.
fn suspect(findings: &[Finding]) -> Option<&str> {
    let pairs: Vec<Vec<&str>> = findings.iter().map(Finding::oracles).filter(|oracles| oracles.len() == 2).collect();
    let mut in_all = pairs.first()?.iter().filter(|oracle| pairs.iter().all(|pair| pair.contains(oracle)));
    match (pairs.len(), in_all.next(), in_all.next()) {
        (2.., Some(oracle), None) => Some(oracle),
        _ => None,
    }
}

/// One finding in one line: who, what, where first, and by how much.
pub fn finding_text(finding: &Finding) -> String {
    match finding {
        Finding::Pair { oracles: [one, two], disagreement } => {
            let figure = disagreement.figure;
            let place = if figure.impact > 0 { format!(", first at impact {}", figure.impact) } else { String::new() };
            let [mine, theirs] = &disagreement.values;
            let poisoned = match disagreement.poisoned {
                0 => String::new(),
                count => format!("; {count} later impacts not judged"),
            };
            let size = if figure.difference.is_finite() {
                format!(" (difference {:.2e}, allowed {:.2e})", figure.difference, figure.allowed)
            } else {
                String::new()
            };
            format!(
                "{one} : {two} disagree on {}{place}: {mine} against {theirs}{size}{poisoned}",
                disagreement.observable
            )
        }
        Finding::Refuted { oracle, judge, disagreement } => {
            let figure = disagreement.figure;
            let place = if figure.impact > 0 { format!(", first at impact {}", figure.impact) } else { String::new() };
            let [proven, answered] = &disagreement.values;
            let size = if figure.difference.is_finite() {
                format!(" (off by {:.2e}, claimed {:.2e})", figure.difference, figure.allowed)
            } else {
                String::new()
            };
            format!(
                "{oracle} is WRONG on {}{place}: {answered}, proven {proven} by {judge}{size}",
                disagreement.observable
            )
        }
        Finding::Law { oracle, breach } => {
            let place = if breach.impact > 0 { format!(" at impact {}", breach.impact) } else { String::new() };
            format!("{oracle} breaks \"{}\"{place}: {}", breach.law.says(), breach.how)
        }
    }
}
