//! What an examination found wrong.

use serde::{Deserialize, Serialize};

use crate::{
    gate::{
        compare::Disagreement,
        laws::{Breach, Law},
    },
    measure::observables::Observable,
};

/// One thing that is wrong with a case: what a red gate has to show.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// Two oracles disagree.
    Pair {
        /// Their names.
        oracles: [String; 2],
        /// On what.
        disagreement: Disagreement,
    },
    /// An oracle breaks a law.
    Law {
        /// Its name.
        oracle: String,
        /// Which, and where.
        breach: Breach,
    },
    /// An oracle is further from a proven enclosure than it claims.
    Refuted {
        /// Its name.
        oracle: String,
        /// The name of the judge.
        judge: String,
        /// On what; the first of the two values is the judge's.
        disagreement: Disagreement,
        /// Whether the error is what the user of an engine grants it, and not what it claims.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        granted: bool,
    },
    /// An engine of somebody else broke: it says nothing about the physics.
    Broke {
        /// Its name.
        oracle: String,
        /// The name of the way in which it broke.
        breakdown: String,
        /// What happened, and what to do.
        how: String,
    },
}

impl Finding {
    /// The names of the oracles that it is about.
    pub fn oracles(&self) -> Vec<&str> {
        match self {
            Self::Pair { oracles, .. } => oracles.iter().map(String::as_str).collect(),
            Self::Law { oracle, .. } | Self::Refuted { oracle, .. } | Self::Broke { oracle, .. } => vec![oracle],
        }
    }

    /// The first impact that it shows at.
    pub fn impact(&self) -> usize {
        match self {
            Self::Pair { disagreement, .. } | Self::Refuted { disagreement, .. } => disagreement.figure.impact,
            Self::Law { breach, .. } => breach.impact,
            Self::Broke { .. } => 0,
        }
    }

    /// Whether it is that an oracle breaks this law.
    pub fn breaks(&self, law: Law) -> bool {
        matches!(self, Self::Law { breach, .. } if breach.law == law)
    }

    /// Whether it is an engine that broke, and nothing that is wrong.
    pub fn is_breakdown(&self) -> bool {
        matches!(self, Self::Broke { .. })
    }

    /// Notes that the errors of this engine are what its user grants it, if it is about one.
    pub fn grant(&mut self, engine: &str) {
        if let Self::Refuted { oracle, granted, .. } = self
            && oracle == engine
        {
            *granted = true;
        }
    }

    /// Whether it is about how the history ends, or how many impacts it has, and not about their numbers.
    pub fn is_of_ending(&self) -> bool {
        match self {
            Self::Pair { disagreement, .. } | Self::Refuted { disagreement, .. } => {
                disagreement.observable == Observable::Ending
            }
            Self::Law { breach, .. } => breach.law.is_of_ending(),
            Self::Broke { .. } => false,
        }
    }

    /// Whether another finding is of the same oracles and kind, so that a smaller case with it shows the same problem.
    pub fn resembles(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Pair { oracles: mine, .. }, Self::Pair { oracles: theirs, .. }) => mine == theirs,
            (Self::Law { oracle: mine, breach: one }, Self::Law { oracle: theirs, breach: two }) => {
                mine == theirs && one.law == two.law
            }
            (Self::Refuted { oracle: mine, .. }, Self::Refuted { oracle: theirs, .. }) => mine == theirs,
            (Self::Broke { oracle: mine, breakdown: one, .. }, Self::Broke { oracle: theirs, breakdown: two, .. }) => {
                mine == theirs && one == two
            }
            _ => false,
        }
    }
}
