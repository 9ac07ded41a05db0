//! What is compared, derived once and in the same way for every oracle.

use std::fmt;

use contract::{Case, Ending, Estimate, History};
use serde::{Deserialize, Serialize};

use crate::measure::zeno;

/// A quantity that every history has and that two histories are compared by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Observable {
    /// The interval `Δτ`, relative. First, because it shows a lost sequence that the times hide.
    Interval,
    /// The velocity after the impact, relative.
    Velocity,
    /// The time of the impact, absolute in `τ`.
    ImpactTime,
    /// The ratio of the interval to the last but one, relative to `η²` (Eq. 73).
    IntervalRatio,
    /// The chattering time, absolute in `τ`.
    ChatteringTime,
    /// How the history ends, and with how many impacts.
    Ending,
}

impl Observable {
    /// Those that every impact has.
    pub const OF_AN_IMPACT: [Self; 4] = [Self::Interval, Self::Velocity, Self::ImpactTime, Self::IntervalRatio];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Interval => "interval",
            Self::Velocity => "velocity",
            Self::ImpactTime => "impact time",
            Self::IntervalRatio => "interval ratio",
            Self::ChatteringTime => "chattering time",
            Self::Ending => "ending",
        }
    }
}

impl fmt::Display for Observable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A history with what follows from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Observed {
    /// What the oracle returned.
    pub history: History,
    /// The chattering time, where the chattering is complete and the list long enough to close its sum.
    pub chattering_time: Option<Estimate>,
}

impl Observed {
    /// Derives the observables of a history of `case`.
    pub fn new(case: &Case, history: History) -> Self {
        let complete = history.ending == Ending::AtRest;
        let chattering_time = if complete { zeno::close(&history, case.eta()) } else { None };
        Self { history, chattering_time }
    }

    /// The value of an observable at impact `n` (1 is the first) and the error claimed for it, in the same scale: relative for the
    /// interval, the velocity and the ratio.
    pub fn at(&self, observable: Observable, n: usize) -> Option<Estimate> {
        let impact = |n: usize| self.history.impacts.get(n.checked_sub(1)?);
        let this = impact(n)?;
        let (value, uncertainty) = match observable {
            Observable::Interval => (this.interval, this.uncertainty.interval),
            Observable::Velocity => (this.velocity, this.uncertainty.velocity),
            Observable::ImpactTime => (this.time, this.uncertainty.time),
            Observable::IntervalRatio => {
                let before = impact(n.checked_sub(2)?)?;
                (this.interval / before.interval, this.uncertainty.interval + before.uncertainty.interval)
            }
            Observable::ChatteringTime | Observable::Ending => return None,
        };
        Some(Estimate { value, uncertainty })
    }
}
