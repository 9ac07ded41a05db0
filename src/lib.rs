//! Differential verification of the *chattering* of a rocking rigid block: the infinitely many impacts in finite time by which a block that
//! rocks under weak ground shaking comes to rest.
//!
//! Independent methods (oracles) are asked the same cases and compared impact by impact. The way of a case through the harness:
//!
//! 1. [`cases`]: it is generated, or read from a file.
//! 2. [`panel`]: the one table of the methods that are asked.
//! 3. [`measure`]: a history becomes numbers, in the same way for every method; the infinite sum is closed.
//! 4. [`gate`]: laws, comparisons, the judge, and the verdict on the run; what failed is made small and kept.
//!
//! Beside the gate: [`page`] makes one HTML file of a report, [`engines`] are simulators of somebody else under it, [`verify`] is the gate in one call for those in Rust,
//! [`faults`] plants mistakes to see that the gate notices, [`motion`] follows blocks and ground motions in physical units
//! from rest to rest, [`plan`] says which method is enough for one, and [`studies`] holds what is measured once and drawn: the
//! paper's figures, the atlas of failures, work against precision. [`sweep`] makes maps over any parameters.
//!
//! The [`guide`] says more, with what was measured.

pub mod cases;
pub mod engines;
pub mod faults;
pub mod gate;
pub mod guide;
pub mod measure;
pub mod motion;
pub mod page;
pub mod panel;
pub mod plan;
pub mod responders;
pub mod stored;
pub mod studies;
pub mod sweep;
pub mod verify;
