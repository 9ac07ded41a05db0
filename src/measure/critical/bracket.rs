//! The critical amplitude to the last bit, by direct stepping.

use contract::{Case, Ending, Invalid, Oracle};

use super::{INTERPOLATION_ERROR, interpolated};
use crate::measure::asking::ask;

/// `a_cr - 1`, as two neighbouring doubles between which `oracle` sees complete chattering turn into incomplete; the one below and the
/// one above. `None` where the oracle declines or can't tell.
///
/// # Errors
/// When `omega` or `eta` is outside the allowed range.
pub fn bracket(oracle: &dyn Oracle, omega: f64, eta: f64) -> Result<Option<(f64, f64)>, Invalid> {
    /// So near to the critical amplitude that the next double is on its other side, thousands of impacts decide.
    const IMPACTS: usize = 20_000;
    /// No frequency in use has its critical amplitude this near to the threshold.
    const SMALLEST: f64 = 1e-12;
    let is_complete = |epsilon: f64| -> Result<Option<bool>, Invalid> {
        let case = Case::from_epsilon(epsilon, omega, eta)?.with_max_impacts(IMPACTS)?;
        Ok(match ask(oracle, &case).observed().map(|observed| observed.history.ending) {
            Some(Ending::AtRest) => Some(true),
            Some(Ending::Incomplete | Ending::Overturned) => Some(false),
            _ => None,
        })
    };
    let (mut low, mut high) = (0.0, 1.0);
    // Where the interpolant knows it nearly, from close around that.
    let near = interpolated(omega, eta).map(|near| (near - INTERPOLATION_ERROR, near + INTERPOLATION_ERROR)).ok();
    let around = near.map(|(below, above)| Ok((is_complete(below)?, is_complete(above)?))).transpose()?;
    if let (Some(near), Some((Some(true), Some(false)))) = (near, around) {
        (low, high) = near;
    } else if is_complete(high)? != Some(false) {
        return Ok(None);
    }
    // a_cr - 1 may be small: come down by decades to the first complete case, then bisect.
    while low == 0.0 {
        let lower = 0.1 * high;
        match is_complete(lower)? {
            Some(true) => low = lower,
            Some(false) if lower > SMALLEST => high = lower,
            _ => return Ok(None),
        }
    }
    loop {
        let middle = 0.5 * (low + high);
        if !(middle > low && middle < high) {
            return Ok(Some((low, high)));
        }
        match is_complete(middle)? {
            Some(true) => low = middle,
            Some(false) => high = middle,
            None => return Ok(None),
        }
    }
}
