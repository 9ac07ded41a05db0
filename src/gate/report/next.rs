//! What to do next.

use super::Report;
use crate::gate::verdict::Verdict;

/// What to do next, in a sentence. Replay files go to the folder of this name, if there are any.
pub fn next(report: &Report, replays: Option<&str>) -> String {
    let failed = report.failures.len() + report.responses.as_ref().map_or(0, |of| of.failures.len());
    match report.verdict {
        Verdict::Pass => format!("another seed: --seed {}", report.seed.wrapping_add(1)),
        Verdict::Undecided if !report.broke.is_empty() => {
            "mend what broke the engine; `chattercheck engine ask` shows the talk about a case".to_owned()
        }
        Verdict::Undecided => "run it again to its end; --partition K/N runs a share of the cases".to_owned(),
        Verdict::Fail if failed == 0 => advice(report),
        Verdict::Fail => match replays {
            Some(folder) => format!(
                "the smallest cases that still fail go to {folder}; run them again with `chattercheck replay`, scenes with `chattercheck response`"
            ),
            None => "the commands beside each case show its histories".to_owned(),
        },
    }
}

/// What to do about the shortfalls, each thing once.
fn advice(report: &Report) -> String {
    let is_engine = |oracle: &&str| report.engines.iter().any(|of| of.engine.name == **oracle);
    let mut all: Vec<&str> = Vec::new();
    for shortfall in &report.shortfalls {
        let advice = shortfall.advice(shortfall.oracles().iter().any(&is_engine));
        if !all.contains(&advice) {
            all.push(advice);
        }
    }
    if all.is_empty() { "see which methods the shortfalls name".to_owned() } else { all.join("; ") }
}
