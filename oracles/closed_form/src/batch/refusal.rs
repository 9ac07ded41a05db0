//! Why a batch is refused.

use core::fmt;

use contract::{Case, Decline, Invalid};

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
    /// No impacts are asked for.
    NoImpacts,
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
            Self::NoImpacts => f.write_str("no impacts are asked for"),
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
    if impacts == 0 {
        return Err(Refusal::NoImpacts);
    }
    for (case, ((epsilon, omega), eta)) in epsilon.iter().zip(omega).zip(eta).enumerate() {
        let whole = Case::from_epsilon(*epsilon, *omega, *eta).map_err(|why| Refusal::Invalid { case, why })?;
        if *epsilon > 0.0 {
            within_reach(&whole).map_err(|why| Refusal::Declined { case, why })?;
        }
    }
    Ok(())
}
