//! The gate on whole responses: rest, rocking, chattering into rest, rocking again, free rocking after the shaking, overturning.
//!
//! Each method's response is held against two things that share nothing with it: the laws that can be read off a response and the ground alone (`laws`), and a
//! plain follower with an integrator and a loop of events of its own (`follower`). How close it has to come follows from how far the problem itself moves
//! when its numbers are moved a little; from where that says nothing any more, nothing is compared, and the response counts as too close to call.
//! A share of the questions is asked again in another form that must not matter (`relations`), and the two answers of a method are held against each other.
//!
//! The gate knows methods as [`Responder`]s only; they are handed in.

mod compare;
mod described;
mod difference;
mod examine;
mod failure;
mod follower;
mod ground;
mod knot;
mod landing;
mod laws;
mod problem;
mod reach;
mod reference;
mod relations;
mod report;
mod rows;
mod run;
mod scene;
mod shortfall;
mod shrink;
mod stepping;
mod tally;
mod whole;

pub use difference::{Difference, What};
pub use examine::{Examination, Finding, Wrong, examine, examine_with};
pub use failure::Failure;
pub use laws::Law;
pub use reach::Example;
pub use relations::{Changed, Relation};
pub use report::{Failed, Report, exercised, failures_text, methods_text};
pub use run::{Selection, questions, run, timed};
pub use scene::{samples_path, samples_text, scene_text};
pub use shortfall::Shortfall;
pub use shrink::shrink;
pub use tally::{MethodCounts, Tally};
pub use whole::{Bout, BoutEnding, Impact, Responder, Row, State, Whole};
