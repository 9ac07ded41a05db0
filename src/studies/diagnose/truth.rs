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

/// Digits enough for what is printed with a few: the enclosure then computes with doubles, in a tenth of the time.
pub(crate) const FEW_DIGITS: u32 = 6;

/// The proven chattering time, to a double's digits; `None` where it is not proven to be complete.
pub(crate) fn proven(epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    enclosed(enclosure::Enclosure::new(Model::Linear), epsilon, omega, eta)
}

/// The same, to so many digits.
pub(crate) fn proven_to(digits: u32, epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    enclosed(enclosure::Enclosure::new(Model::Linear).with_digits(digits).ok()?, epsilon, omega, eta)
}

fn enclosed(enclosure: enclosure::Enclosure, epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    let case = Case::from_epsilon(epsilon, omega, eta).ok()?;
    enclosure.enclose(&case).ok()?.chattering_time.map(|bounds| bounds.middle().0)
}

/// The chattering time by stepping with the closed form, in a tenth of the time.
pub(crate) fn stepped(epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    let impacts = 80 + (8.0 / (1.0 - eta)) as usize;
    let case = Case::from_epsilon(epsilon, omega, eta).ok()?.with_max_impacts(impacts).ok()?;
    let stepper = panel::stepper();
    Some(ask(stepper.as_ref(), &case).into_observed()?.chattering_time?.value)
}
