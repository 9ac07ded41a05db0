//! What mistake would explain the answers of an engine: the faults of the catalogue as hypotheses.
//!
//! Each is planted in an honest oracle, its size is fitted to what the engine answered, and it explains a case if with it the deviation falls to a thousandth
//! of what it was, or the ending, the count and the sides now match that contradicted the truth. A fault that would spoil what the engine has right is none.

mod deviation;
mod fit;
mod hypothesis;
mod signs;

use contract::Model;
use rayon::prelude::*;

use super::Size;
use crate::{
    gate::{
        explanation::{Explained, Explanation, FaultSize},
        samples::Sample,
        tally::Tally,
    },
    panel,
};
use deviation::Held;
use hypothesis::Hypothesis;

/// How far the size that fits is from that of the real mistake, as a factor.
fn strangeness(explanation: &Explanation) -> f64 {
    match &explanation.size {
        Some(FaultSize { value, natural: Some(natural), .. }) if *value > 0.0 => (value / natural).ln().abs(),
        Some(FaultSize { natural: Some(_), .. }) => f64::INFINITY,
        _ => 0.0,
    }
}

/// Whether two explain equally well.
fn are_equal(one: &Explanation, two: &Explanation) -> bool {
    const NOTHING: f64 = 1e-13;
    let alike = |one: f64, two: f64| one <= 10.0 * two.max(NOTHING);
    one.explained == two.explained && alike(one.left, two.left) && alike(two.left, one.left)
}

/// As many wrong cases are explained at the most, and as many right ones must not be spoiled.
const WRONG: usize = 40;
const RIGHT: usize = 20;
/// The share of the right ones that a fault may spoil, where the size that fits is not quite that of the mistake; that it does is said.
const MAY_SPOIL: f64 = 0.1;
/// The size of a fault is looked for in the first of them, most sizes are rejected by fewer.
const SOME: usize = 16;
const FEW: usize = 4;
/// So many impacts are looked at of the wrong cases and of the right ones: what it takes is bounded by them.
const IMPACTS: usize = 6_000;

/// The mistakes that explain most of the wrong answers of an engine for this equation, the best first; none if nothing does. Those that explain equally well are all
/// named, the one whose size is most like that of the real mistake first.
pub fn explain(samples: &[Sample], model: Model) -> Vec<Explanation> {
    let stepper = panel::stepper_of(model);
    let held = |wrong: bool, most: usize| -> Vec<Held> {
        let of = |sample: &Sample| stepper.history(&sample.case).ok();
        chosen(samples, wrong, most).into_iter().map(|sample| Held::new(sample, of(sample).as_ref())).collect()
    };
    let (wrong, right) = (held(true, WRONG), held(false, RIGHT));
    if wrong.is_empty() {
        return Vec::new();
    }
    let hypotheses = hypothesis::all(model);
    let mut found: Vec<(Explanation, bool)> =
        hypotheses.par_iter().filter_map(|hypothesis| judge(hypothesis, &wrong, &right)).collect();
    found.sort_by(|(one, _), (two, _)| {
        let worth = |of: &Explanation| of.explained as i64 - of.spoiled as i64;
        worth(two).cmp(&worth(one)).then(one.left.total_cmp(&two.left))
    });
    let Some((best, _)) = found.first().cloned() else { return Vec::new() };
    found.retain(|(explanation, _)| are_equal(explanation, &best) && explanation.spoiled <= best.spoiled);
    // A size that nobody makes is no explanation where another fault does as well.
    if found.iter().any(|(_, is_plausible)| *is_plausible) {
        found.retain(|(_, is_plausible)| *is_plausible);
    }
    found.sort_by(|(one, _), (two, _)| strangeness(one).total_cmp(&strangeness(two)));
    found.into_iter().map(|(explanation, _)| explanation).collect()
}

