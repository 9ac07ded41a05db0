//! The words that the harness and the oracles share. No physics, no formula: `no_std` keeps `sqrt` and `sin` out,
//! so no mistake can be shared by accident.
//!
//! - An **oracle** is one method that turns a case into an impact history.
//! - A **case** is one dimensionless problem: amplitude, frequency ratio, restitution, and slenderness where the model needs it.
//! - A **flight** is the smooth motion between two impacts; flight `n` starts at impact `n` and has the sign `i_n = ±1`.
//! - An **interval** is the duration of a flight, `Δτ_n = τ_{n+1} - τ_n`.
//! - A **history** is the list of impacts in order, and why it ended.
//! - The **closure** of a sequence is the sum of the infinitely many intervals that follow one impact, and a method that tells it without following them.
//! - A **decline** is an oracle's refusal of a case that it cannot do; it is counted, and it is not a failure.
//!
//! The harness uses these, and with one meaning each:
//!
//! - A **scene** is a block and a motion of the ground in physical units, and what is asked of it. Its **response** goes from rest to rest, in **bouts** of
//!   rocking.
//! - An **observable** is what is compared: an impact time, an interval, a velocity, an interval ratio, the chattering time.
//! - A **finding** is something that an examination found wrong with a case; a **shortfall** is what a run as a whole fails to prove.
//! - A **gate** is a run whose exit status matters; its outcome is the **verdict**.
//! - A **fault** is a mistake planted on purpose, to see that the gate notices. A **specimen** is a scheme that is known to fail, kept to be studied.
//!
//! # Scaling
//! All times are `τ = p t`, with `p = sqrt(3g/(4R))` the frequency parameter of the block; rotations are `φ = θ/α`; velocities are
//! `φ' = dφ/dτ`; the frequency ratio is `ω = ω_g/p` (Eq. 5). Rocking starts at `τ = 0` from rest with `i_0 = -1` and the phase
//! `sin ψ = 1/a` (Eq. 12): the ground acceleration has just reached what the block resists, and is growing.
#![no_std]

extern crate alloc;

mod case;
mod closure;
pub mod conformance;
mod flight;
mod ground;
mod history;
mod invalid;
mod oracle;

pub use case::{Case, Horizon, Normalisation, Slenderness};
pub use closure::Closure;
pub use flight::{Arrival, Departure, FlightSolver, Ground};
pub use ground::{Body, Motion, RICKER_ANTISYMMETRIC_PEAK, Record, Ricker, Sinusoid, Stretch};
pub use history::{Ending, Estimate, History, Impact, Limit, Loss, Sensitivity, SlendernessShift, Uncertainty};
pub use invalid::Invalid;
pub use oracle::{Decline, Model, Oracle};
