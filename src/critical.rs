//! The critical amplitude: below it the chattering is complete, above it incomplete (Section 5.1).

use contract::{Case, Ending, Invalid, Oracle};

use crate::answer::ask;

/// The fit of Eq. 76, good to a few parts in a thousand for `η > 0.75` and `ω` from 0.5 to 8.
pub fn eq76(omega: f64, eta: f64) -> f64 {
    let (w, n) = (omega, eta);
    1.079 - 0.1885 * n + 0.1405 * w + 0.6442 * n * n - 0.1903 * n * w - 0.02818 * w * w - 0.7372 * n.powi(3)
        + 0.06413 * n * n * w
        + 0.03236 * n * w * w
        + 0.00176 * w.powi(3)
        + 0.2146 * n.powi(4)
        - 0.0187 * n.powi(3) * w
        - 0.003045 * n * n * w * w
        - 0.00185 * n * w.powi(3)
}

/// The fit of Eq. 77, by the restitution alone.
pub fn eq77(eta: f64) -> f64 {
    -0.3941 * eta.powi(3) + 0.5763 * eta * eta - 0.45 * eta + 1.271
}

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
    if is_complete(high)? != Some(false) {
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
