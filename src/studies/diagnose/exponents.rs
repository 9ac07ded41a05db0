use std::f64::consts::PI;

use contract::Decline;
use rayon::prelude::*;
use serde::Serialize;

use super::{
    Scope, spread,
    truth::{critical_epsilon, proven},
};
use asymptotic::{Approach, approach, exponent_of_coefficients};

/// The exponent `β` of `1 - τ_ch/(T/2) ~ (a_cr - a)^β`, three times.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExponentRow {
    /// The restitution.
    pub eta: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// By the formula, from the bounce that repeats itself.
    pub formula: f64,
    /// From the coefficients of the series, and the critical amplitude.
    pub coefficients: Option<f64>,
    /// What that may be off by.
    pub coefficients_uncertainty: Option<f64>,
    /// From proven chattering times towards the critical amplitude.
    pub stepping: Option<f64>,
    /// By how much the extrapolation changed that.
    pub stepping_uncertainty: Option<f64>,
    /// The period of the factor in front of the power, in the logarithm of `a_cr - a`.
    pub log_period: f64,
}

/// The local exponent, `d ln(1 - τ_ch/(T/2))/d ln(a_cr - a)`, at one distance from the critical amplitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LocalRow {
    /// The restitution.
    pub eta: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// `(a_cr - a)/(a_cr - 1)`.
    pub to_go: f64,
    /// `1 - τ_ch/(T/2)`.
    pub left: f64,
    /// The local exponent.
    pub exponent: f64,
    /// How far that is from `β` by the formula.
    pub off: f64,
}

pub(super) fn measure(scope: &Scope, done: impl Fn() + Sync) -> Result<Vec<ExponentRow>, Decline> {
    let omega = scope.omega;
    let rows = scope.exponents.par_iter().map(|&eta| {
        let Approach { exponent, log_period } = approach(eta);
        let critical = critical_epsilon(omega, eta)?;
        let coefficients = exponent_of_coefficients(omega, eta, critical);
        let stepping = stepping(omega, eta, critical, log_period);
        done();
        Ok(ExponentRow {
            eta,
            omega,
            formula: exponent,
            coefficients: coefficients.map(|estimate| estimate.value),
            coefficients_uncertainty: coefficients.map(|estimate| estimate.uncertainty),
            stepping: stepping.map(|(value, _)| value),
            stepping_uncertainty: stepping.map(|(_, change)| change),
            log_period,
        })
    });
    rows.collect()
}

/// What is left of the half period, relative, at a share `to_go` of the way from the critical amplitude.
fn left(omega: f64, eta: f64, critical: f64, to_go: f64) -> Option<f64> {
    Some(1.0 - proven(critical - critical * to_go, omega, eta)? * omega / PI)
}

/// The slope over whole periods, in which the periodic factor takes no part, extrapolated: its error falls as `(a_cr - a)^β`. And the last change.
fn stepping(omega: f64, eta: f64, critical: f64, log_period: f64) -> Option<(f64, f64)> {
    // Whole periods that make up a factor of about 20.
    let periods = (20.0_f64.ln() / log_period).round().max(1.0);
    let ratio = (-periods * log_period).exp();
    let places: Vec<f64> = (0..5).map(|k| 1e-2 * ratio.powi(k)).collect();
    let left: Vec<f64> = places.iter().map(|&to_go| left(omega, eta, critical, to_go)).collect::<Option<_>>()?;
    let slopes = left.windows(2).filter_map(|two| match two {
        [far, near] => Some((near / far).ln() / ratio.ln()),
        _ => None,
    });
    let slopes: Vec<f64> = slopes.collect();
    let extrapolated: Vec<f64> = slopes
        .windows(2)
        .filter_map(|two| match two {
            [far, near] => {
                let power = ratio.powf(*near);
                Some((near - power * far) / (1.0 - power))
            }
            _ => None,
        })
        .collect();
    match extrapolated.as_slice() {
        [.., before, last] => Some((*last, (last - before).abs())),
        _ => None,
    }
}

pub(super) fn local(scope: &Scope) -> Result<Vec<LocalRow>, Decline> {
    let Scope { omega, steps, .. } = *scope;
    let mut rows = Vec::new();
    for &eta in &scope.local {
        let critical = critical_epsilon(omega, eta)?;
        // Half a step apart: each slope is taken from half a step before a place to half a step behind it.
        let logs: Vec<f64> = spread(-1.0, -8.0, 2 * steps).collect();
        let at = |log: f64| Some((log, left(omega, eta, critical, 10.0_f64.powf(log))?));
        let known: Vec<Option<(f64, f64)>> = logs.par_iter().map(|log| at(*log)).collect();
        let row = |three: &[Option<(f64, f64)>]| {
            let &[Some((far, before)), Some((log, left)), Some((near, behind))] = three else { return None };
            let exponent = (before / behind).log10() / (far - near);
            let off = (exponent - approach(eta).exponent).abs();
            Some(LocalRow { eta, omega, to_go: 10.0_f64.powf(log), left, exponent, off })
        };
        rows.extend(known.windows(3).step_by(2).filter_map(row));
    }
    Ok(rows)
}
