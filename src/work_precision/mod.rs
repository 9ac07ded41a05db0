//! Speed against accuracy: the error of the chattering time, and of impact 40, against what they cost, at three distances from the critical amplitude.
//!
//! The truth is the enclosure's. What it costs is given in seconds on this machine and in work that is the same on every machine: impacts, and
//! evaluations of the right-hand side. A setting that fails is a row without an error, and why.

mod charts;
mod methods;

use std::{collections::BTreeMap, hint::black_box, time::Instant};

use contract::{Case, Decline, Model};
use serde::{Deserialize, Serialize};

use crate::{chart::csv_text, critical, panel};

pub use charts::CHARTS;
use methods::{Found, Method, methods};

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

/// The frequency ratio and the restitution of all cases.
pub const OMEGA_ETA: (f64, f64) = (2.0, 0.92);

/// A distance: its name, `(a - 1)/(a_cr - 1)`, and the number of impacts that the solvers are asked for, enough to close the sum to nearly all digits.
const SHARES: [(&str, f64, usize); 3] = [("50 %", 0.5, 80), ("90 %", 0.9, 120), ("99.9 %", 0.999, 200)];

/// A row is repeated until it has taken so long, or so often.
const LONG_ENOUGH: (f64, usize) = (0.05, 50);

/// Asks everything. `done` is called after each row.
///
/// # Errors
/// When the enclosure declines a case, which it does not.
pub fn measure(done: impl Fn()) -> Result<Vec<WorkRow>, Decline> {
    let (omega, eta) = OMEGA_ETA;
    let invalid = |why: contract::Invalid| Decline::NotConvergent { why: why.to_string() };
    let critical = critical::interpolated(omega, eta).map_err(invalid)?;
    let mut rows = Vec::new();
    for (name, share, impacts) in SHARES {
        let case = Case::from_epsilon(share * critical, omega, eta).and_then(|case| case.with_max_impacts(impacts));
        let case = case.map_err(invalid)?;
        let truth = Truth::of(&case)?;
        for method in methods(&case) {
            rows.push(truth.row(name, &case, &method));
            done();
        }
    }
    Ok(rows)
}

/// The files: the rows measured here, and those of the peers, which have the same columns.
///
/// # Errors
/// When the peers' rows are not such rows.
pub fn files(mut rows: Vec<WorkRow>, peers: Option<&str>) -> Result<BTreeMap<&'static str, String>, csv::Error> {
    if let Some(peers) = peers {
        let mut reader = csv::Reader::from_reader(peers.as_bytes());
        rows.extend(reader.deserialize().collect::<Result<Vec<WorkRow>, _>>()?);
    }
    Ok(BTreeMap::from([("work_precision.csv", csv_text(&rows)?)]))
}

/// What is true of a case.
struct Truth {
    chattering_time: Option<f64>,
    impact_40: Option<f64>,
}

impl Truth {
    fn of(case: &Case) -> Result<Self, Decline> {
        let proven = panel::enclosure_of(Model::Linear).enclose(case)?.history();
        Ok(Self {
            chattering_time: proven.chattering_time.map(|time| time.value),
            impact_40: proven.impacts.get(39).map(|impact| impact.time),
        })
    }

    /// First the answer, then how long it takes.
    fn row(&self, share: &str, case: &Case, method: &Method) -> WorkRow {
        let Found { chattering_time, impact_40, impacts, evaluations, width, outcome } = (method.run)(case);
        // What is proven is as far off as it is wide; anything else as far as it is from what is proven.
        let off = |found: Option<f64>, exact: Option<f64>| Some((found? / exact? - 1.0).abs());
        WorkRow {
            share: share.to_owned(),
            epsilon: case.epsilon(),
            family: method.family.clone(),
            setting: method.setting.clone(),
            impacts,
            rhs: evaluations,
            seconds: seconds(|| drop(black_box((method.run)(black_box(case))))),
            tau_ch_error: width.map(|width| width.0).or_else(|| off(chattering_time, self.chattering_time)),
            impact_40_error: width.map(|width| width.1).or_else(|| off(impact_40, self.impact_40)),
            outcome,
        }
    }
}

/// The best of some repeats, to three digits.
fn seconds(run: impl Fn()) -> f64 {
    let (long, often) = LONG_ENOUGH;
    let (mut best, mut total) = (f64::INFINITY, 0.0);
    for _ in 0..often {
        let start = Instant::now();
        run();
        let took = start.elapsed().as_secs_f64();
        best = best.min(took);
        total += took;
        if total > long {
            break;
        }
    }
    format!("{best:.2e}").parse().unwrap_or(best)
}
