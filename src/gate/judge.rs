//! The judge: every oracle's answer against an enclosure that is proven to contain the truth.
//!
//! It says which oracle is wrong where two disagree, and how what each oracle claims compares with its true error.

use std::sync::Arc;

use contract::{Case, Model, Oracle};

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        calibration::Calibration,
        compare::{Agreement, Disagreement, Slack, compare},
    },
    measure::{
        asking::{Answer, ask},
        conditioning::Conditioning,
        observables::{Observable, Observed},
    },
};

/// The oracles whose claims are proven, and which cases they are asked. By default there are none.
#[derive(Default)]
pub struct Judges<'a> {
    /// One for each model.
    pub oracles: Vec<&'a dyn Oracle>,
    /// Every so many cases of a run one is judged; every listed case, the user's own too, and every one in which something is wrong, is judged anyway.
    pub every: usize,
    /// What closes a sequence from any one impact: it is held against every answer that ends with rest.
    pub closing: Option<&'a dyn Oracle>,
}

/// What the judge says of one answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The place of the answer in the panel.
    pub place: usize,
    /// The name of the judge.
    pub judge: String,
    /// What is wrong with the answer: it is further from the enclosure than it claims.
    pub refuted: Option<Disagreement>,
    /// What it claims in multiples of its true error.
    pub calibration: Calibration,
    /// What the judge proved.
    pub proven: Arc<Observed>,
}

impl Judges<'_> {
    /// Whether the case at `place` of a run is in the sample: every listed one is, and every one of the user's own.
    pub fn asks(&self, place: usize, named: &Named) -> bool {
        let is_chosen = matches!(named.generator, Generator::Own | Generator::List);
        !self.oracles.is_empty() && (is_chosen || place.is_multiple_of(self.every.max(1)))
    }

    /// Judges the answers to a case at the places that are `wanted`.
    pub fn judge(&self, case: &Case, answers: &[Answer], wanted: impl Fn(usize) -> bool) -> Vec<Judgement> {
        let needed = |judge: &&&dyn Oracle| answers.iter().any(|answer| answer.model == judge.model());
        let prove = |judge: &&dyn Oracle| {
            let proven = ask(*judge, case).into_observed()?;
            Some((judge.name().to_owned(), judge.model(), Arc::new(proven)))
        };
        let judges: Vec<(String, Model, Arc<Observed>)> =
            self.oracles.iter().filter(needed).filter_map(prove).collect();
        let judged = answers.iter().enumerate().filter(|(place, _)| wanted(*place)).filter_map(|(place, answer)| {
            let (judge, _, proven) = judges.iter().find(|(_, model, _)| *model == answer.model)?;
            Some(judgement(place, case, proven, judge.clone(), answer.observed()?))
        });
        judged.collect()
    }
}

fn judgement(place: usize, case: &Case, truth: &Arc<Observed>, judge: String, answer: &Observed) -> Judgement {
    // Claims stand for themselves here: no slack of any kind.
    let slack = Slack { conditioning: &Conditioning::default(), gap: None };
    let comparison = compare(case, truth, answer, slack);
    let mut calibration = Calibration::default();
    for n in 1..=comparison.impacts {
        for observable in [Observable::Interval, Observable::Velocity, Observable::ImpactTime] {
            let Some((proven, answered)) = truth.at(observable, n).zip(answer.at(observable, n)) else { continue };
            let scale = if observable == Observable::ImpactTime { 1.0 } else { proven.value.abs() };
            let error = (answered.value - proven.value).abs() / scale;
            calibration.add(observable, answered.uncertainty, error, proven.uncertainty);
        }
    }
    if let Some((proven, answered)) = truth.chattering_time.zip(answer.chattering_time) {
        let error = (answered.value - proven.value).abs();
        calibration.add(Observable::ChatteringTime, answered.uncertainty, error, proven.uncertainty);
    }
    let refuted = match comparison.agreement {
        Agreement::Disagree(disagreement) => Some(disagreement),
        Agreement::Agree | Agreement::TooClose => None,
    };
    Judgement { place, judge, refuted, calibration, proven: Arc::clone(truth) }
}

#[cfg(test)]
mod tests;
