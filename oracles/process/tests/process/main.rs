//! The talk with engines of every kind: one that behaves, and those that break in every way that is known.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![allow(missing_docs)]

mod batches;
mod breaks;
mod common;
mod handshake;
mod histories;
mod leaving;
mod messages;
mod record;
mod schema;
mod version;
