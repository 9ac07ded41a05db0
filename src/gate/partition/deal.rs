//! Who runs what: the work of a run is dealt to its parts so that they take about equally long.
//!
//! How long a piece of work takes is estimated from what it is, never measured: every part has to come to the same dealing on any machine.

use std::{
    cmp::{Ordering, Reverse},
    collections::BinaryHeap,
};

use crate::{
    cases::{generate::Named, shaking::Question},
    measure::critical,
};

/// The part that each piece of work falls to, from 1 on: the costliest first, each to the part that has least so far.
pub fn deal(costs: &[f64], parts: usize) -> Vec<usize> {
    let mut order: Vec<(usize, f64)> = costs.iter().copied().enumerate().collect();
    order.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    // More parts than pieces of work stay empty.
    let mut loads: BinaryHeap<Reverse<Load>> =
        (1..=parts.min(costs.len())).map(|part| Reverse(Load { cost: 0.0, part })).collect();
    let mut dealt = vec![0; costs.len()];
    for (place, cost) in order {
        let Some(Reverse(least)) = loads.pop() else { break };
        if let Some(part) = dealt.get_mut(place) {
            *part = least.part;
        }
        loads.push(Reverse(Load { cost: least.cost + cost, ..least }));
    }
    dealt
}

/// What a part has to do so far.
#[derive(Debug, Clone, Copy)]
struct Load {
    cost: f64,
    part: usize,
}

impl Ord for Load {
    fn cmp(&self, other: &Self) -> Ordering {
        self.cost.total_cmp(&other.cost).then(self.part.cmp(&other.part))
    }
}

impl PartialOrd for Load {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Load {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Load {}

/// About how long the default panel takes for a case, and the judge where it is asked, in the time that the panel takes for an impact. The
/// weights are rough, from what the cases of one run took, and only how evenly parts are dealt depends on them: the judge needs ever more digits towards the critical amplitude, and ever more impacts where an impact takes hardly anything away.
pub fn cost_of_case(named: &Named, is_judged: bool) -> f64 {
    let case = &named.case;
    let impacts = case.max_impacts() as f64;
    if case.epsilon() <= 0.0 {
        return NO_ROCKING * impacts;
    }
    // Complete below 1, incomplete above.
    let share = case.epsilon() / (critical::short_fit(case.omega(), case.eta()) - 1.0);
    let panel = if share < 1.1 { 1.0 } else { 0.5 };
    if !is_judged {
        return panel * impacts;
    }
    let nearness = (0.3 / (1.0 - share).abs()).powf(0.75).clamp(0.6, 20.0);
    let lossless = (2e-3 / (1.0 - case.eta())).powf(1.6).min(1.0) * (1.0 - share).max(0.0);
    (panel + 0.4 * nearness + 70.0 * lossless) * impacts
}

/// What is left to do where no impact follows.
const NO_ROCKING: f64 = 0.01;

/// About how long a whole response takes, in multiples of a short one: it has ever more impacts where these take hardly anything away.
pub fn cost_of_response(question: &Question) -> f64 {
    1.0 + (0.02 / (1.0 - question.eta())).min(20.0)
}

#[cfg(test)]
mod tests {
    use super::deal;

    #[test]
    fn everything_is_dealt_once_and_evenly() {
        let costs: Vec<f64> = (0..1000).map(|n| f64::from(n * 7919 % 1009)).collect();
        for parts in [1, 2, 3, 7, 100] {
            let dealt = deal(&costs, parts);
            let loads: Vec<f64> = (1..=parts)
                .map(|part| dealt.iter().zip(&costs).filter(|(of, _)| **of == part).map(|(_, cost)| cost).sum())
                .collect();
            let mean = costs.iter().sum::<f64>() / parts as f64;
            assert!(dealt.iter().all(|part| (1..=parts).contains(part)));
            assert!(loads.iter().all(|load| (load / mean - 1.0).abs() < 0.02), "{parts}: {loads:?}");
        }
    }

    #[test]
    fn more_parts_than_work_stay_empty() {
        assert_eq!(deal(&[1.0, 2.0], usize::MAX), [2, 1]);
        assert!(deal(&[], 3).is_empty());
        // What costs nothing is dealt, too.
        assert_eq!(deal(&[0.0; 3], 2), [1, 1, 1]);
    }
}
