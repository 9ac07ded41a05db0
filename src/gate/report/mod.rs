//! What a run found, as data; and as text, JUnit, Markdown and annotations. It counts and decides nothing itself: `shortfall` and `verdict` do.

mod cut;
mod engines;
mod github;
mod junit;
mod listed;
mod next;
mod profiles;
mod summary;
mod tables;
mod text;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{
    cases::case_file::CaseFields,
    gate::{
        calibration::ClaimOverError,
        counting::WorstFigure,
        expected::{self, Differs},
        failure::{Cause, Failure},
        finding::Finding,
        identity::Identity,
        known::KnownFailure,
        ladder::Descent,
        pair::Pair,
        parting::Parting,
        responses,
        roles::Roles,
        run::{DETAILED, Run},
        shortfall::{NotJudged, Shortfall, shortfalls},
        tally::Reach,
        verdict::Verdict,
    },
    measure::observables::Observable,
};

pub use cut::{cut, one_line};
pub use engines::{Engine, EngineReport, Granted, explained};
pub use github::{annotations, not_obeyed};
pub use junit::{LARGEST as LARGEST_JUNIT, MOST_LISTED, junit};
pub use listed::{Fate, Listed, listed};
pub use next::next;
pub use profiles::lines as profile_lines;
pub use summary::summary;
pub use tables::full;
pub use text::{exercised, failure_text, finding_text, headline, narrow_and_left_out, text, verdict};

/// The whole report. It holds no times and no names of machines: the same seed gives the same report, on any number of threads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The version of this program.
    pub version: String,
    /// The seed of the random cases.
    pub seed: u64,
    /// The names of the oracles.
    pub oracles: Vec<String>,
    /// Which cases were to be run, and which were.
    pub accounted: Accounted,
    /// The cases that were not run because the run was interrupted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// What was exercised.
    pub reach: Reach,
    /// How many cases each oracle answered with a history.
    #[serde(default)]
    pub answered: BTreeMap<String, usize>,
    /// How often each oracle declined, by reason.
    pub declines: BTreeMap<String, BTreeMap<String, usize>>,
    /// How often each engine broke, by the way in which it did.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub broke: BTreeMap<String, BTreeMap<String, usize>>,
    /// Every pair of oracles.
    pub pairs: Vec<Pair>,
    /// The interval ratio of each oracle against its law.
    pub ratio_law: BTreeMap<String, WorstFigure>,
    /// The chattering time of each oracle against what the local series says from one of its impacts.
    pub time_left: BTreeMap<String, WorstFigure>,
    /// How the claims of each oracle compare with its true errors, on the cases that were judged.
    pub judged: Judged,
    /// The ladders.
    pub ladders: Vec<Descent>,
    /// Known divergences whose regime was met.
    pub known: Vec<Known>,
    /// Failures of engines that are known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known_failures: Vec<KnownFailure>,
    /// In how many cases an engine failed as is known of it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub failed_as_known: usize,
    /// Cases in which something was wrong.
    pub failures: Vec<FailedCase>,
    /// What is wrong with the run as a whole.
    pub shortfalls: Vec<Shortfall>,
    /// What the run was too small to judge.
    pub not_judged: Vec<NotJudged>,
    /// What became of each engine.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub engines: Vec<EngineReport>,
    /// What was found in whole responses, where any were run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub responses: Option<responses::Report>,
    /// Green or red.
    pub verdict: Verdict,
}

/// Which cases were to be run, and which were.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Accounted {
    /// Those to be run.
    pub handed: Identity,
    /// Those that were examined.
    pub examined: Identity,
}

/// What the judge found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Judged {
    /// How many cases it was to be asked.
    pub asked: usize,
    /// Of how many it judged every history; also of those in which something was wrong.
    pub cases: usize,
    /// For each oracle and observable, its claims in multiples of its true errors.
    pub claims: BTreeMap<String, BTreeMap<Observable, ClaimOverError>>,
}

/// A known divergence in this run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// Who, in what, where.
    pub divergence: String,
    /// Why it is known and tolerated, as the entry says.
    pub reason: String,
    /// In how many cases, or ladders, the two were seen side by side in that regime.
    pub cases: usize,
    /// In what they differ.
    pub observable: Differs,
    /// The largest relative difference that was seen; of endings and orders, 1 where they differed and 0 where they did not.
    pub largest: f64,
}

/// A case in which something was wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FailedCase {
    /// Its name.
    pub name: String,
    /// Its parameters.
    pub case: CaseFields,
    /// What was wrong.
    pub findings: Vec<Finding>,
    /// The oracles with which neither the judge nor any law found anything wrong.
    #[serde(default)]
    pub sound: Vec<String>,
    /// Judges that refute oracles which agree among themselves.
    #[serde(default)]
    pub suspect_judges: Vec<String>,
    /// Commands that show it.
    #[serde(default)]
    pub see: Vec<String>,
    /// The impacts around the first that is wrong, beside those of another; of the first failures only where there are many.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub partings: Vec<Parting>,
}

