//! Differential verification of the *chattering* of a rocking rigid block: the infinitely many impacts in finite time by which a block that
//! rocks under weak ground shaking comes to rest.
//!
//! Independent methods (oracles) are asked the same cases and compared impact by impact. The way of a case through the harness:
//!
//! 1. [`generate`] makes it, or it is read from a [`case_file`].
//! 2. The [`panel`] of oracles is asked ([`answer`]).
//! 3. The [`observables`] are derived from each history in the same way; [`zeno`] closes the infinite sum.
//! 4. The [`laws`] are checked on each history, and each pair is [`compare`]d, with what the [`tolerance`] table allows ([`examine`]).
//! 5. [`verify`] does this for all cases and makes a [`report`]; [`shrink`] and [`replay`] make something small of what failed.
//!
//! Beside the gate: [`diagnose`] measures where the asymptotic series breaks, [`critical`] knows the critical amplitude, [`scene`] reads blocks and
//! ground motions in physical units, [`response`] follows them from rest to rest, [`paper`] regenerates the figures of the paper and judges its
//! claims, and [`chart`] draws what was written as CSV.

pub mod answer;
pub mod atlas;
pub mod case_file;
pub mod chart;
pub mod compare;
pub mod conditioning;
pub mod confirm;
pub mod critical;
pub mod diagnose;
pub mod examine;
pub mod faults;
pub mod generate;
pub mod hex_float;
pub mod judge;
pub mod ladder;
pub mod laws;
pub mod linearisation;
pub mod model_gap;
pub mod observables;
pub mod panel;
pub mod paper;
pub mod plan;
pub mod reference;
pub mod replay;
pub mod report;
pub mod response;
pub mod scene;
pub mod shrink;
pub mod specimens;
pub mod tolerance;
pub mod verify;
pub mod work_precision;
pub mod zeno;
