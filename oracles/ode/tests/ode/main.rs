//! The ODE oracle: how right it is, how honest, and how histories end.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod accuracy;
mod behaviour;
mod common;

#[path = "../../../../tests/effort/mod.rs"]
mod effort;
