//! Changes that must not matter: a question is asked again in another form of which the answer follows from that to the first. No truth is needed for it: the two
//! answers are of one method, and how close they have to come follows from how far the problem moves when its numbers do.

mod added_nothing;
mod halved;
mod later;
mod mirrored;
mod next_period;
mod on_any_motion;
mod reordered;
mod rescaled;
mod split;
mod terms;

use serde::{Deserialize, Serialize};

use super::whole::{Bout, Impact, Whole};
use crate::cases::shaking::Question;

/// A change that must not matter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// Left and right exchanged.
    Mirrored,
    /// The motion begins later.
    Later,
    /// The phases of its sinusoids are a period further.
    NextPeriod,
    /// Its stretches, or the steps of a record, are divided.
    Split,
    /// Its sinusoids are added in another order.
    Reordered,
    /// Each sinusoid is the sum of its halves.
    Halved,
    /// Sinusoids of no amplitude are added.
    AddedNothing,
    /// The samples of a record are in another unit.
    Rescaled,
    /// A steady sinusoid is asked as any motion.
    OnAnyMotion,
}

/// The question in its other form, and what its answer is to that to the first.
#[derive(Debug, Clone, PartialEq)]
pub struct Changed {
    /// What is asked instead.
    pub question: Question,
    /// By how much later everything happens, `τ`.
    later: f64,
    /// Whether it happens to the other side.
    mirrored: bool,
}

impl Relation {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Mirrored,
        Self::Later,
        Self::NextPeriod,
        Self::Split,
        Self::Reordered,
        Self::Halved,
        Self::AddedNothing,
        Self::Rescaled,
        Self::OnAnyMotion,
    ];

    /// What is changed, in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mirrored => "mirrored",
            Self::Later => "begun later",
            Self::NextPeriod => "with phases a period further",
            Self::Split => "with its parts divided",
            Self::Reordered => "with its sinusoids in another order",
            Self::Halved => "with each sinusoid as two halves",
            Self::AddedNothing => "with sinusoids of no amplitude",
            Self::Rescaled => "with samples in another unit",
            Self::OnAnyMotion => "as any motion",
        }
    }

    /// The question in its other form; `None` where it has none.
    pub fn change(self, question: &Question) -> Option<Changed> {
        if let (Self::OnAnyMotion, Question::Sinusoid(shaking)) = (self, question) {
            return on_any_motion::change(shaking).map(|asked| Changed::same(Question::Motion(asked)));
        }
        let Question::Motion(asked) = question else { return None };
        let same = |asked| Changed::same(Question::Motion(asked));
        match self {
            Self::Mirrored => {
                let question = Question::Motion(mirrored::change(asked)?);
                Some(Changed { question, later: 0.0, mirrored: true })
            }
            Self::Later => {
                let question = Question::Motion(later::change(asked)?);
                Some(Changed { question, later: later::BY, mirrored: false })
            }
            Self::NextPeriod => next_period::change(asked).map(same),
            Self::Split => split::change(asked).map(same),
            Self::Reordered => reordered::change(asked).map(same),
            Self::Halved => halved::change(asked).map(same),
            Self::AddedNothing => added_nothing::change(asked).map(same),
            Self::Rescaled => rescaled::change(asked).map(same),
            Self::OnAnyMotion => None,
        }
    }

    /// Those that are tried of the response of this name in a run: each in a small share of those that it can be made of, so many that none is missed in a run of
    /// ordinary size.
    pub(super) fn of(name: &str) -> Vec<Self> {
        let Some(number) = name.rsplit('/').next().and_then(|number| number.parse::<usize>().ok()) else {
            return Vec::new();
        };
        let is_due = |(place, relation): &(usize, Self)| (number + place).is_multiple_of(relation.every());
        Self::ALL.into_iter().enumerate().filter(is_due).map(|(_, relation)| relation).collect()
    }

    /// In one of how many responses it is tried, where it can be.
    fn every(self) -> usize {
        match self {
            Self::Mirrored | Self::Split => 8,
            Self::OnAnyMotion => 16,
            Self::NextPeriod | Self::Halved | Self::AddedNothing => 4,
            Self::Later | Self::Reordered | Self::Rescaled => 3,
        }
    }
}

impl Changed {
    fn same(question: Question) -> Self {
        Self { question, later: 0.0, mirrored: false }
    }

    /// What the answer to it says of the first question, but for its table.
    pub fn back(&self, whole: Whole) -> Whole {
        let earlier = |time: f64| time - self.later;
        let impact = |impact: &Impact| Impact { time: earlier(impact.time), ..*impact };
        let bout = |bout: &Bout| Bout {
            begin: earlier(bout.begin),
            side: if self.mirrored { -bout.side } else { bout.side },
            impacts: bout.impacts.iter().map(impact).collect(),
            end: earlier(bout.end),
            ..bout.clone()
        };
        Whole {
            bouts: whole.bouts.iter().map(bout).collect(),
            rests: whole.rests.iter().map(|(from, to)| (earlier(*from), earlier(*to))).collect(),
            end: earlier(whole.end),
            told_until: whole.told_until.map(earlier),
            rows: Vec::new(),
        }
    }
}
