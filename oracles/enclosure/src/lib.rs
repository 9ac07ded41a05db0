//! The judge: intervals that are proven to contain every impact time, interval and velocity and the chattering time, for the linear equation
//! (Eq. 4) and the nonlinear one (Eq. 2).
//!
//! Every operation is rounded outward (`directed`, `digits`, `interval`), every series carries a bound on what it leaves out (`functions`,
//! `piece`), the impact is proven to be the first root of its flight (`piece`, `flight`), and the ending is proven too: complete, because from
//! some impact on the map from one impact to the next contracts over all that is left (`rest`); incomplete, because half a period passes in the
//! air, or is bound to (`gap`); or undecided, and then it says so. On the linear equation time and speed are bounded together (`parallelogram`). Where doubles are
//! not enough, more digits are used (`ladder`).
// `!(x > 0.0)` is meant: it also holds where `x` is not a number.
#![allow(clippy::neg_cmp_op_on_partial_ord)]
#![cfg_attr(test, allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used))]

mod bounds;
mod bouts;
mod critical;
mod digits;
mod directed;
mod double;
mod enclosed_impact;
mod equation;
mod excitation;
mod flight;
mod functions;
mod gap;
mod ground;
mod interval;
mod judge;
mod known;
mod ladder;
mod oracle;
mod parallelogram;
mod piece;
mod pull;
mod responses;
mod rest;
mod scene;
mod sequence;
mod shaking;
#[cfg(test)]
mod tests;
mod twofold;

pub use bounds::Bounds;
pub use critical::{Critical, critical_amplitude, critical_amplitude_near};
pub use enclosed_impact::EnclosedImpact;
pub use judge::Enclosure;
pub use oracle::Enclosed;
pub use responses::{EnclosedBout, EnclosedEnd};
