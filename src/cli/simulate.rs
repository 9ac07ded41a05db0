use anyhow::{anyhow, bail};
use chattercheck::{
    motion::plan::Question,
    panel::{self, Method, Refused, Setting},
};
use clap::{Args, ValueEnum};
use contract::{Case, Ending, History, Oracle};
use serde::Serialize;

use super::{
    Status,
    case_flags::CaseFlags,
    oracle_flags::{Asked, OracleFlags},
    output,
};

/// One impact history
///
/// CSV columns n, tau, interval, velocity, sign: row 0 is initiation; velocity is that just after impact n, sign that of the flight that follows.
/// The JSON document also has what the oracle claims: tau_uncertainty (absolute), interval_uncertainty and velocity_uncertainty (relative).
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    case: CaseFlags,
    #[command(flatten)]
    oracle: OracleFlags,
    /// List this many impacts at the most
    #[arg(long, value_name = "N", default_value_t = Case::DEFAULT_IMPACTS, allow_negative_numbers = true)]
    impacts: usize,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Csv,
    Json,
}

/// Row `n = 0` is initiation; `velocity` is that just after impact `n`, `sign` that of the flight that follows.
#[derive(Serialize)]
struct Row {
    n: usize,
    tau: f64,
    interval: Option<f64>,
    velocity: f64,
    sign: i8,
}

/// A row of the JSON document, with what the oracle claims; `null` where it claims nothing.
#[derive(Serialize)]
struct ClaimedRow {
    #[serde(flatten)]
    row: Row,
    /// Absolute.
    tau_uncertainty: Option<f64>,
    /// Relative.
    interval_uncertainty: Option<f64>,
    /// Relative.
    velocity_uncertainty: Option<f64>,
}

#[derive(Serialize)]
struct Document<'a> {
    oracle: &'a str,
    rocks: bool,
    ending: String,
    impacts: Vec<ClaimedRow>,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let case = arguments.case.case(arguments.impacts)?;
    let oracle = match arguments.oracle.asked(&arguments.case, &case, None)? {
        Asked::Auto(question) => arguments.stepper(&question)?,
        Asked::Oracle(oracle) => oracle,
    };
    let history = oracle.history(&case).map_err(|decline| anyhow!("{} declines: {decline}", oracle.name()))?;
    let rows = rows(&history);
    match arguments.format {
        Format::Csv => output::write(|stdout| {
            // Without rows there would be no head.
            let mut csv = csv::WriterBuilder::new().has_headers(false).from_writer(stdout);
            csv.write_record(["n", "tau", "interval", "velocity", "sign"])?;
            rows.iter().try_for_each(|row| csv.serialize(row))?;
            csv.flush()
        })?,
        Format::Json => {
            let rocks = history.ending != Ending::NeverRocks;
            let document = Document {
                oracle: oracle.name(),
                rocks,
                ending: history.ending.to_string(),
                impacts: claimed(rows, &history),
            };
            output::print(&(serde_json::to_string_pretty(&document)? + "\n"))?;
        }
    }
    output::note(format_args!("{}: {} after {} impacts", oracle.name(), history.ending, history.impacts.len()));
    Ok(if matches!(history.ending, Ending::Lost(_)) { Status::Disagreed } else { Status::Well })
}

impl Arguments {
    /// For impacts, other than for a chattering time, `auto` takes flights of the very equation that is asked for.
    fn stepper(&self, question: &Question) -> anyhow::Result<Box<dyn Oracle>> {
        if let Some(tolerance) = self.oracle.tolerance() {
            let uses = |method: &Method| method.uses(Setting::Tolerance);
            return Err(Refused::unused("tolerance", tolerance, "auto (for impacts)", uses).into());
        }
        if question.request.is_some() {
            bail!(
                "phase or duration (of the scene) is not used by simulate, which is for a motion that passes the threshold and goes on; see `chattercheck scene` with what = [\"impact-times\"]"
            );
        }
        Ok(panel::stepper_of(panel::model_of(&question.case)))
    }
}

/// The rows with the claims of the oracle; initiation is exact.
fn claimed(rows: Vec<Row>, history: &History) -> Vec<ClaimedRow> {
    let claims = history.impacts.iter().map(|impact| Some(impact.uncertainty));
    let finite = |claim: f64| Some(claim).filter(|claim| claim.is_finite());
    rows.into_iter()
        .zip(std::iter::once(None).chain(claims))
        .map(|(row, claim)| ClaimedRow {
            row,
            tau_uncertainty: claim.and_then(|claim| finite(claim.time)),
            interval_uncertainty: claim.and_then(|claim| finite(claim.interval)),
            velocity_uncertainty: claim.and_then(|claim| finite(claim.velocity)),
        })
        .collect()
}

/// Nothing at all if the block never rocks, else initiation and the impacts.
fn rows(history: &History) -> Vec<Row> {
    if history.ending == Ending::NeverRocks {
        return Vec::new();
    }
    let initiation = Row { n: 0, tau: 0.0, interval: None, velocity: 0.0, sign: -1 };
    let impacts = history.impacts.iter().enumerate().map(|(index, impact)| Row {
        n: index + 1,
        tau: impact.time,
        interval: Some(impact.interval),
        velocity: impact.velocity,
        sign: if index % 2 == 0 { 1 } else { -1 },
    });
    std::iter::once(initiation).chain(impacts).collect()
}
