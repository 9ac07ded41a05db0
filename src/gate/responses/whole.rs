//! A whole response as the gate sees it, whoever made it, and who may be asked for one.

use contract::Model;
use serde::{Deserialize, Serialize};

use crate::cases::shaking::Question;

/// A method that follows whole responses.
pub trait Responder: Sync {
    /// Its name in reports.
    fn name(&self) -> &str;

    /// The equation of motion that it solves.
    fn model(&self) -> Model;

    /// What its flights are worth: as wrong as one whose parameters are off by this much, relative.
    fn accuracy(&self) -> f64;

    /// Whether it lists impacts. What foretells when a block comes to rest does not, and declines what it does not foresee: then the rests are what is compared.
    fn lists_impacts(&self) -> bool {
        true
    }

    /// Whether this is a question for it; otherwise it is not asked, and declines nothing.
    fn is_asked(&self, _question: &Question) -> bool {
        true
    }

    /// The response, with its rows at about `rows` times where the method gives any; `None` where it declines.
    fn respond(&self, question: &Question, rows: usize) -> Option<Whole>;
}

/// What happens to a block from `τ = 0` on, or the beginning of it. All times are `τ`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Whole {
    /// When it rocks.
    pub bouts: Vec<Bout>,
    /// When it rests, each from and to.
    pub rests: Vec<(f64, f64)>,
    /// When the response ends, as far as it is told.
    pub end: f64,
    /// Until when it is told what happens, where that is not to the end.
    pub told_until: Option<f64>,
    /// The response as a table, in the order in which it is printed; may be empty.
    pub rows: Vec<Row>,
}

/// Rocking from rest until it rests, overturns, or the response ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Bout {
    /// When it begins.
    pub begin: f64,
    /// The sign of the first rotation.
    pub side: f64,
    /// The impacts that are resolved, in order.
    pub impacts: Vec<Impact>,
    /// How it ends.
    pub outcome: BoutEnding,
    /// When it ends, `τ`.
    pub end: f64,
    /// What is claimed to be wrong with `end` at the most, where the block comes to rest.
    pub uncertainty: f64,
    /// The largest rotation, without its sign, up to the last impact that is resolved; `None` where the method was not asked for it.
    pub peak: Option<f64>,
}

/// One impact of a bout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// When it happens, `τ`.
    pub time: f64,
    /// The speed just before it.
    pub before: f64,
    /// The speed just after it, where a flight that follows was resolved.
    pub after: Option<f64>,
}

/// How a bout ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BoutEnding {
    /// With rest.
    Rest,
    /// With overturning.
    Overturned,
    /// With the end of the response, while the block rocks.
    Cut,
    /// It was given up.
    GivenUp,
}

impl BoutEnding {
    /// In the words of the report.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rest => "comes to rest",
            Self::Overturned => "overturns",
            Self::Cut => "rocks to the end of the response",
            Self::GivenUp => "is given up",
        }
    }
}

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// The time of the row, `τ`.
    pub time: f64,
    /// The rotation `φ`.
    pub rotation: f64,
    /// Its velocity.
    pub velocity: f64,
    /// The ground acceleration, in multiples of the threshold.
    pub ground: f64,
    /// What the block does.
    pub state: State,
}

/// What a block does at one time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// It stands still on its base.
    Rest,
    /// It rocks.
    Rocking,
    /// It can't return any more.
    Overturned,
    /// It lies on its side.
    Lying,
}