/// Some of the samples, spread over all of them.
fn chosen(samples: &[Sample], is_wrong: bool, most: usize) -> Vec<&Sample> {
    let all: Vec<&Sample> = samples.iter().filter(|sample| sample.is_wrong == is_wrong).collect();
    let count = all.len().min(most);
    let mut left = IMPACTS;
    let fits = |sample: &&Sample| {
        let impacts = sample.answer.as_ref().map_or(1, |answer| answer.impacts.len());
        let rest = left.checked_sub(impacts);
        left = rest.unwrap_or(left);
        rest.is_some()
    };
    (0..count).filter_map(|place| all.get(place * all.len() / count).copied()).filter(fits).collect()
}

/// What would explain the wrong answers of the guest of this name, of those that a run has kept; `None` if there is none.
pub fn for_guest(name: &str, model: Model, tally: &Tally) -> Option<Explained> {
    let samples = tally.samples(name).filter(|samples| samples.has_wrong())?;
    let samples: Vec<Sample> = samples.all().cloned().collect();
    Some(Explained { explanations: explain(&samples, model), signs: signs::signs(&samples) })
}

/// What a hypothesis explains, of samples with their deviations from the truth, at the size that fits best, if that is most; and whether that size is plausible.
fn judge(hypothesis: &Hypothesis, wrong: &[Held], right: &[Held]) -> Option<(Explanation, bool)> {
    let left_at = |size: f64, held: &Held| held.off(hypothesis.at(size, &held.sample.case).as_ref());
    let some = wrong.get(..SOME).unwrap_or(wrong);
    let scored_on = |size: f64, wrong: &[Held]| {
        let left = wrong.iter().map(|held| (held, left_at(size, held)));
        let mut left: Vec<f64> =
            left.filter(|(held, left)| held.is_explained(*left)).map(|(_, left)| left.whole).collect();
        left.sort_by(f64::total_cmp);
        let middle = left.get(left.len() / 2).copied().unwrap_or(f64::INFINITY);
        (size, left.len(), middle)
    };
    let scored = |size: f64| {
        // Most sizes explain nothing, which a few cases tell.
        let few = wrong.get(..FEW).unwrap_or(wrong);
        if scored_on(size, few).1 == 0 { (size, 0, f64::INFINITY) } else { scored_on(size, some) }
    };
    let better = |one: (f64, usize, f64), two: (f64, usize, f64)| {
        if two.1 > one.1 || two.1 == one.1 && two.2 < 0.1 * one.2 { two } else { one }
    };
    // That of the real mistake comes first: another has to be clearly better.
    let mut best = fit::candidates(hypothesis, &some.iter().map(|held| held.sample).collect::<Vec<_>>())
        .into_iter()
        .map(scored)
        .reduce(better)?;
    if 2 * best.1 <= some.len() && hypothesis.is_stepwise() {
        best = fit::scan(hypothesis.natural(), |size| scored(size).1).into_iter().map(scored).fold(best, better);
    }
    let (value, explained, _) = best;
    if 2 * explained <= some.len() {
        return None;
    }
    let (_, explained, left) = scored_on(value, wrong);
    if 2 * explained <= wrong.len() {
        return None;
    }
    let spoiled = right.iter().filter(|held| held.is_spoiled(left_at(value, held))).count();
    if spoiled as f64 > MAY_SPOIL * right.len() as f64 {
        return None;
    }
    let fault = &hypothesis.fault;
    let size = match fault.size {
        Size::Amount { meaning, natural } => {
            Some(FaultSize { meaning: meaning.to_owned(), value, natural: Some(natural) })
        }
        Size::Depth(_) => Some(FaultSize { meaning: "at impact".to_owned(), value, natural: None }),
        Size::Whole => None,
    };
    let explanation = Explanation {
        fault: fault.name.to_owned(),
        as_if: fault.as_if.to_owned(),
        size,
        explained,
        of: wrong.len(),
        left,
        spoiled,
    };
    Some((explanation, hypothesis.is_plausible(value)))
}
