//! What an engine says of the end of a history, and what is true of it.

use std::collections::BTreeMap;

use contract::{Ending, Limit};
use serde::{Deserialize, Serialize};

use crate::gate::{
    counting::{add_counts, ending_name},
    finding::Finding,
};

/// The cases that end in one way.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Said {
    /// How many answers say that they do.
    pub right: usize,
    /// How many leave it open: as many impacts as were asked for, and no word of what follows; or a case that is too close to call.
    pub open: usize,
    /// How many say something else.
    pub wrong: usize,
    /// How many say what.
    pub says: BTreeMap<String, usize>,
}

impl Said {
    /// One answer: what it says, what is true, and what is wrong with it. A list that ends too early or too late is no right ending, whatever it says.
    pub(super) fn of(said: Ending, truth: Ending, findings: &[Finding]) -> Self {
        let rocks = |ending| matches!(ending, Ending::Incomplete | Ending::Overturned);
        let is_ending_wrong = findings.iter().any(Finding::is_of_ending);
        let is_right = !is_ending_wrong && (said == truth || rocks(said) && rocks(truth));
        let says_nothing = findings.is_empty() || said == Ending::LimitReached(Limit::Impacts);
        let is_open = !is_ending_wrong && !is_right && says_nothing;
        Self {
            right: usize::from(is_right),
            open: usize::from(is_open),
            wrong: usize::from(!is_right && !is_open),
            says: BTreeMap::from([(ending_name(said), 1)]),
        }
    }

    /// Adds those of other cases.
    pub(super) fn add(&mut self, other: Self) {
        self.right += other.right;
        self.open += other.open;
        self.wrong += other.wrong;
        add_counts(&mut self.says, other.says);
    }

    /// How many answers there are.
    pub fn count(&self) -> usize {
        self.right + self.open + self.wrong
    }
}
