//! Points that are dimensionless cases.

use contract::{Case, Decline, Ending, Estimate, Horizon, Invalid, Oracle};

use super::{Axis, Column, Findings, SweepError, Value};
use crate::{
    cases::case_file::CaseFields,
    measure::sharpest,
    motion::response::{Asked, Request},
    panel,
};

/// The fields that an axis may be.
const FIELDS: [&str; 5] = ["a", "epsilon", "omega", "eta", "alpha"];

/// How cases are made of the values of the axes, and what is found out of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Cases {
    names: Vec<&'static str>,
    normalisation: Option<String>,
    has_response: bool,
    has_history: bool,
}

impl Cases {
    /// # Errors
    /// When an axis is none of a case, or one that is needed is not there.
    pub(super) fn new(axes: &[Axis], normalisation: Option<String>, columns: &[Column]) -> Result<Self, SweepError> {
        let names: Vec<&'static str> = axes
            .iter()
            .map(|axis| {
                FIELDS.into_iter().find(|name| *name == axis.name).ok_or_else(|| {
                    SweepError(format!(
                        "axes.{} is not known here; known are {}, and with scene = \"FILE\" the fields of a scene",
                        axis.name,
                        FIELDS.join(", ")
                    ))
                })
            })
            .collect::<Result<_, _>>()?;
        for needed in ["omega", "eta"] {
            if !names.contains(&needed) {
                return Err(SweepError(format!("axes.{needed} is missing")));
            }
        }
        match (names.contains(&"a"), names.contains(&"epsilon")) {
            (true, true) => {
                return Err(SweepError("axes.epsilon is outside the allowed: one of a and epsilon".to_owned()));
            }
            (false, false) => return Err(SweepError("axes.a is missing; allowed is one of a and epsilon".to_owned())),
            _ => {}
        }
        let has_response = columns.contains(&Column::LargestRotation);
        if has_response && normalisation.as_deref() == Some("slender") {
            return Err(SweepError(
                "columns: largest_rotation is outside the allowed: only with normalisation = \"threshold\"".to_owned(),
            ));
        }
        let has_history = columns
            .iter()
            .any(|column| !matches!(column, Column::LargestRotation | Column::LargestRotationUncertainty));
        Ok(Self { names, normalisation, has_response, has_history })
    }

    /// The case of these values, one for each axis.
    pub(super) fn case(&self, values: impl Iterator<Item = Value>) -> Result<Case, Invalid> {
        let mut fields = CaseFields { normalisation: self.normalisation.clone(), ..CaseFields::default() };
        for (name, value) in self.names.iter().zip(values) {
            let value = value.number();
            match *name {
                "a" => fields.a = value,
                "epsilon" => fields.epsilon = value,
                "omega" => fields.omega = value.unwrap_or(f64::NAN),
                "eta" => fields.eta = value.unwrap_or(f64::NAN),
                _ => fields.alpha = value,
            }
        }
        fields.case()?.with_max_impacts(sharpest::FIRST_IMPACTS)
    }

    /// What is found of a point.
    pub(super) fn findings(&self, values: impl Iterator<Item = Value>) -> Findings {
        let Ok(case) = self.case(values) else { return Findings::nothing("refused") };
        let oracle = panel::stepper_of(panel::model_of(&case));
        let mut findings = Findings::nothing("declined");
        if self.has_history
            && let Ok(found) = of_history(oracle.as_ref(), &case)
        {
            findings = found;
        }
        if self.has_response {
            match largest_rotation(oracle.as_ref(), &case) {
                Ok((rotation, ending)) => {
                    findings.largest_rotation = rotation;
                    // What the response alone knows; where nothing turned, it says why.
                    if !self.has_history || findings.ending == "declined" {
                        findings.ending = ending;
                    }
                }
                Err(_) => findings.ending = "declined",
            }
        }
        findings
    }
}

/// What `chattering-time` says.
fn of_history(oracle: &dyn Oracle, case: &Case) -> Result<Findings, Decline> {
    let (_, observed) = sharpest::observe(oracle, case)?;
    let time = observed.chattering_time;
    let is_unsure = time.is_some_and(|time| !time.uncertainty.is_finite());
    Ok(Findings {
        tau_ch: time.filter(|_| !is_unsure),
        impacts: Some(observed.history.impacts.len()),
        ending: if is_unsure { "unsure" } else { name(observed.history.ending) },
        ..Findings::default()
    })
}

/// The largest rotation within half a period, and how that ends; none of a block that overturns.
fn largest_rotation(oracle: &dyn Oracle, case: &Case) -> Result<(Option<Estimate>, &'static str), Decline> {
    let refused = |_| Decline::Unsupported { what: "cases at the border of what is allowed" };
    let case = case.with_horizon(Horizon::HalfPeriod).map_err(refused)?;
    let half_period = std::f64::consts::PI / case.omega();
    let request = Request::new(case, None, half_period).map_err(refused)?;
    let (response, rotation) = Asked::Sinusoid(request).with_rotation(oracle)?;
    let Some(bout) = response.bouts.first() else { return Ok((None, "never-rocks")) };
    let ending = match bout.ending() {
        "complete" => "at-rest",
        "rocking" => "incomplete",
        other => other,
    };
    let rotation = rotation.filter(|(_, uncertainty)| ending != "overturned" && uncertainty.is_finite());
    let rotation = rotation.map(|(peak, uncertainty)| Estimate { value: peak.rotation.abs(), uncertainty });
    Ok((rotation, ending))
}

/// The name of an ending in tables.
fn name(ending: Ending) -> &'static str {
    match ending {
        Ending::AtRest => "at-rest",
        Ending::Incomplete => "incomplete",
        Ending::Overturned => "overturned",
        Ending::NeverRocks => "never-rocks",
        Ending::LimitReached(_) => "limit-reached",
        Ending::Lost(_) => "lost",
    }
}
