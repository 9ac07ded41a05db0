//! The report for people: twenty lines, the verdict first.

use std::fmt::Write;

use super::{FailedCase, Report, cut::one_line, engines};
use crate::{
    gate::{
        compare::{Disagreement, Figure},
        counting::WorstFigure,
        expected::Differs,
        failure::{by_cause, common, likewise},
        finding::Finding,
        ladder::Descent,
        pair::Pair,
        responses,
        verdict::Verdict,
    },
    measure::observables::Observable,
};

/// The report in short: what came out, what was exercised, how narrow it was, what was left out, and what to do next.
pub fn text(report: &Report) -> String {
    let mut out = verdict(report) + "\n";
    let line = |(head, said): (&str, String)| format!("  {head:12} {said}");
    let parts = [exercised(report).into_iter().map(line).collect(), engines::lines(report)];
    let rest = narrow_and_left_out(report).into_iter().map(line);
    for line in parts.into_iter().flatten().chain(rest) {
        let _ = writeln!(out, "{line}");
    }
    if report.verdict != Verdict::Pass {
        out.push('\n');
    }
    for shortfall in &report.shortfalls {
        let _ = writeln!(out, "SHORTFALL: {shortfall}");
    }
    let groups = by_cause(&report.failures, FailedCase::cause);
    for (cause, group) in groups.iter().take(CAUSES) {
        let Some((first, others)) = group.split_first() else { continue };
        let _ = writeln!(out, "{} of {} failed cases point to {cause}", group.len(), report.failures.len());
        let _ = writeln!(out, "{}", failure_text(first));
        if !others.is_empty() {
            let names: Vec<&str> = others.iter().map(|failure| failure.name.as_str()).collect();
            let _ = writeln!(out, "  {}", likewise(&names));
        }
    }
    if groups.len() > CAUSES {
        let more: usize = groups.iter().skip(CAUSES).map(|(_, group)| group.len()).sum();
        let _ = writeln!(out, "and {} other causes, in {more} more cases", groups.len() - CAUSES);
    }
    out.extend(report.responses.as_ref().map(responses::failures_text));
    out
}

/// How many causes are shown, one case each.
const CAUSES: usize = 5;

/// What came out, in a line.
pub fn verdict(report: &Report) -> String {
    let (cases, oracles) = (report.reach.cases, report.oracles.len());
    let responses = report.responses.as_ref();
    let said = match report.verdict {
        Verdict::Pass => {
            let and = responses.map_or_else(String::new, |of| format!(" and {} whole responses", of.tally.responses));
            match report.failed_as_known {
                0 => format!("{oracles} oracles agree on {cases} cases{and}"),
                known => format!(
                    "{oracles} oracles agree on {} of {cases} cases{and}; {known} fail as is known",
                    cases - known
                ),
            }
        }
        Verdict::Undecided => {
            let and = responses.map_or_else(String::new, |of| format!(" and {} whole responses", of.tally.responses));
            let broke: Vec<&str> = report.broke.keys().map(String::as_str).collect();
            let broke = match broke.as_slice() {
                [] => "interrupted".to_owned(),
                names => format!("{} broke in {} cases", names.join(" and "), report.failures.len()),
            };
            format!("{broke}; nothing was wrong in {} cases{and}", cases - report.failures.len())
        }
        Verdict::Fail => {
            let failed = format!("{} of {cases} cases failed", report.failures.len());
            let short = match report.shortfalls.len() {
                0 => String::new(),
                1 => ", and the run as a whole falls short".to_owned(),
                count => format!(", and the run as a whole falls short in {count} ways"),
            };
            let wrong = responses.filter(|of| of.verdict() == Verdict::Fail && of.tally.responses > 0);
            let wrong = wrong.map_or_else(String::new, |of| {
                format!("; {} of {} whole responses failed", of.failures.len(), of.tally.responses)
            });
            failed + &short + &wrong
        }
    };
    format!("{}: {said} (chattercheck {}, seed {})", report.verdict, report.version, report.seed)
}

