mod document;
mod drawings;
mod proven;
mod told;

use std::{
    io::{self, IsTerminal as _},
    path::PathBuf,
};

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        closed::Closed,
        response::{Asked, BoutEnd, Request, Sample, State, Termination, Window},
        scene::{self, Scene},
    },
    panel,
    studies::{
        chattering_threshold::{Condition, chattering_threshold},
        response_chart::Drawn,
    },
};
use clap::{Args, ValueEnum, builder::PossibleValue};
use contract::{Case, Decline, Invalid, Oracle};
use serde::Serialize;

use super::{
    Status,
    case_flags::read_scene_as,
    flight_flags::FlightFlags,
    moment::Moment,
    numbers::{count, number},
    output::{json, note, print, print_csv, say},
};
use document::document;
use drawings::{Drawings, Files};

/// The whole response of a scene: rest, rocking, chattering into rest, rocking again, free rocking, overturning
///
/// A summary comes first, in seconds and degrees, on stderr where stdout is for other data. --svg and --html draw the response.
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
    #[command(flatten)]
    flights: FlightFlags,
    /// For enclosure: how many digits are to be proven, 1 to 100 [default: as many as a double holds]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    digits: Option<i64>,
    /// How chattering is ended: exactly, where its infinite sum accumulates; or by a scheme of the paper's Section 5.2
    #[arg(long, value_enum, default_value_t = Scheme::Exact)]
    termination: Scheme,
    /// For the velocity threshold: VelTol/(p alpha)
    #[arg(long, value_name = "V", allow_hyphen_values = true, value_parser = number)]
    velocity_threshold: Option<f64>,
    /// For the chattering threshold: the fit of the critical amplitude below which it applies [default: eq76]
    #[arg(long, value_enum)]
    condition: Option<Fit>,
    /// How the infinite sum is closed where chattering is ended exactly: from the list of impacts, or from the last one alone, by its local series [default: impacts]
    #[arg(long, value_enum)]
    closing: Option<Closing>,
    /// Follow the block to this time at the most: tau, as in 2.5, or seconds, as in 2.5s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    until: Option<Moment>,
    /// Print or draw the response from this time on, tau or seconds, to see more of a part
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    from: Option<Moment>,
    /// Print or draw it to this time, tau or seconds
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    to: Option<Moment>,
    /// Into how many steps the printed part is divided [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, MOST_STEPS>)]
    steps: Option<usize>,
    /// List the first N impacts of each time of rocking in the JSON document
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, MOST_STEPS>)]
    impacts: Option<usize>,
    #[command(flatten)]
    drawings: Drawings,
    /// Output format: the summary as text, the history as CSV, or what happens as JSON [default: text on a terminal and with --svg or --html, csv elsewhere]
    #[arg(long, value_enum)]
    format: Option<Format>,
}

/// How the response is printed. The summary goes to stderr where it is not what is asked for.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Csv,
    Json,
    /// JSON on one line, for answers that are collected
    JsonLine,
}

