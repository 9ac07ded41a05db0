//! The cases of a run one by one, each with what became of it: what the reports that list cases have in common.

use std::{
    collections::{HashMap, HashSet},
    fmt,
};

use super::{EngineReport, FailedCase, Report, engines::is_to_blame};
use crate::{
    cases::generate::Named,
    gate::{
        finding::Finding,
        outcome::{KnownHere, Outcome, Outcomes, Without},
    },
};

/// A case of a run, with what became of it.
pub struct Listed<'a> {
    /// The case.
    pub named: &'a Named,
    /// Its name, as in `random/17`.
    pub name: String,
    /// What was wrong with it, if anything.
    pub failure: Option<&'a FailedCase>,
    /// Whether it was not run.
    pub is_left_out: bool,
    /// Who said what, and how long it took, if that is known.
    pub outcome: Option<&'a Outcome>,
    /// Failures of engines that are known and were met in it.
    pub known: &'a [KnownHere],
    report: &'a Report,
}

/// What became of a case, or of one engine in it. The worst comes first.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fate {
    /// Something is wrong.
    Wrong,
    /// An engine broke, in this way, and nothing is wrong.
    Broke(String),
    /// It was not run.
    LeftOut,
    /// It fails as is known, for this reason.
    Known(String),
    /// Nothing could be compared, for these reasons.
    Declined(String),
    /// All is well.
    Passed,
}

impl Fate {
    /// The word for it.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Wrong => "wrong",
            Self::Broke(_) => "broke",
            Self::LeftOut => "left out",
            Self::Known(_) => "known",
            Self::Declined(_) => "declined",
            Self::Passed => "passed",
        }
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong | Self::Passed => f.write_str(self.word()),
            Self::LeftOut => f.write_str("left out: the run was interrupted"),
            Self::Broke(why) | Self::Known(why) | Self::Declined(why) => write!(f, "{}: {why}", self.word()),
        }
    }
}

/// The cases of a run, in their order.
pub fn listed<'a>(
    report: &'a Report,
    cases: &'a [Named],
    outcomes: &'a Outcomes,
) -> impl Iterator<Item = Listed<'a>> + use<'a> {
    let failures: HashMap<&str, &FailedCase> =
        report.failures.iter().map(|failure| (failure.name.as_str(), failure)).collect();
    let by_name = outcomes.by_name();
    let left_out: HashSet<&str> = report.left_out.iter().map(String::as_str).collect();
    cases.iter().map(move |named| {
        let name = named.to_string();
        Listed {
            named,
            failure: failures.get(name.as_str()).copied(),
            is_left_out: left_out.contains(name.as_str()),
            outcome: by_name.get(name.as_str()).copied(),
            known: outcomes.known(&name),
            name,
            report,
        }
    })
}

