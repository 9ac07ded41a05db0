//! Event stepping with the closed-form solution of the linear rocking equation (Eqs 4-13), with no loss of accuracy however
//! deep the sequence goes.
//!
//! A flight is followed in local time as the distance from the base, `u = i φ >= 0`, for which Eq. 4 reads
//! `u'' = u - 1 - i f`. `flow` is its exact solution, `forcing` the excitation, `flight` finds the first impact and
//! proves that it is the first, `march` does so where Newton's method can't, `sequence` strings flights together,
//! and `rest` knows when the rest of the sequence is certain. `flights` offers the flights one at a time, and from anywhere; `still` is those on a
//! ground that has come to rest. `sensitivity` follows the same impacts with `dual` numbers, which carry
//! their derivatives by the parameters, and `slenderness` with power series in
//! the slenderness, which carry what the linear model leaves out.
#![cfg_attr(test, allow(clippy::indexing_slicing))]

pub mod batch;
mod dual;
mod error;
mod flight;
mod flights;
mod flow;
mod forcing;
mod ground;
mod march;
mod rest;
mod sensitivity;
mod sequence;
mod slenderness;
mod still;
mod takeoff;
mod twofold;

use contract::{
    Body, Case, Decline, Ending, FlightSolver, History, Model, Motion, Oracle, Sensitivity, SlendernessShift,
};

use crate::{flights::Flights, forcing::Excitation, sensitivity::Derivatives, slenderness::Shifts};

/// The unit round-off.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// The oracle. It has no settings: it is as accurate as a double allows.
///
/// It claims for each number the rounding errors of all flights so far, independent of each other and carried through the derivatives of each
/// flight, so that the claim grows with the conditioning of the case (near the critical amplitude, above all).
#[derive(Debug, Clone, Copy, Default)]
pub struct ClosedForm;

impl Oracle for ClosedForm {
    fn name(&self) -> &str {
        "closed-form"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        if case.epsilon() <= 0.0 {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        within_reach(case)?;
        let excitation = Excitation::new(case.epsilon(), case.omega());
        Ok(sequence::follow(case, &excitation, None))
    }

    fn sensitivities(&self, case: &Case) -> Option<Vec<Sensitivity>> {
        if case.epsilon() <= 0.0 {
            return Some(Vec::new());
        }
        within_reach(case).ok()?;
        let excitation = Excitation::new(case.epsilon(), case.omega());
        let mut follower = Derivatives::new(&excitation, case.eta());
        sequence::follow(case, &excitation, Some(&mut follower));
        Some(follower.found)
    }

    fn slenderness_shifts(&self, case: &Case) -> Option<Vec<SlendernessShift>> {
        if case.epsilon() <= 0.0 {
            return Some(Vec::new());
        }
        within_reach(case).ok()?;
        let excitation = Excitation::new(case.epsilon(), case.omega());
        let mut follower = Shifts::new(case.omega());
        sequence::follow(case, &excitation, Some(&mut follower));
        Some(follower.found)
    }

    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        within_reach(case)?;
        Ok(Box::new(Flights::new(case)))
    }

    fn flights_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        Ok(Box::new(ground::Flights::new(motion, body.eta())?))
    }
}

fn within_reach(case: &Case) -> Result<(), Decline> {
    within("epsilon", case.epsilon(), 1e-60, 1e9, "1e-60 <= epsilon <= 1e9")?;
    within("omega", case.omega(), 1e-6, 1e6, "1e-6 <= omega <= 1e6")?;
    within("eta", case.eta(), 1e-6, 1.0, "1e-6 <= eta < 1")
}

fn within(field: &'static str, value: f64, least: f64, most: f64, allowed: &'static str) -> Result<(), Decline> {
    if (least..=most).contains(&value) { Ok(()) } else { Err(Decline::OutOfRange { field, value, allowed }) }
}
