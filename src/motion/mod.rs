//! A block on a moving ground, from rest to rest: scenes in physical units, whole responses, and which model a scene needs.

pub mod linearisation;
pub mod plan;
pub mod response;
pub mod scene;
pub mod walk;