/// What was exercised, in lines of a head and what is said; a line without a head belongs to the one before.
pub fn exercised(report: &Report) -> Vec<(&'static str, String)> {
    let reach = &report.reach;
    let count = |(name, count): (&str, &usize)| format!("{count} {name}");
    let generators = reach.by_generator.iter().map(|(generator, n)| count((generator.name(), n)));
    let endings = reach.endings.iter().map(|(ending, n)| count((ending, n)));
    let range = |name: &str, range: Option<(f64, f64)>| {
        range.map(|(low, high)| format!("{name} {} to {}", short(low), short(high)))
    };
    let ranges = [range("a - 1", reach.epsilon), range("omega", reach.omega), range("eta", reach.eta)];
    let deepest = reach
        .deepest_interval
        .map_or_else(String::new, |deepest| format!(", compared down to intervals of {deepest:.0e}"));
    let mut lines = vec![
        ("cases", list(generators)),
        ("parameters", list(ranges.into_iter().flatten())),
        ("histories", list(endings)),
        ("impacts", format!("{}{deepest}", reach.impacts)),
    ];
    let judged = report.judged.asked > 0;
    let judged = judged.then(|| format!("{} cases by proven enclosures", report.judged.cases));
    let held = report.ladders.iter().filter(|descent| Descent::holds(descent)).count();
    let ladders = !report.ladders.is_empty();
    let ladders = ladders.then(|| format!("{held} of {} ladders fall at the order of theory", report.ladders.len()));
    if judged.is_some() || ladders.is_some() {
        lines.push(("judged", list(judged.into_iter().chain(ladders))));
    }
    lines
}

/// How many observables are shown with the comparison that came nearest to failing.
const NARROWEST: usize = 3;

/// The comparisons that came nearest to failing, one for an observable; `--full` has all pairs.
fn margins(report: &Report) -> Vec<(&'static str, String)> {
    let worst = |observable: Observable| {
        let all = report.pairs.iter().filter_map(|pair| Some((observable, pair, pair.worst.get(&observable)?)));
        all.max_by(|(.., one), (.., two)| one.share.total_cmp(&two.share))
    };
    let observables = Observable::OF_AN_IMPACT.into_iter().chain([Observable::ChatteringTime]);
    let mut narrowest: Vec<_> = observables.filter_map(worst).collect();
    narrowest.sort_by(|(.., one), (.., two)| two.share.total_cmp(&one.share));
    let mut lines = Vec::new();
    for (observable, pair, WorstFigure { figure, share, case }) in narrowest.into_iter().take(NARROWEST) {
        let [one, two] = &pair.oracles;
        let at = if figure.impact > 0 { format!(", impact {}", figure.impact) } else { String::new() };
        let head = if lines.is_empty() { "narrowest" } else { "" };
        let share = 100.0 * share;
        lines.push((head, format!("{share:.0} % of what is allowed: {observable}, {one} : {two} ({case}{at})")));
    }
    lines
}

/// How narrow it was, what was exercised of whole responses, and what was left out, in lines as [`exercised`].
pub fn narrow_and_left_out(report: &Report) -> Vec<(&'static str, String)> {
    let of_responses = report.responses.as_ref().map(responses::exercised).unwrap_or_default();
    [margins(report), of_responses, left_out(report)].into_iter().flatten().collect()
}

fn left_out(report: &Report) -> Vec<(&'static str, String)> {
    let mut lines: Vec<(&str, String)> = Vec::new();
    let mut add = |head, said: String| {
        let head = if lines.iter().any(|(known, _)| *known == head) { "" } else { head };
        lines.push((head, said));
    };
    let mut declined: Vec<(String, Vec<&str>)> = Vec::new();
    for (oracle, reasons) in &report.declines {
        let reasons = list(reasons.iter().map(|(reason, count)| format!("{count} {}", one_line(reason))));
        match declined.iter_mut().find(|(known, _)| *known == reasons) {
            Some((_, oracles)) => oracles.push(oracle),
            None => declined.push((reasons, vec![oracle])),
        }
    }
    for (reasons, oracles) in declined {
        add("declined", format!("{}: {reasons}", oracles.join(" and ")));
    }
    for (oracle, ways) in &report.broke {
        add("broke", format!("{oracle}: {}", list(ways.iter().map(|(way, count)| format!("{count} {way}")))));
    }
    for known in &report.known_failures {
        add("known", format!("{}: failed in {} of {} cases: {}", known.says, known.failed, known.met, known.reason));
    }
    for Pair { oracles, vacuous, impacts, .. } in &report.pairs {
        let [one, two] = oracles;
        let is_told = report.shortfalls.iter().any(|shortfall| shortfall.oracles() == [one, two]);
        // Of oracles of our own it stands in the table of pairs.
        let is_of_engine = report.engines.iter().any(|engine| oracles.contains(&engine.engine.name));
        if is_of_engine && 2 * vacuous > *impacts && !is_told {
            let said = format!(
                "{vacuous} of {impacts} impacts of {one} and {two}: what is claimed or granted is so wide that nearly anything passes"
            );
            add("in name only", said);
        }
    }
    let close = report.pairs.iter().map(|pair| pair.too_close).sum::<usize>();
    if close > 0 {
        let pairs = report.pairs.iter().filter(|pair| pair.too_close > 0).count();
        add("undecided", format!("{close} endings in {pairs} pairs, nearer to a_cr than the two claim to know"));
    }
    for known in &report.known {
        let how = match known.observable {
            Differs::ChatteringTime => format!("by up to {:.0} % in", 100.0 * known.largest),
            // Endings and orders differ or do not.
            Differs::Ending | Differs::Order if known.largest > 0.0 => "in some of".to_owned(),
            Differs::Ending | Differs::Order => "in none of".to_owned(),
        };
        add("known", format!("{}: {how} {} comparisons", known.divergence, known.cases));
    }
    let of_responses = report.responses.iter().flat_map(|of| &of.not_judged);
    for not in report.not_judged.iter().chain(of_responses) {
        add("not judged", format!("{}: too few cases, {} of {}", not.what, not.cases, not.needed));
    }
    lines
}

