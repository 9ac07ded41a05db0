//! The paper's exact solution as it is printed: Eqs 6-13 in absolute time, `φ_n = B_n e^τ + A_n e^-τ + i_n + Ξ(τ)`, with so many digits that
//! their cancellation does not matter. Slow, and simple enough to be believed.
//!
//! - Late flights have rotations of the order of the square of their velocity `v`, made up from terms of order 1. The length of the numbers is
//!   chosen from the depth asked for, so that what is left has the wanted digits. No other form of the solution is used, not even to start
//!   the search for an impact.
//! - A flight is sampled from its start, with steps that grow by 15 %, to the first change of sign: no root before it is passed over unless
//!   it is a graze within that part of the flight.
//! - Parameters are the doubles they are: `a = 1 + ε` of the exact `ε`.
//! - [`Printed::decimals`] and [`Printed::chattering_time_decimal`] give many digits, and only those that a second, longer computation
//!   confirms.
#![forbid(unsafe_code)]

mod arithmetic;
mod flights;
mod follow;
mod motion;
mod oracle;
mod precision;
mod rest;
mod zeno;

pub use oracle::{DecimalImpact, Printed};
