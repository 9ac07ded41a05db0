//! Engines: simulators of somebody else, under the gate beside the panel.
//!
//! A [`Manifest`] says how each is started and what is allowed it; [`Fleet::start`] starts them, each as an oracle; [`checkup`] tells its author what is
//! missing before anything is compared; [`starter`] writes one to begin with. How they are talked to is the crate `process`.

pub mod checkup;
mod error;
mod fleet;
mod granted;
mod manifest;
mod program;
pub mod record;
pub mod serve;
mod spans;
pub mod starter;
mod table;

pub use error::ManifestError;
pub use fleet::{Fleet, Started, Took};
pub use granted::Granted;
pub use manifest::{Entry, Manifest};
