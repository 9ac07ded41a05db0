//! Event stepping in closed form: laws of every history, endings, references, batches.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Reference values are written with all the digits that are known.

mod batch;
mod common;
mod endings;
mod flights;
mod laws;
mod references;
mod sensitivities;
mod slenderness;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
