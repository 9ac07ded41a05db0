//! What came out for a pair of oracles over a run.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::Named,
    gate::{
        compare::{Agreement, Comparison},
        counting::{WorstFigure, add_counts, keep_worst},
    },
    measure::observables::Observable,
};

/// What came out for a pair of oracles.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Their names.
    pub oracles: [String; 2],
    /// How many cases were compared.
    pub compared: usize,
    /// How many impacts.
    pub impacts: usize,
    /// Of them, how many in name only: with claims so wide that nearly anything would have passed.
    pub vacuous: usize,
    /// How many chattering times, and of them, how many in name only.
    pub chattering_times: usize,
    /// See `chattering_times`.
    pub vacuous_times: usize,
    /// Cases in which one of the two gave no history.
    pub absent: usize,
    /// Cases that are different problems to the two, by reason.
    pub incomparable: BTreeMap<String, usize>,
    /// Cases that are complete for one and incomplete for the other, within what they claim.
    pub too_close: usize,
    /// Cases in which they disagree.
    pub disagreements: usize,
    /// For each observable the figure that used most of its allowance, among those of cases in which they agree; those of the failures are
    /// listed with them.
    pub worst: BTreeMap<Observable, WorstFigure>,
}

impl Pair {
    pub(super) fn add_comparison(&mut self, named: &Named, comparison: &Comparison) {
        self.compared = 1;
        self.impacts = comparison.impacts;
        self.vacuous = comparison.vacuous;
        self.chattering_times = usize::from(comparison.chattering_time.is_some());
        self.vacuous_times = usize::from(comparison.chattering_time == Some(false));
        match comparison.agreement {
            Agreement::Agree => {
                for (&observable, &figure) in &comparison.worst {
                    self.worst.insert(observable, WorstFigure::new(named, figure));
                }
            }
            Agreement::TooClose => self.too_close = 1,
            Agreement::Disagree(_) => self.disagreements = 1,
        }
    }

    pub(super) fn add(&mut self, other: Self) {
        self.compared += other.compared;
        self.impacts += other.impacts;
        self.vacuous += other.vacuous;
        self.chattering_times += other.chattering_times;
        self.vacuous_times += other.vacuous_times;
        self.absent += other.absent;
        self.too_close += other.too_close;
        self.disagreements += other.disagreements;
        add_counts(&mut self.incomparable, other.incomparable);
        for (observable, worst) in other.worst {
            keep_worst(&mut self.worst, observable, worst);
        }
    }

    /// The observable that used least of its allowance where it came nearest to it, and that share.
    pub(super) fn used(&self) -> (Observable, f64) {
        let shares = self.worst.iter().map(|(&observable, worst)| (observable, worst.share));
        shares.min_by(|(_, one), (_, two)| one.total_cmp(two)).unwrap_or((Observable::Interval, 0.0))
    }
}
