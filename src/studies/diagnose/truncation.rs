use contract::Decline;
use rayon::prelude::*;
use serde::Serialize;

use super::{
    PAPER, spread,
    truth::{critical_epsilon, proven},
};
use asymptotic::{Coefficients, Expansion, coefficients};

/// Eq. 65 keeps the `ε^(3/2)` of one half of the flights only; beside it the truncation that keeps all of them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TruncationRow {
    /// The restitution.
    pub eta: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// Which of the two: `paper (Eq. 65)` or `consistent`.
    pub truncation: &'static str,
    /// Its coefficient of `ε^(3/2)` in `ω τ_ch`.
    pub coefficient: f64,
    /// `(a - 1)/(a_cr - 1)`.
    pub share: f64,
    /// Its relative error, against the enclosure.
    pub error: Option<f64>,
}

pub(super) fn measure(expansions: &[Expansion]) -> Result<Vec<TruncationRow>, Decline> {
    let mut rows = Vec::new();
    for expansion in expansions {
        let (omega, eta) = (expansion.omega(), expansion.eta());
        let critical = critical_epsilon(omega, eta)?;
        let Some(paper) = coefficients(eta) else { continue };
        let Some(second) = expansion.coefficients().get(1).map(|coefficient| coefficient.value) else { continue };
        let shares: Vec<f64> = spread(-3.0, 0.0, 60).map(|log| 10.0_f64.powf(log).min(0.999)).collect();
        let truths: Vec<Option<f64>> = shares.par_iter().map(|share| proven(share * critical, omega, eta)).collect();
        // Both have the same first coefficient.
        for (truncation, coefficient) in [(PAPER, paper.u), ("consistent", second)] {
            rows.extend(shares.iter().zip(&truths).map(|(&share, truth)| {
                let epsilon = share * critical;
                let value = Coefficients { u: coefficient, ..paper }.chattering_time(epsilon, omega);
                let error = truth.map(|truth| (value / truth - 1.0).abs());
                TruncationRow { eta, omega, truncation, coefficient, share, error }
            }));
        }
    }
    Ok(rows)
}
