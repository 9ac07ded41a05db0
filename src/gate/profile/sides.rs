//! The two sides of the critical amplitude: how near to it an engine is right, and on which side it is not.

use std::collections::BTreeMap;

use contract::{Case, Ending, Horizon, Model};
use serde::{Deserialize, Serialize};

use crate::measure::critical;

/// Complete chattering below the critical amplitude, incomplete above it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Sides {
    /// The cases that come to rest.
    pub below: Side,
    /// Those that rock on.
    pub above: Side,
}

/// The cases on one side.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Side {
    /// How many answers are right.
    pub right: usize,
    /// How many are wrong.
    pub wrong: usize,
    /// In how many of these the answer is that of the other side.
    pub turned: usize,
    /// The cases whose distance from the critical amplitude is known, by its power of ten.
    pub by_distance: BTreeMap<i32, Counts>,
    /// The least of these distances at which the answer is right.
    pub nearest_right: Option<f64>,
    /// The largest at which it is wrong.
    pub farthest_wrong: Option<f64>,
    /// The largest at which it is that of the other side.
    pub farthest_turned: Option<f64>,
}

/// Answers that are right and wrong.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// How many are right.
    pub right: usize,
    /// How many are wrong.
    pub wrong: usize,
    /// In how many of these the answer is that of the other side.
    pub turned: usize,
}

/// Distances below this are not told from each other: the critical amplitude is not known better.
const NEAREST: f64 = 1e-13;

/// How an answer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Outcome {
    /// Whether anything is wrong with it.
    pub is_wrong: bool,
    /// What it says of the end.
    pub said: Ending,
}

impl Sides {
    /// Counts an answer to a case that truly ends so. One that was not followed to half a period has no side.
    pub(super) fn note(&mut self, case: &Case, model: Model, truth: Ending, outcome: Outcome) {
        let is_complete = |ending| matches!(ending, Ending::AtRest);
        let is_rocking = |ending| matches!(ending, Ending::Incomplete | Ending::Overturned);
        let (side, is_of_the_other) = match truth {
            _ if case.horizon() != Horizon::HalfPeriod => return,
            _ if is_complete(truth) => (&mut self.below, is_rocking(outcome.said)),
            _ if is_rocking(truth) => (&mut self.above, is_complete(outcome.said)),
            _ => return,
        };
        let turned = outcome.is_wrong && is_of_the_other;
        let counts = Counts {
            right: usize::from(!outcome.is_wrong),
            wrong: usize::from(outcome.is_wrong),
            turned: usize::from(turned),
        };
        side.add(Side { right: counts.right, wrong: counts.wrong, turned: counts.turned, ..Side::default() });
        if let Some(distance) = distance(case, model) {
            let at = |holds: bool| holds.then_some(distance);
            side.add(Side {
                by_distance: BTreeMap::from([(distance.log10().floor() as i32, counts)]),
                nearest_right: at(!outcome.is_wrong),
                farthest_wrong: at(outcome.is_wrong),
                farthest_turned: at(turned),
                ..Side::default()
            });
        }
    }

    /// Adds those of other cases.
    pub(super) fn add(&mut self, other: Self) {
        self.below.add(other.below);
        self.above.add(other.above);
    }
}

impl Side {
    fn add(&mut self, other: Self) {
        let larger = |one: Option<f64>, two: Option<f64>| one.into_iter().chain(two).reduce(f64::max);
        let smaller = |one: Option<f64>, two: Option<f64>| one.into_iter().chain(two).reduce(f64::min);
        self.right += other.right;
        self.wrong += other.wrong;
        self.turned += other.turned;
        for (decade, counts) in other.by_distance {
            let mine = self.by_distance.entry(decade).or_default();
            mine.right += counts.right;
            mine.wrong += counts.wrong;
            mine.turned += counts.turned;
        }
        self.nearest_right = smaller(self.nearest_right, other.nearest_right);
        self.farthest_wrong = larger(self.farthest_wrong, other.farthest_wrong);
        self.farthest_turned = larger(self.farthest_turned, other.farthest_turned);
    }
}

/// The distance of a case from the critical amplitude, over that of the critical amplitude from the threshold; `None` of the nonlinear model, and where no
/// formula has the critical amplitude to all digits.
fn distance(case: &Case, model: Model) -> Option<f64> {
    if model != Model::Linear {
        return None;
    }
    let critical = critical::interpolated(case.omega(), case.eta()).ok()?;
    Some(((case.epsilon() - critical) / critical).abs().max(NEAREST))
}
