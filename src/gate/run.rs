//! A verification run: every case through the panel, on all threads, and one report that does not depend on how many there were.

use contract::Oracle;
use rayon::prelude::*;

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        examine::Finding,
        judge::Judges,
        ladder::Descent,
        report::{Report, Tally},
    },
    panel,
};

/// What a run is made from.
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

/// A case in which something was wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// The case.
    pub named: Named,
    /// What was wrong.
    pub findings: Vec<Finding>,
    /// The oracles that the judge confirmed.
    pub confirmed: Vec<String>,
}

/// The cases of a run, in order. The edge generator finds the critical amplitudes with the first oracle of the default panel, whichever
/// panel is being verified, so that the cases do not depend on it.
pub fn cases(selection: &Selection) -> Vec<Named> {
    let stepper = panel::default().into_iter().next();
    let all = Generator::ALL.into_iter().flat_map(|generator| match &stepper {
        Some(stepper) => generator.cases(selection.seed, selection.cases, stepper.as_ref()),
        None => Vec::new(),
    });
    let (part, parts) = selection.partition;
    all.enumerate().filter(|(place, _)| place % parts.max(1) + 1 == part).map(|(_, named)| named).collect()
}

/// Runs the cases through the panel, with the judge on a sample of them, and reports on them and on the ladders; a run without ladders is of a few chosen cases and does not have
/// to prove anything as a whole. `done` is called after each case, from any thread.
pub fn run(
    panel: &[&dyn Oracle],
    judges: &Judges,
    cases: &[Named],
    seed: u64,
    ladders: Option<Vec<Descent>>,
    done: impl Fn() + Sync,
) -> (Report, Vec<Failure>) {
    let names: Vec<&str> = panel.iter().map(|oracle| oracle.name()).collect();
    let results: Vec<(Tally, Failure)> = cases
        .par_iter()
        .enumerate()
        .map(|(place, named)| {
            let examination = judges.examine(panel, &named.case, judges.asks(place, named));
            done();
            let (findings, confirmed) = (examination.findings(), examination.confirmed());
            (Tally::of(named, &examination), Failure { named: named.clone(), findings, confirmed })
        })
        .collect();
    let asked = cases.iter().enumerate().filter(|(place, named)| judges.asks(*place, named)).count();
    let mut tally = Tally::expecting(asked);
    let mut failures = Vec::new();
    for (of_case, failure) in results {
        tally.add(of_case);
        if !failure.findings.is_empty() {
            failures.push(failure);
        }
    }
    let whole = ladders.is_some();
    (Report::new(&names, seed, tally, ladders.unwrap_or_default(), &failures, whole), failures)
}
