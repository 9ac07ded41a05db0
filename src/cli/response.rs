use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        response::{Bout, BoutEnd, Request, Response, Termination, Window},
        scene::Scene,
    },
    panel,
    studies::chattering_threshold::{Condition, chattering_threshold},
};
use clap::{Args, ValueEnum, builder::PossibleValue};
use contract::{Case, Invalid, Model};
use serde::Serialize;

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::read_scene,
    numbers::{count, number},
    output::{TableFormat, json, note, print, print_csv},
};

/// The whole response of a scene: rest, rocking, chattering into rest, rocking again, free rocking, overturning
///
/// CSV columns tau, phi, phi_velocity, ground_acceleration, state. tau is p t since the start of the motion; phi is theta/alpha; ground_acceleration is in
/// multiples of the acceleration at which the block begins to rock (g tan alpha; g alpha for the linear model if the scene's amplitude is over that); state is rest, rocking, overturned (no return is possible any more) or lying. Time never decreases; at an impact, and where the ground stops, there are two
/// rows of the same time, just before and just after it. A flight has 9 rows at least; most of those that are shorter than a quarter of a step are left out, and more --steps, or a part by
/// --from and --to, show them. A block that overturns is followed until its side lies on the ground, by either model: theta is 90 degrees, phi is pi/(2 alpha). There the response ends, with a row lying. The JSON document lists what happens instead: when the block rocks, how often it hits its base, and when it rests.
///
/// Followed until the block rests after the motion; a motion without end for 5 cycles.
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML; see `chattercheck scene`
    scene: PathBuf,
    /// The equation of motion, linear or nonlinear [default: the one that the scene asks for]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// How chattering is ended: exactly, where its infinite sum accumulates; or by a scheme of the paper's Section 5.2
    #[arg(long, value_enum, default_value_t = Scheme::Exact)]
    termination: Scheme,
    /// For the velocity threshold: VelTol/(p alpha)
    #[arg(long, value_name = "V", allow_hyphen_values = true, value_parser = number)]
    velocity_threshold: Option<f64>,
    /// For the chattering threshold: the fit of the critical amplitude below which it applies [default: eq76]
    #[arg(long, value_enum)]
    condition: Option<Fit>,
    /// Follow the block to this time tau at the most
    #[arg(long, value_name = "TAU", allow_hyphen_values = true, value_parser = number)]
    until: Option<f64>,
    /// Print the response from this time tau on, to see more of a part
    #[arg(long, value_name = "TAU", allow_hyphen_values = true, value_parser = number)]
    from: Option<f64>,
    /// Print it to this time tau
    #[arg(long, value_name = "TAU", allow_hyphen_values = true, value_parser = number)]
    to: Option<f64>,
    /// Into how many steps the printed part is divided [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, MOST_STEPS>)]
    steps: Option<usize>,
    /// Output format: the history as CSV, or what happens as JSON
    #[arg(long, value_enum, default_value_t = TableFormat::Csv)]
    format: TableFormat,
}

const MOST_STEPS: usize = 1_000_000;

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Scheme {
    Exact,
    Velocity,
    Chattering,
}

#[derive(Clone, Copy, ValueEnum)]
enum Fit {
    Eq76,
    Eq77,
}

/// Times are `τ` since the start of the motion.
#[derive(Serialize)]
struct Document<'a> {
    title: &'a str,
    model: &'static str,
    #[serde(flatten)]
    case: CaseFacts,
    /// `p`, 1/s: a time over it is in seconds.
    frequency_parameter: f64,
    bouts: Vec<BoutRow>,
    rests: Vec<RestRow>,
    end: f64,
}

#[derive(Serialize)]
struct BoutRow {
    from: f64,
    to: f64,
    /// How many impacts were resolved; infinitely many follow where the ending is `complete`.
    impacts: usize,
    ending: &'static str,
    /// What is expected to be wrong with `to`; `null` where nothing is known of it, which the ending `unsure` says too.
    uncertainty: Option<f64>,
}

#[derive(Serialize)]
struct RestRow {
    from: f64,
    to: f64,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let mut scene = read_scene(&arguments.scene)?;
    if let Some(name) = &arguments.model {
        scene.ask.model = panel::model_named(name)?;
    }
    arguments.check()?;
    let request = scene.response(arguments.until, Termination::Exact)?;
    let request = Request { termination: arguments.termination(&request.case)?.check()?, ..request };
    let oracle = panel::stepper_of(scene.ask.model);
    let (name, model) = (oracle.name(), if scene.ask.model == Model::Linear { "linear" } else { "nonlinear" });
    let response = Response::new(oracle.as_ref(), &request).map_err(|decline| anyhow!("{name} declines: {decline}"))?;
    match arguments.format {
        TableFormat::Json | TableFormat::JsonLine => {
            let document = document(&scene, model, &request, &response);
            print(&json(&document, matches!(arguments.format, TableFormat::JsonLine))?)?;
        }
        TableFormat::Csv => {
            let window = arguments.window(response.end)?;
            let samples =
                response.samples(oracle.as_ref(), &request, &window).map_err(|decline| anyhow!("{decline}"))?;
            print_csv(&samples)?;
        }
    }
    note(format_args!("{name}: {}", summary(&response)));
    let lost = response.bouts.iter().any(|bout| matches!(bout.outcome, BoutEnd::Lost(_) | BoutEnd::TooManyImpacts));
    Ok(if lost { Status::Disagreed } else { Status::Well })
}

