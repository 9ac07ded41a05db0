use contract::Decline;
use rayon::prelude::*;
use serde::Serialize;

use super::truth::critical_epsilon;
use asymptotic::{Expansion, Resummed, approach, ratios, scaled_tail};

/// One coefficient of `ω τ_ch/ε^(1/2)`, and what it and the one before say of the critical amplitude (Domb and Sykes).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CoefficientRow {
    /// The restitution.
    pub eta: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// The order `k`, from 0.
    pub k: usize,
    /// `c_k`.
    pub coefficient: f64,
    /// Its relative error, claimed.
    pub relative_error: f64,
    /// `1/k`.
    pub inverse_k: Option<f64>,
    /// `c_k/c_(k-1)`.
    pub ratio: Option<f64>,
    /// The same over its limit, `1/(a_cr - 1)`.
    pub ratio_over_limit: Option<f64>,
    /// `a_cr - 1` by this ratio with the known exponent, over the true one, less 1.
    pub biased_error: Option<f64>,
    /// The same by the coefficients up to this one resummed.
    pub resummed_error: Option<f64>,
    /// The coefficient of `H = (1 - (τ_ch/(T/2))²)^(1/β)` times `-(a_cr - 1)^k k^(2+β)`, over the last one: what is periodic in `ln k`.
    pub scaled_tail: Option<f64>,
}

pub(super) fn measure(expansions: &[Expansion]) -> Result<Vec<CoefficientRow>, Decline> {
    let rows = expansions.par_iter().map(of_one);
    Ok(rows.collect::<Result<Vec<_>, _>>()?.concat())
}

fn of_one(expansion: &Expansion) -> Result<Vec<CoefficientRow>, Decline> {
    let (omega, eta) = (expansion.omega(), expansion.eta());
    let critical = critical_epsilon(omega, eta)?;
    let ratios = ratios(expansion.coefficients(), approach(eta).exponent);
    let tail = scaled_tail(expansion, critical);
    let rows = expansion.coefficients().iter().enumerate().map(|(k, coefficient)| {
        let ratio = ratios.iter().find(|ratio| ratio.k == k);
        // With `k + 1` coefficients; there is a tail to fit from 16 on.
        let resummed = Resummed::new(&expansion.shortened(k + 1)).ok();
        CoefficientRow {
            eta,
            omega,
            k,
            coefficient: coefficient.value,
            relative_error: coefficient.error / coefficient.value,
            inverse_k: ratio.map(|_| 1.0 / k as f64),
            ratio: ratio.map(|ratio| ratio.ratio),
            ratio_over_limit: ratio.map(|ratio| ratio.ratio * critical),
            biased_error: ratio.map(|ratio| (ratio.biased / critical - 1.0).abs()),
            resummed_error: resummed.map(|resummed| (resummed.critical_epsilon().value / critical - 1.0).abs()),
            scaled_tail: k.checked_sub(1).and_then(|k| Some(tail.get(k)? / tail.last()?)),
        }
    });
    Ok(rows.collect())
}
