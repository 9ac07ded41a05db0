//! Blocks on a moving ground: flights, whole responses, scenes, and the model that a scene needs.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod flights;
mod plan;
mod response;
mod scenes;
mod thrift;

#[path = "../effort/mod.rs"]
mod effort;
