//! How a sweep is written in TOML. What its fields mean is for [`super`] to say; the axes, whose order counts, are read by [`super::axes`].

use serde::Deserialize;
use toml::Spanned;

use crate::cases::toml_error::Allowed;

/// What is allowed for each field, in words.
pub const ALLOWED: [Allowed; 7] = [
    ("title", "a text in quotes"),
    ("scene", "a text in quotes: the path of a scene, from where the sweep is"),
    ("normalisation", "\"threshold\" or \"slender\""),
    ("seed", SEEDS),
    ("axes", "a table [axes]"),
    ("want", "a table [want]"),
    ("columns", "a list of names in quotes"),
];
/// What is allowed for the seed.
pub const SEEDS: &str = "a whole number, 0 to 9223372036854775807";

/// A sweep.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SweepFile {
    /// What it is, for people; it stands above the drawing.
    pub title: Option<String>,
    /// The scene whose fields the axes are; without one they are those of a case.
    pub scene: Option<String>,
    /// What the amplitude of a case with `alpha` is a multiple of.
    pub normalisation: Option<Spanned<String>>,
    /// The seed of the random axes.
    pub seed: Option<Spanned<i64>>,
    /// The axes.
    #[serde(rename = "axes")]
    pub _axes: toml::Table,
    /// What is wanted.
    pub want: WantFields,
}

/// What is wanted of each point.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WantFields {
    /// The columns of the table, beside those of the axes.
    pub columns: Spanned<Vec<Spanned<String>>>,
}
