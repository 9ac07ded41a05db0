use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        closed::Closed,
        response::{Bout, BoutEnd, OnMotion, Peak, Request, Response, Sample, State, Termination, Window},
        scene::{self, Scene},
    },
    panel,
    studies::chattering_threshold::{Condition, chattering_threshold},
};
use clap::{Args, ValueEnum, builder::PossibleValue};
use contract::{Case, Decline, Invalid, Model, Oracle};
use serde::Serialize;

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::read_scene_as,
    numbers::{count, number},
    output::{TableFormat, json, note, print, print_csv},
};

/// The whole response of a scene: rest, rocking, chattering into rest, rocking again, free rocking, overturning
///
/// CSV columns tau, t, phi, theta, phi_velocity, ground_acceleration, state. tau is p t since the start of the motion, t in seconds; phi is theta/alpha, theta in degrees; ground_acceleration is in
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
    /// How the infinite sum is closed where chattering is ended exactly: from the list of impacts, or from the last one alone, by its local series
    #[arg(long, value_enum, default_value_t = Closing::Impacts)]
    closing: Closing,
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
    /// List the first N impacts of each time of rocking in the JSON document
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, MOST_STEPS>)]
    impacts: Option<usize>,
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

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Closing {
    Impacts,
    Series,
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
    /// Of a sinusoid under a block at rest.
    #[serde(flatten)]
    case: Option<CaseFacts>,
    /// Of another motion.
    #[serde(flatten)]
    motion: Option<MotionFacts>,
    /// `p`, 1/s: a time over it is in seconds.
    frequency_parameter: f64,
    /// The largest rotation; `null` if the block never rocks.
    peak: Option<PeakRow>,
    bouts: Vec<BoutRow>,
    rests: Vec<RestRow>,
    end: f64,
}

#[derive(Serialize)]
struct MotionFacts {
    ground: &'static str,
    eta: f64,
    alpha: Option<f64>,
    /// When the ground comes to rest; `null` if it does not.
    duration: Option<f64>,
}

#[derive(Serialize)]
struct PeakRow {
    tau: f64,
    /// `θ/α`, with its sign: at 1 the block stands on its corner.
    phi: f64,
    /// In degrees.
    theta: f64,
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
    /// The first impacts, as many as are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_times: Option<Vec<f64>>,
    /// `φ'` just after each of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_velocities: Option<Vec<f64>>,
}

#[derive(Serialize)]
struct RestRow {
    from: f64,
    to: f64,
}

/// A row of the history: of the response, with seconds and degrees.
#[derive(Serialize)]
struct Row {
    tau: f64,
    t: f64,
    phi: f64,
    theta: f64,
    phi_velocity: f64,
    ground_acceleration: f64,
    state: State,
}

/// What is asked of the response.
enum Asked {
    Sinusoid(Request),
    Motion(OnMotion),
}

impl Asked {
    fn response(&self, oracle: &dyn Oracle) -> Result<Response, Decline> {
        match self {
            Self::Sinusoid(request) => Response::new(oracle, request),
            Self::Motion(request) => Response::on_motion(oracle, request),
        }
    }

    fn samples(&self, response: &Response, oracle: &dyn Oracle, window: &Window) -> Result<Vec<Sample>, Decline> {
        match self {
            Self::Sinusoid(request) => response.samples(oracle, request, window),
            Self::Motion(request) => response.samples_on_motion(oracle, request, window),
        }
    }

    fn peak(&self, response: &Response, oracle: &dyn Oracle) -> Result<Option<Peak>, Decline> {
        match self {
            Self::Sinusoid(request) => response.peak(oracle, request),
            Self::Motion(request) => response.peak_on_motion(oracle, request),
        }
    }

