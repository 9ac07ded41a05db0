//! Failures of an engine that are known, as data: of what kind, where, and why. Strict: one that no longer fails is an error, for then the entry is out of
//! date, or the gate has stopped looking.

use std::fmt;

use contract::Case;
use serde::{
    Deserialize, Serialize,
    de::value::{self, StrDeserializer},
};

use crate::{
    gate::{finding::Finding, laws::Law},
    measure::observables::Observable,
};

/// An entry.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// The name of the engine.
    pub oracle: String,
    /// What fails.
    pub class: Class,
    /// Where it may.
    pub regime: Regime,
    /// Why.
    pub reason: String,
    /// Where more is said about it.
    pub link: Option<String>,
    /// Over how many cases of the regime it has to show at the latest.
    pub within: usize,
    /// The file and the line of the entry.
    pub entry: String,
}

/// What fails.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Class {
    /// An observable differs from that of others, or from what is proven.
    Observable(Observable),
    /// A law is broken.
    Law(Law),
    /// The engine breaks, in the way of this name.
    Breakdown(String),
}

/// Where a failure may be: ranges of the parameters, their ends included, and of the first impact that is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Regime {
    /// Of the amplitude `a`.
    pub a: Option<[f64; 2]>,
    /// Of `a - 1`.
    pub epsilon: Option<[f64; 2]>,
    /// Of the frequency ratio.
    pub omega: Option<[f64; 2]>,
    /// Of the restitution.
    pub eta: Option<[f64; 2]>,
    /// Of the slenderness.
    pub alpha: Option<[f64; 2]>,
    /// Of the impact; a failure of a whole history is at impact 0.
    pub impact: Option<[f64; 2]>,
}

/// What became of an entry in a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KnownFailure {
    /// The name of the engine.
    pub oracle: String,
    /// The entry, in a few words.
    pub says: String,
    /// Why it is known, as the entry says.
    pub reason: String,
    /// Where more is said about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// How many cases were in its regime.
    pub met: usize,
    /// In how many of them it failed.
    pub failed: usize,
    /// Over how many cases of the regime it has to show at the latest.
    pub within: usize,
    /// Whether it failed in none of as many as it takes to tell.
    pub is_out_of_date: bool,
    /// The file and the line of the entry.
    pub entry: String,
}

impl Class {
    /// The kind of failure of this name: an observable, a law, or, if `is_breakdown` knows it, a way to break.
    pub fn named(name: &str, is_breakdown: impl Fn(&str) -> bool) -> Option<Self> {
        let word = || StrDeserializer::<value::Error>::new(name);
        let observable = Observable::deserialize(word()).ok().map(Self::Observable);
        let law = || Law::deserialize(word()).ok().map(Self::Law);
        observable.or_else(law).or_else(|| is_breakdown(name).then(|| Self::Breakdown(name.to_owned())))
    }

    fn is_of(&self, finding: &Finding) -> bool {
        match (self, finding) {
            (
                Self::Observable(observable),
                Finding::Pair { disagreement, .. } | Finding::Refuted { disagreement, .. },
            ) => disagreement.observable == *observable,
            // The law of the interval ratios has the name of the observable that it is about.
            (Self::Observable(Observable::IntervalRatio), Finding::Law { breach, .. }) => {
                breach.law == Law::IntervalRatio
            }
            (Self::Law(law), Finding::Law { breach, .. }) => breach.law == *law,
            (Self::Breakdown(name), Finding::Broke { breakdown, .. }) => breakdown == name,
            _ => false,
        }
    }
}

impl Regime {
    /// Whether a case is in it, as far as its parameters say.
    pub fn has(&self, case: &Case) -> bool {
        let holds = |range: Option<[f64; 2]>, value: f64| range.is_none_or(|[from, to]| from <= value && value <= to);
        let alpha = case.slenderness().map(|slenderness| slenderness.alpha());
        holds(self.a, case.amplitude())
            && holds(self.epsilon, case.epsilon())
            && holds(self.omega, case.omega())
            && holds(self.eta, case.eta())
            && (self.alpha.is_none() || alpha.is_some_and(|alpha| holds(self.alpha, alpha)))
    }

    fn has_impact(&self, impact: usize) -> bool {
        self.impact.is_none_or(|[from, to]| from <= impact as f64 && impact as f64 <= to)
    }
}

impl Known {
    /// Whether this entry is about what was found in this case.
    pub fn excuses(&self, case: &Case, finding: &Finding) -> bool {
        finding.oracles().contains(&self.oracle.as_str())
            && self.class.is_of(finding)
            && self.regime.has(case)
            && self.regime.has_impact(finding.impact())
    }

    /// What became of it, when `met` cases were in its regime and it failed in `failed` of them.
    pub fn outcome(&self, met: usize, failed: usize) -> KnownFailure {
        KnownFailure {
            oracle: self.oracle.clone(),
            says: self.to_string(),
            reason: self.reason.clone(),
            link: self.link.clone(),
            met,
            failed,
            within: self.within,
            is_out_of_date: failed == 0 && met >= self.within,
            entry: self.entry.clone(),
        }
    }
}

impl KnownFailure {
    /// Adds what became of the same entry in other cases.
    pub fn add(&mut self, other: &Self) {
        self.met += other.met;
        self.failed += other.failed;
        self.is_out_of_date = self.failed == 0 && self.met >= self.within;
    }
}

impl fmt::Display for Known {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let class = match &self.class {
            Class::Observable(observable) => observable.name(),
            Class::Law(law) => law.says(),
            Class::Breakdown(name) => name,
        };
        write!(f, "{}: {class}", self.oracle)?;
        let Regime { a, epsilon, omega, eta, alpha, impact } = self.regime;
        for (name, range) in
            [("a", a), ("epsilon", epsilon), ("omega", omega), ("eta", eta), ("alpha", alpha), ("impact", impact)]
        {
            if let Some([from, to]) = range {
                write!(f, ", {name} {from} to {to}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gate::laws::Breach;

    /// One name is of an observable and of the law about it, and is known to fail as both.
    #[test]
    fn the_interval_ratio_is_known_as_an_observable_and_as_a_law() {
        let broken = |law| {
            let breach = Breach { law, impact: 9, how: String::new() };
            Finding::Law { oracle: "mine".to_owned(), breach }
        };
        let known = Class::named("interval-ratio", |_| false).unwrap();
        assert!(known.is_of(&broken(Law::IntervalRatio)));
        assert!(!known.is_of(&broken(Law::TimeIsSum)));
        let other = Class::named("interval", |_| false).unwrap();
        assert!(!other.is_of(&broken(Law::IntervalRatio)));
    }
}
