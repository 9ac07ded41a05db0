//! Cases as data: how a case is written in TOML and JSON.

use contract::{Case, Horizon, Invalid, Normalisation, Slenderness};
use serde::{Deserialize, Serialize};

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

/// What is wrong with a TOML file, in one line and without the parser's picture of it; with the line that it is in, if it is in one.
pub fn one_line(error: &toml::de::Error, text: &str) -> String {
    const LONGEST: usize = 100;
    let message = printable(error.message());
    let Some((span, before)) = error.span().and_then(|span| Some((span.clone(), text.get(..span.start)?))) else {
        return message;
    };
    let number = before.matches('\n').count();
    let line = text.lines().nth(number).unwrap_or_default();
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let place = format!("line {}: {message}", number + 1);
    // What is missing is in no line, whatever the parser points at.
    let is_absent = message.starts_with("missing field");
    if is_absent || line.trim().is_empty() || span.end > start + line.len() {
        return place;
    }
    let shown: String = line.trim().chars().take(LONGEST).collect();
    let dots = if shown.len() < line.trim().len() { "..." } else { "" };
    format!("{place}, in `{}{dots}`", printable(&shown))
}

/// A text of a file as it may be shown: in one line, and without what a terminal would obey.
fn printable(text: &str) -> String {
    let shown = |c: char| if is_control(c) { char::REPLACEMENT_CHARACTER } else { c };
    text.replace('\n', " ").chars().map(shown).collect()
}

/// Whether a character does something instead of being seen: control characters, and those that turn the direction of writing.
pub fn is_control(c: char) -> bool {
    c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> String {
        one_line(&toml::from_str::<CaseFields>(text).unwrap_err(), text)
    }

    #[test]
    fn the_line_with_the_error_is_quoted() {
        let told = told("# first\nomega = \"fast\" # why\n");
        assert!(told.starts_with("line 2: invalid type") && told.ends_with("in `omega = \"fast\" # why`"), "{told}");
    }

    #[test]
    fn what_is_missing_is_in_no_line() {
        let told = told("# only a comment\nomega = 2.0\n");
        assert!(told.starts_with("line 1: missing field") && !told.contains("comment"), "{told}");
    }

    #[test]
    fn nothing_that_a_terminal_obeys_is_shown() {
        for hidden in ['\u{1b}', '\u{9b}', '\u{202e}', '\r'] {
            let told = told(&format!("omega = \"fast\" # {hidden}[31m"));
            assert!(!told.contains(hidden), "{told:?}");
        }
        let told = told(&format!("omega = \"{}\"", "ü".repeat(500)));
        assert!(told.ends_with("...`") && told.lines().count() == 1, "{told}");
    }
}
