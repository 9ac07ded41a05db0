//! Where a verdict comes out: laws, comparisons, the judge, and what is made of a run.

pub mod calibration;
pub mod compare;
mod counting;
pub mod endings;
pub mod examine;
pub mod expected;
pub mod failure;
pub mod finding;
pub mod identity;
pub mod judge;
pub mod known;
pub mod ladder;
pub mod laws;
pub mod listed;
pub mod pair;
pub mod progress;
pub mod replay;
pub mod report;
pub mod responses;
pub mod roles;
pub mod run;
pub mod shortfall;
pub mod shrink;
pub mod tally;
pub mod tolerance;
pub mod verdict;
