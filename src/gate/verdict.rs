//! The outcome of the gate, and what decides it.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Whether a run is green.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// No case failed and nothing is wrong with the run as a whole.
    Pass,
    /// Nothing was wrong as far as the run came, but it was interrupted.
    Undecided,
    /// Something is wrong.
    Fail,
}

impl Verdict {
    /// Of a run in which so many cases failed, and in which these things are wrong as a whole.
    pub fn of(failures: usize, shortfalls: impl IntoIterator<Item = Self>) -> Self {
        let worst = shortfalls.into_iter().max().unwrap_or(Self::Pass);
        if failures > 0 { Self::Fail } else { worst }
    }

    /// What a shortfall means for the run: one that was interrupted may have been green.
    pub fn of_shortfall(is_interruption: bool) -> Self {
        if is_interruption { Self::Undecided } else { Self::Fail }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Pass => "PASS",
            Self::Undecided => "UNDECIDED",
            Self::Fail => "FAIL",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Verdict::{self, Fail, Pass, Undecided};

    /// A failure weighs more than an interruption, and that more than nothing.
    #[test]
    fn the_worst_decides() {
        assert_eq!(Verdict::of(0, []), Pass);
        assert_eq!(Verdict::of(0, [Undecided]), Undecided);
        assert_eq!(Verdict::of(1, []), Fail);
        assert_eq!(Verdict::of(1, [Undecided]), Fail);
        assert_eq!(Verdict::of(0, [Undecided, Fail, Undecided]), Fail);
    }
}
