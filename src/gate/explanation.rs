//! What mistake would explain the wrong answers of an engine, as a report says it. Who looks for it is passed in.

use std::fmt;

use serde::{Deserialize, Serialize};

/// What would explain the wrong answers of an engine.
#[derive(Debug, Clone, PartialEq)]
pub struct Explained {
    /// The mistakes that explain most, the best first, and all that do so equally well; empty if none of the catalogue does.
    pub explanations: Vec<Explanation>,
    /// What can be read off its numbers, in words.
    pub signs: Vec<String>,
}

/// A mistake that explains what is wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Explanation {
    /// The name of the mistake in the catalogue of planted faults.
    pub fault: String,
    /// The mistake, in words that go on after "as if".
    pub as_if: String,
    /// How large it is, of one that may be of any size.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub size: Option<FaultSize>,
    /// How many of the wrong answers that were looked at it explains.
    pub explained: usize,
    /// How many were looked at.
    pub of: usize,
    /// What it leaves unexplained in those: the middle one of the largest relative deviations.
    pub left: f64,
    /// How many of the right answers that were looked at it would spoil.
    #[serde(default)]
    pub spoiled: usize,
}

/// How large a mistake is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FaultSize {
    /// What is measured.
    pub meaning: String,
    /// The size that fits best.
    pub value: f64,
    /// The size that the mistake has where it is really made; `None` where any is as likely.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub natural: Option<f64>,
}

impl Explanation {
    /// Whether it explains so much that it can be named without doubt, if nothing else does as well.
    pub fn is_sure(&self) -> bool {
        10 * self.explained >= 9 * self.of && self.spoiled == 0
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { fault, as_if, explained, of, left, .. } = self;
        write!(f, "as if {as_if}: explains {explained} of {of} failing cases; what is left is {left:.0e} ({fault}")?;
        match &self.size {
            Some(FaultSize { meaning, value, natural: None }) => write!(f, ", {meaning} {value}")?,
            // What it is where the mistake is really made goes without saying.
            Some(FaultSize { meaning, value, natural: Some(natural) }) if (value / natural - 1.0).abs() > 1e-9 => {
                if (1e-3..1e4).contains(&value.abs()) {
                    write!(f, ", {meaning}: {value:.6}")?;
                } else {
                    write!(f, ", {meaning}: {value:.6e}")?;
                }
            }
            _ => {}
        }
        f.write_str(")")?;
        if explained < of {
            write!(f, "; {} it does not explain", of - explained)?;
        }
        if self.spoiled > 0 { write!(f, "; but it would spoil {} that are right", self.spoiled) } else { Ok(()) }
    }
}
