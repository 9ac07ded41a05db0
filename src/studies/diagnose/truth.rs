//! What the series is measured against.

use contract::{Case, Decline, Model};

use crate::{
    measure::{asking::ask, critical},
    panel,
};

/// `a_cr - 1`, by the interpolant of the certified range.
pub(crate) fn critical_epsilon(omega: f64, eta: f64) -> Result<f64, Decline> {
    critical::interpolated(omega, eta).map_err(|invalid| Decline::NotConvergent { why: invalid.to_string() })
}

/// The proven chattering time, to a double's digits; `None` where it is not proven to be complete.
pub(crate) fn proven(epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    let case = Case::from_epsilon(epsilon, omega, eta).ok()?;
    let enclosed = enclosure::Enclosure::new(Model::Linear).enclose(&case).ok()?;
    enclosed.chattering_time.map(|bounds| bounds.middle().0)
}

/// The chattering time by stepping with the closed form, in a tenth of the time.
pub(crate) fn stepped(epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    let impacts = 80 + (8.0 / (1.0 - eta)) as usize;
    let case = Case::from_epsilon(epsilon, omega, eta).ok()?.with_max_impacts(impacts).ok()?;
    let stepper = panel::stepper();
    Some(ask(stepper.as_ref(), &case).into_observed()?.chattering_time?.value)
}
