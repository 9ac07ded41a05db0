//! A first look at an engine: does it start, does it say what it has to, is it right on easy cases, does it decline what it does not offer. In the words of
//! somebody who has never read the protocol.

use std::time::Instant;

use contract::{Case, Ending, Invalid, Model, Normalisation, Oracle, Slenderness};
use process::{Answer, Breakdown, Outcome, Tolerance, Welcome};
use serde::Serialize;

use super::{fleet::Started, manifest::Entry, record::Keeper};
use crate::{
    cases::case_file::flags,
    gate::{finding::Finding, judge::Judges, laws, report::finding_text},
    measure::{
        asking::{self, Reply, ask},
        observables::{Observable, Observed},
    },
};

/// What was looked at, and what was seen.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Step {
    /// What.
    pub name: &'static str,
    /// How it is.
    pub mark: Mark,
    /// What was seen, in words.
    pub says: String,
    /// The last lines of its error output, where it broke.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stderr: Vec<String>,
}

/// How many lines of the error output are shown.
const STDERR: usize = 10;

/// How something is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// As it should be.
    Well,
    /// It can be left so, but better is possible.
    Hint,
    /// Nothing was seen of it.
    Nothing,
    /// Wrong.
    Wrong,
    /// It broke.
    Broke,
}

impl Step {
    fn new(name: &'static str, mark: Mark, says: impl Into<String>) -> Self {
        Self { name, mark, says: says.into(), stderr: Vec::new() }
    }

    fn broke(name: &'static str, broke: &Breakdown) -> Self {
        let lines: Vec<String> = broke.stderr.lines().map(str::to_owned).collect();
        let last = lines.get(lines.len().saturating_sub(STDERR)..).unwrap_or_default();
        Self { stderr: last.to_vec(), ..Self::new(name, Mark::Broke, broke.to_string()) }
    }
}

/// Looks at one engine. `sensitive` has derivatives, the judges prove what is right.
///
/// # Errors
/// Never for the built-in cases; the contract would have to refuse one.
pub fn checkup(entry: &Entry, sensitive: Box<dyn Oracle>, judges: &Judges) -> Result<Vec<Step>, Invalid> {
    let began = Instant::now();
    let started = match Started::new(entry, sensitive, &Keeper::default()) {
        Ok(started) => started,
        Err(broke) => return Ok(vec![Step::broke("start", &broke)]),
    };
    let welcome = started.oracle.engine().welcome().clone();
    let mut steps = vec![
        start(&welcome, began.elapsed().as_secs_f64()),
        receipt(&started),
        Step::new("numbers", Mark::Well, "come back bit for bit"),
        offers(&welcome),
        errors(&welcome, entry.launch.tolerance),
    ];
    let cases = easy_cases(&entry.launch.model, entry.launch.normalisation)?;
    for (name, case) in &cases {
        steps.extend(easy(&started, judges, name, case));
    }
    let declined = steps.iter().filter(|step| step.says.starts_with(DECLINES)).count();
    if declined == cases.len() {
        let says = "none of the easy cases was answered: whether it is right is not known";
        steps.push(Step::new("answers", Mark::Nothing, says));
    }
    steps.push(decline(&started, &welcome)?);
    let broke = started.oracle.into_engine().stop();
    steps.push(match broke.first() {
        Some(broke) => Step::broke("stop", broke),
        None => Step::new("stop", Mark::Well, "ends when it is told to"),
    });
    Ok(steps)
}

fn start(welcome: &Welcome, seconds: f64) -> Step {
    let Welcome { name, version, language, .. } = welcome;
    let language = if language.is_empty() { String::new() } else { format!(", in {language}") };
    Step::new("start", Mark::Well, format!("{name} {version}{language}; answered in {:.0} ms", 1e3 * seconds))
}

fn receipt(started: &Started) -> Step {
    if started.receipt.is_empty() {
        let says = "none; with version = { command = [\"..\"] } in the manifest every report says what was tested";
        return Step::new("receipt", Mark::Hint, says);
    }
    Step::new("receipt", Mark::Well, started.receipt.clone())
}

fn offers(welcome: &Welcome) -> Step {
    let list = |words: &[String]| words.join(" and ");
    let at_once = match welcome.max_batch {
        1 => "one case at a time".to_owned(),
        many => format!("up to {many} cases at once"),
    };
    let says = format!(
        "the {} model, amplitudes over {}, a {} ground motion, {at_once}",
        list(&welcome.models),
        list(&welcome.normalisations),
        list(&welcome.ground)
    );
    Step::new("offers", Mark::Well, says)
}

fn errors(welcome: &Welcome, tolerance: Tolerance) -> Step {
    if welcome.claims {
        return Step::new(
            "errors",
            Mark::Well,
            "claims its own; for what it does not claim the manifest's tolerance stands",
        );
    }
    if tolerance == Tolerance::default() {
        let says = "it claims none, and the manifest grants none: every rounding counts as wrong. Grant some, as tolerance = { time = 1e-9, \
                    interval = 1e-9, velocity = 1e-9, reason = \"my root finder\" }";
        return Step::new("errors", Mark::Hint, says);
    }
    let Tolerance { time, interval, velocity, .. } = tolerance;
    let none =
        [("time", time), ("interval", interval), ("velocity", velocity)].into_iter().filter(|(_, of)| *of == 0.0);
    let none: Vec<&str> = none.map(|(name, _)| name).collect();
    if !none.is_empty() {
        let says = format!(
            "it claims none, and the manifest's tolerance leaves out {}, which is granted nothing: every rounding of it counts as wrong",
            none.join(" and ")
        );
        return Step::new("errors", Mark::Hint, says);
    }
    let says = format!(
        "it claims none; granted are {time:e} in the time, {interval:e} of an interval and {velocity:e} of a velocity, more where the case is ill-conditioned"
    );
    Step::new("errors", Mark::Well, says)
}

