use std::io::Write as _;

use anyhow::anyhow;
use clap::{Args, ValueEnum};
use contract::{Case, Ending, History};
use serde::Serialize;

use super::{
    Verdict,
    case_flags::{CaseFlags, OracleFlags},
};

/// One impact history
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

#[derive(Serialize)]
struct Document<'a> {
    oracle: &'a str,
    rocks: bool,
    ending: String,
    impacts: Vec<Row>,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Verdict> {
    let case = arguments.case.case(arguments.impacts)?;
    let oracle = arguments.oracle.oracle(&case)?;
    let history = oracle.history(&case).map_err(|decline| anyhow!("{} declines: {decline}", oracle.name()))?;
    let rows = rows(&history);
    let mut stdout = std::io::stdout().lock();
    match arguments.format {
        Format::Csv => {
            let mut csv = csv::WriterBuilder::new().has_headers(false).from_writer(stdout);
            csv.write_record(["n", "tau", "interval", "velocity", "sign"])?;
            for row in &rows {
                csv.serialize(row)?;
            }
            csv.flush()?;
        }
        Format::Json => {
            let rocks = history.ending != Ending::NeverRocks;
            let document = Document { oracle: oracle.name(), rocks, ending: history.ending.to_string(), impacts: rows };
            writeln!(stdout, "{}", serde_json::to_string_pretty(&document)?)?;
        }
    }
    eprintln!("{}: {} after {} impacts", oracle.name(), history.ending, history.impacts.len());
    Ok(Verdict::Well)
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
