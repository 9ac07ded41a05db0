//! A verification run: every case through the panel, on all threads, with an outcome that does not depend on how many there were.

use std::collections::HashSet;

use contract::{Case, Oracle};
use rayon::prelude::*;

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        examine::examine_and_judge,
        failure::Failure,
        guests::Guests,
        identity::Identity,
        judge::Judges,
        known::{Known, KnownFailure},
        ladder::Descent,
        pair::Pair,
        progress::Progress,
        tally::Tally,
    },
};

/// Which cases a run is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection {
    /// How many random cases.
    pub cases: usize,
    /// What they are made from.
    pub seed: u64,
    /// Which share of all cases to run: the `K`-th of `N`.
    pub partition: (usize, usize),
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
    let all =
        Generator::ALL.into_iter().flat_map(|generator| generator.cases(selection.seed, selection.cases, stepper));
    let (part, parts) = selection.partition;
    all.enumerate().filter(|(place, _)| place % parts.max(1) + 1 == part).map(|(_, named)| named).collect()
}

/// What came out of a run.
#[derive(Debug, Clone)]
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
    with_guests(panel, &Guests::default(), judges, cases, seed, ladders, progress)
}

/// The same with guests in the panel.
pub fn with_guests(
    panel: &[&dyn Oracle],
    guests: &Guests,
    judges: &Judges,
    cases: &[Named],
    seed: u64,
    ladders: Option<Vec<Descent>>,
    progress: &impl Progress,
) -> Run {
    let examine = |(place, named): (usize, &Named)| {
        if progress.is_interrupted() {
            return None;
        }
        let examination = examine_and_judge(panel, judges, &named.case, judges.asks(place, named));
        let failure = Failure::of(named, &examination);
        progress.done(failure.is_some());
        Some((Tally::of(named, &examination).with_guests(named, &examination, guests), failure))
    };
    let asked = cases.iter().enumerate().filter(|(place, named)| judges.asks(*place, named)).count();
    let mut tally = Tally::expecting(asked);
    let (mut failures, mut left_out) = (Vec::new(), Vec::new());
    // What came out of a case is kept no longer than those beside it are run.
    for (part, next) in cases.chunks(AHEAD).enumerate() {
        if !progress.is_interrupted() {
            let next: Vec<Case> = next.iter().map(|named| named.case).collect();
            panel.par_iter().for_each(|oracle| oracle.prepare(&next));
        }
        let places = next.par_iter().enumerate().map(|(place, named)| (part * AHEAD + place, named));
        let results: Vec<Option<(Tally, Option<Failure>)>> = places.map(examine).collect();
        for (named, result) in next.iter().zip(results) {
            match result {
                Some((of_case, failure)) => {
                    tally.add(of_case);
                    failures.extend(failure);
                }
                None => left_out.push(named.to_string()),
            }
        }
    }
    let oracles = panel.iter().map(|oracle| oracle.name().to_owned()).collect();
    Run { left_out, ..Run::of(oracles, seed, Identity::of_all(cases), tally, ladders, failures) }
}

/// How many cases the oracles are told of before they are asked them.
const AHEAD: usize = 128;

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
            let case = &failure.named.case;
            failure.findings.retain(|finding| !known.iter().any(|entry| entry.excuses(case, finding)));
        }
        self.failures.retain(|failure| !failure.findings.is_empty());
        self
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
        }
    }
}
