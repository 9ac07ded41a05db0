use std::path::PathBuf;

use anyhow::bail;
use chattercheck::plan::{Answer, Candidate, Conclusion, Errors, Plan, Question};
use clap::Args;
use contract::Invalid;
use serde::Serialize;

use super::{Status, case_facts::CaseFacts, case_flags::read_scene, numbers::number, output::Format, plan_on_motion};

/// The cheapest method that answers a scene as accurately as it asks, and why
///
/// The question is how long the block of the scene chatters until it rests. Each candidate is listed with the relative error that is predicted for it, in four
/// parts (from the model, from ending a series or sum early, from steps and rounding, from the rounding of the scene's own numbers), and with its
/// predicted cost. The cheapest that is accurate enough is run; if its answer turns out to be worse than asked, the next one.
///
/// On other motions of the ground than a sinusoid under a block at rest nothing is predicted: the whole response is followed by both models, and when the block rests and how
/// far it turns is compared.
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
    #[serde(flatten)]
    case: CaseFacts,
    tolerance: f64,
    candidates: Vec<Row>,
    chosen: Option<String>,
    answer: Answered,
}

#[derive(Serialize)]
struct Row {
    method: String,
    description: &'static str,
    /// Relative errors of the chattering time; `null` if it can't answer, or if none is predicted.
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
    /// How many impacts the last of them took.
    impacts: usize,
    /// Whether the block comes to rest by complete chattering; `null` if nothing could tell.
    complete: Option<bool>,
    rocks: Option<bool>,
    overturned: Option<bool>,
    tau_ch: Option<f64>,
    seconds: Option<f64>,
    /// The relative error estimated after the fact.
    relative_uncertainty: Option<f64>,
    meets_tolerance: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let scene = read_scene(&arguments.scene)?;
    let tolerance = arguments.tolerance.unwrap_or(scene.ask.tolerance);
    if !(1e-15..=0.5).contains(&tolerance) {
        return Err(Invalid::new("tolerance", format!("{tolerance:?}"), "1e-15 to 0.5 (relative)").into());
    }
    if scene.sine().is_err() {
        return plan_on_motion::run(&scene, tolerance, arguments.format);
    }
    let plan = Plan::new(Question { tolerance, ..scene.question()? });
    let answer = plan.answer();
    if let (None, Some(decline)) = (answer.conclusion(), answer.declined()) {
        bail!("{}: every method declines, first because {decline}", arguments.scene.display());
    }
    let document = document(scene.title.clone(), scene.block.frequency_parameter(), &plan, &answer);
    arguments.format.print(&document, text)?;
    Ok(if answer.conclusion().is_some() { Status::Well } else { Status::Disagreed })
}

fn document(title: String, frequency_parameter: f64, plan: &Plan, answer: &Answer) -> Document {
    let Question { case, tolerance, .. } = plan.question;
    let chosen = plan.chosen();
    let rows = plan.candidates.iter().map(|candidate| {
        let is_chosen = chosen.is_some_and(|chosen| chosen.method == candidate.method);
        let (verdict, why) = verdict(candidate, plan, is_chosen);
        let errors = candidate.errors.as_ref().ok().copied().filter(|_| plan.question.is_predicted());
        Row {
            method: candidate.method.to_string(),
            description: candidate.method.description(),
            errors,
            total: errors.map(|errors| errors.total()),
            cost_microseconds: candidate.cost,
            verdict,
            why,
        }
    });
    let outcome = answer.conclusion();
    let time = answer.chattering_time();
    Document {
        title,
        case: CaseFacts::of(&case),
        tolerance,
        candidates: rows.collect(),
        chosen: chosen.map(|candidate| candidate.method.to_string()),
        answer: Answered {
            ran: answer.attempts.iter().map(|attempt| attempt.method.to_string()).collect(),
            impacts: answer.attempts.last().map_or(0, |attempt| attempt.impacts),
            complete: outcome.map(|outcome| matches!(outcome, Conclusion::Complete(_))),
            rocks: outcome.map(|outcome| outcome != Conclusion::NeverRocks),
            overturned: outcome.map(|outcome| outcome == Conclusion::Overturned),
            tau_ch: time.map(|time| time.value),
            seconds: time.map(|time| time.value / frequency_parameter),
            relative_uncertainty: time.map(|time| time.uncertainty / time.value),
            meets_tolerance: answer.meets,
        },
    }
}