const MOST_STEPS: usize = 1_000_000;
/// As fine as a drawing shows.
const DRAWN_STEPS: usize = 2000;

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

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let scene = read_scene_as(&arguments.scene, arguments.model.as_deref())?;
    let files = arguments.check(&scene)?;
    if let Some(status) = proven::run(arguments, &scene, &files)? {
        return Ok(status);
    }
    if let Some(digits) = arguments.digits {
        return Err(Invalid::new("digits", digits, "only with --oracle enclosure").into());
    }
    let asked = arguments.asked(&scene)?;
    let oracle = match &asked {
        Asked::Sinusoid(request) => arguments.flights.on_sinusoid(scene.ask.model, request),
        Asked::Motion(request) => arguments.flights.on_motion(scene.ask.model, request),
    }?;
    let method = |oracle: &dyn Oracle| panel::method(oracle.name()).map(|method| method.name);
    let closes_itself = method(oracle.as_ref()) == method(panel::closing().as_ref());
    if let Some(closing) = arguments.closing.filter(|_| closes_itself) {
        let allowed = "only with an oracle that has no local series of its own, not with accumulation";
        return Err(Invalid::new("closing", typed(closing), allowed).into());
    }
    let oracle: Box<dyn Oracle> = match arguments.closing {
        None | Some(Closing::Impacts) => oracle,
        Some(Closing::Series) => {
            let closing = panel::closing();
            Box::new(Closed::new(format!("{} closed by {}", oracle.name(), closing.name()), oracle, closing))
        }
    };
    let oracle = oracle.as_ref();
    let declined = |decline: Decline| anyhow!("{} declines: {decline}", oracle.name());
    let response = asked.response(oracle).map_err(declined)?;
    let window = arguments.window(&scene, response.end)?;
    let peak = asked.peak(&response, oracle).map_err(declined)?;
    if let scene::Ground::Shaking(shaking) = &scene.ground {
        shaking.notes.iter().for_each(|said| note(format_args!("{said}")));
    }
    let account = scene.account(&response, peak)?;
    let (summary, rows) = (told::summary(&scene, &account, &response, oracle.name()), told::rows(&scene, &response));
    let samples = |steps| asked.samples(&response, oracle, &Window { steps, ..window }).map_err(declined);
    if !files.is_empty() {
        let (samples, eta) = (samples(DRAWN_STEPS)?, asked.eta());
        let drawn = Drawn { scene: &scene, response: &response, account: &account, samples: &samples, window, eta };
        let foot = format!("chattercheck {} by {}", env!("CARGO_PKG_VERSION"), oracle.name());
        files.write(&scene.title, &drawn.svg()?, &account, &rows, &foot)?;
    }
    let format = arguments.format(&files);
    if !matches!(format, Some(Format::Text)) {
        summary.iter().for_each(note);
    }
    match format {
        None => {}
        Some(Format::Text) => say(&(told::text(&summary, &rows) + "\n"))?,
        Some(Format::Json | Format::JsonLine) => {
            let document = document(&scene, &account, &asked, &response, peak, arguments.impacts);
            print(&json(&document, matches!(format, Some(Format::JsonLine)))?)?;
        }
        Some(Format::Csv) => {
            let (p, degrees) = (scene.block.frequency_parameter(), scene.block.slenderness.to_degrees());
            let samples = samples(window.steps)?;
            print_csv(&samples.into_iter().map(|sample| Row::of(sample, p, degrees)).collect::<Vec<_>>())?;
        }
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

/// A value of a list as it is typed.
fn typed(value: impl ValueEnum) -> String {
    let typed = value.to_possible_value();
    typed.as_ref().map_or("", PossibleValue::get_name).to_owned()
}

impl Arguments {
    fn asked(&self, scene: &Scene) -> anyhow::Result<Asked> {
        let until = self.until.map(|until| until.tau(scene.block.frequency_parameter()));
        if scene.sine().is_err() {
            return Ok(Asked::Motion(scene.on_motion(until, self.termination(None)?)?));
        }
        let request = scene.response(until, Termination::Exact)?;
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
        if let (Some(closing), true) = (self.closing, self.termination != Scheme::Exact) {
            return Err(Invalid::new("closing", typed(closing), "only with --termination exact").into());
        }
        if let (Some(condition), true) = (self.condition, self.termination != Scheme::Chattering) {
            return Err(Invalid::new("condition", typed(condition), "only with --termination chattering").into());
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

    /// What is printed; nothing where stdout is for a drawing.
    fn format(&self, files: &Files) -> Option<Format> {
        let usual = if io::stdout().is_terminal() || !files.is_empty() { Format::Text } else { Format::Csv };
        if files.take_stdout() { None } else { Some(self.format.unwrap_or(usual)) }
    }

    /// Refuses what is not used by what is printed and drawn, and files that can't be written.
    fn check(&self, scene: &Scene) -> anyhow::Result<Files> {
        let record = match &scene.ground {
            scene::Ground::Shaking(shaking) => shaking.file.as_deref(),
            scene::Ground::Sinusoid(_) => None,
        };
        let scene = ("it has to be another file than the scene", self.scene.as_path());
        let record = record.map(|record| ("it has to be another file than the record of the scene", record));
        let files = self.drawings.check(&[scene].into_iter().chain(record).collect::<Vec<_>>())?;
        if let (Some(format), true) = (self.format, files.take_stdout()) {
            return Err(Invalid::new("format", typed(format), "none where - is the file of --svg or --html").into());
        }
        let format = self.format(&files);
        let is_csv = matches!(format, Some(Format::Csv));
        let is_json = matches!(format, Some(Format::Json | Format::JsonLine));
        let of_part =
            |moment: Option<Moment>| moment.filter(|_| !is_csv && files.is_empty()).map(|moment| moment.to_string());
        let unused = [
            ("from", of_part(self.from), "only with --format csv, --svg or --html"),
            ("to", of_part(self.to), "only with --format csv, --svg or --html"),
            ("steps", self.steps.filter(|_| !is_csv).map(|steps| steps.to_string()), "only with --format csv"),
            (
                "impacts",
                self.impacts.filter(|_| !is_json).map(|impacts| impacts.to_string()),
                "only with --format json",
            ),
        ];
        match unused.into_iter().find_map(|(field, value, allowed)| Some(Invalid::new(field, value?, allowed))) {
            Some(unused) => Err(unused.into()),
            None => Ok(files),
        }
    }

    fn window(&self, scene: &Scene, end: f64) -> Result<Window, Invalid> {
        let tau = |moment: Option<Moment>| moment.map(|moment| moment.tau(scene.block.frequency_parameter()));
        let (from, to) = (tau(self.from).unwrap_or(0.0), tau(self.to).unwrap_or(end));
        let typed = |moment: Option<Moment>, tau: f64| moment.map_or(format!("{tau:?}"), |moment| moment.to_string());
        if !(from >= 0.0 && from < end) && end > 0.0 {
            return Err(Invalid::new("from", typed(self.from, from), "from 0 to the end of the response"));
        }
        if !(to > from && to <= end) && end > 0.0 {
            return Err(Invalid::new("to", typed(self.to, to), "after --from, up to the end of the response"));
        }
        let steps = self.steps.unwrap_or(1000);
        if !(1..=MOST_STEPS).contains(&steps) {
            return Err(Invalid::new("steps", steps, "1 to 1000000"));
        }
        Ok(Window { from, to, steps })
    }
}
