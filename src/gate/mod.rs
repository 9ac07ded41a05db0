//! Where a verdict comes out: laws, comparisons, the judge, and what is made of a run.

pub mod compare;
pub mod endings;
pub mod examine;
pub mod judge;
pub mod ladder;
pub mod laws;
pub mod replay;
pub mod report;
pub mod run;
pub mod shrink;
pub mod tolerance;