impl FailedCase {
    fn new(failure: &Failure, roles: &Roles) -> Self {
        Self {
            name: failure.named.to_string(),
            case: CaseFields::from(&failure.named.case),
            findings: failure.findings.clone(),
            sound: failure.sound.clone(),
            suspect_judges: failure.suspect_judges.clone(),
            see: failure.see.iter().map(|see| (roles.shown_by)(&see.oracle, &see.flags)).collect(),
            partings: failure.partings.clone(),
        }
    }

    /// Whether an engine broke, and nothing else was wrong.
    pub fn is_breakdown(&self) -> bool {
        self.findings.iter().all(Finding::is_breakdown)
    }

    /// What this failure is grouped by.
    pub fn cause(&self) -> Cause {
        Cause::of(&self.findings, &self.suspect_judges)
    }
}

impl Report {
    /// The report on a run, for a panel whose oracles have these roles.
    pub fn new(run: &Run, roles: &Roles) -> Self {
        let tally = &run.tally;
        let (shortfalls, not_judged) = shortfalls(run, roles);
        let mut failures: Vec<FailedCase> =
            run.failures.iter().map(|failure| FailedCase::new(failure, roles)).collect();
        // A run that was put together of parts has more of them.
        failures.iter_mut().skip(DETAILED).for_each(|failure| failure.partings = Vec::new());
        let claims = tally.claims.iter().map(|(oracle, claims)| (oracle.clone(), claims.figures())).collect();
        let report = Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            seed: run.seed,
            oracles: run.oracles.clone(),
            accounted: Accounted { handed: run.handed, examined: tally.examined },
            left_out: run.left_out.clone(),
            reach: tally.reach.clone(),
            answered: tally.answered.clone(),
            declines: tally.declines.clone(),
            broke: tally.broke.clone(),
            pairs: run.pairs.clone(),
            ratio_law: tally.ratio_law.clone(),
            time_left: tally.time_left.clone(),
            judged: Judged { asked: tally.to_judge, cases: tally.judged, claims },
            ladders: run.ladders.clone(),
            known: known(run),
            known_failures: run.known.clone(),
            failed_as_known: run.outcomes.cases_known(),
            failures,
            shortfalls,
            not_judged,
            engines: Vec::new(),
            responses: None,
            verdict: Verdict::Pass,
        };
        report.concluded()
    }

    /// The same with what was found in whole responses: one of them that is wrong turns the run red as a case does.
    #[must_use]
    pub fn with_responses(self, responses: Option<responses::Report>) -> Self {
        Self { responses, ..self }.concluded()
    }

    /// The same with the verdicts on it and on its engines that follow from all else that is in it.
    pub(super) fn concluded(mut self) -> Self {
        for engine in &mut self.engines {
            let name = engine.engine.name.as_str();
            let about = self.shortfalls.iter().filter(|shortfall| shortfall.oracles().contains(&name));
            let undecided = (engine.broke > 0).then_some(Verdict::Undecided);
            engine.verdict = Verdict::of(engine.wrong, about.map(Shortfall::verdict).chain(undecided));
        }
        // An engine that broke leaves its cases undecided.
        let broke = self.failures.iter().filter(|failure| failure.is_breakdown());
        let wrong = self.failures.len() - broke.clone().count();
        let shortfalls = self.shortfalls.iter().map(Shortfall::verdict);
        let undecided = broke.map(|_| Verdict::Undecided);
        let of_engines = self.engines.iter().map(|engine| engine.verdict);
        let of_responses = self.responses.iter().map(responses::Report::verdict);
        self.verdict = Verdict::of(wrong, shortfalls.chain(undecided).chain(of_engines).chain(of_responses));
        self
    }

    /// Whether nothing was wrong.
    pub fn passes(&self) -> bool {
        self.verdict == Verdict::Pass
    }
}

/// For fields that go without saying.
fn is_zero(count: &usize) -> bool {
    *count == 0
}

fn known(run: &Run) -> Vec<Known> {
    let entries = expected::table().iter().enumerate().filter_map(|(place, entry)| {
        let mut met = run.tally.known.get(&place).copied().unwrap_or_default();
        for descent in run.ladders.iter().filter(|descent| entry.excuses(descent)) {
            met.add(expected::Met { cases: 1, largest: f64::from(!descent.holds()) });
        }
        let (divergence, reason) = (entry.says(), entry.reason.clone());
        (met.cases > 0).then_some(Known {
            divergence,
            reason,
            cases: met.cases,
            observable: entry.observable,
            largest: met.largest,
        })
    });
    entries.collect()
}
