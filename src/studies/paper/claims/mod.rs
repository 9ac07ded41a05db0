//! The claims of the paper, each measured and judged.
//!
//! A claim is an entry of `data/paper/claims.toml`: where it stands, what it says, what is measured against what, and up to which deviation it
//! holds. What measures it is the function here that is listed under its `id`; the files follow the sections of the paper. The verdict is
//! decided by the numbers in the entry, never by the function.

mod critical;
mod fig_5;
mod first_cycle;
mod infinity;
mod motion;
mod schemes;
mod semi_analytical;
mod series;
mod slender;
mod subsequent_cycles;
mod table;
mod verdict;

use rayon::prelude::*;
use serde::Deserialize;

use super::Error;

pub(super) use table::csv;
pub use table::{markdown, summary};
pub use verdict::{Standing, Unit};

/// A statement of the paper.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// A short name, unique.
    pub id: String,
    /// Where in the paper it stands.
    pub place: String,
    /// What it says, in the paper's words or nearly.
    pub statement: String,
    /// What is measured: the deviation that the verdict is about.
    pub measured: String,
    /// What the truth is: which oracle, or the equation of motion itself.
    pub truth: String,
    /// In what the deviation is counted.
    pub unit: Unit,
    /// It holds if the deviation is no larger than this,
    pub holds: f64,
    /// it holds within the deviation if that is no larger than this, and does not hold if it is.
    pub within: f64,
}

/// What the measurement of a claim came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// How far the statement is from what was found, in the unit of the claim; never negative.
    pub deviation: f64,
    /// What was found, in a sentence, with numbers rounded to what is certain.
    pub found: String,
}

impl Measured {
    fn new(deviation: f64, found: impl Into<String>) -> Self {
        Self { deviation, found: found.into() }
    }

    /// The finding that something is so, to so many digits. How many there are beyond is the chance of a machine, and not said.
    fn to_digits(deviation: f64, digits: i32, what: &str) -> Self {
        let bound = 10.0_f64.powi(-digits);
        let found = if deviation <= bound {
            format!("{what}, to {digits} digits")
        } else {
            format!("{what}, but for {deviation:.1e}")
        };
        Self { deviation, found }
    }
}

/// A claim with its measurement and verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The claim.
    pub claim: Claim,
    /// What was measured.
    pub measured: Measured,
    /// What follows.
    pub verdict: Standing,
}

/// The `id` of a claim and what measures it.
type Measurement = (&'static str, fn() -> Result<Measured, Error>);

/// All measurements, in the order of the paper.
fn measurements() -> impl Iterator<Item = Measurement> {
    let sections: [&[Measurement]; 10] = [
        motion::ALL,
        slender::ALL,
        infinity::ALL,
        first_cycle::ALL,
        subsequent_cycles::ALL,
        series::ALL,
        semi_analytical::ALL,
        fig_5::ALL,
        critical::ALL,
        schemes::ALL,
    ];
    sections.into_iter().flatten().copied()
}

/// The claims of `data/paper/claims.toml`, in its order.
///
/// # Errors
/// When the file can't be read, or two claims have the same `id`.
pub fn claims() -> Result<Vec<Claim>, Error> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        claim: Vec<Claim>,
    }
    let File { claim: claims } = toml::from_str(include_str!("../../../../data/paper/claims.toml"))?;
    match claims.iter().enumerate().find(|(k, claim)| claims.iter().take(*k).any(|other| other.id == claim.id)) {
        Some((_, twice)) => Err(Error::Mismatch(format!("{} stands there twice", twice.id))),
        None => Ok(claims),
    }
}

/// The `id` of every claim that has a measurement.
pub fn measured() -> Vec<&'static str> {
    measurements().map(|(id, _)| id).collect()
}

/// Measures and judges every claim. `done` is called after each, from any thread.
///
/// # Errors
/// When a claim has no measurement or a measurement no claim, or a method declines what the measurement asks.
pub fn judge(done: impl Fn() + Sync) -> Result<Vec<Judged>, Error> {
    let claims = claims()?;
    if let Some(id) = measured().into_iter().find(|id| !claims.iter().any(|claim| claim.id == *id)) {
        return Err(Error::Mismatch(format!("{id} is measured, but is no claim")));
    }
    let judged = claims.into_par_iter().map(|claim| {
        let measurement = measurements().find(|(id, _)| *id == claim.id);
        let (_, measure) = measurement.ok_or_else(|| Error::Mismatch(format!("{} is not measured", claim.id)))?;
        let measured = measure()?;
        let verdict = Standing::of(&claim, measured.deviation);
        done();
        Ok(Judged { claim, measured, verdict })
    });
    judged.collect()
}
