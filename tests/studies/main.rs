//! What is measured, recorded and drawn: the paper, the series, the critical amplitude, the charts.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod atlas;
mod chart;
mod critical;
mod diagnose;
mod paper;
mod paper_claims;
mod plan_map;
mod reference;
mod remaining_time;

#[path = "../effort/mod.rs"]
mod effort;