fn list(parts: impl IntoIterator<Item = String>) -> String {
    parts.into_iter().collect::<Vec<_>>().join(", ")
}

/// A parameter to four digits.
fn short(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    if rounded != 0.0 && rounded.abs() < 1e-3 { format!("{rounded:e}") } else { format!("{rounded}") }
}

/// What was wrong with a failed case, in a line: what the judge refutes if anything, else the first finding; and how many more there are.
pub fn headline(failure: &FailedCase) -> String {
    let refuted = failure.findings.iter().find(|finding| matches!(finding, Finding::Refuted { .. }));
    let first = refuted.or(failure.findings.first()).map_or_else(String::new, finding_text);
    match failure.findings.len() {
        0 | 1 => first,
        2 => format!("{first}; and one more finding"),
        count => format!("{first}; and {} more findings", count - 1),
    }
}

/// One failed case, as someone has to read it whose run just went red.
pub fn failure_text(failure: &FailedCase) -> String {
    // Over which an engine broke, there is no verdict.
    let head = if failure.is_breakdown() { "UNDECIDED" } else { "FAILED" };
    let mut out = format!("{head} {}", failure.name);
    for finding in &failure.findings {
        let _ = write!(out, "\n  {}", finding_text(finding));
    }
    if !failure.sound.is_empty() {
        let _ = write!(out, "\n  nothing is wrong, by the judge and the laws, with {}", failure.sound.join(", "));
    }
    for judge in &failure.suspect_judges {
        let _ = write!(out, "\n  the JUDGE is suspect: those that {judge} refutes agree among themselves");
    }
    if let Some(suspect) = common(&failure.findings) {
        let _ = write!(out, "\n  in every failing pair: {suspect}");
    }
    for command in &failure.see {
        let _ = write!(out, "\n  see it: {command}");
    }
    out
}

/// One finding in one line: who, what, where first, and by how much.
pub fn finding_text(finding: &Finding) -> String {
    match finding {
        Finding::Pair { oracles: [one, two], disagreement } => {
            let [mine, theirs] = &disagreement.values;
            let size = size(disagreement.figure, "difference", "allowed");
            let poisoned = match disagreement.poisoned {
                0 => String::new(),
                count => format!("; {count} later impacts not judged"),
            };
            format!("{one} : {two} disagree on {}: {mine} against {theirs}{size}{poisoned}", place(disagreement))
        }
        Finding::Refuted { oracle, judge, disagreement, granted } => {
            let [proven, answered] = &disagreement.values;
            let size = size(disagreement.figure, "off by", if *granted { "granted" } else { "claimed" });
            format!("{oracle} is WRONG on {}: {answered}, proven {proven} by {judge}{size}", place(disagreement))
        }
        Finding::Broke { oracle, how, .. } => format!("{oracle} BROKE: {how}"),
        Finding::Law { oracle, breach } => {
            let place = if breach.impact > 0 { format!(" at impact {}", breach.impact) } else { String::new() };
            format!("{oracle} breaks \"{}\"{place}: {}", breach.law.says(), breach.how)
        }
    }
}

fn place(disagreement: &Disagreement) -> String {
    match disagreement.figure.impact {
        0 => disagreement.observable.to_string(),
        impact => format!("{}, first at impact {impact}", disagreement.observable),
    }
}

fn size(figure: Figure, off: &str, allowed: &str) -> String {
    if figure.difference.is_finite() {
        format!(" ({off} {:.2e}, {allowed} {:.2e})", figure.difference, figure.allowed)
    } else {
        String::new()
    }
}
