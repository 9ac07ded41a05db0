//! What became of each case of a run, for reports that list cases: who declined and why, and how long it took.
//!
//! Measured times are here and in no [`Report`](super::report::Report), which is the same for any number of threads.

use std::{
    collections::{BTreeMap, HashMap, HashSet},
    sync::Arc,
};

use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::Named,
    gate::{examine::Examination, known::Known},
    measure::asking::Reply,
};

/// What became of the cases of a run; of those that were left out nothing is known.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Outcomes {
    cases: Vec<Outcome>,
    known: BTreeMap<String, Vec<KnownHere>>,
    /// How long each whole response took, in seconds as measured.
    responses: HashMap<String, f64>,
    /// Every word of a reason once: a run may have a million cases.
    #[serde(skip)]
    words: HashSet<Arc<str>>,
}

/// What became of one case.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Outcome {
    /// Its name.
    pub case: String,
    /// Whether every history that was given was judged, and there was one.
    pub is_judged: bool,
    /// How long everything took, in seconds, where that was measured.
    pub seconds: Option<f64>,
    /// The same of each oracle, in the order of the panel.
    of_each: Vec<f32>,
    /// The oracles that gave no history, by their places, and why not.
    without: Vec<(usize, Without)>,
}

/// Why an oracle gave no history.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Without {
    /// It declined, for this reason.
    Declined(#[serde(with = "word")] Arc<str>),
    /// It broke, in this way.
    Broke(#[serde(with = "word")] Arc<str>),
    /// It panicked.
    Panicked,
}

/// A known failure of an engine that was met in a case, and is not held against it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct KnownHere {
    /// The name of the engine.
    pub oracle: String,
    /// Why it is known.
    pub reason: String,
}

impl Outcome {
    /// Of a case that took so many seconds.
    pub(super) fn of(named: &Named, examination: &Examination, seconds: f64) -> Self {
        let without = examination.answers.iter().enumerate().filter_map(|(place, answer)| {
            let without = match &answer.reply {
                Reply::Observed(_) => return None,
                Reply::Declined(why) => Without::Declined(why.reason().into()),
                Reply::Broke(how) => Without::Broke(how.reason().into()),
                Reply::Panicked(_) => Without::Panicked,
            };
            Some((place, without))
        });
        let of_each = examination.seconds.iter().map(|seconds| *seconds as f32).collect();
        let (is_judged, seconds, without) = (examination.is_judged(), Some(seconds), without.collect());
        Self { case: named.to_string(), is_judged, seconds, of_each, without }
    }

    /// Why the oracle at this place gave no history; `None` if it gave one.
    pub fn without(&self, oracle: usize) -> Option<&Without> {
        self.without.iter().find(|(place, _)| *place == oracle).map(|(_, why)| why)
    }

    /// How long the oracle at this place took, in seconds, where that was measured.
    pub fn seconds_of(&self, oracle: usize) -> Option<f64> {
        self.of_each.get(oracle).copied().map(f64::from)
    }
}

impl Outcomes {
    /// Notes a case that was examined. Each oracle took so many seconds more `before` it, when it was told of the cases that come.
    pub(super) fn push(&mut self, mut outcome: Outcome, before: &[f64]) {
        outcome.seconds = outcome.seconds.map(|seconds| seconds + before.iter().sum::<f64>());
        for (seconds, before) in outcome.of_each.iter_mut().zip(before) {
            *seconds += *before as f32;
        }
        for (_, without) in &mut outcome.without {
            if let Without::Declined(word) | Without::Broke(word) = without {
                match self.words.get(word) {
                    Some(known) => *word = Arc::clone(known),
                    None => _ = self.words.insert(Arc::clone(word)),
                }
            }
        }
        self.cases.push(outcome);
    }

    /// Adds those of another part of the same run.
    pub(super) fn add(&mut self, other: Self) {
        self.cases.extend(other.cases);
        for (case, known) in other.known {
            let mine = self.known.entry(case).or_default();
            mine.extend(known.into_iter().filter(|known| !mine.contains(known)).collect::<Vec<_>>());
        }
        self.responses.extend(other.responses);
    }

    /// Notes that this case fails as is known of an engine.
    pub(super) fn push_known(&mut self, named: &Named, known: &Known) {
        let here = KnownHere { oracle: known.oracle.clone(), reason: known.reason.clone() };
        let all = self.known.entry(named.to_string()).or_default();
        if !all.contains(&here) {
            all.push(here);
        }
    }

    /// The same with how long each of these whole responses took, in seconds as measured.
    #[must_use]
    pub fn with_responses(self, names: &[String], seconds: Vec<f64>) -> Self {
        Self { responses: names.iter().cloned().zip(seconds).collect(), ..self }
    }

    /// How long the whole response of this name took, in seconds, if that was measured.
    pub fn response_seconds(&self, name: &str) -> Option<f64> {
        self.responses.get(name).copied()
    }

    /// What became of each case, by its name.
    pub fn by_name(&self) -> HashMap<&str, &Outcome> {
        self.cases.iter().map(|outcome| (outcome.case.as_str(), outcome)).collect()
    }

    /// In how many cases anything fails as is known of an engine.
    pub fn cases_known(&self) -> usize {
        self.known.len()
    }

    /// In how many cases this engine fails as is known of it.
    pub fn cases_known_of(&self, engine: &str) -> usize {
        self.known.values().filter(|all| all.iter().any(|known| known.oracle == engine)).count()
    }

    /// Known failures of engines that were met in the case of this name.
    pub fn known(&self, name: &str) -> &[KnownHere] {
        self.known.get(name).map_or(&[], Vec::as_slice)
    }
}

/// A word that many cases share, as a text.
mod word {
    use std::sync::Arc;

    use serde::{Deserialize, Deserializer, Serializer};

    pub fn serialize<S: Serializer>(word: &Arc<str>, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(word)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Arc<str>, D::Error> {
        Ok(String::deserialize(from)?.into())
    }
}
