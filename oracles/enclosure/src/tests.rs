//! Evidence that the enclosures are rigorous: each operation against exact arithmetic, and controls that show that the tests can tell.

mod bounds;
mod corners;
mod exact;
mod formats;
mod intervals;
mod motion;
mod nearest;
mod rest;
mod series;

#[path = "../../../tests/effort/mod.rs"]
mod effort;