fn verdict(candidate: &Candidate, plan: &Plan, is_chosen: bool) -> (&'static str, String) {
    let Question { tolerance, .. } = plan.question;
    match &candidate.errors {
        Err(why) => ("refused", why.to_string()),
        Ok(_) if !plan.question.is_predicted() && is_chosen => ("chosen", "the cheapest that can tell".to_owned()),
        Ok(_) if !plan.question.is_predicted() => ("not needed", "can tell, but is dearer".to_owned()),
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
    let Document { case, tolerance, .. } = document;
    let CaseFacts { a, omega, eta, .. } = case;
    let mut lines = vec![
        document.title.clone(),
        format!("  the ground acceleration is at most {a:.6} times what begins to rock the block (a);"),
        format!(
            "  the ground moves at {omega:.4} times the block's own frequency p (omega); an impact leaves {eta:.4} of the velocity (eta)"
        ),
        document.case.alpha.map_or_else(
            || "  the block is taken as slender (Eq. 4)".to_owned(),
            |alpha| {
                format!("  the block is taken as it is (Eq. 2), {alpha:.4} rad from upright to its balance (alpha)")
            },
        ),
        format!(
            "asked: how long it chatters until it rests, to {tolerance:.0e} of that time. What each method would get wrong of it, relative, and take:"
        ),
        format!(
            "  {:22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}",
            "method", "model", "cut off", "steps", "numbers", "total", "cost (us)"
        ),
    ];
    // What is refused for the same reason shares a line.
    let mut refused: Vec<(&str, Vec<&str>)> = Vec::new();
    for row in &document.candidates {
        let Some(errors) = row.errors else {
            if row.verdict == "refused" {
                match refused.iter_mut().find(|(why, _)| *why == row.why) {
                    Some((_, methods)) => methods.push(&row.method),
                    None => refused.push((&row.why, vec![&row.method])),
                }
            } else {
                lines.push(format!(
                    "  {:22}{:>45}{:>11.1}  {}: {}",
                    row.method, "-", row.cost_microseconds, row.verdict, row.why
                ));
            }
            continue;
        };
        let parts = [errors.model, errors.truncation, errors.discretisation, errors.conditioning, errors.total()];
        let numbers: String = parts.iter().map(|part| format!("{:>9}", format!("{part:.0e}"))).collect();
        lines
            .push(format!("  {:22}{numbers}{:>11.1}  {}: {}", row.method, row.cost_microseconds, row.verdict, row.why));
    }
    for (why, methods) in refused {
        lines.push(format!("  {} refused: {why}", methods.join(", ")));
    }
    lines.push(
        "  (model: from another equation; cut off: a sum or a series ended early; steps: steps and rounding; numbers: the rounding of the scene's own)"
            .to_owned(),
    );
    lines.push(format!("answer: {}", answered(&document.answer)));
    if let Some(last) = document.answer.ran.last() {
        let row = document.candidates.iter().find(|row| row.method == *last);
        let description = row.map_or("", |row| row.description);
        let impacts =
            if document.answer.impacts > 0 { format!(" ({} impacts)", document.answer.impacts) } else { String::new() };
        lines.push(format!("by {}: {description}{impacts}", document.answer.ran.join(", then ")));
    }
    lines.join("\n")
}

fn answered(answer: &Answered) -> String {
    match (answer.rocks, answer.overturned, answer.seconds, answer.relative_uncertainty) {
        (None, ..) => "none; no method could tell".to_owned(),
        (Some(false), ..) => "the block never rocks".to_owned(),
        (_, Some(true), ..) => "the block overturns".to_owned(),
        (_, _, Some(seconds), Some(off)) => {
            let meets = if answer.meets_tolerance { "as asked" } else { "WORSE THAN ASKED" };
            format!("it rests {} s after it began to rock, to {off:.0e} of it, {meets}", meaningful(seconds, off))
        }
        _ => "it does not come to rest as long as it is followed (5 cycles of a motion without end): `chattercheck response` follows it further with --until".to_owned(),
    }
}

/// A number with the digits that its relative error leaves, and two more.
fn meaningful(value: f64, off: f64) -> String {
    let digits = (3.0 - off.max(1e-16).log10()).clamp(3.0, 17.0);
    let decimals = (digits - value.log10().floor() - 1.0).max(0.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and some tens
    let decimals = decimals as usize;
    format!("{value:.decimals$}")
}
