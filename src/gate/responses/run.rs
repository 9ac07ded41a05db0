//! Many responses on all threads, and one report that does not depend on how many there were.

use std::time::Instant;

use rayon::prelude::*;

use super::{
    examine::examine_with, failure::Failure, relations::Relation, report::Report, tally::Tally, whole::Responder,
};
use crate::{
    cases::{generate, shaking::Question},
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
    pub const DEFAULT: usize = 300;
    /// How many it may be asked for.
    pub const MOST: usize = 1_000_000;
}

/// The responses of a run, by name and in order: two of three on sinusoids, the others on any motion.
pub fn questions(request: &Selection) -> Vec<(String, Question)> {
    let motions = request.responses / 3;
    let shakings = generate::shakings(request.seed, request.responses - motions);
    let shakings =
        (1..).zip(shakings).map(|(number, shaking)| (format!("response/{number}"), Question::Sinusoid(shaking)));
    let motions = (1..).zip(generate::motions(request.seed, motions));
    shakings.chain(motions.map(|(number, motion)| (format!("motion/{number}"), Question::Motion(motion)))).collect()
}

/// Runs them through all methods.
pub fn run(
    responders: &[&dyn Responder],
    questions: &[(String, Question)],
    progress: &impl Progress,
) -> (Report, Vec<Failure>) {
    let (report, failures, _) = timed(responders, questions, progress);
    (report, failures)
}

/// The same, and how many seconds each of those that were run took.
pub fn timed(
    responders: &[&dyn Responder],
    questions: &[(String, Question)],
    progress: &impl Progress,
) -> (Report, Vec<Failure>, Vec<f64>) {
    let examinations: Vec<_> = questions
        .par_iter()
        .map(|(name, question)| {
            if progress.is_interrupted() {
                return None;
            }
            let start = Instant::now();
            let examination = examine_with(responders, question, &Relation::of(name));
            progress.done(!examination.findings.is_empty());
            Some((examination, start.elapsed().as_secs_f64()))
        })
        .collect();
    let mut tally = Tally::default();
    let (mut failures, mut seconds) = (Vec::new(), Vec::new());
    for ((name, question), examination) in questions.iter().zip(examinations) {
        let Some((examination, took)) = examination else {
            tally.left_out.push(name.clone());
            continue;
        };
        seconds.push(took);
        tally.add(name, &examination);
        if !examination.findings.is_empty() {
            failures.push(Failure { name: name.clone(), question: question.clone(), findings: examination.findings });
        }
    }
    (Report::new(tally, &failures), failures, seconds)
}
