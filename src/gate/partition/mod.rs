//! A run in parts: its cases are dealt to them, each part leaves a file, and the files together are the run.
//!
//! A part is a function of what was asked and of which part it is, and of nothing else. What is counted in it is such that the counts of the parts, added
//! in any order, are those of the run in one piece; what is concluded is concluded anew, from the sums.

mod deal;
mod join;
mod of_part;
mod part;
mod request;

use std::fmt;

use contract::Invalid;

pub use deal::{cost_of_case, cost_of_response, deal};
pub use join::{Whole, join};
pub use part::{KIND, Names, Part};
pub use request::{EngineAsked, Request};

/// Which of how many parts: the `K`-th of `N`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Partition {
    /// Which, from 1 on.
    pub part: usize,
    /// Of how many.
    pub parts: usize,
}

impl Partition {
    /// All of it.
    pub const WHOLE: Self = Self { part: 1, parts: 1 };

    /// Reads `K/N` with `1 <= K <= N`.
    ///
    /// # Errors
    /// When it is something else.
    pub fn parse(text: &str) -> Result<Self, Invalid> {
        text.split_once('/')
            .and_then(|(part, parts)| Some(Self { part: part.parse().ok()?, parts: parts.parse().ok()? }))
            .filter(|&Self { part, parts }| 1 <= part && part <= parts)
            .ok_or_else(|| Invalid::new("partition", text, "K/N with 1 <= K <= N"))
    }

    /// What tells the files of this part from those of another; nothing for all of it.
    pub fn suffix(self) -> String {
        if self.parts > 1 { format!("-part-{}-of-{}", self.part, self.parts) } else { String::new() }
    }

    /// The name of its file.
    pub fn file_name(self) -> String {
        format!("part-{}-of-{}.jsonl", self.part, self.parts)
    }

    /// Of this work, with the cost of each, what falls to this part; in the same order.
    pub fn of<T>(self, work: impl IntoIterator<Item = T>, costs: &[f64]) -> Vec<T> {
        let dealt = deal(costs, self.parts);
        work.into_iter().zip(dealt).filter(|(_, part)| *part == self.part).map(|(work, _)| work).collect()
    }
}

impl fmt::Display for Partition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.parts)
    }
}
