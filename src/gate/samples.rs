//! A few of the answers of an engine, right ones and wrong ones: what an explanation is looked for in.

mod written;

use std::collections::BTreeMap;

use contract::{Case, Estimate, History, Impact, Uncertainty};
use serde::{Deserialize, Serialize};

use super::{finding::Finding, identity::Identity};
use crate::cases::generate::Named;

/// What an engine answered to a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The case.
    pub case: Case,
    /// The answer; `None` if it declined.
    pub answer: Option<History>,
    /// Whether something is wrong with it.
    pub is_wrong: bool,
    /// Whether all that is wrong with it is how it ends, or how many impacts it has.
    pub is_ending_wrong: bool,
}

/// Some answers of an engine. Which are kept depends on the cases alone, not on their order, so that those of the shares of a run add up to those of the whole.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Samples {
    wrong: Kept,
    right: Kept,
}

/// By the hash of the case, the smallest ones.
type Kept = BTreeMap<u64, Sample>;

/// So many wrong answers are kept...
pub const WRONG: usize = 40;
/// ...and so many right ones.
pub const RIGHT: usize = 20;
/// A longer history is none of them.
const IMPACTS: usize = 5_000;

impl Samples {
    /// One answer, and what is wrong with it.
    pub(super) fn of(named: &Named, answer: &History, findings: &[Finding]) -> Self {
        let is_wrong = !findings.is_empty();
        let is_ending_wrong = is_wrong && findings.iter().all(Finding::is_of_ending);
        if answer.impacts.len() > IMPACTS {
            return Self::default();
        }
        let sample = Sample { case: named.case, answer: Some(bare(answer)), is_wrong, is_ending_wrong };
        let kept = BTreeMap::from([(Identity::of(named).hash, sample)]);
        if is_wrong { Self { wrong: kept, ..Self::default() } } else { Self { right: kept, ..Self::default() } }
    }

    /// Adds those of other cases.
    pub fn add(&mut self, other: Self) {
        keep(&mut self.wrong, other.wrong, WRONG);
        keep(&mut self.right, other.right, RIGHT);
    }

    /// All that are kept, the wrong ones first.
    pub fn all(&self) -> impl Iterator<Item = &Sample> {
        self.wrong.values().chain(self.right.values())
    }

    /// Whether there is a wrong one.
    pub fn has_wrong(&self) -> bool {
        !self.wrong.is_empty()
    }
}

fn keep(mine: &mut Kept, theirs: Kept, most: usize) {
    mine.extend(theirs);
    while mine.len() > most {
        mine.pop_last();
    }
}

/// The history without claims, which say nothing about what is wrong.
fn bare(history: &History) -> History {
    let none = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
    let impacts = history.impacts.iter().map(|impact| Impact { uncertainty: none, ..*impact });
    History {
        impacts: impacts.collect(),
        ending: history.ending,
        chattering_time: history.chattering_time.map(|time| Estimate { uncertainty: 0.0, ..time }),
    }
}

#[cfg(test)]
mod tests {
    use contract::{Ending, Loss};

    use super::*;
    use crate::cases::generate::Generator;
    use crate::gate::laws::{Breach, Law};
    use crate::stored::{from_line, to_line};

    fn named(number: usize) -> Named {
        let case = Case::from_epsilon(0.01, 1.0 + number as f64, 0.9).unwrap();
        Named { generator: Generator::Random, name: number.to_string(), case }
    }

    fn history(time: f64) -> History {
        let uncertainty = Uncertainty { time: 1.0, interval: 2.0, velocity: 3.0 };
        let impact = Impact { time, interval: f64::NAN, velocity: -0.0, uncertainty };
        let ending = Ending::Lost(Loss::FellThrough);
        let chattering_time = Some(Estimate { value: f64::NEG_INFINITY, uncertainty: 1.0 });
        History { impacts: vec![impact], ending, chattering_time }
    }

    fn all(numbers: impl Iterator<Item = usize>) -> Samples {
        let mut samples = Samples::default();
        for number in numbers {
            let breach = Breach { law: Law::NotLost, impact: 1, how: String::new() };
            let finding = Finding::Law { oracle: "mine".to_owned(), breach };
            let findings = if number % 2 == 0 { vec![finding] } else { Vec::new() };
            samples.add(Samples::of(&named(number), &history(0.1), &findings));
        }
        samples
    }

    /// Shares of a run have together the samples of the whole, in whichever order they are added.
    #[test]
    fn shares_add_up_to_the_whole() {
        let whole = all(0..200);
        assert_eq!(whole.all().filter(|sample| sample.is_wrong).count(), WRONG);
        assert_eq!(whole.all().count(), WRONG + RIGHT);
        let mut parts = all((0..200).rev().step_by(3));
        parts.add(all((2..200).step_by(3)));
        parts.add(all((0..200).step_by(3)));
        let same = |one: &Samples, two: &Samples| format!("{one:?}") == format!("{two:?}");
        assert!(same(&parts, &whole));
        assert!(!same(&all(0..150), &whole));
    }

    /// A file has every bit of them, of numbers that are none too.
    #[test]
    fn samples_come_back_from_a_file() {
        let samples = all(0..3);
        let text = to_line(&samples).unwrap();
        let back: Samples = from_line(&text).unwrap();
        assert_eq!(format!("{back:?}"), format!("{samples:?}"));
        assert!(text.contains("{\"#f64\":\"nan\"}") && text.contains("-0.0"), "{text}");
        assert!(from_line::<Samples>(&text.replace("fell-through", "fell")).is_err());
    }
}
