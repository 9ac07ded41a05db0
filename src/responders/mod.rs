//! The methods that follow whole responses, as the gate asks them.

mod proven;
mod stepped;

pub use proven::{Proven, judges};
pub use stepped::{Stepped, all};
