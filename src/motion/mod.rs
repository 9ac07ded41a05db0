//! A block on a moving ground, from rest to rest: scenes in physical units, whole responses.

pub mod certainty;
pub mod closed;
pub mod criterion;
pub mod linearisation;
pub mod record;
pub mod response;
pub mod scene;
pub mod walk;
