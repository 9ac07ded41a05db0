//! The methods that follow whole responses, as the gate asks them.

mod stepped;
mod told;

pub use stepped::{Stepped, all};
pub use told::{Told, told};
