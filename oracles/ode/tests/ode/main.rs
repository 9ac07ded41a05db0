//! The ODE oracle: how right it is, how honest, and how histories end.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(clippy::excessive_precision)] // Reference values are written with all the digits that are known.

mod accuracy;
mod behaviour;
mod common;
mod ground;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
