//! The judge: references inside, more digits inside fewer, first roots, critical amplitudes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Reference values are written with all the digits that are known.

mod critical;
mod first_root;
mod hard;
mod motions;
mod nested;
mod references;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
