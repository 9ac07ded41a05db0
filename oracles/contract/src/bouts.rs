use alloc::vec::Vec;

use crate::{Estimate, Impact};

/// What is asked of a method that follows whole responses by itself: from where, and how far. All times are `τ`, from the start of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Followed {
    /// The rotation and the velocity at `τ = 0`, `φ` and `φ'`; from rest if both are 0.
    pub start: (f64, f64),
    /// When the response ends at the latest; may be infinite where the motion ends.
    pub until: f64,
    /// How many impacts of a bout are listed at the most. The ends of the bouts are found whatever their number.
    pub most_impacts: usize,
}

/// Rocking from rest to rest, as a method finds it that follows whole responses by itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Bout {
    /// When it begins.
    pub begin: Estimate,
    /// The sign of the first rotation, 1 or -1.
    pub side: f64,
    /// The impacts in order.
    pub impacts: Vec<Impact>,
    /// How it ends.
    pub end: BoutEnd,
}

/// How a bout ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BoutEnd {
    /// With rest, where infinitely many impacts accumulate.
    Rest(Estimate),
    /// With overturning: it is certain not to come back.
    Overturned,
    /// With the end of the response, while the block rocks.
    Aloft,
    /// Not known: the method went no further.
    Undecided,
}
