//! Where and why the asymptotic series breaks near the critical amplitude: everything that the `diagnose` command measures, as rows for CSV.
//!
//! The truth is the proven one of the enclosure, or stepping by the closed form where there are too many cases; each table says which.

mod charts;
mod coefficients;
mod errors;
mod exponents;
mod first_error;
mod fits;
mod truncation;
pub(crate) mod truth;

use std::collections::BTreeMap;

use asymptotic::{Expansion, RESUMMED_TERMS};
use contract::Decline;
use rayon::prelude::*;

use crate::studies::chart::csv_text;

pub use charts::CHARTS;
pub use coefficients::CoefficientRow;
pub use errors::ErrorRow;
pub use exponents::{ExponentRow, LocalRow};
pub use first_error::FirstErrorRow;
pub use fits::FitRow;
pub use truncation::TruncationRow;

/// Orders, in terms, at which the series is looked at.
const ORDERS: [usize; 6] = [1, 2, 4, 8, 16, 32];
/// What the tables call the order of the paper.
const PAPER: &str = "paper (Eq. 65)";

/// What is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Scope {
    /// The frequency ratio of the charts at one frequency.
    pub omega: f64,
    /// The restitutions of the charts with a panel for each.
    pub etas: Vec<f64>,
    /// How many steps each axis of the maps has.
    pub grid: usize,
    /// The restitutions at which the exponent of the approach is found,
    pub exponents: Vec<f64>,
    /// those at which it is followed from place to place,
    pub local: Vec<f64>,
    /// and in how many steps.
    pub steps: usize,
}

impl Default for Scope {
    /// The frequency of the paper's figures, and restitutions from the lowest to the highest.
    fn default() -> Self {
        Self {
            omega: 2.0,
            etas: vec![0.5, 0.8, 0.92, 0.97],
            grid: 16,
            exponents: vec![0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.92, 0.95, 0.97],
            local: vec![0.5, 0.6, 0.7, 0.92],
            steps: 140,
        }
    }
}

/// The tables, one for each file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tables {
    /// Error of each order and of the resummed series against the amplitude.
    pub errors: Vec<ErrorRow>,
    /// The coefficients, their ratios, and what these say of the critical amplitude.
    pub coefficients: Vec<CoefficientRow>,
    /// Where each order first errs by 1 %.
    pub first_error: Vec<FirstErrorRow>,
    /// The exponent of the approach, three times.
    pub exponents: Vec<ExponentRow>,
    /// The exponent from one step towards the critical amplitude to the next.
    pub local_exponents: Vec<LocalRow>,
    /// The fits of the critical amplitude.
    pub fits: Vec<FitRow>,
    /// The truncation of Eq. 65 and the consistent one.
    pub truncation: Vec<TruncationRow>,
}

impl Tables {
    /// Measures everything. `done` is called after each part, from any thread.
    ///
    /// # Errors
    /// When a frequency or a restitution is outside of what the series or the critical amplitude can do.
    pub fn measure(scope: &Scope, done: impl Fn() + Sync) -> Result<Self, Decline> {
        let Scope { omega, etas, grid, .. } = scope;
        let expansions = expansions(*omega, etas, &done)?;
        Ok(Self {
            errors: errors::measure(&expansions, &done)?,
            coefficients: coefficients::measure(&expansions)?,
            truncation: truncation::measure(&expansions)?,
            exponents: exponents::measure(scope, &done)?,
            local_exponents: exponents::local(scope)?,
            first_error: first_error::measure(*grid, &done)?,
            fits: fits::measure(*grid)?,
        })
    }

    /// The name of each file and its text.
    ///
    /// # Errors
    /// Never, as far as rows of numbers and names can be written.
    pub fn files(&self) -> Result<BTreeMap<&'static str, String>, csv::Error> {
        Ok(BTreeMap::from([
            ("errors.csv", csv_text(&self.errors)?),
            ("coefficients.csv", csv_text(&self.coefficients)?),
            ("first_error.csv", csv_text(&self.first_error)?),
            ("exponents.csv", csv_text(&self.exponents)?),
            ("local_exponents.csv", csv_text(&self.local_exponents)?),
            ("fits.csv", csv_text(&self.fits)?),
            ("truncation.csv", csv_text(&self.truncation)?),
        ]))
    }
}

fn expansions(omega: f64, etas: &[f64], done: impl Fn() + Sync) -> Result<Vec<Expansion>, Decline> {
    let expansions = etas.par_iter().map(|&eta| {
        let expansion = Expansion::new(omega, eta, RESUMMED_TERMS, 0);
        done();
        expansion
    });
    expansions.collect()
}

/// Evenly spread from `low` to `high`, both included.
pub(crate) fn spread(low: f64, high: f64, steps: usize) -> impl Iterator<Item = f64> + Clone {
    (0..=steps).map(move |k| low + (high - low) * k as f64 / steps as f64)
}

/// Frequencies from 0.5 to 8, evenly in their logarithm, and restitutions from 0.5 to 0.98: the range of the paper's Fig. 6 and beyond.
fn map(grid: usize) -> Vec<(f64, f64)> {
    let omegas = spread(0.5_f64.ln(), 8.0_f64.ln(), grid).map(f64::exp);
    // Rounded to four digits, which keeps the ends inside the range and the tables short.
    let omegas = omegas.map(|omega| (omega * 1e4).round() / 1e4);
    spread(0.5, 0.98, grid)
        .map(|eta| (eta * 1e4).round() / 1e4)
        .flat_map(|eta| omegas.clone().map(move |omega| (omega, eta)))
        .collect()
}
