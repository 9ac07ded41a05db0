//! The order of the paper: Eqs 31, 57, 60, 62, 64 and 65.

mod answer;
mod claim;
mod coefficients;
pub(crate) mod even_flight;
mod flights;

pub(crate) use answer::answer;
pub use coefficients::{Coefficients, coefficients};
