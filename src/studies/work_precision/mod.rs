//! Speed against accuracy: the error of the chattering time, and of impact 40, against what they cost, at three distances from the critical amplitude.
//!
//! The truth is the enclosure's. What it costs is given in seconds on this machine and in work that is the same on every machine: impacts, and
//! evaluations of the right-hand side. A setting that fails is a row without an error, and why.

mod beside;
mod charts;
mod methods;

use std::{collections::BTreeMap, hint::black_box, time::Instant};

use contract::{Case, Decline, Invalid, Model};
use serde::{Deserialize, Serialize};

use crate::{
    measure::critical,
    studies::chart::{csv_in_words, csv_text},
};

pub use beside::{Stranger, measure_beside};
pub use charts::{BESIDE, CHARTS};
use methods::{Contender, Found, methods};

/// One setting of one method at one distance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorkRow {
    /// How far the amplitude is from the threshold to the critical one.
    pub share: String,
    /// `a - 1`.
    pub epsilon: f64,
    /// The method: one line of a chart.
    pub family: String,
    /// Its setting: one point.
    pub setting: String,
    /// How many impacts it took.
    pub impacts: Option<usize>,
    /// How often it evaluated the right-hand side.
    pub rhs: Option<u64>,
    /// How long it took: the best of some repeats, in seconds.
    pub seconds: f64,
    /// The relative error of its chattering time.
    pub tau_ch_error: Option<f64>,
    /// The relative error of its time of impact 40.
    pub impact_40_error: Option<f64>,
    /// How it failed, if it did.
    pub outcome: String,
}

/// What is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Scope {
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// The distances: `(a - 1)/(a_cr - 1)` in percent, and the number of impacts that the solvers are asked for there.
    pub percents: Vec<(f64, usize)>,
    /// A setting is repeated until it has taken so many seconds.
    pub patience: f64,
}

impl Default for Scope {
    /// The block of the paper's figures at three distances, with impacts enough to close the sum to nearly all digits.
    fn default() -> Self {
        Self { omega: 2.0, eta: 0.92, percents: vec![(50.0, 80), (90.0, 120), (99.9, 200)], patience: 0.1 }
    }
}

/// Asks everything. `done` is called after each row.
///
/// # Errors
/// When a quantity is out of range.
pub fn measure(request: &Scope, done: impl Fn()) -> Result<Vec<WorkRow>, Decline> {
    measure_some(request, |_| true, done)
}

/// The cases, each with how far it is on the way to the critical amplitude.
fn cases(request: &Scope) -> Result<Vec<(String, Case)>, Decline> {
    let Scope { omega, eta, .. } = *request;
    let invalid = |why: contract::Invalid| Decline::NotConvergent { why: why.to_string() };
    let critical = critical::interpolated(omega, eta).map_err(invalid)?;
    let case = |(percent, impacts): &(f64, usize)| {
        let case = Case::from_epsilon(percent / 100.0 * critical, omega, eta);
        let case = case.and_then(|case| case.with_max_impacts(*impacts)).map_err(invalid)?;
        Ok((format!("{percent} %"), case))
    };
    request.percents.iter().map(case).collect()
}

/// Asks the methods whose family is `wanted`.
fn measure_some(request: &Scope, wanted: impl Fn(&str) -> bool, done: impl Fn()) -> Result<Vec<WorkRow>, Decline> {
    let mut rows = Vec::new();
    for (share, case) in cases(request)? {
        let truth = Truth::of(&case)?;
        for method in methods(&case).into_iter().filter(|method| wanted(&method.family)) {
            let mut row = truth.row(&case, &method);
            row.share = share.clone();
            row.seconds = seconds(request.patience, || drop(black_box((method.run)(black_box(&case)))));
            rows.push(row);
            done();
        }
    }
    Ok(rows)
}

/// The columns of the rows.
const COLUMNS: [&str; 10] = [
    "share",
    "epsilon",
    "family",
    "setting",
    "impacts",
    "rhs",
    "seconds",
    "tau_ch_error",
    "impact_40_error",
    "outcome",
];

/// The rows of peers, which have the same columns.
///
/// # Errors
/// When the text is not CSV with these columns, has no row, or a value of a row is out of range; it says in which line.
pub fn read(text: &str) -> Result<Vec<WorkRow>, Unreadable> {
    let in_words = |error: csv::Error| Unreadable::Csv(csv_in_words(&error));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().map_err(in_words)?.clone();
    if COLUMNS.iter().any(|column| !head.iter().any(|there| there == *column)) {
        return Err(Unreadable::Columns { head: head.iter().collect::<Vec<_>>().join(", ") });
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(in_words)?;
        let line = record.position().map_or(0, csv::Position::line);
        let row: WorkRow = record.deserialize(Some(&head)).map_err(|error| match error.kind() {
            csv::ErrorKind::Deserialize { err, .. } => {
                let place = err.field().and_then(|field| usize::try_from(field).ok());
                let of =
                    |from: &csv::StringRecord| place.and_then(|place| from.get(place)).unwrap_or_default().to_owned();
                Unreadable::Cell { line, column: of(&head), value: of(&record) }
            }
            _ => in_words(error),
        })?;
        row.check().map_err(|why| Unreadable::Row { line, why })?;
        rows.push(row);
    }
    if rows.is_empty() { Err(Unreadable::Empty) } else { Ok(rows) }
}

