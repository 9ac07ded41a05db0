//! A manifest as it is written.

use std::{collections::BTreeMap, path::PathBuf};

use serde::Deserialize;
use toml::Spanned;

use crate::{cases::toml_error::Allowed, gate::known::Regime};

/// What is allowed for the fields.
pub const ALLOWED: [Allowed; 23] = [
    ("engine", "tables that start with [[engine]]"),
    ("name", "a name in quotes: letters, digits and - _ . +"),
    ("run", "a list of texts: the program first, then its arguments, as [\"python3\", \"mine.py\"]"),
    ("directory", "a folder in quotes, relative to this file"),
    ("environment", "a table of texts, as { NAME = \"value\" }"),
    ("version", "a table { command = [\"..\"], pattern = \"..\" }"),
    ("command", "a list of texts: the program first, then its arguments"),
    ("pattern", "a text in quotes, in which * stands for anything"),
    ("start-timeout", "a number of seconds above 0, at most 86400"),
    ("case-timeout", "a number of seconds above 0, at most 86400"),
    ("grace", "a number of seconds above 0, at most 86400"),
    ("processes", "a whole number, 1 to 256"),
    ("restarts", "a whole number from 0 on"),
    ("model", "\"linear\" or \"nonlinear\""),
    ("normalisation", "\"threshold\" or \"slender\""),
    ("may-decline", "a share, 0 to 1"),
    ("never-at-rest", "true or false"),
    (
        "tolerance",
        "a table { time = .., interval = .., velocity = .., tau-ch = .., reason = \"..\" } of numbers from 0 on",
    ),
    ("tau-ch", "a number from 0 on"),
    ("known", "a list of tables { class = \"..\", where = { .. }, reason = \"..\" }"),
    ("where", "a table of ranges of a, epsilon, omega, eta, alpha or impact, as { eta = [0.97, 1.0] }"),
    ("reason", "a text in quotes"),
    ("link", "a text in quotes"),
];

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    #[serde(default)]
    pub engine: Vec<Spanned<Table>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Table {
    pub name: Spanned<String>,
    pub run: Spanned<Vec<String>>,
    pub directory: Option<Spanned<PathBuf>>,
    #[serde(default)]
    pub environment: BTreeMap<String, String>,
    pub version: Option<Spanned<Version>>,
    pub start_timeout: Option<Spanned<f64>>,
    pub case_timeout: Option<Spanned<f64>>,
    pub grace: Option<Spanned<f64>>,
    pub processes: Option<Spanned<usize>>,
    pub restarts: Option<usize>,
    pub model: Model,
    pub normalisation: Option<Normalisation>,
    pub may_decline: Option<Spanned<f64>>,
    #[serde(default)]
    pub never_at_rest: bool,
    pub tolerance: Option<Spanned<Tolerance>>,
    #[serde(default)]
    pub known: Vec<Spanned<Known>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Version {
    pub command: Vec<String>,
    pub pattern: Option<String>,
}

#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    Linear,
    Nonlinear,
}

#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    Threshold,
    Slender,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
#[derive(Default)]
pub struct Tolerance {
    pub time: f64,
    pub interval: f64,
    pub velocity: f64,
    pub tau_ch: f64,
    pub reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Known {
    pub class: String,
    #[serde(default, rename = "where")]
    pub regime: Regime,
    pub reason: Option<String>,
    pub link: Option<String>,
    pub within: Option<usize>,
}