    fn eta(&self) -> f64 {
        match self {
            Self::Sinusoid(request) => request.case.eta(),
            Self::Motion(request) => request.body.eta(),
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let scene = read_scene_as(&arguments.scene, arguments.model.as_deref())?;
    arguments.check()?;
    let asked = arguments.asked(&scene)?;
    let oracle = match &asked {
        Asked::Sinusoid(_) => panel::stepper_of(scene.ask.model),
        Asked::Motion(request) => panel::stepper_on(&request.body, &request.motion),
    };
    let oracle: Box<dyn Oracle> = match arguments.closing {
        Closing::Impacts => oracle,
        Closing::Series => {
            let closing = panel::closing();
            Box::new(Closed::new(format!("{} closed by {}", oracle.name(), closing.name()), oracle, closing))
        }
    };
    let oracle = oracle.as_ref();
    let declined = |decline: Decline| anyhow!("{} declines: {decline}", oracle.name());
    let response = asked.response(oracle).map_err(declined)?;
    if let scene::Ground::Shaking(shaking) = &scene.ground {
        shaking.notes.iter().for_each(|said| note(format_args!("{said}")));
    }
    let peak = asked.peak(&response, oracle).map_err(declined)?;
    match arguments.format {
        TableFormat::Json | TableFormat::JsonLine => {
            let document = document(&scene, &asked, &response, peak, arguments.impacts);
            print(&json(&document, matches!(arguments.format, TableFormat::JsonLine))?)?;
        }
        TableFormat::Csv => {
            let window = arguments.window(response.end)?;
            let samples = asked.samples(&response, oracle, &window).map_err(declined)?;
            let (p, degrees) = (scene.block.frequency_parameter(), scene.block.slenderness.to_degrees());
            print_csv(&samples.into_iter().map(|sample| Row::of(sample, p, degrees)).collect::<Vec<_>>())?;
        }
    }
    note(format_args!("{}: {}", oracle.name(), summary(&response)));
    if let Some(Peak { time, rotation }) = peak {
        let (degrees, seconds) = (scene.block.slenderness.to_degrees(), time / scene.block.frequency_parameter());
        note(format_args!(
            "largest rotation {:.4} degrees, {:.4} of alpha, at {seconds:.4} s",
            rotation * degrees,
            rotation.abs()
        ));
    }
    let lost = response.bouts.iter().any(|bout| matches!(bout.outcome, BoutEnd::Lost(_) | BoutEnd::TooManyImpacts));
    Ok(if lost { Status::Disagreed } else { Status::Well })
}

impl Row {
    fn of(sample: Sample, p: f64, degrees: f64) -> Self {
        let Sample { tau, phi, phi_velocity, ground_acceleration, state } = sample;
        Self { tau, t: tau / p, phi, theta: phi * degrees, phi_velocity, ground_acceleration, state }
    }
}

impl Arguments {
    fn asked(&self, scene: &Scene) -> anyhow::Result<Asked> {
        if scene.sine().is_err() {
            return Ok(Asked::Motion(scene.on_motion(self.until, self.termination(None)?)?));
        }
        let request = scene.response(self.until, Termination::Exact)?;
        let termination = self.termination(Some(&request.case))?.check()?;
        Ok(Asked::Sinusoid(Request { termination, ..request }))
    }

    /// That of a case; of none where the motion is no sinusoid under a block at rest.
    fn termination(&self, case: Option<&Case>) -> anyhow::Result<Termination> {
        ensure!(
            self.velocity_threshold.is_none() || self.termination == Scheme::Velocity,
            Invalid::new(
                "velocity-threshold",
                self.velocity_threshold.unwrap_or_default(),
                "only with --termination velocity"
            )
        );
        ensure!(
            self.closing == Closing::Impacts || self.termination == Scheme::Exact,
            Invalid::new("closing", "series", "only with --termination exact")
        );
        if let (Some(condition), true) = (self.condition, self.termination != Scheme::Chattering) {
            let typed = condition.to_possible_value();
            let typed = typed.as_ref().map_or("", PossibleValue::get_name);
            return Err(Invalid::new("condition", typed, "only with --termination chattering").into());
        }
        Ok(match self.termination {
            Scheme::Exact => Termination::Exact,
            Scheme::Chattering => {
                let allowed = "of a sinusoid under a block at rest only";
                let case = case.ok_or_else(|| Invalid::new("termination", "chattering", allowed))?;
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
        if let (TableFormat::Csv, Some(impacts)) = (self.format, self.impacts) {
            return Err(Invalid::new("impacts", impacts, "only with --format json"));
        }
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

fn document<'a>(
    scene: &'a Scene,
    asked: &Asked,
    response: &Response,
    peak: Option<Peak>,
    impacts: Option<usize>,
) -> Document<'a> {
    let (case, motion) = match asked {
        Asked::Sinusoid(request) => (Some(CaseFacts::of(&request.case)), None),
        Asked::Motion(request) => {
            let duration = Some(request.motion.duration()).filter(|duration| duration.is_finite());
            let (eta, alpha) = (request.body.eta(), request.body.alpha());
            (None, Some(MotionFacts { ground: scene.ground_name(), eta, alpha, duration }))
        }
    };
    let degrees = scene.block.slenderness.to_degrees();
    let peak = peak.map(|Peak { time, rotation }| PeakRow { tau: time, phi: rotation, theta: rotation * degrees });
    Document {
        title: &scene.title,
        model: if scene.ask.model == Model::Linear { "linear" } else { "nonlinear" },
        case,
        motion,
        frequency_parameter: scene.block.frequency_parameter(),
        peak,
        bouts: response.bouts.iter().map(|bout| row(bout, asked.eta(), impacts)).collect(),
        rests: response.rests().into_iter().map(|(from, to)| RestRow { from, to }).collect(),
        end: response.end,
    }
}

fn row(bout: &Bout, eta: f64, impacts: Option<usize>) -> BoutRow {
    let uncertainty = Some(bout.uncertainty()).filter(|uncertainty| uncertainty.is_finite());
    let listed = impacts.map(|most| bout.impact_list(eta).take(most).collect::<Vec<_>>());
    BoutRow {
        from: bout.begin(),
        to: bout.end(),
        impacts: bout.impacts(),
        ending: bout.ending(),
        uncertainty,
        impact_times: listed.as_ref().map(|listed| listed.iter().map(|(time, ..)| *time).collect()),
        impact_velocities: listed.map(|listed| listed.iter().map(|(.., velocity)| *velocity).collect()),
    }
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
