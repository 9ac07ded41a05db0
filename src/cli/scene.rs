use std::path::PathBuf;

use anyhow::anyhow;
use chattercheck::{
    measure::critical,
    motion::{
        response::Termination,
        scene::{self, Answers, Scene},
    },
    panel,
};
use clap::Args;
use contract::Model;
use serde::Serialize;

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::read_scene,
    motion_facts::{Facts, MotionFacts},
    output::{Format, note, print},
};

/// Say what a scene is in dimensionless terms, and answer what it asks; or print the JSON Schema of scene files
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML
    #[arg(required_unless_present = "schema", value_name = "FILE")]
    file: Option<PathBuf>,
    /// Print the JSON Schema of scene files
    #[arg(long, conflicts_with_all = ["file", "format"])]
    schema: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Answer {
    title: String,
    #[serde(flatten)]
    asked: Facts,
    model: &'static str,
    /// `p`, 1/s: a dimensionless time over it is a time in seconds.
    frequency_parameter: f64,
    /// m/s²; of other motions than a sinusoid the strongest, or a bound on it.
    ground_acceleration: f64,
    /// It over the acceleration at which this block of this model begins to rock: what `a_cr` of a sinusoid is to be compared with.
    over_threshold: f64,
    /// That acceleration, m/s².
    threshold: f64,
    rocks: bool,
    /// The critical amplitude of the linear model; `null` outside of the range of its interpolant, and for other motions than a sinusoid.
    a_cr: Option<f64>,
    /// Relative.
    tolerance: f64,
    /// In seconds since the start of the ground motion; `null` for what was not asked.
    #[serde(flatten)]
    answers: Answers,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    if arguments.schema {
        print(&scene::schema()?)?;
        return Ok(Status::Well);
    }
    let path = arguments.file.as_deref().ok_or_else(|| anyhow!("no scene file"))?;
    let scene = read_scene(path)?;
    if let scene::Ground::Shaking(shaking) = &scene.ground {
        shaking.notes.iter().for_each(note);
    }
    let answer = if scene.sine().is_ok() { of_case(&scene)? } else { of_motion(&scene)? };
    arguments.format.print(&answer, text)?;
    let lost = answer.answers.chattering_time.is_some_and(|chattering| chattering.complete.is_none());
    Ok(if lost { Status::Disagreed } else { Status::Well })
}

/// Of a sinusoid under a block at rest.
fn of_case(scene: &Scene) -> anyhow::Result<Answer> {
    let case = scene.case()?;
    let acceleration = scene.block.acceleration(scene.sine()?.amplitude);
    let a_cr = critical::interpolated(case.omega(), case.eta()).ok().map(|epsilon| 1.0 + epsilon);
    let answers = scene.answers(panel::stepper_of(scene.ask.model).as_ref())?;
    let over_threshold = scene.question()?.case.amplitude();
    Ok(answer(scene, Facts::Case(CaseFacts::of(&case)), (acceleration, over_threshold), a_cr, answers))
}

/// Of any other scene.
fn of_motion(scene: &Scene) -> anyhow::Result<Answer> {
    let request = scene.on_motion(None, Termination::Exact)?;
    let facts = MotionFacts::of(scene, &request);
    let strongest = facts.strongest;
    let acceleration = strongest * scene.threshold() * scene.block.gravity;
    let answers = scene.answers(panel::stepper_on(&request.body, &request.motion).as_ref())?;
    Ok(answer(scene, Facts::Motion(facts), (acceleration, strongest), None, answers))
}

fn answer(
    scene: &Scene,
    asked: Facts,
    (ground_acceleration, over_threshold): (f64, f64),
    a_cr: Option<f64>,
    answers: Answers,
) -> Answer {
    Answer {
        title: scene.title.clone(),
        asked,
        model: if scene.ask.model == Model::Linear { "linear" } else { "nonlinear" },
        frequency_parameter: scene.block.frequency_parameter(),
        ground_acceleration,
        over_threshold,
        threshold: scene.block.gravity * scene.threshold(),
        rocks: answers.initiation.is_some(),
        a_cr,
        tolerance: scene.ask.tolerance,
        answers,
    }
}

