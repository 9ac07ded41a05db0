//! Why a batch is refused.

use core::fmt;

use contract::{Case, Decline, Invalid};

use super::MOST_IMPACTS;
use crate::within_reach;

/// Why a batch is refused.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// A slice has another length than it should have.
    Length {
        /// Which one.
        what: &'static str,
        /// Its length.
        length: usize,
        /// What that should be.
        expected: usize,
    },
    /// So many impacts are asked for: none, or more than [`MOST_IMPACTS`](super::MOST_IMPACTS).
    Impacts(usize),
    /// A case that is none.
    Invalid {
        /// Its place in the slices.
        case: usize,
        /// What is wrong with it.
        why: Invalid,
    },
    /// A case that the method can't do.
    Declined {
        /// Its place in the slices.
        case: usize,
        /// Why not.
        why: Decline,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { what, length, expected } => write!(f, "{what} has {length} numbers, not {expected}"),
            Self::Impacts(impacts) => {
                write!(f, "impacts = {impacts} is outside the allowed range: from 1 to {MOST_IMPACTS} for each case")
            }
            Self::Invalid { case, why } => write!(f, "case {case}: {why}"),
            Self::Declined { case, why } => write!(f, "case {case}: {why}"),
        }
    }
}

impl core::error::Error for Refusal {}

/// Refuses a slice of another length than expected.
pub(super) fn of_length(what: &'static str, length: usize, expected: usize) -> Result<(), Refusal> {
    if length == expected { Ok(()) } else { Err(Refusal::Length { what, length, expected }) }
}

/// Refuses what [`Batch::new`](super::Batch::new) says.
pub(super) fn check(epsilon: &[f64], omega: &[f64], eta: &[f64], impacts: usize) -> Result<(), Refusal> {
    of_length("omega", omega.len(), epsilon.len())?;
    of_length("eta", eta.len(), epsilon.len())?;
    if !(1..=MOST_IMPACTS).contains(&impacts) {
        return Err(Refusal::Impacts(impacts));
    }
    for (case, ((epsilon, omega), eta)) in epsilon.iter().zip(omega).zip(eta).enumerate() {
        let whole = Case::from_epsilon(*epsilon, *omega, *eta).map_err(|why| Refusal::Invalid { case, why })?;
        if *epsilon > 0.0 {
            within_reach(&whole).map_err(|why| Refusal::Declined { case, why })?;
        }
    }
    Ok(())
}
