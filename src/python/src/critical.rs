//! The critical amplitude.

use chattercheck::{measure::critical, panel};
use pyo3::prelude::*;

use crate::{
    error::value_error,
    wait::{Stop, interruptible},
};

/// Digits enough to tell the two amplitudes apart.
const DIGITS: u32 = 18;

/// `a_cr`, the exponent, what Eqs 76 and 77 give, and the proven bounds as decimals.
type Critical = (f64, f64, f64, f64, String, String);

/// The critical amplitude of the linear model, proven.
#[pyfunction]
pub fn critical_amplitude(py: Python<'_>, omega: f64, eta: f64) -> PyResult<Critical> {
    let found = interruptible(py, &Stop::default(), move || panel::critical_amplitude(omega, eta, DIGITS))?;
    let found = found.map_err(value_error)?;
    Ok((
        found.a_cr,
        found.exponent,
        critical::eq76(omega, eta),
        critical::eq77(eta),
        found.complete_at,
        found.incomplete_at,
    ))
}
