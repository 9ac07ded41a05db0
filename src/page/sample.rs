//! Which cases a page shows, where there are too many to show all: the first that are wrong or broke an engine, up to [`MOST_WRONG`]; of the others, evenly
//! spaced over the run, up to [`MOST_OTHERS`] of each fate.

use std::collections::BTreeMap;

use crate::gate::report::{Fate, Listed};

/// How many cases in which something is wrong are shown, and how many that broke an engine.
const MOST_WRONG: usize = 2000;
/// How many of each other fate.
const MOST_OTHERS: usize = 1000;

/// The cases that are shown.
pub(super) struct Sample<'a> {
    /// The worst first, each kind in the order of the run.
    pub shown: Vec<Shown<'a>>,
    /// Of each fate: how many are shown, and of how many.
    pub counts: BTreeMap<Fates, (usize, usize)>,
}

/// A case that is shown.
pub(super) struct Shown<'a> {
    pub case: Listed<'a>,
    pub fate: Fate,
    /// Its place among all cases, which names it in links.
    pub place: usize,
}

/// Fates without their reasons, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fates {
    Wrong,
    Broke,
    LeftOut,
    Known,
    Declined,
    Passed,
}

impl From<&Fate> for Fates {
    fn from(fate: &Fate) -> Self {
        match fate {
            Fate::Wrong => Self::Wrong,
            Fate::Broke(_) => Self::Broke,
            Fate::LeftOut => Self::LeftOut,
            Fate::Known(_) => Self::Known,
            Fate::Declined(_) => Self::Declined,
            Fate::Passed => Self::Passed,
        }
    }
}

impl Fates {
    /// The word for it.
    pub fn says(self) -> &'static str {
        match self {
            Self::Wrong => "wrong",
            Self::Broke => "broke an engine",
            Self::LeftOut => "left out",
            Self::Known => "known failure",
            Self::Declined => "declined",
            Self::Passed => "passed",
        }
    }

    /// What is said of those of it, after "that".
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Wrong => "are wrong",
            Self::Broke => "broke an engine",
            Self::LeftOut => "were left out",
            Self::Known => "fail as is known",
            Self::Declined => "were declined",
            Self::Passed => "passed",
        }
    }

    /// The class of what has this fate.
    pub fn class(self) -> &'static str {
        match self {
            Self::Wrong => "wrong",
            Self::Broke => "broke",
            Self::LeftOut => "left-out",
            Self::Known => "known",
            Self::Declined => "declined",
            Self::Passed => "passed",
        }
    }

    fn most(self) -> usize {
        if matches!(self, Self::Wrong | Self::Broke) { MOST_WRONG } else { MOST_OTHERS }
    }
}

impl<'a> Sample<'a> {
    /// The cases that `cases` gives, twice the same.
    pub fn of<Cases: Iterator<Item = Listed<'a>>>(cases: impl Fn() -> Cases) -> Self {
        let mut counts: BTreeMap<Fates, (usize, usize)> = BTreeMap::new();
        for case in cases() {
            counts.entry(Fates::from(&case.fate())).or_default().1 += 1;
        }
        let mut met: BTreeMap<Fates, usize> = BTreeMap::new();
        let mut shown = Vec::new();
        for (place, case) in cases().enumerate() {
            let fate = case.fate();
            let kind = Fates::from(&fate);
            let Some((taken, all)) = counts.get_mut(&kind) else { continue };
            let met = met.entry(kind).or_default();
            let is_shown = match kind {
                // Of what is wrong the first, of which a run keeps the impacts.
                Fates::Wrong | Fates::Broke => *met < kind.most(),
                _ => is_taken(*met, *all, kind.most()),
            };
            if is_shown {
                *taken += 1;
                shown.push(Shown { case, fate, place });
            }
            *met += 1;
        }
        shown.sort_by_key(|shown: &Shown| Fates::from(&shown.fate));
        Self { shown, counts }
    }

    /// Whether every case is shown.
    pub fn is_whole(&self) -> bool {
        self.counts.values().all(|(shown, all)| shown == all)
    }

    /// Where in the page the case of this name is, if it is shown.
    pub fn place_of(&self, name: &str) -> Option<usize> {
        Some(self.shown.iter().find(|shown| shown.case.name == name)?.place)
    }
}

/// Whether the one at `place` is among the `most` that are taken of `all`, evenly spaced: the first of each of so many shares.
fn is_taken(place: usize, all: usize, most: usize) -> bool {
    let share = |place: usize| place * most / all;
    all <= most || place == 0 || share(place) != share(place - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_as_there_is_room_for_are_taken_evenly() {
        for (all, most) in [(10, 1000), (1000, 1000), (1001, 1000), (1999, 1000), (1_000_000, 1000), (7, 3)] {
            let taken: Vec<usize> = (0..all).filter(|place| is_taken(*place, all, most)).collect();
            assert_eq!(taken.len(), all.min(most), "{most} of {all}");
            let gaps = taken.windows(2).map(|pair| pair[1] - pair[0]);
            let (least, largest) = (gaps.clone().min().unwrap(), gaps.max().unwrap());
            assert!(largest - least <= 1, "{most} of {all}: {least} to {largest}");
        }
    }
}
