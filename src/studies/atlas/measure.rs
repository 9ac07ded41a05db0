//! One case, every method.

use contract::Decline;
use serde::Serialize;

use super::{Contender, truth::Truth};
use crate::studies::specimens::{Conclusion, Run};

/// What one method made of one case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AtlasRow {
    /// The kind of method.
    pub family: String,
    /// Its setting, or the name of an oracle.
    pub setting: String,
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// `a - 1`.
    pub epsilon: f64,
    /// `(a_cr - a)/(a_cr - 1)`, positive below the critical amplitude.
    pub to_go: f64,
    /// The place of that on an axis with `a_cr` in the middle: the decades from 1e-9, negative below `a_cr`.
    pub place: f64,
    /// What is true: `rests` before `T/2` or `rocks`.
    pub truth: &'static str,
    /// What it says: `rests`, `rocks`, or nothing.
    pub verdict: Option<&'static str>,
    /// The relative error of its chattering time, where that is true and it gives one.
    pub tau_ch_error: Option<f64>,
    /// The largest error of its rotation in the half period after `T/2`, over the largest rotation then.
    pub response_error: Option<f64>,
    /// What counts of the two: of the chattering time where the chattering is complete, of the response where it is not; 1 where the
    /// complete chattering is called incomplete. Nothing where it gives no answer.
    pub error: Option<f64>,
    /// How many impacts it resolves: up to the first interval that is off by 1 %.
    pub resolved: usize,
    /// The shortest interval among those.
    pub shortest: Option<f64>,
    /// How it fails: `none`, `silent`, `loud` or `hang`.
    pub failure: &'static str,
    /// In words.
    pub how: String,
}

/// Whether an answer with this error is wrong: by a part in a hundred or more, or by what is not a number.
pub(super) fn is_wrong(error: f64) -> bool {
    error.is_nan() || error >= 0.01
}

/// Every method at one place.
pub(super) fn at(methods: &[Contender], omega: f64, eta: f64, to_go: f64) -> Result<Vec<AtlasRow>, Decline> {
    let truth = Truth::at(omega, eta, to_go)?;
    let row = |method: &Contender| method.run(&truth.case).map(|run| row(method, &truth, to_go, &run));
    Ok(methods.iter().filter_map(row).collect())
}

fn row(method: &Contender, truth: &Truth, to_go: f64, run: &Run) -> AtlasRow {
    let tau_ch_error = match (&run.conclusion, truth.chattering_time) {
        (Conclusion::Rests(time), Some(exact)) => Some((time / exact - 1.0).abs()),
        _ => None,
    };
    let response_error = run.response.as_ref().map(|response| response.error(&truth.response));
    let error = match (&run.conclusion, truth.chattering_time) {
        (Conclusion::Rests(_), Some(_)) => tau_ch_error,
        (Conclusion::Rocks, Some(_)) => Some(1.0),
        (Conclusion::Rests(_) | Conclusion::Rocks, None) => response_error,
        _ => None,
    };
    let resolved = truth.resolved(&run.impacts);
    let (failure, how) = failure(&run.conclusion, truth.chattering_time.is_some(), error);
    AtlasRow {
        family: method.family().to_owned(),
        setting: method.setting(),
        omega: truth.case.omega(),
        eta: truth.case.eta(),
        epsilon: truth.case.epsilon(),
        to_go,
        place: place(to_go),
        truth: if truth.chattering_time.is_some() { "rests" } else { "rocks" },
        verdict: match run.conclusion {
            Conclusion::Rests(_) => Some("rests"),
            Conclusion::Rocks => Some("rocks"),
            _ => None,
        },
        tau_ch_error,
        response_error,
        error,
        resolved,
        shortest: resolved.checked_sub(1).and_then(|last| truth.impacts.get(last)).map(|impact| impact.interval),
        failure,
        how,
    }
}

/// How a method fails at a case whose chattering is complete or not, if it does.
fn failure(conclusion: &Conclusion, is_complete: bool, error: Option<f64>) -> (&'static str, String) {
    let is_off = error.is_some_and(is_wrong);
    match conclusion {
        Conclusion::Rests(_) if !is_complete => ("silent", "puts to rest a block that rocks".into()),
        Conclusion::Rocks if is_complete => ("silent", "rocks where the block rests".into()),
        Conclusion::Rests(_) if is_off => ("silent", "rests at the wrong time".into()),
        Conclusion::Rocks if is_off => ("silent", "rocks on in the wrong way".into()),
        Conclusion::Rests(_) | Conclusion::Rocks => ("none", String::new()),
        Conclusion::Astray(why) => ("silent", (*why).into()),
        Conclusion::GaveUp(why) => ("loud", why.clone()),
        Conclusion::Hangs(why) => ("hang", (*why).into()),
    }
}

/// The decades of the distance from 1e-9, with the critical amplitude in the middle and what is below it on the left.
fn place(to_go: f64) -> f64 {
    -to_go.signum() * (to_go.abs().log10() + 9.0)
}
