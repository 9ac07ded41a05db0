//! Many responses on all threads, and one report that does not depend on how many there were.

use rayon::prelude::*;

use super::{examine::examine, failure::Failure, report::Report, tally::Tally, whole::Responder};
use crate::{
    cases::{generate, shaking::Shaking},
    gate::progress::Progress,
};

/// What responses a run is made from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Selection {
    /// How many.
    pub responses: usize,
    /// What they are made from.
    pub seed: u64,
}

impl Selection {
    /// How many responses a run has unless told otherwise.
    pub const DEFAULT: usize = 200;
    /// How many it may be asked for.
    pub const MOST: usize = 1_000_000;
}

/// The responses of a run, by name and in order.
pub fn shakings(request: &Selection) -> Vec<(String, Shaking)> {
    let all = (1..).zip(generate::shakings(request.seed, request.responses));
    all.map(|(number, shaking)| (format!("response/{number}"), shaking)).collect()
}

/// Runs them through all methods.
pub fn run(
    responders: &[&dyn Responder],
    shakings: &[(String, Shaking)],
    progress: &impl Progress,
) -> (Report, Vec<Failure>) {
    let examinations: Vec<_> = shakings
        .par_iter()
        .map(|(_, shaking)| {
            if progress.is_interrupted() {
                return None;
            }
            let examination = examine(responders, shaking);
            progress.done(!examination.findings.is_empty());
            Some(examination)
        })
        .collect();
    let mut tally = Tally::default();
    let mut failures = Vec::new();
    for ((name, shaking), examination) in shakings.iter().zip(examinations) {
        let Some(examination) = examination else {
            tally.left_out.push(name.clone());
            continue;
        };
        tally.add(name, &examination);
        if !examination.findings.is_empty() {
            failures.push(Failure { name: name.clone(), shaking: *shaking, findings: examination.findings });
        }
    }
    (Report::new(tally, &failures), failures)
}
