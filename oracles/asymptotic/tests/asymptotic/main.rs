//! The asymptotic series: coefficients, claims, and what stepping finds.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Reference values are written with all the digits that are known.

mod claim;
mod coefficients;
mod exact;
mod orders;
mod resummed;
mod series;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