fn text(answer: &Answer) -> String {
    let Answer { model, frequency_parameter: p, ground_acceleration, over_threshold, .. } = answer;
    let slenderness = |alpha: &Option<f64>| alpha.map_or(String::new(), |alpha| format!(", alpha = {alpha}"));
    let asked = match &answer.asked {
        Facts::Case(CaseFacts { a, omega, eta, alpha, normalisation, .. }) => {
            let normalisation = normalisation.map_or(String::new(), |name| format!(" ({name} normalisation)"));
            vec![
                format!("  a = {a}{normalisation}, omega = {omega}, eta = {eta}{}, {model}", slenderness(alpha)),
                format!("  p = {p} 1/s, ground acceleration {ground_acceleration} m/s^2"),
            ]
        }
        Facts::Motion(MotionFacts { ground, eta, alpha, duration, samples, dt, .. }) => {
            let lasts = duration.map_or("without end".to_owned(), |tau| format!("for {tau} tau = {:.6} s", tau / p));
            let sampled = samples
                .zip(*dt)
                .map_or(String::new(), |(samples, dt)| format!(", {samples} samples {dt} tau = {:.6} s apart", dt / p));
            vec![
                format!("  {ground} {lasts}{sampled}, at most {over_threshold} times the threshold"),
                format!("  eta = {eta}{}, {model}", slenderness(alpha)),
                format!(
                    "  p = {p} 1/s, ground acceleration up to {ground_acceleration} m/s^2, threshold {} m/s^2",
                    answer.threshold
                ),
            ]
        }
    };
    let rocks = match (answer.answers.initiation, answer.a_cr) {
        (None, _) => "does not rock".to_owned(),
        (Some(time), None) => format!("begins to rock at {time:.6} s"),
        (Some(time), Some(a_cr)) => {
            let kind = if answer.over_threshold < a_cr { "complete" } else { "incomplete" };
            format!(
                "begins to rock at {time:.6} s, at {:.6} times the threshold; chattering is {kind} by the linear model, whose a_cr is {a_cr:.6}",
                answer.over_threshold
            )
        }
    };
    let title = if answer.title.is_empty() { "(no title)".to_owned() } else { answer.title.clone() };
    let mut lines: Vec<String> = [title].into_iter().chain(asked).chain([format!("  {rocks}")]).collect();
    lines.extend(answered(&answer.answers, answer.tolerance).into_iter().map(|line| format!("  {line}")));
    lines.join("\n")
}

/// A line for each thing that was asked.
fn answered(answers: &Answers, tolerance: f64) -> Vec<String> {
    let Answers { chattering_time, impact_times, rest_periods, response, .. } = answers;
    let chattering = chattering_time.as_ref().map(|chattering| {
        let after = if chattering.after_the_motion { ", counted to its end after the ground had come to rest" } else { "" };
        match (chattering.seconds, chattering.relative_uncertainty, chattering.complete) {
            (Some(seconds), Some(off), _) => {
                let meets = if off <= tolerance { "meets" } else { "DOES NOT MEET" };
                format!("chattering time: {seconds} s{after}, to {off:.0e} of it, which {meets} the tolerance of {tolerance:.0e}")
            }
            (.., None) => format!("chattering time: NOT FOUND ({})", chattering.ending),
            _ => format!("chattering time: none, the block does not come to rest ({})", chattering.ending),
        }
    });
    let impacts = impact_times
        .as_ref()
        .map(|times| format!("impacts at (s): {}", list(times.iter().map(|time| format!("{time:.9}")))));
    let rests = rest_periods
        .as_ref()
        .map(|rests| format!("at rest (s): {}", list(rests.iter().map(|(from, to)| format!("{from:.6} to {to:.6}")))));
    // That it does not rock is said above.
    let whole = response.filter(|response| response.bouts > 0).map(|response| {
        let times = if response.bouts == 1 { "time" } else { "times" };
        format!(
            "rocks {} {times} from rest to rest, with {} impacts resolved, until {:.6} s: {}",
            response.bouts, response.impacts, response.end, response.ending
        )
    });
    [chattering, impacts, rests, whole].into_iter().flatten().collect()
}

/// A list of texts; none is said.
fn list(texts: impl Iterator<Item = String>) -> String {
    let texts: Vec<_> = texts.collect();
    if texts.is_empty() { "none".to_owned() } else { texts.join(", ") }
}
