//! The asymptotic series: coefficients, claims, and what stepping finds.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod claim;
mod coefficients;
mod exact;
mod orders;
mod resummed;
mod series;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