/// Why rows of peers can't be used.
#[derive(Debug, thiserror::Error)]
pub enum Unreadable {
    /// No CSV.
    #[error("{0}")]
    Csv(String),
    /// Columns are missing.
    #[error("columns = {head} are outside the allowed: {}", COLUMNS.join(", "))]
    Columns {
        /// Those of the head.
        head: String,
    },
    /// Something else where a number should be.
    #[error(
        "line {line}: {column} = {value} is outside the allowed range: a number, or a whole one of impacts and evaluations"
    )]
    Cell {
        /// Of the file, from 1.
        line: u64,
        /// The column.
        column: String,
        /// What stands there.
        value: String,
    },
    /// There are no rows.
    #[error("there are no rows")]
    Empty,
    /// A value is out of range.
    #[error("line {line}: {why}")]
    Row {
        /// Of the file, from 1.
        line: u64,
        /// Which, and what is allowed.
        why: Invalid,
    },
}

impl WorkRow {
    /// Refuses what the charts have no place for.
    fn check(&self) -> Result<(), Invalid> {
        for (field, value) in [("epsilon", self.epsilon), ("seconds", self.seconds)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Invalid::new(field, value, "a finite number above 0"));
            }
        }
        for (field, error) in [("tau_ch_error", self.tau_ch_error), ("impact_40_error", self.impact_40_error)] {
            if let Some(error) = error.filter(|error| !(*error >= 0.0 && error.is_finite())) {
                return Err(Invalid::new(field, error, "empty, or a finite number not below 0"));
            }
        }
        let mut charts = Scope::default().percents.into_iter().map(|(percent, _)| format!("{percent} %"));
        if charts.any(|share| share == self.share) {
            Ok(())
        } else {
            Err(Invalid::new("share", &self.share, "50 %, 90 % or 99.9 %"))
        }
    }
}

/// The file that the charts are drawn from.
///
/// # Errors
/// Never, as far as rows of numbers and names can be written.
pub fn files(rows: &[WorkRow]) -> Result<BTreeMap<&'static str, String>, csv::Error> {
    Ok(BTreeMap::from([("work_precision.csv", csv_text(rows)?)]))
}

/// What is true of a case.
struct Truth {
    chattering_time: Option<f64>,
    impact_40: Option<f64>,
}

impl Truth {
    fn of(case: &Case) -> Result<Self, Decline> {
        let proven = enclosure::Enclosure::new(Model::Linear).enclose(case)?.history();
        Ok(Self {
            chattering_time: proven.chattering_time.map(|time| time.value),
            impact_40: proven.impacts.get(39).map(|impact| impact.time),
        })
    }

    /// The answer, before it is timed.
    fn row(&self, case: &Case, method: &Contender) -> WorkRow {
        let Found { chattering_time, impact_40, impacts, evaluations, width, outcome } = (method.run)(case);
        // What is proven is as far off as it is wide; anything else as far as it is from what is proven.
        WorkRow {
            share: String::new(),
            epsilon: case.epsilon(),
            family: method.family.clone(),
            setting: method.setting.clone(),
            impacts,
            rhs: evaluations,
            seconds: f64::NAN,
            tau_ch_error: width.map(|width| rounded(width.0)).or_else(|| off(chattering_time, self.chattering_time)),
            impact_40_error: width.map(|width| rounded(width.1)).or_else(|| off(impact_40, self.impact_40)),
            outcome,
        }
    }
}

/// How far what was found is from what is true, relative.
fn off(found: Option<f64>, exact: Option<f64>) -> Option<f64> {
    Some(rounded((found? / exact? - 1.0).abs()))
}

/// The best of some repeats.
fn seconds(patience: f64, run: impl Fn()) -> f64 {
    let (mut best, mut total) = (f64::INFINITY, 0.0);
    for _ in 0..MOST_REPEATS {
        let start = Instant::now();
        run();
        let took = start.elapsed().as_secs_f64();
        best = best.min(took);
        total += took;
        if total > patience {
            break;
        }
    }
    rounded(best)
}

/// To three digits, which is more than such numbers say.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// How often a setting is repeated at the most.
const MOST_REPEATS: usize = 50;
