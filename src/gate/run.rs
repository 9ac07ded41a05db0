//! A verification run: every case through the panel, on all threads, with an outcome that does not depend on how many there were.

use std::{collections::HashSet, time::Instant};

use contract::{Case, Oracle};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        examine::examine_and_judge,
        failure::Failure,
        finding::Finding,
        guests::Guests,
        identity::Identity,
        judge::Judges,
        known::{Known, KnownFailure},
        ladder::Descent,
        outcome::{Outcome, Outcomes},
        pair::Pair,
        progress::Progress,
        tally::Tally,
    },
};

/// Which cases a run is made of, besides the user's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Selection {
    /// How many random cases.
    pub cases: usize,
    /// What they are made from.
    pub seed: u64,
}

impl Selection {
    /// How many random cases a run may be asked for.
    pub const MOST_CASES: usize = 1_000_000;
    /// How many random cases a run has unless told otherwise.
    pub const DEFAULT_CASES: usize = 2000;
}

/// The cases of a run, in order. The edge generator finds the critical amplitudes with `stepper`, whichever panel is being verified, so that the
/// cases do not depend on it.
pub fn cases(selection: &Selection, stepper: &dyn Oracle) -> Vec<Named> {
    Generator::ALL.into_iter().flat_map(|generator| generator.cases(selection.seed, selection.cases, stepper)).collect()
}

/// A case and its place among all cases of the run, of which there may be a part here.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// From 0 on.
    pub place: usize,
    /// The case.
    pub named: Named,
}

impl Placed {
    /// Every case at its place.
    pub fn all(cases: &[Named]) -> Vec<Self> {
        cases.iter().enumerate().map(|(place, named)| Self { place, named: named.clone() }).collect()
    }
}

/// What came out of a run, or of a part of one.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Run {
    /// The names of the oracles.
    pub oracles: Vec<String>,
    /// What the random cases are made from.
    pub seed: u64,
    /// What was handed in to be run.
    pub handed: Identity,
    /// What was counted.
    pub tally: Tally,
    /// Every pair of oracles.
    pub pairs: Vec<Pair>,
    /// The ladders.
    pub ladders: Vec<Descent>,
    /// The cases in which something was wrong, in order.
    pub failures: Vec<Failure>,
    /// Failures of engines that are known, and what became of them.
    pub known: Vec<KnownFailure>,
    /// Whether the run has to prove something by itself. One without ladders is of a few chosen cases, and has not.
    pub whole: bool,
    /// The names of the cases that were not run because the run was interrupted.
    pub left_out: Vec<String>,
    /// What became of each case, for reports that list them.
    pub outcomes: Outcomes,
}

/// Runs the cases through the panel, with the judge on a sample of them. A run without `ladders` is of a few chosen cases and does not have to
/// prove anything as a whole.
pub fn run(
    panel: &[&dyn Oracle],
    judges: &Judges,
    cases: &[Named],
    seed: u64,
    ladders: Option<Vec<Descent>>,
    progress: &impl Progress,
) -> Run {
    with_guests(panel, &Guests::default(), judges, &Placed::all(cases), seed, ladders, progress)
}

/// The same with guests in the panel, for cases that may be a part of a run: which of them are judged depends on their places in the whole.
pub fn with_guests(
    panel: &[&dyn Oracle],
    guests: &Guests,
    judges: &Judges,
    cases: &[Placed],
    seed: u64,
    ladders: Option<Vec<Descent>>,
    progress: &impl Progress,
) -> Run {
    let examine = |Placed { place, named }: &Placed| {
        if progress.is_interrupted() {
            return None;
        }
        let start = Instant::now();
        let examination = examine_and_judge(panel, judges, &named.case, judges.asks(*place, named));
        let seconds = start.elapsed().as_secs_f64();
        let failure = Failure::of(named, &examination);
        progress.done(failure.is_some());
        let tally = Tally::of(named, &examination).with_guests(named, &examination, guests);
        Some((tally, failure, Outcome::of(named, &examination, seconds)))
    };
    let asked = cases.iter().filter(|Placed { place, named }| judges.asks(*place, named)).count();
    let mut tally = Tally::expecting(asked);
    let (mut failures, mut left_out, mut outcomes) = (Vec::new(), Vec::new(), Outcomes::default());
    let mut detailed = Detailed::default();
    // What came out of a case is kept no longer than those beside it are run.
    for next in cases.chunks(AHEAD) {
        let before = if progress.is_interrupted() { Vec::new() } else { prepare(panel, next) };
        let results: Vec<Option<(Tally, Option<Failure>, Outcome)>> = next.par_iter().map(examine).collect();
        for (Placed { named, .. }, result) in next.iter().zip(results) {
            let Some((of_case, failure, outcome)) = result else {
                left_out.push(named.to_string());
                continue;
            };
            tally.add(of_case);
            failures.extend(failure.map(|failure| detailed.keep(failure, guests.known)));
            outcomes.push(outcome, &before);
        }
    }
    let oracles = panel.iter().map(|oracle| oracle.name().to_owned()).collect();
    let handed = Identity::of_all(cases.iter().map(|Placed { named, .. }| named));
    Run { left_out, outcomes, ..Run::of(oracles, seed, handed, tally, ladders, failures) }
}

