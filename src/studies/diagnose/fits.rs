use contract::Decline;
use serde::Serialize;

use super::{map, truth::critical_epsilon};
use crate::measure::critical;

/// How far a fit is from the critical amplitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FitRow {
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// `a_cr`, by the interpolant, which is good to 1e-14.
    pub a_cr: f64,
    /// `Eq. 76`, `Eq. 77`, or ours with as many coefficients.
    pub fit: &'static str,
    /// What it gives.
    pub value: f64,
    /// How far that is from `a_cr`.
    pub error: f64,
}

pub(super) fn measure(grid: usize) -> Result<Vec<FitRow>, Decline> {
    let mut rows = Vec::new();
    for (omega, eta) in map(grid) {
        let a_cr = 1.0 + critical_epsilon(omega, eta)?;
        let fits = [
            ("Eq. 76", critical::eq76(omega, eta)),
            ("ours, 14 coefficients", critical::fit(omega, eta)),
            ("Eq. 77", critical::eq77(eta)),
            ("ours, 4 coefficients", critical::short_fit(omega, eta)),
        ];
        rows.extend(fits.map(|(fit, value)| FitRow { omega, eta, a_cr, fit, value, error: (value - a_cr).abs() }));
    }
    Ok(rows)
}
