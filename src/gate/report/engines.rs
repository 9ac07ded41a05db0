//! What a report says of the engines in a run, the simulators of somebody else.

use std::collections::BTreeMap;

use contract::Decline;
use serde::{Deserialize, Serialize};

use super::{FailedCase, Report, profiles};
use crate::gate::{
    explanation::{Explained, Explanation},
    failure::Cause,
    profile::Profile,
    run::Run,
    shortfall::{MOST_DECLINES_OF_FEW, Shortfall},
    verdict::Verdict,
};

/// An engine, as it is known before it is asked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Engine {
    /// Its name in the manifest.
    pub name: String,
    /// Its own name, version and language, as it says.
    pub says: String,
    /// What its version command printed; empty without one.
    pub receipt: String,
    /// Whether it claims errors itself.
    pub claims: bool,
    /// What its user grants it where it claims none.
    pub granted: Granted,
}

/// Errors that a user grants an engine, times `1 + κ`, with `κ` the conditioning of each observable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Granted {
    /// Of a time, absolute.
    pub time: f64,
    /// Of an interval, relative.
    pub interval: f64,
    /// Of a velocity, relative.
    pub velocity: f64,
    /// Of the chattering time, absolute.
    pub tau_ch: f64,
    /// Why.
    pub reason: String,
}

/// What became of an engine in a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EngineReport {
    /// Which.
    #[serde(flatten)]
    pub engine: Engine,
    /// In how many cases it gave a history.
    pub answered: usize,
    /// How many cases it declined.
    pub declined: usize,
    /// How many it was not asked: its model needs a slenderness, and they have none.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub not_asked: usize,
    /// Over how many it broke.
    pub broke: usize,
    /// In how many it fails as is known of it.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub known: usize,
    /// In how many something is wrong with its answer, or it is in every pair that disagrees.
    pub wrong: usize,
    /// Its own verdict.
    pub verdict: Verdict,
    /// How good it is; `None` where that was not looked at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profile: Option<Profile>,
    /// What mistakes would explain its wrong answers: those that explain most, the best first, and all that do so equally well; empty if none of the
    /// catalogue does. `None` if nothing is wrong, or it was not looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explanations: Option<Vec<Explanation>>,
    /// What can be read off the numbers of one that is wrong, in words.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub signs: Vec<String>,
}

impl Report {
    /// The same with what became of these engines, as it was counted. One that answered nothing turns any run red.
    #[must_use]
    pub fn with_engines(mut self, engines: Vec<Engine>, run: &Run) -> Self {
        for engine in engines {
            let name = &engine.name;
            let answered = self.answered.get(name).copied().unwrap_or(0);
            let count = |by_reason: &BTreeMap<String, usize>| by_reason.values().sum();
            // What its model can't be asked, it did not refuse.
            let not_asked = self.declines.get(name).and_then(|of| of.get(Decline::NeedsSlenderness.reason()));
            let not_asked = not_asked.copied().unwrap_or(0);
            let declined = self.declines.get(name).map_or(0, count) - not_asked;
            let broke = self.broke.get(name).map_or(0, count);
            self.shortfalls.retain_mut(|shortfall| is_of_asked(name, not_asked, shortfall));
            let silent = Shortfall::Silent { oracle: name.clone() };
            if answered + broke + declined == 0 && not_asked > 0 {
                self.shortfalls.retain(|shortfall| *shortfall != silent);
                self.shortfalls.push(Shortfall::NotAsked { oracle: name.clone(), cases: not_asked });
            } else if answered + broke == 0 && !self.shortfalls.contains(&silent) {
                self.shortfalls.push(silent);
            }
            if !engine.claims {
                for finding in self.failures.iter_mut().flat_map(|failure| &mut failure.findings) {
                    finding.grant(name);
                }
            }
            let wrong = self.failures.iter().filter(|failure| is_to_blame(name, failure)).count();
            let profile = run.tally.profiles.get(name).cloned();
            let known = run.outcomes.cases_known_of(name);
            let explanations = None;
            self.engines.push(EngineReport {
                engine,
                answered,
                declined,
                not_asked,
                broke,
                known,
                wrong,
                verdict: Verdict::Pass,
                profile,
                explanations,
                signs: Vec::new(),
            });
        }
        self.concluded()
    }

