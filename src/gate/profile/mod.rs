//! How good an engine is: its error against depth, how deep and how near to the critical amplitude it is right, and how often it knows the end.
//!
//! It is held against what the judge proved, in the cases that were judged, and else against the first oracle of the panel that solves the same equation.
//! It is counted case by case and can be added in any order. It holds no times.

mod endings;
mod errors;
mod sides;

use std::collections::BTreeMap;

use contract::{Ending, Model};
use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::Named,
    gate::{counting::ending_name, examine::Examination, finding::Finding, guests::Guests},
    measure::observables::{Observable, Observed},
};
pub use endings::Said;
pub use errors::Errors;
pub use sides::{Counts, Side, Sides};

/// The profile of an engine.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// How many answers were held against what is proven...
    pub proven: usize,
    /// ...and how many against the first oracle of the panel beside it that solves the same equation.
    pub stepped: usize,
    /// In how many of them nothing is wrong.
    pub right: usize,
    /// In how many something is.
    pub wrong: usize,
    /// The errors of the intervals, relative, by depth: impact 1, 2, 3 and 4, 5 to 8, 9 to 16 and so on. Those after a lost impact too.
    pub depth: Vec<Depth>,
    /// The errors of the chattering time, relative.
    pub chattering_time: Errors,
    /// The deepest impact up to which an answer is right.
    pub deepest: Option<Deepest>,
    /// The smallest interval that is right, with all before it.
    pub smallest: Option<Smallest>,
    /// Below and above the critical amplitude.
    pub sides: Sides,
    /// By how a case truly ends: what the answers say.
    pub endings: BTreeMap<String, Said>,
}

/// The impacts of one range of depths.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Depth {
    /// The first impact of the range.
    pub from: usize,
    /// The last one.
    pub to: usize,
    /// How many impacts are right: nothing is wrong with them or any before them.
    pub right: usize,
    /// How many answers lack impacts here that they should have.
    pub lacking: usize,
    /// The relative errors of the intervals.
    pub intervals: Errors,
}

/// The deepest impact that is right.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Deepest {
    /// Which.
    pub impact: usize,
    /// Of which case.
    pub case: String,
}

/// The smallest interval that is right.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Smallest {
    /// The interval.
    pub interval: f64,
    /// At which impact.
    pub impact: usize,
    /// Of which case.
    pub case: String,
}

/// What is looked at: an answer, what it is held against, and what is wrong with it.
struct Held<'a> {
    answer: &'a Observed,
    truth: &'a Observed,
    is_proven: bool,
    model: Model,
    findings: &'a [Finding],
}

impl Profile {
    /// The profile of the answer at this place of an examination, with which this is wrong; `None` where there is no answer, or nothing to hold it against.
    pub(super) fn of(
        named: &Named,
        examination: &Examination,
        place: usize,
        findings: &[Finding],
        guests: &Guests,
    ) -> Option<Self> {
        let answer = examination.answers.get(place)?;
        let proven = examination.judgements.iter().find(|judgement| judgement.place == place);
        let beside = || {
            let mut others = examination.answers.iter().filter(|other| !(guests.is_guest)(&other.oracle));
            others.find_map(|other| other.observed().filter(|_| other.model == answer.model))
        };
        let truth = proven.map(|judgement| judgement.proven.as_ref()).or_else(beside)?;
        let (is_proven, model) = (proven.is_some(), answer.model);
        Some(Held { answer: answer.observed()?, truth, is_proven, model, findings }.profile(named))
    }