impl Listed<'_> {
    /// What became of it.
    pub fn fate(&self) -> Fate {
        match self.failure {
            Some(failure) if failure.is_breakdown() => Fate::Broke(breakdowns(&failure.findings, |_| true)),
            Some(_) => Fate::Wrong,
            None if self.is_left_out => Fate::LeftOut,
            None => self.known_fate(|_| true).or_else(|| self.nothing_compared()).unwrap_or(Fate::Passed),
        }
    }

    /// What became of it as far as the oracles beside the engines go: what an engine did wrong is told by [`Listed::fate_of`].
    pub fn fate_without_engines(&self) -> Fate {
        let is_engine = |oracle: &&str| self.report.engines.iter().any(|of| of.engine.name == **oracle);
        let of_panel = |finding: &&Finding| !finding.oracles().iter().any(is_engine);
        match self.failure {
            Some(failure) if failure.findings.iter().any(|finding| of_panel(&finding)) => Fate::Wrong,
            Some(failure) => {
                // Somebody has to tell it.
                let mut engines = self.report.engines.iter();
                let is_told = engines.any(|of| failure.is_breakdown() || is_to_blame(&of.engine.name, failure));
                if is_told { Fate::Passed } else { Fate::Wrong }
            }
            None if self.is_left_out => Fate::LeftOut,
            None => self.nothing_compared().unwrap_or(Fate::Passed),
        }
    }

    /// What became of an engine in it.
    pub fn fate_of(&self, engine: &EngineReport) -> Fate {
        let name = engine.engine.name.as_str();
        let is_its = |finding: &Finding| finding.oracles().contains(&name);
        if let Some(failure) = self.failure.filter(|failure| failure.findings.iter().any(is_its)) {
            if is_to_blame(name, failure) {
                return Fate::Wrong;
            }
            let broke = breakdowns(&failure.findings, is_its);
            if !broke.is_empty() {
                return Fate::Broke(broke);
            }
        }
        if self.is_left_out {
            return Fate::LeftOut;
        }
        let declined = || match self.outcome?.without(self.place_of(name)?)? {
            Without::Declined(reason) => Some(Fate::Declined(reason.to_string())),
            Without::Broke(_) | Without::Panicked => None,
        };
        self.known_fate(|oracle| oracle == name).or_else(declined).unwrap_or(Fate::Passed)
    }

    /// Whom its findings are about, but those with which nothing is wrong, and who declined it.
    pub fn concerned(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        let is_sound =
            |name: &&str| self.failure.is_some_and(|failure| failure.sound.iter().any(|sound| sound == name));
        let findings = self.failure.iter().flat_map(|failure| &failure.findings).flat_map(Finding::oracles);
        let findings = findings.filter(|name| !is_sound(name));
        let declined = self.oracles_without().map(|(oracle, _)| oracle);
        for name in findings.chain(self.known.iter().map(|known| known.oracle.as_str())).chain(declined) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// The oracles that gave no history, and why not.
    pub fn oracles_without(&self) -> impl Iterator<Item = (&str, &Without)> {
        self.report
            .oracles
            .iter()
            .enumerate()
            .filter_map(|(place, oracle)| Some((oracle.as_str(), self.outcome?.without(place)?)))
    }

    /// How long an oracle took, in seconds as measured, if that is known.
    pub fn seconds_of(&self, oracle: &str) -> Option<f64> {
        self.outcome?.seconds_of(self.place_of(oracle)?)
    }

    fn place_of(&self, oracle: &str) -> Option<usize> {
        self.report.oracles.iter().position(|name| name == oracle)
    }

    fn known_fate(&self, of: impl Fn(&str) -> bool) -> Option<Fate> {
        let reasons: Vec<&str> =
            self.known.iter().filter(|known| of(&known.oracle)).map(|known| known.reason.as_str()).collect();
        (!reasons.is_empty()).then(|| Fate::Known(reasons.join("; ")))
    }

    /// A case of which fewer than two histories were given, and none was judged, was held against nothing.
    fn nothing_compared(&self) -> Option<Fate> {
        let outcome = self.outcome?;
        let without: Vec<(&str, &Without)> = self.oracles_without().collect();
        let histories = self.report.oracles.len() - without.len();
        if histories > 1 || outcome.is_judged {
            return None;
        }
        let said = |(oracle, why): (&str, &Without)| match why {
            Without::Declined(reason) => Some(format!("{oracle}: {reason}")),
            Without::Broke(_) | Without::Panicked => None,
        };
        let said: Vec<String> = without.into_iter().filter_map(said).collect();
        (!said.is_empty()).then(|| Fate::Declined(said.join("; ")))
    }
}

/// The ways in which engines broke.
fn breakdowns(findings: &[Finding], wanted: impl Fn(&Finding) -> bool) -> String {
    let ways = findings.iter().filter(|finding| wanted(finding)).filter_map(|finding| match finding {
        Finding::Broke { breakdown, .. } => Some(breakdown.as_str()),
        _ => None,
    });
    ways.collect::<Vec<_>>().join("; ")
}
