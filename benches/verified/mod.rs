//! What the benches start with: the workload, and the check of an answer against the tables of reference. An answer that is wrong aborts the
//! bench: its speed would mean nothing.
#![allow(dead_code, unused_imports)] // each bench uses its part

#[path = "../../oracles/closed_form/benches/workload/mod.rs"]
mod workload;

use std::path::Path;

use chattercheck::{measure::zeno, studies::reference::ProvenTimeRow};
use contract::{Case, Oracle};
use serde::de::DeserializeOwned;

pub use workload::{Batched, IMPACTS, one_thread, verify_impacts, workload};

fn table<Row: DeserializeOwned>(name: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/reference").join(name);
    let mut reader = csv::Reader::from_path(path).expect("the table of reference");
    reader.deserialize().collect::<Result<_, _>>().expect("rows of the table")
}

/// A case whose chattering time is proven, with that time; `distance` is how far its amplitude is from the critical one, as a share of
/// `a_cr - 1`.
pub struct Proven {
    pub case: Case,
    pub time: f64,
    pub distance: f64,
}

/// Those at `ω = 2`, `η = 0.92` in the linear model, from the farthest to the nearest.
pub fn proven() -> Vec<Proven> {
    let critical = 0.038_015_538_7; // of that pair; data/reference/critical_amplitudes.csv
    let rows: Vec<ProvenTimeRow> = table("proven_chattering_times.csv");
    let linear = rows.into_iter().filter(|row| row.alpha.is_none() && row.omega == 2.0 && row.eta == 0.92);
    let found: Vec<_> = linear
        .filter_map(|row| {
            let time = row.tau_ch?.parse().expect("a number");
            let case = Case::from_epsilon(row.epsilon, row.omega, row.eta).expect("a case");
            Some(Proven { case, time, distance: 1.0 - row.epsilon / critical })
        })
        .collect();
    assert!(found.len() >= 5, "{} proven chattering times", found.len());
    found
}

/// The chattering time by an oracle, if it has one.
pub fn chattering_time(oracle: &dyn Oracle, case: &Case) -> Option<f64> {
    let history = oracle.history(case).ok()?;
    zeno::close(&history, case.eta()).map(|time| time.value)
}
