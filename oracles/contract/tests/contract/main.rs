//! The words that are shared.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Reference values are written with all the digits that are known.

mod cases;
mod conformance;
