//! Faults: mistakes that simulators of rocking really make, each planted in one oracle of the panel to see that the gate turns red,
//! and how small the fault may get before it no longer does.
//!
//! - The [`catalogue`] lists the faults.
//! - A fault is planted ([`plant`]) by tampering with what an oracle is asked or what it answers; or, where it sits inside of a method, by
//!   putting a [`stepper`] (or, for the series, a [`recursion`]) that makes it in the place of the oracle, under its name and with its claims.
//! - A [`trial`] is the gate of `verify` on a fixed set of cases, with the answers of the honest oracles kept.
//! - [`explain`] turns them round: which of them would explain what an engine answers.
//! - The [`confusion`] matrix tells whether a mistake is named by what would explain it.
//! - The [`floor`] is the smallest size at which the gate is red.

pub mod catalogue;
pub mod confusion;
pub mod explain;
pub mod floor;
pub mod plant;
pub mod recursion;
pub mod remember;
pub mod stepper;
pub mod trial;

use plant::Plant;

/// A planted fault.
#[derive(Debug, Clone)]
pub struct Fault {
    /// A short name.
    pub name: &'static str,
    /// The mistake that a simulator with it makes, in words that go on after "as if".
    pub as_if: &'static str,
    /// The name of the oracle that it sits in.
    pub oracle: String,
    /// How large it is.
    pub size: Size,
    /// How it is planted.
    pub plant: Plant,
}

/// What the size of a fault means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Size {
    /// An amount, which can get as small as one likes.
    Amount {
        /// What it measures, and in what unit.
        meaning: &'static str,
        /// What it is when the fault is really made; 1 for a term that is left out.
        natural: f64,
    },
    /// The number of the impact at which it happens. Every one is tried that at least so many impacts follow.
    Depth(usize),
    /// The fault is there or it is not.
    Whole,
}