/// How it is said that a case was declined.
const DECLINES: &str = "declines an easy case";

/// Cases that everybody can do: one that comes to rest, one that still rocks at half a period, one that never rocks. A rigid body can have the restitution of
/// each at that slenderness: it loses no more than `1 - eta <= 2 sin(alpha)^2`, all that turned about the other corner.
fn easy_cases(model: &Model, normalisation: Normalisation) -> Result<Vec<(&'static str, Case)>, Invalid> {
    let alpha = Slenderness::new(0.5, normalisation)?;
    let case = |a, omega, eta| -> Result<Case, Invalid> {
        let case = Case::from_amplitude(a, omega, eta)?.with_max_impacts(12)?;
        Ok(if *model == Model::Nonlinear { case.with_slenderness(alpha) } else { case })
    };
    Ok(vec![("rest", case(1.1, 2.0, 0.6)?), ("rocking", case(1.06, 2.0, 0.92)?), ("still", case(0.9, 2.0, 0.92)?)])
}

fn easy(started: &Started, judges: &Judges, name: &'static str, case: &Case) -> Vec<Step> {
    let answer = ask(&started.oracle, case);
    let observed = match &answer.reply {
        Reply::Observed(observed) => observed,
        Reply::Declined(why) => {
            let share = started.entry.may_decline;
            let says = format!("{DECLINES}, {}: {why} (of a run it may decline {share}: may-decline)", flags(case));
            return vec![Step::new(name, Mark::Hint, says)];
        }
        Reply::Broke(how) => return vec![Step::new(name, Mark::Broke, format!("{how} (the case: {})", flags(case)))],
        Reply::Panicked(message) => return vec![Step::new(name, Mark::Broke, message.clone())],
    };
    let history = &observed.history;
    let mut steps = Vec::new();
    let judgement = judges.judge(case, std::slice::from_ref(&answer), |_| true).into_iter().next();
    let truth = judgement.as_ref().map(|judgement| judgement.proven.history.ending);
    let refuted = judgement.and_then(|judgement| {
        let disagreement = judgement.refuted?;
        let granted = started.is_granted();
        Some(Finding::Refuted { oracle: answer.oracle.clone(), judge: judgement.judge, disagreement, granted })
    });
    let broken = || {
        let breach = laws::check(case, answer.model, observed, started.oracle.times()).breach?;
        Some(Finding::Law { oracle: answer.oracle.clone(), breach })
    };
    steps.push(match refuted.or_else(broken) {
        Some(finding) => {
            Step::new(name, Mark::Wrong, format!("{} (the case: {})", finding_text(&finding), flags(case)))
        }
        None => {
            let digits = digits(judges, case, &answer, observed);
            let right = digits.map_or_else(String::new, |digits| format!(", intervals right to {digits} digits"));
            Step::new(name, Mark::Well, format!("{} impacts, {}{right}", history.impacts.len(), history.ending))
        }
    });
    if truth == Some(Ending::AtRest)
        && matches!(history.ending, Ending::LimitReached(_))
        && !started.entry.never_at_rest
    {
        let says = "it does not say \"at-rest\" of a block that comes to rest, and so no chattering time of it can be compared, without which a run falls \
                    short. If it can't know, never-at-rest = true in the manifest says so";
        steps.push(Step::new("at-rest", Mark::Hint, says));
    }
    if started.oracle.engine().answer(case).intervals_from_times {
        let says = "it sends no \"interval\": they are differences of times, which lose digits with every impact; an engine that knows them should send them";
        steps.push(Step::new("intervals", Mark::Hint, says));
    }
    steps
}

/// How many digits of the worst interval are right.
fn digits(judges: &Judges, case: &Case, answer: &asking::Answer, observed: &Observed) -> Option<i32> {
    let judge = judges.oracles.iter().find(|judge| judge.model() == answer.model)?;
    let proven = ask(*judge, case).into_observed()?;
    let error = |n: usize| {
        let (right, given) = (proven.at(Observable::Interval, n)?, observed.at(Observable::Interval, n)?);
        Some(((given.value - right.value) / right.value).abs())
    };
    let worst = (1..=observed.history.impacts.len()).filter_map(error).max_by(f64::total_cmp)?;
    Some((-worst.log10()).floor().clamp(0.0, 16.0) as i32)
}

fn decline(started: &Started, welcome: &Welcome) -> Result<Step, Invalid> {
    let (engine, model) = (started.oracle.engine(), started.entry.launch.model);
    let (other, name) = match model {
        Model::Linear => ("nonlinear", Model::Nonlinear),
        Model::Nonlinear => ("linear", Model::Linear),
    };
    if welcome.models.iter().any(|offered| offered == other) {
        return Ok(Step::new("decline", Mark::Well, "not tried: it offers both models"));
    }
    let cases = easy_cases(&name, started.entry.launch.normalisation)?;
    let Some((_, case)) = cases.first() else { return Ok(Step::new("decline", Mark::Well, "not tried")) };
    let Answer { outcome, .. } = engine.answer_to_the_other_model(case);
    Ok(match outcome {
        Outcome::Declined(why) => Step::new("decline", Mark::Well, format!("declines a {other} case: {why}")),
        Outcome::History(_) => {
            let says = format!(
                "it answers a {other} case although it offers no such model: it should look at \"model\" and decline"
            );
            Step::new("decline", Mark::Hint, says)
        }
        Outcome::Broke(broke) => {
            let says = format!("it does not decline a {other} case, which it does not offer, but breaks. {broke}");
            Step::new("decline", Mark::Hint, says)
        }
    })
}