    /// Adds the profile of other cases.
    pub fn add(&mut self, other: Self) {
        self.proven += other.proven;
        self.stepped += other.stepped;
        self.right += other.right;
        self.wrong += other.wrong;
        for (place, theirs) in other.depth.into_iter().enumerate() {
            match self.depth.get_mut(place) {
                Some(mine) => mine.add(theirs),
                None => self.depth.push(theirs),
            }
        }
        self.chattering_time.add(other.chattering_time);
        let deeper = |one: &Deepest, two: &Deepest| one.impact.cmp(&two.impact).then_with(|| two.case.cmp(&one.case));
        self.deepest = self.deepest.take().into_iter().chain(other.deepest).max_by(deeper);
        let smaller = |one: &Smallest, two: &Smallest| {
            one.interval.total_cmp(&two.interval).then_with(|| one.case.cmp(&two.case))
        };
        self.smallest = self.smallest.take().into_iter().chain(other.smallest).min_by(smaller);
        self.sides.add(other.sides);
        for (ending, said) in other.endings {
            self.endings.entry(ending).or_default().add(said);
        }
    }

    /// How many answers there are.
    pub fn answers(&self) -> usize {
        self.right + self.wrong
    }
}

impl Depth {
    fn add(&mut self, other: Self) {
        self.right += other.right;
        self.lacking += other.lacking;
        self.intervals.add(other.intervals);
    }
}

/// The place of the range that an impact is in.
fn range_of(impact: usize) -> usize {
    impact.saturating_sub(1).checked_ilog2().map_or(0, |power| power as usize + 1)
}

/// The first and last impact of the range at a place.
fn range(place: usize) -> (usize, usize) {
    let last = 1_usize << place.min(40);
    (last / 2 + 1, last)
}

impl Held<'_> {
    fn profile(&self, named: &Named) -> Profile {
        let is_wrong = !self.findings.is_empty();
        let (said, truth) = (self.answer.history.ending, self.truth.history.ending);
        let mut profile = Profile {
            proven: usize::from(self.is_proven),
            stepped: usize::from(!self.is_proven),
            right: usize::from(!is_wrong),
            wrong: usize::from(is_wrong),
            depth: self.depth(),
            ..Profile::default()
        };
        if let (Some(truth), Some(answer)) = (self.truth.chattering_time, self.answer.chattering_time) {
            profile.chattering_time.note((answer.value - truth.value) / truth.value);
        }
        let right = self.right();
        let case = named.to_string();
        let intervals =
            (1..=right).filter_map(|impact| Some((self.truth.at(Observable::Interval, impact)?.value, impact)));
        let smallest = intervals.min_by(|(one, _), (two, _)| one.total_cmp(two));
        profile.smallest = smallest.map(|(interval, impact)| Smallest { interval, impact, case: case.clone() });
        profile.deepest = (right > 0).then_some(Deepest { impact: right, case });
        profile.sides.note(&named.case, self.model, truth, sides::Outcome { is_wrong, said });
        profile.endings.insert(ending_name(truth), Said::of(said, truth, self.findings));
        profile
    }

    /// Up to which impact nothing is wrong.
    fn right(&self) -> usize {
        let listed = self.answer.history.impacts.len();
        let wrong = self.findings.iter().map(Finding::impact).filter(|impact| *impact > 0).min();
        wrong.map_or(listed, |impact| listed.min(impact - 1))
    }

    fn depth(&self) -> Vec<Depth> {
        let (listed, right) = (self.answer.history.impacts.len(), self.right());
        // A list that ends at an impact which its sequence goes on from lacks nothing.
        let expected = match self.truth.history.ending {
            Ending::Lost(_) => 0,
            _ => self.truth.history.impacts.len(),
        };
        let ranges = range_of(listed.max(expected)) + usize::from(listed.max(expected) > 0);
        let mut depth: Vec<Depth> = (0..ranges)
            .map(|place| {
                let (from, to) = range(place);
                let lacking = usize::from(listed < to.min(expected));
                let right = right.min(to).saturating_sub(from - 1);
                Depth { from, to, right, lacking, intervals: Errors::default() }
            })
            .collect();
        for impact in 1..=listed.min(expected) {
            let (answer, truth) =
                (self.answer.at(Observable::Interval, impact), self.truth.at(Observable::Interval, impact));
            if let (Some(answer), Some(truth), Some(of)) = (answer, truth, depth.get_mut(range_of(impact))) {
                of.intervals.note((answer.value - truth.value) / truth.value);
            }
        }
        depth
    }
}

#[cfg(test)]
mod tests;
