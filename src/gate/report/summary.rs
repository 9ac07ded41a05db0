//! The report as Markdown, for the page of a job in a CI.
//!
//! GitHub takes at most 1 MiB; every part is capped, so that the whole stays far below.

use std::fmt::Write;

use super::{
    EngineReport, FailedCase, Report,
    cut::{cut, one_line},
    failure_text, text,
};
use crate::gate::{
    failure::{by_cause, likewise},
    responses,
};

/// How many causes are shown, how many shortfalls, and how many engines.
const CAUSES: usize = 5;
const SHORTFALLS: usize = 20;
const ENGINES: usize = 50;
/// The letters of one block of text, and of one line.
const LONGEST: usize = 4000;
const LONGEST_LINE: usize = 600;

/// The report as Markdown. Replay files go to the folder of this name, if there are any.
pub fn summary(report: &Report, replays: Option<&str>) -> String {
    let mut out = format!("## chattercheck: {}\n\n{}\n", report.verdict, line(&text::verdict(report)));
    out += &engines(&report.engines);
    out += &wrong(report);
    let _ = write!(out, "\n### What to do next\n\n{}\n", line(&super::next(report, replays)));
    let heads = [text::exercised(report), text::narrow_and_left_out(report)];
    out += "\n### What was exercised\n\n| | |\n| --- | --- |\n";
    for (head, said) in heads.into_iter().flatten() {
        let _ = writeln!(out, "| {head} | {} |", line(&said));
    }
    out
}

fn engines(engines: &[EngineReport]) -> String {
    if engines.is_empty() {
        return String::new();
    }
    let mut out =
        "\n| engine | who it says it is | verdict | answered | wrong | as known | declined | broke |\n".to_owned();
    out += "| --- | --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
    for EngineReport { engine, answered, declined, broke, known, wrong, verdict, .. } in engines.iter().take(ENGINES) {
        let receipt = if engine.receipt.is_empty() { String::new() } else { format!("; {}", engine.receipt) };
        let says = line(&format!("{}{receipt}", engine.says));
        let name = line(&engine.name);
        let counts = [answered, wrong, known, declined, broke].map(usize::to_string).join(" | ");
        let _ = writeln!(out, "| {name} | {says} | **{verdict}** | {counts} |");
    }
    if engines.len() > ENGINES {
        let _ = writeln!(out, "\nand {} more engines", engines.len() - ENGINES);
    }
    out
}

/// What is wrong, by its cause.
fn wrong(report: &Report) -> String {
    let mut out = String::new();
    let of_responses = report.responses.as_ref();
    let shortfalls = report.shortfalls.iter().map(ToString::to_string);
    let shortfalls: Vec<String> =
        shortfalls.chain(of_responses.iter().flat_map(|of| &of.shortfalls).map(ToString::to_string)).collect();
    for shortfall in shortfalls.iter().take(SHORTFALLS) {
        let _ = writeln!(out, "- the run as a whole: {}", line(shortfall));
    }
    if shortfalls.len() > SHORTFALLS {
        let _ = writeln!(out, "- and {} more shortfalls", shortfalls.len() - SHORTFALLS);
    }
    let groups = by_cause(&report.failures, FailedCase::cause);
    for (cause, group) in groups.iter().take(CAUSES) {
        let Some((first, others)) = group.split_first() else { continue };
        let (count, all) = (group.len(), report.failures.len());
        let _ = writeln!(out, "\n**{count} of {all} failed cases point to {}**\n", line(&cause.to_string()));
        out += &block(&failure_text(first));
        if !others.is_empty() {
            let names: Vec<&str> = others.iter().map(|failure| failure.name.as_str()).collect();
            let _ = writeln!(out, "\n{}", line(&likewise(&names)));
        }
    }
    if groups.len() > CAUSES {
        let more: usize = groups.iter().skip(CAUSES).map(|(_, group)| group.len()).sum();
        let _ = writeln!(out, "\nand {} other causes, in {more} more cases", groups.len() - CAUSES);
    }
    if let Some(of) = of_responses.filter(|of| !of.failures.is_empty()) {
        let _ = writeln!(out, "\n**{} of {} whole responses failed**\n", of.failures.len(), of.tally.responses);
        out += &block(&responses::failures_text(of));
    }
    if out.is_empty() { out } else { format!("\n### What is wrong\n\n{}\n", out.trim_matches('\n')) }
}

/// A text as it is, fenced by more ticks than it has in a row.
fn block(text: &str) -> String {
    let text = cut(text, LONGEST, "\n");
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}text\n{}\n{fence}\n", text.trim_end())
}

/// A text on one line that says what it says, whatever Markdown or HTML would make of it.
fn line(text: &str) -> String {
    let mut out = String::new();
    for c in cut(&one_line(text), LONGEST_LINE, " ").chars() {
        match c {
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '&' => out += "&amp;",
            '\\' | '`' | '*' | '_' | '[' | ']' | '#' | '|' | '~' | '!' => {
                out.push('\\');
                out.push(c);
            }
            // Not to be made a link of.
            '/' if out.ends_with(':') => out += "&#47;",
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_from_outside_is_markup() {
        assert_eq!(line("<b>*x*</b> | y\n# z"), "&lt;b&gt;\\*x\\*&lt;/b&gt; \\| y \\# z");
        assert_eq!(line("http://x"), "http:&#47;/x");
        assert_eq!(block("a\n```\nb"), "````text\na\n```\nb\n````\n");
    }
}
