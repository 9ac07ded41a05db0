use anyhow::anyhow;
use chattercheck::{
    motion::response::BoutEnd,
    panel::{self, Method, Refused, Setting},
    plan::Question,
};
use clap::Args;
use contract::{Case, Ending, History, Impact, Limit, Oracle};
use serde::Serialize;

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::CaseFlags,
    estimate,
    followed::{Followed, follow, on_motion},
    motion_facts::Facts,
    numbers::count,
    oracle_flags::{Asked, OracleFlags},
    output::{self, TableFormat, of_csv},
};

/// One impact history
///
/// CSV columns n, tau, interval, velocity, sign: row 0 is initiation; velocity is that just after impact n, sign that of the flight that follows.
/// For a scene that is more than a case (its motion starts elsewhere than at the threshold or ends, or the block rocks on after half a period) tau is counted from the
/// start of the motion, as in `chattercheck response`, and the impacts are those of the first rocking.
/// The JSON document also has what the oracle claims: tau_uncertainty (absolute), interval_uncertainty and velocity_uncertainty (relative).
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    case: CaseFlags,
    #[command(flatten)]
    oracle: OracleFlags,
    /// List this many impacts at the most
    #[arg(long, value_name = "N", default_value_t = Case::DEFAULT_IMPACTS, allow_negative_numbers = true, value_parser = count::<1, { Case::MOST_IMPACTS }>)]
    impacts: usize,
    /// Output format
    #[arg(long, value_enum, default_value_t = TableFormat::Csv)]
    format: TableFormat,
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
    #[serde(flatten)]
    asked: Facts,
    oracle: &'a str,
    rocks: bool,
    ending: String,
    impacts: Vec<ClaimedRow>,
}

/// The impacts to be printed.
struct Listed {
    history: History,
    start: Start,
    /// Whether rounding alone would have changed how it ends.
    unsure: bool,
}

/// When rocking begins, and to which side.
#[derive(Clone, Copy)]
struct Start {
    tau: f64,
    sign: i8,
    /// As it is, of a block that is in motion.
    velocity: f64,
}

impl Start {
    /// That of a case.
    const OF_CASE: Self = Self { tau: 0.0, sign: -1, velocity: 0.0 };
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    if let Some((oracle, followed)) = on_motion(&arguments.case, &arguments.oracle, None)? {
        return arguments.print(&oracle, followed.facts()?, arguments.in_scene(&followed));
    }
    let case = arguments.case.case(arguments.impacts)?;
    let oracle = match arguments.oracle.asked(&arguments.case, &case, None)? {
        Asked::Auto(question) => arguments.stepper(&question)?,
        Asked::Oracle(oracle) => oracle,
    };
    estimate::impacts(oracle.as_ref(), &case);
    let listed = arguments.listed(oracle.as_ref(), &case)?;
    arguments.print(oracle.name(), Facts::Case(CaseFacts::of(&case)), listed)
}

impl Arguments {
    /// The impacts as they are asked for, and the status.
    fn print(&self, oracle: &str, asked: Facts, Listed { history, start, unsure }: Listed) -> anyhow::Result<Status> {
        let rows = rows(&history, start);
        let ending =
            if unsure { "unsure: rounding alone changes how it ends".to_owned() } else { history.ending.to_string() };
        match self.format {
            TableFormat::Csv => output::write(|stdout| {
                // Without rows there would be no head.
                let mut csv = csv::WriterBuilder::new().has_headers(false).from_writer(stdout);
                csv.write_record(["n", "tau", "interval", "velocity", "sign"]).map_err(of_csv)?;
                rows.iter().try_for_each(|row| csv.serialize(row)).map_err(of_csv)?;
                csv.flush()
            })?,
            TableFormat::Json | TableFormat::JsonLine => {
                let rocks = history.ending != Ending::NeverRocks;
                let document =
                    Document { asked, oracle, rocks, ending: ending.clone(), impacts: claimed(rows, &history) };
                output::print(&output::json(&document, matches!(self.format, TableFormat::JsonLine))?)?;
            }
        }
        output::note(format_args!("{oracle}: {ending} after {} impacts", history.impacts.len()));
        Ok(if unsure || matches!(history.ending, Ending::Lost(_)) { Status::Disagreed } else { Status::Well })
    }

    /// The impacts of the case, or of the first rocking of the scene.
    fn listed(&self, oracle: &dyn Oracle, case: &Case) -> anyhow::Result<Listed> {
        if let Some(followed) = follow(&self.case, oracle, None)? {
            return Ok(self.in_scene(&followed));
        }
        let history = oracle.history(case).map_err(|decline| anyhow!("{} declines: {decline}", oracle.name()))?;
        match follow(&self.case, oracle, Some(history.ending))? {
            Some(followed) => Ok(self.in_scene(&followed)),
            None => Ok(Listed { history, start: Start::OF_CASE, unsure: false }),
        }
    }

    /// The impacts of the first rocking of a scene that is more than a case, with the claims of its response.
    fn in_scene(&self, followed: &Followed) -> Listed {
        let Some(bout) = followed.first() else {
            let history = History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None };
            return Listed { history, start: Start::OF_CASE, unsure: false };
        };
        let eta = followed.scene.block.restitution;
        let claims = bout.claims(&followed.moved, eta);
        let impacts = bout
            .impact_list(eta)
            .zip(claims)
            .take(self.impacts)
            .map(|((time, interval, velocity), uncertainty)| Impact { time, interval, velocity, uncertainty });
        let ending = match bout.outcome {
            BoutEnd::Complete { .. } | BoutEnd::VelocityThreshold | BoutEnd::ChatteringThreshold => Ending::AtRest,
            BoutEnd::Overturned => Ending::Overturned,
            BoutEnd::Cut => Ending::LimitReached(Limit::Time),
            BoutEnd::TooManyImpacts => Ending::LimitReached(Limit::Impacts),
            BoutEnd::Lost(loss) => Ending::Lost(loss),
        };
        let history = History { impacts: impacts.collect(), ending, chattering_time: None };
        let side = bout.flights.first().map_or(-1.0, |flight| flight.departure.side);
        let start = Start {
            tau: bout.begin(),
            sign: if bout.lobe.mirror * side > 0.0 { 1 } else { -1 },
            velocity: if bout.begin() == 0.0 { followed.scene.start.1 } else { 0.0 },
        };
        Listed { history, start, unsure: bout.is_unsure() }
    }

    /// For impacts, other than for a chattering time, `auto` takes flights of the very equation that is asked for.
    fn stepper(&self, question: &Question) -> anyhow::Result<Box<dyn Oracle>> {
        if let Some(tolerance) = self.oracle.tolerance() {
            let uses = |method: &Method| method.uses(Setting::Tolerance);
            return Err(Refused::unused("tolerance", tolerance, "auto (for impacts)", uses).into());
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
fn rows(history: &History, start: Start) -> Vec<Row> {
    if history.ending == Ending::NeverRocks {
        return Vec::new();
    }
    let initiation = Row { n: 0, tau: start.tau, interval: None, velocity: start.velocity, sign: start.sign };
    let impacts = history.impacts.iter().enumerate().map(|(index, impact)| Row {
        n: index + 1,
        tau: impact.time,
        interval: Some(impact.interval),
        velocity: impact.velocity,
        sign: if index % 2 == 0 { -start.sign } else { start.sign },
    });
    std::iter::once(initiation).chain(impacts).collect()
}
