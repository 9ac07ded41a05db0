//! The judge: every oracle's answer against an enclosure that is proven to contain the truth.
//!
//! It says which oracle is wrong where two disagree, and how what each oracle claims compares with its true error.

use std::collections::BTreeMap;

use contract::{Case, Oracle};
use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        compare::{Agreement, Disagreement, Slack, compare},
        examine::{Examination, examine},
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
    /// Every so many cases of a run one is judged; every listed case, and every one in which something is wrong, is judged anyway.
    pub every: usize,
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
}

/// How claims compare with true errors, for each observable.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Calibration(BTreeMap<Observable, Ratios>);

/// Claims over true errors, counted in classes of equal width in the logarithm.
#[derive(Debug, Clone, Default, PartialEq)]
struct Ratios {
    classes: BTreeMap<i32, usize>,
    smallest: f64,
}

/// The figures of one observable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ClaimOverError {
    /// How many numbers were judged.
    pub numbers: usize,
    /// The smallest claim, in multiples of the true error: below 1 it is too small.
    pub smallest: f64,
    /// The median.
    pub median: f64,
}

/// Classes for every factor of 10.
const CLASSES: f64 = 16.0;

/// What is called a claim of nothing.
const LARGEST: f64 = 1e30;

impl Judges<'_> {
    /// Whether the case at `place` of a run is in the sample: every listed one is.
    pub fn asks(&self, place: usize, named: &Named) -> bool {
        !self.oracles.is_empty() && (named.generator == Generator::List || place.is_multiple_of(self.every.max(1)))
    }

    /// Asks every oracle of the panel, compares, and judges if that is `asked` for or something is wrong.
    pub fn examine(&self, panel: &[&dyn Oracle], case: &Case, asked: bool) -> Examination {
        let mut examination = examine(panel, case);
        if asked || !examination.findings().is_empty() {
            examination.judgements = self.judge(case, &examination.answers, |_| true);
        }
        examination
    }

    /// Judges the answers to a case at the places that are `wanted`.
    pub fn judge(&self, case: &Case, answers: &[Answer], wanted: impl Fn(usize) -> bool) -> Vec<Judgement> {
        let needed = |judge: &&&dyn Oracle| answers.iter().any(|answer| answer.model == judge.model());
        let judges: Vec<Answer> = self.oracles.iter().filter(needed).map(|judge| ask(*judge, case)).collect();
        let judged = answers.iter().enumerate().filter(|(place, _)| wanted(*place)).filter_map(|(place, answer)| {
            let judge = judges.iter().find(|judge| judge.model == answer.model)?;
            Some(judgement(place, case, judge.observed()?, judge.oracle.clone(), answer.observed()?))
        });
        judged.collect()
    }
}

fn judgement(place: usize, case: &Case, truth: &Observed, judge: String, answer: &Observed) -> Judgement {
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
    Judgement { place, judge, refuted, calibration }
}

impl Calibration {
    /// Notes a claim for a number that is `error` away from the middle of an enclosure that reaches `unsure` to both sides of it. An error that
    /// the enclosure can't tell from nothing counts as half of what it could be.
    fn add(&mut self, observable: Observable, claim: f64, error: f64, unsure: f64) {
        let ratio = (claim / error.max(0.5 * unsure)).clamp(0.0, LARGEST);
        let ratios = self.0.entry(observable).or_insert(Ratios { classes: BTreeMap::new(), smallest: f64::INFINITY });
        // What is not a number is no claim at all.
        let class = if ratio > 0.0 { (CLASSES * ratio.log10()).floor() as i32 } else { i32::MIN };
        *ratios.classes.entry(class).or_default() += 1;
        ratios.smallest = ratios.smallest.min(if ratio.is_nan() { 0.0 } else { ratio });
    }

    /// Adds the claims of other cases.
    pub fn add_all(&mut self, other: Self) {
        for (observable, theirs) in other.0 {
            let mine = self.0.entry(observable).or_insert(Ratios { classes: BTreeMap::new(), smallest: f64::INFINITY });
            mine.smallest = mine.smallest.min(theirs.smallest);
            for (class, count) in theirs.classes {
                *mine.classes.entry(class).or_default() += count;
            }
        }
    }

    /// The figures of each observable.
    pub fn figures(&self) -> BTreeMap<Observable, ClaimOverError> {
        self.0.iter().map(|(&observable, ratios)| (observable, ratios.figures())).collect()
    }
}

impl Ratios {
    fn figures(&self) -> ClaimOverError {
        let numbers: usize = self.classes.values().sum();
        let mut below = 0;
        let middle = self.classes.iter().find(|(_, count)| {
            below += **count;
            2 * below >= numbers
        });
        let median = middle.map_or(f64::NAN, |(&class, _)| 10.0_f64.powf((f64::from(class) + 0.5) / CLASSES));
        ClaimOverError { numbers, smallest: self.smallest, median }
    }
}

#[cfg(test)]
mod tests;