/// Tells every oracle which cases come next. How many seconds each took for it, a case.
fn prepare(panel: &[&dyn Oracle], next: &[Placed]) -> Vec<f64> {
    let cases: Vec<Case> = next.iter().map(|Placed { named, .. }| named.case).collect();
    let timed = |oracle: &&dyn Oracle| {
        let start = Instant::now();
        oracle.prepare(&cases);
        start.elapsed().as_secs_f64() / cases.len() as f64
    };
    panel.par_iter().map(timed).collect()
}

/// How many failures have kept their impacts.
#[derive(Default)]
struct Detailed(usize);

impl Detailed {
    /// The failure with its impacts, or without them where it is excused, or enough others have theirs.
    fn keep(&mut self, failure: Failure, known: &[Known]) -> Failure {
        let excuses = |finding: &Finding| known.iter().any(|entry| entry.excuses(&failure.named.case, finding));
        if self.0 >= DETAILED || failure.findings.iter().all(excuses) {
            return Failure { partings: Vec::new(), ..failure };
        }
        self.0 += 1;
        failure
    }
}

/// How many cases the oracles are told of before they are asked them.
const AHEAD: usize = 128;
/// Of how many failed cases the impacts are kept.
pub(super) const DETAILED: usize = 200;

impl Run {
    /// The run without what is known of it: findings that an entry excuses are none, and it is counted where each entry applies.
    #[must_use]
    pub fn excused(mut self, known: &[Known], cases: &[Named]) -> Self {
        let left_out: HashSet<&String> = self.left_out.iter().collect();
        let met = |entry: &Known| {
            let in_regime = cases.iter().filter(|named| entry.regime.has(&named.case));
            in_regime.filter(|named| !left_out.contains(&named.to_string())).count()
        };
        let failed = |entry: &Known, failures: &[Failure]| {
            let excuses =
                |failure: &&Failure| failure.findings.iter().any(|finding| entry.excuses(&failure.named.case, finding));
            failures.iter().filter(excuses).count()
        };
        self.known = known.iter().map(|entry| entry.outcome(met(entry), failed(entry, &self.failures))).collect();
        for failure in &mut self.failures {
            let named = &failure.named;
            failure.findings.retain(|finding| {
                let excused = known.iter().find(|entry| entry.excuses(&named.case, finding));
                if let Some(entry) = excused {
                    self.outcomes.push_known(named, entry);
                }
                excused.is_none()
            });
            let is_left = |oracle: &str| failure.findings.iter().any(|finding| finding.oracles().contains(&oracle));
            failure.partings.retain(|parting| is_left(&parting.answered.oracle));
        }
        self.failures.retain(|failure| !failure.findings.is_empty());
        self
    }

    /// Adds another part of the same run. Failures are then in the order of the parts.
    pub(super) fn add(&mut self, other: Self) {
        self.handed.add(other.handed);
        self.tally.add(other.tally);
        for theirs in other.pairs {
            match self.pairs.iter_mut().find(|mine| mine.oracles == theirs.oracles) {
                Some(mine) => mine.add(theirs),
                // A part without cases has no pairs.
                None => self.pairs.push(theirs),
            }
        }
        self.failures.extend(other.failures);
        self.known.iter_mut().zip(&other.known).for_each(|(mine, theirs)| mine.add(theirs));
        self.left_out.extend(other.left_out);
        self.outcomes.add(other.outcomes);
    }

    /// A run from what was counted in it.
    pub fn of(
        oracles: Vec<String>,
        seed: u64,
        handed: Identity,
        mut tally: Tally,
        ladders: Option<Vec<Descent>>,
        failures: Vec<Failure>,
    ) -> Self {
        let name = |place: usize| oracles.get(place).cloned().unwrap_or_default();
        let pairs = std::mem::take(&mut tally.pairs);
        let pairs = pairs.into_iter().map(|((i, j), pair)| Pair { oracles: [name(i), name(j)], ..pair }).collect();
        let whole = ladders.is_some();
        Self {
            oracles,
            seed,
            handed,
            tally,
            pairs,
            ladders: ladders.unwrap_or_default(),
            failures,
            known: Vec::new(),
            whole,
            left_out: Vec::new(),
            outcomes: Outcomes::default(),
        }
    }
}
