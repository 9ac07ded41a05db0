//! The full nonlinear rocking equation (Eq. 2) by event stepping, each flight expanded in a Taylor series in its own local time.
//!
//! Written to be independent of every other solver of Eq. 2: its own form of the equation, its own recurrences and root search.
//! See [`equation`] for the form that does not cancel, [`series`] for the recurrences, [`flight`] for the way from one impact
//! to the next, and [`sequence`] for the history and what is claimed of it.
#![cfg_attr(test, allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used))]

pub mod equation;
pub mod flight;
mod flights;
mod ground;
pub mod sequence;
pub mod series;
mod still;
#[cfg(test)]
mod tests;

use contract::{Body, Case, Decline, Ending, FlightSolver, History, Model, Motion, Oracle};
use equation::{Block, excess};
use flights::Flights;

/// The solver of Eq. 2 by Taylor series.
#[derive(Debug, Clone, Copy, Default)]
pub struct Taylor;

impl Oracle for Taylor {
    fn name(&self) -> &str {
        "taylor"
    }

    fn model(&self) -> Model {
        Model::Nonlinear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let slenderness = case.slenderness().ok_or(Decline::NeedsSlenderness)?;
        let (epsilon, rounding) = excess(case.epsilon(), slenderness);
        if epsilon <= 0.0 {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        within_reach(case, epsilon)?;
        let alpha = slenderness.alpha();
        let block = Block::new(epsilon, case.omega(), case.eta(), alpha);
        let shifted = Block::new(epsilon * (1.0 + 1e-14 + 8.0 * rounding), case.omega(), case.eta(), alpha);
        let damped = Block::new(epsilon, case.omega() * (1.0 + 1e-15), case.eta() * (1.0 - 1e-15), alpha);
        Ok(sequence::history(&block, &[shifted, damped], case.horizon(), case.max_impacts()))
    }

    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        let slenderness = case.slenderness().ok_or(Decline::NeedsSlenderness)?;
        let (epsilon, _) = excess(case.epsilon(), slenderness);
        within_reach(case, epsilon)?;
        Ok(Box::new(Flights(Block::new(epsilon, case.omega(), case.eta(), slenderness.alpha()))))
    }

    /// Of the linear equation for a block without a slenderness.
    fn flights_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        Ok(Box::new(ground::Flights::new(body, motion)?))
    }
}

/// Refuses what the method cannot do; `epsilon` is that of the threshold of Eq. 1.
fn within_reach(case: &Case, epsilon: f64) -> Result<(), Decline> {
    inside("epsilon", epsilon, epsilon >= 1e-60, "epsilon (effective) <= 0 or >= 1e-60")?;
    inside("omega", case.omega(), (1e-3..=1e3).contains(&case.omega()), "1e-3 <= omega <= 1e3")?;
    inside("eta", case.eta(), case.eta() >= 1e-6, "eta >= 1e-6")
}

/// The refusal of a `value` that the method cannot do.
fn inside(field: &'static str, value: f64, holds: bool, allowed: &'static str) -> Result<(), Decline> {
    if holds { Ok(()) } else { Err(Decline::OutOfRange { field, value, allowed }) }
}
