//! Simulators of somebody else in the chart, beside the methods that it is held against, all on this machine.

use contract::{Case, Decline, Ending, History, Model};

use super::{Scope, Truth, WorkRow, cases, measure_some, off, rounded};
use crate::measure::observables::Observed;

/// A simulator of somebody else.
pub struct Stranger<'a> {
    /// Its name.
    pub name: &'a str,
    /// The equation that it solves; the chart is of the linear one.
    pub model: Model,
    /// What it answers to a case, and how long that took, in seconds.
    pub ask: &'a dyn Fn(&Case) -> (Option<History>, f64),
}

/// What they are held against.
const FAMILIES: [&str; 2] = ["closed form, higher orders", "tsit45, rescaled"];

/// A setting of those is repeated until it has taken so many seconds...
const PATIENCE: f64 = 0.02;
/// ...and a stranger is asked so often.
const ASKED: usize = 5;

/// The rows of the strangers that solve the linear equation, and of what they are held against.
///
/// # Errors
/// When a quantity is out of range.
pub fn measure_beside(strangers: &[Stranger]) -> Result<Vec<WorkRow>, Decline> {
    let scope = Scope { patience: PATIENCE, ..Scope::default() };
    let mut rows = measure_some(&scope, |family| FAMILIES.contains(&family), || ())?;
    for (share, case) in cases(&scope)? {
        let truth = Truth::of(&case)?;
        let linear = strangers.iter().filter(|stranger| stranger.model == Model::Linear);
        rows.extend(linear.map(|stranger| row(stranger, &share, &case, &truth)));
    }
    Ok(rows)
}

fn row(stranger: &Stranger, share: &str, case: &Case, truth: &Truth) -> WorkRow {
    let answers: Vec<(Option<History>, f64)> = (0..ASKED).map(|_| (stranger.ask)(case)).collect();
    let best = answers.iter().map(|(_, seconds)| *seconds).fold(f64::INFINITY, f64::min);
    let answer = answers.into_iter().next().and_then(|(answer, _)| answer);
    let outcome = match &answer {
        None => "no answer".to_owned(),
        Some(history) if matches!(history.ending, Ending::AtRest | Ending::LimitReached(_)) => String::new(),
        Some(history) => format!("{}, after {} impacts", history.ending, history.impacts.len()),
    };
    let observed = answer.filter(|_| outcome.is_empty()).map(|history| Observed::new(case, history));
    let time = observed.as_ref().and_then(|observed| observed.chattering_time).map(|time| time.value);
    let impact_40 = observed.as_ref().and_then(|observed| Some(observed.history.impacts.get(39)?.time));
    WorkRow {
        share: share.to_owned(),
        epsilon: case.epsilon(),
        family: format!("{} (engine)", stranger.name),
        setting: String::new(),
        impacts: observed.as_ref().map(|observed| observed.history.impacts.len()),
        rhs: None,
        seconds: rounded(best),
        tau_ch_error: off(time, truth.chattering_time),
        impact_40_error: off(impact_40, truth.impact_40),
        outcome,
    }
}
