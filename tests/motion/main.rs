//! Blocks on a moving ground: flights, whole responses, scenes, and the model that a scene needs.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod closing;
mod drawn;
mod falling;
mod flights;
mod free_rocking;
mod ground;
mod one_answer;
mod overturning;
mod plan;
mod plan_on_motion;
mod proven;
mod refused;
mod response;
mod rounding;
mod rows;
mod scenes;
mod slender_threshold;
mod thrift;
mod touching;
mod weak;

#[path = "../effort/mod.rs"]
mod effort;
