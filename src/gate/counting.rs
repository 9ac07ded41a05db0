//! Counts, ranges and worst figures that are added up case by case.

use std::collections::BTreeMap;

use contract::Ending;
use serde::{Deserialize, Serialize};

use crate::{cases::generate::Named, gate::compare::Figure};

/// A figure, its share of the allowance, and the case that gave it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorstFigure {
    /// The figure.
    #[serde(flatten)]
    pub figure: Figure,
    /// The share of the allowance.
    pub share: f64,
    /// The case.
    pub case: String,
}

impl WorstFigure {
    pub(super) fn new(named: &Named, figure: Figure) -> Self {
        Self { figure, share: figure.share(), case: named.to_string() }
    }
}

/// Adds one count to another, key by key.
pub(super) fn add_counts<K: Ord>(mine: &mut BTreeMap<K, usize>, theirs: BTreeMap<K, usize>) {
    for (key, count) in theirs {
        *mine.entry(key).or_default() += count;
    }
}

/// Keeps the figure with the larger share; where they are equal, that of the case whose name sorts first: what is kept does not depend on the order in which
/// the cases come.
pub(super) fn keep_worst<K: Ord>(mine: &mut BTreeMap<K, WorstFigure>, key: K, theirs: WorstFigure) {
    let rank = |of: &WorstFigure, other: &WorstFigure| of.share.total_cmp(&other.share).then(other.case.cmp(&of.case));
    match mine.get(&key) {
        Some(worst) if rank(worst, &theirs).is_ge() => {}
        _ => {
            mine.insert(key, theirs);
        }
    }
}

/// The smaller of two that may be missing.
pub(super) fn smaller(one: Option<f64>, two: Option<f64>) -> Option<f64> {
    match (one, two) {
        (Some(one), Some(two)) => Some(one.min(two)),
        _ => one.or(two),
    }
}

/// The range that holds both.
pub(super) fn wider(one: Option<(f64, f64)>, two: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (one, two) {
        (Some((low, high)), Some((lower, higher))) => Some((low.min(lower), high.max(higher))),
        _ => one.or(two),
    }
}

/// A short name for an ending, for counting.
pub(super) fn ending_name(ending: Ending) -> String {
    match ending {
        Ending::NeverRocks => "never-rocks",
        Ending::AtRest => "at-rest",
        Ending::Incomplete => "incomplete",
        Ending::Overturned => "overturned",
        Ending::LimitReached(_) => "limit-reached",
        Ending::Lost(_) => "lost",
    }
    .to_owned()
}
