//! Cases as data: how a case is written in TOML and JSON.

use contract::{Case, Horizon, Invalid, Normalisation, Slenderness};
use serde::{Deserialize, Serialize};

pub use super::toml_error::is_control;
use super::toml_error::{self, Allowed};

/// What is allowed for the fields of a case, and for those of the files that hold one.
pub const ALLOWED: [Allowed; 9] = [
    ("a", "a number, 0 <= a <= 1e9"),
    ("epsilon", "a number, -1 <= epsilon <= 1e9"),
    ("omega", "a number, omega > 0"),
    ("eta", "a number, 0 < eta < 1"),
    ("alpha", "a number, 1e-100 <= alpha < pi/2 (radians)"),
    ("normalisation", "\"threshold\" or \"slender\""),
    ("impacts", "a whole number, 1 to 1000000"),
    ("until", "a number above 0"),
    ("seed", "a whole number from 0 on"),
];

/// A case as it is written. Either `a` or `epsilon` is given; unknown keys are errors.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseFields {
    /// The amplitude `a`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub a: Option<f64>,
    /// `a - 1`, without the rounding of `a`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epsilon: Option<f64>,
    /// The frequency ratio.
    pub omega: f64,
    /// The coefficient of restitution.
    pub eta: f64,
    /// The slenderness angle in radians, for the nonlinear model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alpha: Option<f64>,
    /// `threshold` (the default) or `slender`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normalisation: Option<String>,
    /// How many impacts are listed at the most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub impacts: Option<usize>,
    /// The time up to which the history is followed, instead of half a period.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
}

impl CaseFields {
    /// The case, if every field is allowed.
    ///
    /// # Errors
    /// Names the field, its value, and what is allowed.
    pub fn case(&self) -> Result<Case, Invalid> {
        let mut case = match (self.a, self.epsilon) {
            (Some(a), None) => Case::from_amplitude(a, self.omega, self.eta)?,
            (None, Some(epsilon)) => Case::from_epsilon(epsilon, self.omega, self.eta)?,
            (None, None) => return Err(Invalid::new("a", "(missing)", "one of a and epsilon")),
            (Some(_), Some(epsilon)) => return Err(Invalid::new("epsilon", epsilon, "one of a and epsilon, not both")),
        };
        let normalisation = match self.normalisation.as_deref() {
            None | Some("threshold") => Normalisation::Threshold,
            Some("slender") => Normalisation::Slender,
            Some(other) => return Err(Invalid::new("normalisation", other, "threshold or slender")),
        };
        match (self.alpha, &self.normalisation) {
            (Some(alpha), _) => case = case.with_slenderness(Slenderness::new(alpha, normalisation)?),
            (None, Some(name)) => return Err(Invalid::new("normalisation", name, "only together with alpha")),
            (None, None) => {}
        }
        if let Some(impacts) = self.impacts {
            case = case.with_max_impacts(impacts)?;
        }
        if let Some(until) = self.until {
            case = case.with_horizon(Horizon::Until(until))?;
        }
        Ok(case)
    }
}

impl From<&Case> for CaseFields {
    fn from(case: &Case) -> Self {
        let slenderness = case.slenderness();
        Self {
            a: None,
            epsilon: Some(case.epsilon()),
            omega: case.omega(),
            eta: case.eta(),
            alpha: slenderness.map(|s| s.alpha()),
            normalisation: slenderness.map(|s| name_of(s.normalisation()).to_owned()),
            impacts: Some(case.max_impacts()),
            until: match case.horizon() {
                Horizon::HalfPeriod => None,
                Horizon::Until(time) => Some(time),
            },
        }
    }
}

/// The word for a normalisation in files and on the command line.
pub fn name_of(normalisation: Normalisation) -> &'static str {
    match normalisation {
        Normalisation::Threshold => "threshold",
        Normalisation::Slender => "slender",
    }
}

/// A case as the flags that ask for it on the command line.
pub fn flags(case: &Case) -> String {
    let mut flags = format!("--epsilon {:?} --omega {:?} --eta {:?}", case.epsilon(), case.omega(), case.eta());
    flags += &format!(" --impacts {}", case.max_impacts());
    if let Horizon::Until(time) = case.horizon() {
        flags += &format!(" --until {time:?}");
    }
    if let Some(slenderness) = case.slenderness() {
        flags +=
            &format!(" --alpha {:?} --normalisation {}", slenderness.alpha(), name_of(slenderness.normalisation()));
    }
    flags
}

/// What is wrong with a file that holds a case, in one line.
pub fn one_line(error: &toml::de::Error, text: &str) -> String {
    toml_error::one_line(error, text, &ALLOWED)
}
