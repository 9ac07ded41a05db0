//! The size of a fault that comes nearest to what an engine answered.

use contract::Case;

use super::{deviation, hypothesis::Hypothesis};
use crate::{
    faults::{Size, plant::Plant},
    gate::samples::Sample,
};

/// So many impacts of a case are fitted to.
const IMPACTS: usize = 12;
/// So many cases.
const CASES: usize = 6;
/// So often the size is bettered.
const STEPS: usize = 8;

/// Sizes to be tried, that of the real mistake first.
pub(super) fn candidates(hypothesis: &Hypothesis, wrong: &[&Sample]) -> Vec<f64> {
    match hypothesis.fault.size {
        Size::Whole => vec![1.0],
        Size::Depth(_) => depths(hypothesis, wrong),
        // A term of a series is lost or it is not.
        Size::Amount { natural, .. } if matches!(hypothesis.fault.plant, Plant::Series(_)) => vec![natural],
        Size::Amount { natural, .. } => {
            let some: Vec<&Sample> = wrong.iter().step_by(wrong.len().div_ceil(CASES).max(1)).copied().collect();
            let seeds = [0.0, natural, 0.03 * natural, -natural];
            let mut sizes = vec![natural];
            sizes.extend(seeds.into_iter().filter_map(|seed| improved(hypothesis, &some, seed, natural)));
            sizes
        }
    }
}

/// The places at which the cases go wrong, and those beside them.
fn depths(hypothesis: &Hypothesis, wrong: &[&Sample]) -> Vec<f64> {
    let mut depths: Vec<usize> = wrong
        .iter()
        .filter_map(|sample| {
            let (answer, truth) = (sample.answer.as_ref()?, hypothesis.truth(&sample.case)?);
            let is_off = |(one, two): (&contract::Impact, &contract::Impact)| {
                deviation::of(one, two).iter().any(|off| off.abs() > 1e-6) || one.velocity * two.velocity <= 0.0
            };
            answer.impacts.iter().zip(&truth.impacts).position(is_off)
        })
        .flat_map(|index| [index + 1, index, index + 2])
        .collect();
    depths.sort_unstable();
    depths.dedup();
    depths.into_iter().filter(|depth| *depth > 0).take(MOST_DEPTHS).map(|depth| depth as f64).collect()
}

const MOST_DEPTHS: usize = 30;

/// The size from `seed` on that makes the deviations least, by steps of Gauss and Newton.
fn improved(hypothesis: &Hypothesis, samples: &[&Sample], seed: f64, natural: f64) -> Option<f64> {
    // Of each case no more is asked than is fitted to, where asking takes time.
    let asked = |case: &Case| match hypothesis.fault.plant {
        Plant::Answer(_) => Some(*case),
        _ => case.with_max_impacts(IMPACTS).ok(),
    };
    let short: Vec<_> = samples.iter().filter_map(|sample| Some((*sample, asked(&sample.case)?))).collect();
    let residuals = |size: f64| -> Vec<f64> {
        short.iter().flat_map(|(sample, case)| residuals(sample, hypothesis.at(size, case).as_ref())).collect()
    };
    let (mut size, mut off) = (seed, residuals(seed));
    let mut moved = false;
    for _ in 0..STEPS {
        let step = 1e-4 * size.abs().max(1e-3 * natural.abs());
        let slope = residuals(size + step).into_iter().zip(&off).map(|(there, here)| (there - here) / step);
        let (mut along, mut square) = (0.0, 0.0);
        for (slope, off) in slope.zip(&off).filter(|(slope, off)| slope.is_finite() && off.is_finite()) {
            along += slope * off;
            square += slope * slope;
        }
        if !(square > 0.0 && along.is_finite() && along != 0.0) {
            break;
        }
        let shorter = [1.0, 0.5, 0.25, 0.0625].map(|share| size - share * along / square);
        let bettered = shorter.into_iter().map(|size| (size, residuals(size))).find(|(_, new)| sum(new) < sum(&off));
        let Some(next) = bettered else { break };
        (size, off) = next;
        moved = true;
    }
    moved.then_some(size)
}

/// The deviations of the first impacts; not a number where there is nothing to compare.
fn residuals(sample: &Sample, planted: Option<&contract::History>) -> Vec<f64> {
    let pair = |n: usize| {
        let (answer, planted) = (sample.answer.as_ref()?, planted?);
        Some(deviation::of(planted.impacts.get(n)?, answer.impacts.get(n)?))
    };
    let answers = sample.answer.as_ref().zip(planted);
    let whole = answers.filter(|(answer, planted)| answer.impacts.len() == planted.impacts.len());
    let rest = whole.and_then(|(answer, planted)| deviation::of_rest(&sample.case, answer, planted));
    (0..IMPACTS).flat_map(|n| pair(n).unwrap_or([f64::NAN; 3])).chain([rest.map_or(f64::NAN, |off| -off)]).collect()
}

/// The sum of squares. What there is nothing to compare for, counts as wholly off.
fn sum(residuals: &[f64]) -> f64 {
    residuals.iter().map(|off| if off.is_finite() { off * off } else { 1.0 }).sum()
}

/// Sizes around the real mistake's, over many powers of ten, then finer about the one that explains most.
pub(super) fn scan(natural: f64, explained: impl Fn(f64) -> usize) -> Vec<f64> {
    let mut best = (natural, 0);
    let mut span = 12.0_f64;
    let mut sizes = Vec::new();
    for _ in 0..4 {
        let middle = best.0;
        for k in -32..=32 {
            let size = middle * 10.0_f64.powf(span * f64::from(k) / 32.0);
            let count = explained(size);
            if count > best.1 {
                best = (size, count);
            }
        }
        if best.1 == 0 {
            break;
        }
        sizes.push(best.0);
        span /= 16.0;
    }
    sizes
}