impl Arguments {
    fn termination(&self, case: &Case) -> anyhow::Result<Termination> {
        ensure!(
            self.velocity_threshold.is_none() || self.termination == Scheme::Velocity,
            Invalid::new(
                "velocity-threshold",
                self.velocity_threshold.unwrap_or_default(),
                "only with --termination velocity"
            )
        );
        if let (Some(condition), true) = (self.condition, self.termination != Scheme::Chattering) {
            let typed = condition.to_possible_value();
            let typed = typed.as_ref().map_or("", PossibleValue::get_name);
            return Err(Invalid::new("condition", typed, "only with --termination chattering").into());
        }
        Ok(match self.termination {
            Scheme::Exact => Termination::Exact,
            Scheme::Chattering => {
                let condition = match self.condition.unwrap_or(Fit::Eq76) {
                    Fit::Eq76 => Condition::Eq76,
                    Fit::Eq77 => Condition::Eq77,
                };
                chattering_threshold(case, condition)
            }
            Scheme::Velocity => Termination::VelocityThreshold(self.velocity_threshold.ok_or_else(|| {
                Invalid::new("velocity-threshold", "none", "a speed above 0 (in p alpha), with --termination velocity")
            })?),
        })
    }

    /// Refuses what the format does not use.
    fn check(&self) -> Result<(), Invalid> {
        let given = [
            ("from", self.from.map(|from| from.to_string())),
            ("to", self.to.map(|to| to.to_string())),
            ("steps", self.steps.map(|steps| steps.to_string())),
        ];
        let unused = given.into_iter().find_map(|(field, value)| Some((field, value?)));
        match (self.format, unused) {
            (TableFormat::Json | TableFormat::JsonLine, Some((field, value))) => {
                Err(Invalid::new(field, value, "only with --format csv"))
            }
            _ => Ok(()),
        }
    }

    fn window(&self, end: f64) -> Result<Window, Invalid> {
        let (from, to) = (self.from.unwrap_or(0.0), self.to.unwrap_or(end));
        if !(from >= 0.0 && from < end) && end > 0.0 {
            return Err(Invalid::new("from", format!("{from:?}"), "from 0 to the end of the response"));
        }
        if !(to > from && to <= end) && end > 0.0 {
            return Err(Invalid::new("to", format!("{to:?}"), "after --from, up to the end of the response"));
        }
        let steps = self.steps.unwrap_or(1000);
        if !(1..=MOST_STEPS).contains(&steps) {
            return Err(Invalid::new("steps", steps, "1 to 1000000"));
        }
        Ok(Window { from, to, steps })
    }
}

fn document<'a>(scene: &'a Scene, model: &'static str, request: &Request, response: &Response) -> Document<'a> {
    Document {
        title: &scene.title,
        model,
        case: CaseFacts::of(&request.case),
        frequency_parameter: scene.block.frequency_parameter(),
        bouts: response.bouts.iter().map(row).collect(),
        rests: response.rests().into_iter().map(|(from, to)| RestRow { from, to }).collect(),
        end: response.end,
    }
}

fn row(bout: &Bout) -> BoutRow {
    let uncertainty = Some(bout.uncertainty()).filter(|uncertainty| uncertainty.is_finite());
    BoutRow { from: bout.begin(), to: bout.end(), impacts: bout.impacts(), ending: bout.ending(), uncertainty }
}

fn summary(response: &Response) -> String {
    let impacts: usize = response.bouts.iter().map(Bout::impacts).sum();
    let Some(last) = response.bouts.last() else { return "the block never rocks".to_owned() };
    let times = response.bouts.len();
    let many = format!("{times} time{} of rocking, {impacts} impacts resolved", if times == 1 { "" } else { "s" });
    let lies = if response.lying.is_some() { ", and lies on its side" } else { "" };
    let (end, off, name) = (last.end(), last.uncertainty(), last.outcome.name());
    let first_unsure = response.bouts.iter().find(|bout| bout.is_unsure());
    match first_unsure {
        None => format!("{many}; the last one ends at tau = {end} ± {off:.0e}: {name}{lies}"),
        Some(bout) if bout.uncertainty().is_finite() => format!(
            "{many}; UNSURE: the one that begins at tau = {} ends at about {}, which may be off by {:.0e}",
            bout.begin(),
            bout.end(),
            bout.uncertainty()
        ),
        Some(bout) => format!(
            "{many}; UNSURE from tau = {} on: rounding alone changes how the rocking goes that begins there",
            bout.begin()
        ),
    }
}
