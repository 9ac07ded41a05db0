//! The paper, figure by figure and claim by claim: every figure as rows for CSV and as a chart drawn from them, and every claim measured.
//!
//! The claims are data, `data/paper/claims.toml`; each has one function here that measures it, by the name of its `id`.

mod claims;
mod fig_10;
mod fig_11;
mod fig_2;
mod fig_3;
mod fig_4;
mod fig_5;
mod fig_6;
mod fig_7;
mod fig_9;
mod figure;
mod history;
mod limits;

use std::collections::BTreeMap;

use contract::{Case, Decline, Invalid};
use rayon::prelude::*;

use crate::{
    measure::{asking::ask, excitation::half_period, observables::Observed},
    panel,
    studies::chart::{self, Table},
};

pub use claims::{Claim, Judged, Measured, Standing, claims, judge, markdown, measured, summary};
pub use figure::Figure;

/// Every figure that is regenerated.
pub const FIGURES: [Figure; 10] = [
    fig_2::FIGURE,
    fig_3::A,
    fig_3::B,
    fig_4::FIGURE,
    fig_5::FIGURE,
    fig_6::FIGURE,
    fig_7::FIGURE,
    fig_9::FIGURE,
    fig_10::FIGURE,
    fig_11::FIGURE,
];

/// Why the paper could not be regenerated.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A method had no answer.
    #[error("{0}")]
    Decline(Decline),
    /// A parameter was out of range.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// A table could not be written.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// A chart could not be drawn.
    #[error(transparent)]
    Chart(#[from] chart::Error),
    /// `data/paper/claims.toml` can't be read.
    #[error("data/paper/claims.toml: {0}")]
    Toml(#[from] toml::de::Error),
    /// A claim and what measures it do not match.
    #[error("data/paper/claims.toml and src/studies/paper/claims do not match: {0}")]
    Mismatch(String),
    /// A number that a figure or a claim needs is not there.
    #[error("{what}: there is no such number")]
    Missing {
        /// What was looked for.
        what: String,
    },
}

impl From<Decline> for Error {
    fn from(decline: Decline) -> Self {
        Self::Decline(decline)
    }
}

/// Every file: its name and its text. `done` is called after each figure and each claim, from any thread.
///
/// # Errors
/// When a method declines what the paper asks, or a chart can't be drawn; nothing then.
pub fn files(done: impl Fn() + Sync) -> Result<BTreeMap<String, String>, Error> {
    let (figures, judged) = rayon::join(|| figures(&done), || judge(&done));
    let mut files = figures?;
    let judged = judged?;
    files.insert("claims.csv".to_owned(), claims::csv(&judged)?);
    files.insert("claims.md".to_owned(), markdown(&judged));
    files.insert("summary.md".to_owned(), summary(&judged));
    Ok(files)
}

/// The files of all figures. The charts are drawn from the text of the tables, not from what made it.
fn figures(done: impl Fn() + Sync) -> Result<BTreeMap<String, String>, Error> {
    let files = FIGURES.par_iter().map(|figure| {
        let name = format!("{}.csv", figure.name);
        let csv = (figure.measure)()?;
        let table = Table::from_reader(&name, csv.as_bytes())?;
        let mut files = vec![(name, csv)];
        for (name, draw) in figure.charts {
            files.push(((*name).to_owned(), draw(&table)?));
        }
        done();
        Ok(files)
    });
    Ok(files.collect::<Result<Vec<_>, Error>>()?.into_iter().flatten().collect())
}

/// A case of the paper, with so many impacts listed, as the closed form answers it: to 12 digits or more.
fn observed(a: f64, omega: f64, eta: f64, impacts: usize) -> Result<Observed, Error> {
    let case = Case::from_amplitude(a, omega, eta)?.with_max_impacts(impacts)?;
    let answer = ask(panel::stepper().as_ref(), &case);
    answer.into_observed().ok_or_else(|| missing(format!("the history of a = {a}, omega = {omega}, eta = {eta}")))
}

/// The phase at which rocking begins, `ψ` of Eq. 12 with `i_0 = -1`.
fn phase(a: f64) -> f64 {
    (1.0 / a).asin()
}

fn missing(what: impl Into<String>) -> Error {
    Error::Missing { what: what.into() }
}
