use std::path::PathBuf;

use anyhow::anyhow;
use chattercheck::{critical, scene};
use clap::Args;
use contract::{Case, Model};
use serde::Serialize;

use super::{
    Verdict,
    case_flags::read_scene,
    output::{Format, print},
};

/// Check a scene file, and say what it is in dimensionless terms; or print the JSON Schema of scene files
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML
    #[arg(required_unless_present = "schema")]
    file: Option<PathBuf>,
    /// Print the JSON Schema of scene files
    #[arg(long)]
    schema: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Answer {
    title: String,
    a: f64,
    epsilon: f64,
    omega: f64,
    eta: f64,
    /// `null` for the linear model, which ignores it.
    alpha: Option<f64>,
    normalisation: Option<&'static str>,
    model: &'static str,
    /// `p`, 1/s: a dimensionless time over it is a time in seconds.
    frequency_parameter: f64,
    /// m/s².
    ground_acceleration: f64,
    rocks: bool,
    /// When rocking begins, s; `null` if it never does.
    initiation: Option<f64>,
    /// The critical amplitude of the linear model; `null` outside of the range of its interpolant.
    a_cr: Option<f64>,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Verdict> {
    if arguments.schema {
        print(&scene::schema()?)?;
        return Ok(Verdict::Well);
    }
    let path = arguments.file.as_deref().ok_or_else(|| anyhow!("no scene file"))?;
    let scene = read_scene(path)?;
    let case: Case = scene.case()?;
    let initiation = scene.initiation()?;
    let answer = Answer {
        title: scene.title.clone(),
        a: case.amplitude(),
        epsilon: case.epsilon(),
        omega: case.omega(),
        eta: case.eta(),
        alpha: case.slenderness().map(|slenderness| slenderness.alpha()),
        normalisation: case.slenderness().map(|s| chattercheck::case_file::name_of(s.normalisation())),
        model: if scene.ask.model == Model::Linear { "linear" } else { "nonlinear" },
        frequency_parameter: scene.block.frequency_parameter(),
        ground_acceleration: scene.acceleration(),
        rocks: initiation.is_some(),
        initiation: initiation.map(|(time, _)| time),
        a_cr: critical::interpolated(case.omega(), case.eta()).ok().map(|epsilon| 1.0 + epsilon),
    };
    arguments.format.print(&answer, text)?;
    Ok(Verdict::Well)
}

fn text(answer: &Answer) -> String {
    let Answer { a, omega, eta, model, frequency_parameter, ground_acceleration, .. } = answer;
    let alpha = answer.alpha.map_or(String::new(), |alpha| format!(", alpha = {alpha}"));
    let normalisation = answer.normalisation.map_or(String::new(), |name| format!(" ({name} normalisation)"));
    let rocks = match (answer.initiation, answer.a_cr) {
        (None, _) => "does not rock".to_owned(),
        (Some(time), None) => format!("begins to rock at {time:.6} s"),
        (Some(time), Some(a_cr)) => {
            let kind = if *a < a_cr { "complete" } else { "incomplete" };
            format!("begins to rock at {time:.6} s; chattering is {kind} by the linear model, whose a_cr is {a_cr:.6}")
        }
    };
    format!(
        "{}\n  a = {a}{normalisation}, omega = {omega}, eta = {eta}{alpha}, {model}\n  p = {frequency_parameter} 1/s, ground acceleration \
         {ground_acceleration} m/s^2\n  {rocks}",
        answer.title
    )
}
