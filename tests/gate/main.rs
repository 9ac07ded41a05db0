//! The gate: what agrees, what has to turn it red, and what it is allowed.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod agreement;
mod audit;
mod audit_command;
mod calibration;
mod conditioning;
mod detection_floor;
mod explained;
mod faults;
mod foretold;
mod judge;
mod junit;
mod linearisation;
mod mistaken;
mod mixed;
mod motions;
mod page;
mod planted_responses;
mod reach;
mod relations;
mod reports;
mod responses;
mod shrink;
mod summary;
mod time_left;

#[path = "../effort/mod.rs"]
mod effort;
