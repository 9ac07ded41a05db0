use std::path::PathBuf;

use chattercheck::plan::{Answer, Candidate, Errors, Outcome, Plan, Question};
use clap::Args;
use contract::Invalid;
use serde::Serialize;

use super::{
    Verdict,
    case_flags::{number, read_scene},
    output::Format,
};

/// The cheapest method that answers a scene as accurately as it asks, and why
///
/// The question is how long the block of the scene chatters until it rests. Each candidate is listed with the relative error that is predicted for it, in four
/// parts (from the model, from ending a series or sum early, from steps and rounding, from the rounding of the scene's own numbers), and with its
/// predicted cost. The cheapest that is accurate enough is run; if its answer turns out to be worse than asked, the next one.
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML; see `chattercheck scene`
    scene: PathBuf,
    /// The relative tolerance [default: the scene's]
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = number)]
    tolerance: Option<f64>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Document {
    title: String,
    a: f64,
    omega: f64,
    eta: f64,
    /// `null` for the linear model.
    alpha: Option<f64>,
    tolerance: f64,
    candidates: Vec<Row>,
    chosen: Option<String>,
    answer: Answered,
}

#[derive(Serialize)]
struct Row {
    method: String,
    /// `null` if it can't answer.
    errors: Option<Errors>,
    total: Option<f64>,
    cost_microseconds: f64,
    /// `chosen`, `refused` or `not needed`.
    verdict: &'static str,
    why: String,
}

#[derive(Serialize)]
struct Answered {
    /// The methods that were run, in order.
    ran: Vec<String>,
    /// Whether the block comes to rest by complete chattering; `null` if nothing could tell.
    complete: Option<bool>,
    rocks: Option<bool>,
    tau_ch: Option<f64>,
    seconds: Option<f64>,
    /// The relative error estimated after the fact.
    relative_uncertainty: Option<f64>,
    meets_tolerance: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Verdict> {
    let scene = read_scene(&arguments.scene)?;
    let tolerance = arguments.tolerance.unwrap_or(scene.ask.tolerance);
    if !(1e-15..=0.5).contains(&tolerance) {
        return Err(Invalid::new("tolerance", format!("{tolerance:?}"), "1e-15 to 0.5 (relative)").into());
    }
    let plan = Plan::new(Question { tolerance, ..scene.question()? });
    let answer = plan.answer();
    let document = document(scene.title.clone(), scene.block.frequency_parameter(), &plan, &answer);
    arguments.format.print(&document, text)?;
    Ok(Verdict::Well)
}

fn document(title: String, frequency_parameter: f64, plan: &Plan, answer: &Answer) -> Document {
    let Question { case, tolerance, .. } = plan.question;
    let chosen = plan.chosen();
    let rows = plan.candidates.iter().map(|candidate| {
        let is_chosen = chosen.is_some_and(|chosen| chosen.method == candidate.method);
        let (verdict, why) = verdict(candidate, tolerance, is_chosen);
        Row {
            method: candidate.method.to_string(),
            errors: candidate.errors.as_ref().ok().copied(),
            total: candidate.errors.as_ref().ok().map(Errors::total),
            cost_microseconds: candidate.cost,
            verdict,
            why,
        }
    });
    let outcome = answer.outcome();
    let time = answer.chattering_time();
    Document {
        title,
        a: case.amplitude(),
        omega: case.omega(),
        eta: case.eta(),
        alpha: case.slenderness().map(|slenderness| slenderness.alpha()),
        tolerance,
        candidates: rows.collect(),
        chosen: chosen.map(|candidate| candidate.method.to_string()),
        answer: Answered {
            ran: answer.attempts.iter().map(|attempt| attempt.method.to_string()).collect(),
            complete: outcome.map(|outcome| matches!(outcome, Outcome::Complete(_))),
            rocks: outcome.map(|outcome| outcome != Outcome::NeverRocks),
            tau_ch: time.map(|time| time.value),
            seconds: time.map(|time| time.value / frequency_parameter),
            relative_uncertainty: time.map(|time| time.uncertainty / time.value),
            meets_tolerance: answer.meets,
        },
    }
}

fn verdict(candidate: &Candidate, tolerance: f64, is_chosen: bool) -> (&'static str, String) {
    match &candidate.errors {
        Err(why) => ("refused", why.to_string()),
        Ok(errors) if is_chosen && errors.total() <= tolerance => {
            ("chosen", "the cheapest that is accurate enough".to_owned())
        }
        Ok(_) if is_chosen => ("chosen", "none is accurate enough; this one comes nearest".to_owned()),
        Ok(errors) if errors.total() > tolerance => ("refused", format!("its {} is too large", largest(errors))),
        // The cheapest of these is the one that is chosen.
        Ok(_) => ("not needed", "accurate enough, but dearer".to_owned()),
    }
}

/// The largest part of an error, in words.
fn largest(errors: &Errors) -> &'static str {
    let parts = [
        (errors.model, "error of the model"),
        (errors.truncation, "truncation error"),
        (errors.discretisation, "error of steps and rounding"),
        (errors.conditioning, "error from the rounding of the scene's own numbers"),
    ];
    let (mut largest, mut name) = (0.0, "error");
    for (part, of) in parts {
        if part > largest {
            (largest, name) = (part, of);
        }
    }
    name
}

fn text(document: &Document) -> String {
    let Document { a, omega, eta, tolerance, .. } = document;
    let alpha = document.alpha.map_or(String::new(), |alpha| format!(", alpha = {alpha:.4}"));
    let mut lines = vec![
        document.title.clone(),
        format!(
            "  a = {a:.6}, omega = {omega:.4}, eta = {eta:.4}{alpha}; asked: the chattering time to {tolerance:.0e} of it"
        ),
        format!(
            "  {:22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}",
            "candidate", "model", "trunc.", "steps", "numbers", "total", "cost (us)"
        ),
    ];
    for row in &document.candidates {
        let numbers = row.errors.map_or_else(
            || format!("{:>45}", "-"),
            |errors| {
                let parts =
                    [errors.model, errors.truncation, errors.discretisation, errors.conditioning, errors.total()];
                parts.iter().map(|part| format!("{:>9}", format!("{part:.0e}"))).collect()
            },
        );
        lines
            .push(format!("  {:22}{numbers}{:>11.1}  {}: {}", row.method, row.cost_microseconds, row.verdict, row.why));
    }
    lines.push(format!("  {}", answered(&document.answer)));
    lines.join("\n")
}

fn answered(answer: &Answered) -> String {
    let ran = answer.ran.join(", then ");
    match (answer.rocks, answer.seconds, answer.relative_uncertainty) {
        (None, ..) => format!("no answer (ran {ran})"),
        (Some(false), ..) => "the block never rocks".to_owned(),
        (Some(true), Some(seconds), Some(off)) => {
            let meets = if answer.meets_tolerance { "as asked" } else { "WORSE THAN ASKED" };
            format!("it rests {seconds} s after it began to rock, to {off:.0e} of it, {meets} (ran {ran})")
        }
        _ => format!("it does not come to rest within half a period of the ground motion (ran {ran})"),
    }
}
