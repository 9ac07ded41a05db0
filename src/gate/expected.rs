//! Divergences that are known, as data: who differs from whom, in what, where, and why. Strict: one that no longer shows is an error, for then
//! the entry is out of date, or the gate has stopped looking.

use contract::{Case, Model, Normalisation};
use serde::{Deserialize, Serialize};

use crate::{
    gate::{
        compare::{Agreement, Comparison},
        ladder::{Descent, Ladder},
    },
    measure::{asking::Answer, critical, observables::Observable},
};

/// An entry.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Divergence {
    /// The two oracles. `linear` and `nonlinear` stand for every oracle of that model.
    pub pair: [String; 2],
    /// In what they differ.
    pub observable: Differs,
    /// Where it shows.
    pub regime: Regime,
    /// The smallest relative difference that counts; of endings and orders, any does.
    #[serde(default)]
    pub at_least: f64,
    /// Over how many cases of the regime it has to show at the latest.
    #[serde(default = "one")]
    pub within: usize,
    /// Why they differ, for the report.
    pub reason: String,
}

fn one() -> usize {
    1
}

/// What two oracles are known to differ in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Differs {
    /// The chattering time, relative.
    ChatteringTime,
    /// The ending: complete for one and incomplete for the other, within what they claim.
    Ending,
    /// The order of their difference on a ladder.
    Order,
}

/// Where a divergence shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// Amplitudes over `g α` (Eq. 5): the threshold of the nonlinear block is another.
    SlenderNormalisation,
    /// From nine tenths of the way from the threshold to `a_cr` (Eq. 77) on.
    NearCritical,
    /// The ladder of slenderness.
    LadderOfAlpha,
}

/// How often an entry's regime was met, and the largest difference that was seen there.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Met {
    /// Cases.
    pub cases: usize,
    /// The largest relative difference; 1 for endings that differ.
    pub largest: f64,
}

impl Met {
    /// Adds what was met in other cases.
    pub fn add(&mut self, other: Self) {
        self.cases += other.cases;
        self.largest = self.largest.max(other.largest);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    divergence: Vec<Divergence>,
}

/// Reads a table of entries.
///
/// # Errors
/// When the text is not one.
pub fn read(text: &str) -> Result<Vec<Divergence>, toml::de::Error> {
    Ok(toml::from_str::<File>(text)?.divergence)
}

/// The entries in force. A test makes sure that they can be read.
pub fn table() -> &'static [Divergence] {
    static TABLE: std::sync::LazyLock<Vec<Divergence>> =
        std::sync::LazyLock::new(|| read(include_str!("../../data/expected.toml")).unwrap_or_default());
    &TABLE
}

impl Regime {
    fn holds(self, case: &Case) -> bool {
        match self {
            Self::SlenderNormalisation => {
                case.slenderness().is_some_and(|slenderness| slenderness.normalisation() == Normalisation::Slender)
            }
            Self::NearCritical => (0.9..1.1).contains(&(case.epsilon() / (critical::eq77(case.eta()) - 1.0))),
            Self::LadderOfAlpha => false,
        }
    }
}

impl Divergence {
    fn is_of(&self, first: (&str, Model), second: (&str, Model)) -> bool {
        let stands_for = |named: &str, (oracle, model): (&str, Model)| match named {
            "linear" => model == Model::Linear,
            "nonlinear" => model == Model::Nonlinear,
            name => name == oracle,
        };
        let [one, two] = &self.pair;
        (stands_for(one, first) && stands_for(two, second)) || (stands_for(one, second) && stands_for(two, first))
    }

    /// By how much two answers to a case differ as this entry says, if it is about them.
    pub fn seen(&self, case: &Case, first: &Answer, second: &Answer, comparison: Option<&Comparison>) -> Option<f64> {
        if !self.regime.holds(case) || !self.is_of((&first.oracle, first.model), (&second.oracle, second.model)) {
            return None;
        }
        match self.observable {
            Differs::ChatteringTime => {
                let time = |answer: &Answer| Some(answer.observed()?.chattering_time?.value);
                let (one, two) = (time(first)?, time(second)?);
                Some((one - two).abs() / one.abs().max(two.abs()))
            }
            Differs::Ending => Some(f64::from(comparison?.agreement == Agreement::TooClose)),
            Differs::Order => None,
        }
    }

    /// Whether this entry says that the ladder does not hold.
    pub fn excuses(&self, descent: &Descent) -> bool {
        let [one, two] = &descent.oracles;
        self.observable == Differs::Order
            && self.regime == Regime::LadderOfAlpha
            && descent.ladder == Ladder::Alpha
            && self.is_of((one, Model::Linear), (two, Model::Nonlinear))
    }

    /// Whether it no longer shows, where its regime was met often enough to tell.
    pub fn is_out_of_date(&self, met: Met) -> bool {
        met.cases >= self.within && !(met.largest > 0.0 && met.largest >= self.at_least)
    }

    /// In a few words: who, in what, where.
    pub fn says(&self) -> String {
        let [one, two] = &self.pair;
        let differs = match self.observable {
            Differs::ChatteringTime => Observable::ChatteringTime.name(),
            Differs::Ending => Observable::Ending.name(),
            Differs::Order => "order of the difference",
        };
        let regime = match self.regime {
            Regime::SlenderNormalisation => "under the slender normalisation",
            Regime::NearCritical => "near a_cr",
            Regime::LadderOfAlpha => "on the ladder of slenderness",
        };
        format!("{one} and {two}, {differs} {regime}")
    }
}

#[cfg(test)]
mod tests;
