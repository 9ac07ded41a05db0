//! What people and other programs meet: the command line, the README, and the rules that the tree keeps.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.

mod ci;
mod command_line;
mod engines;
mod guide;
mod hostile;
mod independence;
mod judged_lists;
mod options;
mod own_cases;
mod pages;
mod parts;
mod paths;
mod readme;
mod record;
mod reports;
mod rooms;
mod surroundings;
mod sweeps;

#[path = "../effort/mod.rs"]
mod effort;
