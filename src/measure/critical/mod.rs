//! The critical amplitude: below it the chattering is complete, above it incomplete (Section 5.1).
//!
//! Three ways to it: searched for with an oracle ([`bracket`]), interpolated to nearly as many digits ([`interpolated`]), and fits short
//! enough to print, those of the paper and better ones of the same length.

mod bracket;
mod fits;
mod interpolant;

pub use bracket::bracket;
pub use fits::{eq76, eq77, fit, short_fit};
pub use interpolant::{INTERPOLATION_ERROR, Term, interpolated, terms};