    /// The same with what would explain the wrong answers of each engine, by its name. It is asked about those only that got something wrong.
    #[must_use]
    pub fn explained(mut self, explain: impl Fn(&str) -> Option<Explained>) -> Self {
        for engine in self.engines.iter_mut().filter(|engine| engine.wrong > 0) {
            let Some(Explained { explanations, signs }) = explain(&engine.engine.name) else { continue };
            (engine.explanations, engine.signs) = (Some(explanations), signs);
        }
        self
    }
}

/// Leaves what this engine was not asked out of what it declined; whether the shortfall still is one.
fn is_of_asked(name: &str, not_asked: usize, shortfall: &mut Shortfall) -> bool {
    let Shortfall::Declined { oracle, declined, cases, allowed } = shortfall else { return true };
    if oracle != name || not_asked == 0 {
        return true;
    }
    let share = *allowed / *cases as f64;
    *declined = declined.saturating_sub(not_asked);
    *cases = cases.saturating_sub(not_asked);
    *allowed = (share * *cases as f64).max(MOST_DECLINES_OF_FEW);
    *declined as f64 > *allowed
}

/// Whether a failure points to this oracle, and not only because it broke.
pub(super) fn is_to_blame(name: &str, failure: &FailedCase) -> bool {
    match failure.cause() {
        Cause::Oracles(oracles) => oracles.iter().any(|oracle| oracle == name),
        Cause::Pairs(pairs) => pairs.iter().flatten().any(|oracle| oracle == name),
        Cause::Judge(_) => {
            failure.findings.iter().any(|finding| !finding.is_breakdown() && finding.oracles().contains(&name))
        }
        Cause::Broken(..) => false,
    }
}

/// The lines about the engines in the report for people.
pub(super) fn lines(report: &Report) -> Vec<String> {
    let mut lines = Vec::new();
    for of in &report.engines {
        let EngineReport {
            engine,
            answered,
            declined,
            not_asked,
            broke,
            known,
            wrong,
            verdict,
            profile,
            explanations,
            ..
        } = of;
        let Engine { name, says, receipt, claims, granted } = engine;
        let receipt = if receipt.is_empty() { String::new() } else { format!("; {receipt}") };
        let mut said = format!("{name} ({says}{receipt}): {verdict}, {answered} cases answered");
        for (count, what) in [
            (wrong, "wrong"),
            (known, "wrong as is known"),
            (declined, "declined"),
            (not_asked, "not asked, for they have no slenderness (alpha)"),
            (broke, "broke it"),
        ] {
            if *count > 0 {
                said += &format!(", {count} {what}");
            }
        }
        lines.push(format!("  {:12} {said}", "engine"));
        let mut more = Vec::new();
        if !claims {
            let Granted { time, interval, velocity, tau_ch, reason } = granted;
            let by = if reason.is_empty() { "nothing is granted by its manifest".to_owned() } else { reason.clone() };
            more.push(format!(
                "it claims no errors; granted by the manifest: time {time:e}, interval {interval:e}, velocity {velocity:e}, tau-ch {tau_ch:e} ({by})"
            ));
        }
        more.extend(profile.iter().flat_map(profiles::lines));
        more.extend(explanations.iter().flat_map(|found| explained(found)));
        more.extend(of.signs.iter().cloned());
        lines.extend(more.into_iter().map(|said| format!("  {:12} {said}", "")));
    }
    lines
}

/// How many explanations are shown.
const EXPLANATIONS: usize = 4;

/// What would explain what is wrong, in words.
pub fn explained(found: &[Explanation]) -> Vec<String> {
    let mut lines: Vec<String> = found.iter().take(EXPLANATIONS).map(Explanation::to_string).collect();
    match found.len() {
        0 => lines.push("nothing in the catalogue of mistakes explains it".to_owned()),
        1 => {}
        many => {
            lines.insert(0, format!("{many} mistakes explain it equally well:"));
            if many > EXPLANATIONS {
                lines.push(format!("and {} more", many - EXPLANATIONS));
            }
        }
    }
    lines
}
