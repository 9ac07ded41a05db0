//! Replay files: one stored disagreement, to be run again.

use contract::{Case, Invalid};
use serde::{Deserialize, Serialize};

use crate::{
    cases::{
        case_file::{self, CaseFields},
        hex_float,
        toml_error::{self, Allowed, printable},
    },
    gate::{report, shrink::Shrunk},
};

/// A stored disagreement.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Replay {
    /// The version of the program that wrote it.
    pub version: String,
    /// The name of the case that it was shrunk from.
    pub found_in: String,
    /// The seed of that run.
    pub seed: u64,
    /// The names of the oracles of that run.
    pub oracles: Vec<String>,
    /// What was seen, for the reader.
    pub finding: String,
    /// The shrunk case, in decimal.
    pub case: CaseFields,
    /// The same numbers, exactly.
    pub exact: Exact,
}

/// The numbers of a case in hexadecimal, bit for bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exact {
    epsilon: String,
    omega: String,
    eta: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    alpha: Option<String>,
}

/// Why a replay file can't be used.
#[derive(Debug, thiserror::Error)]
pub enum ReplayError {
    /// It is not TOML of the right form.
    #[error("not a replay file: {0}")]
    Form(String),
    /// A value is not allowed.
    #[error(transparent)]
    Value(#[from] Invalid),
}

/// What is allowed for the fields of a replay file: those of a case, and those of the same names in `[exact]`.
fn allowed() -> Vec<Allowed> {
    const HEXADECIMAL: &str = "the hexadecimal form in quotes, as \"0x1p+1\"";
    let exact = ["exact.epsilon", "exact.omega", "exact.eta", "exact.alpha"].map(|field| (field, HEXADECIMAL));
    exact.into_iter().chain(case_file::ALLOWED).collect()
}

impl Replay {
    /// The replay of what a case was shrunk to.
    pub fn new(shrunk: &Shrunk, found_in: String, seed: u64) -> Self {
        let Shrunk { case, finding, oracles, .. } = shrunk;
        let alpha = case.slenderness().map(|slenderness| hex_float::format(slenderness.alpha()));
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            found_in,
            seed,
            oracles: oracles.clone(),
            finding: report::finding_text(finding),
            case: CaseFields::from(case),
            exact: Exact {
                epsilon: hex_float::format(case.epsilon()),
                omega: hex_float::format(case.omega()),
                eta: hex_float::format(case.eta()),
                alpha,
            },
        }
    }

    /// The file's text.
    ///
    /// # Errors
    /// When the values can't be written as TOML.
    pub fn to_text(&self) -> Result<String, toml::ser::Error> {
        Ok(format!("# Run again with: chattercheck replay FILE\n{}", toml::to_string(self)?))
    }

    /// Reads a file's text, and the case in it.
    ///
    /// # Errors
    /// When it is not a replay file, a value is not allowed, or the decimal and the exact numbers differ.
    pub fn read(text: &str) -> Result<(Self, Case), ReplayError> {
        let read: Self =
            toml::from_str(text).map_err(|error| ReplayError::Form(toml_error::one_line(&error, text, &allowed())))?;
        // They go to terminals and into reports, each in a line.
        let replay = Self { found_in: printable(&read.found_in), finding: printable(&read.finding), ..read };
        let case = replay.case.case()?;
        let same = |field, exact: &str, decimal: f64| match hex_float::parse(exact) {
            Some(value) if value.to_bits() == decimal.to_bits() => Ok(()),
            _ => Err(Invalid::new(field, exact, "the hexadecimal form of the decimal number in [case]")),
        };
        same("exact.epsilon", &replay.exact.epsilon, case.epsilon())?;
        same("exact.omega", &replay.exact.omega, case.omega())?;
        same("exact.eta", &replay.exact.eta, case.eta())?;
        match (&replay.exact.alpha, case.slenderness()) {
            (Some(exact), Some(slenderness)) => same("exact.alpha", exact, slenderness.alpha())?,
            (None, None) => {}
            (exact, _) => {
                let value = exact.clone().unwrap_or_else(|| "(missing)".to_owned());
                return Err(Invalid::new("exact.alpha", value, "given exactly when alpha is given in [case]").into());
            }
        }
        Ok((replay, case))
    }
}
