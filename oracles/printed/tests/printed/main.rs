//! The printed solution.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod printed;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
