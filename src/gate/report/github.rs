//! The report as workflow commands of GitHub, which shows them as annotations of a run.
//!
//! GitHub shows ten of a kind in a step: one for each cause, the rest summed up in the last.

use super::{
    FailedCase, Report,
    cut::{cut, one_line},
    failure_text, text,
};
use crate::gate::{
    failure::{by_cause, likewise},
    responses,
    verdict::Verdict,
};

/// How many annotations of a kind GitHub shows.
pub const MOST: usize = 10;
/// The letters of one message.
const LONGEST: usize = 4000;

/// An annotation: its title, and its text.
type Annotation = (String, String);

/// The commands, a line each: what is wrong as errors, what broke as warnings, a run that is well as a notice.
pub fn annotations(report: &Report) -> String {
    let (mut errors, mut warnings) = (Vec::new(), Vec::new());
    for shortfall in &report.shortfalls {
        let kind = if shortfall.verdict() == Verdict::Fail { &mut errors } else { &mut warnings };
        kind.push(("the run falls short".to_owned(), shortfall.to_string()));
    }
    for (cause, group) in by_cause(&report.failures, FailedCase::cause) {
        let Some((first, others)) = group.split_first() else { continue };
        let others: Vec<&str> = others.iter().map(|failure| failure.name.as_str()).collect();
        let likewise = if others.is_empty() { String::new() } else { format!("\n{}", likewise(&others)) };
        let title = format!("{} failed cases point to {cause}", group.len());
        let kind = if first.is_breakdown() { &mut warnings } else { &mut errors };
        kind.push((title, failure_text(first) + &likewise));
    }
    if let Some(of) = &report.responses {
        for shortfall in &of.shortfalls {
            let kind = if shortfall.verdict() == Verdict::Fail { &mut errors } else { &mut warnings };
            kind.push(("the whole responses fall short".to_owned(), shortfall.to_string()));
        }
        if !of.failures.is_empty() {
            let title = format!("{} of {} whole responses failed", of.failures.len(), of.tally.responses);
            errors.push((title, responses::failures_text(of)));
        }
    }
    let mut notices = Vec::new();
    if report.verdict == Verdict::Pass {
        notices.push(("chattercheck".to_owned(), text::verdict(report)));
    }
    [("error", errors), ("warning", warnings), ("notice", notices)]
        .into_iter()
        .flat_map(|(kind, all)| at_most_ten(all).into_iter().map(move |annotation| command(kind, &annotation)))
        .collect()
}

/// The text of a report between commands that keep GitHub from obeying what stands in it, as an engine may have put it there.
pub fn not_obeyed(text: &str) -> String {
    // Nothing that is in the text ends it.
    let word = (0_u64..).map(|n| format!("chattercheck-{n}")).find(|word| !text.contains(word.as_str()));
    let word = word.unwrap_or_default();
    format!("::stop-commands::{word}\n{}\n::{word}::\n", text.trim_end_matches('\n'))
}

/// The rest is summed up in the last.
fn at_most_ten(mut all: Vec<Annotation>) -> Vec<Annotation> {
    if all.len() > MOST {
        let rest = all.split_off(MOST - 1);
        let titles: Vec<String> = rest.iter().map(|(title, _)| one_line(title)).collect();
        all.push((format!("and {} more", rest.len()), titles.join("\n")));
    }
    all
}

fn command(kind: &str, (title, message): &Annotation) -> String {
    let title = escaped(&cut(title, 200, " ")).replace(':', "%3A").replace(',', "%2C");
    format!("::{kind} title={title}::{}\n", escaped(&cut(message.trim_end(), LONGEST, "\n")))
}

fn escaped(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_end_a_command_is_escaped() {
        let annotation = ("50 %: a, b\n::error::".to_owned(), "1:2, 100%\r\nnext".to_owned());
        let expected = "::error title=50 %25%3A a%2C b%0A%3A%3Aerror%3A%3A::1:2, 100%25%0D%0Anext\n";
        assert_eq!(command("error", &annotation), expected);
    }

    #[test]
    fn the_last_of_ten_sums_up_the_rest() {
        let all = |count: usize| (0..count).map(|n| (format!("title {n}"), String::new())).collect::<Vec<_>>();
        assert_eq!(at_most_ten(all(10)), all(10));
        let shown = at_most_ten(all(13));
        assert_eq!((shown.len(), &shown[..9]), (10, &all(9)[..]));
        let last = ("and 4 more".to_owned(), "title 9\ntitle 10\ntitle 11\ntitle 12".to_owned());
        assert_eq!(shown[9], last);
    }

    #[test]
    fn commands_in_the_text_stay_stopped() {
        let text = "FAIL\n::chattercheck-0::\n::error::no\n";
        assert_eq!(not_obeyed(text), format!("::stop-commands::chattercheck-1\n{text}::chattercheck-1::\n"));
    }
}
