//! What every bench of stepping starts with: the workload, and the check of an answer against the proven impacts. An answer that is wrong aborts
//! the bench: its speed would mean nothing.
#![allow(dead_code)] // each bench uses its part

use closed_form::batch::{Batch, InstructionSet, Rows, Sequence, Tally};
use contract::{Case, History, Model, Normalisation, Slenderness};
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};
use serde::Deserialize;

/// What is used of a row of the table of proven impacts.
#[derive(Deserialize)]
struct ProvenImpact {
    epsilon: f64,
    omega: f64,
    eta: f64,
    alpha: Option<f64>,
    normalisation: Option<String>,
    n: usize,
    interval: String,
}

/// The table of proven impacts, from the folder of this package or that of the workspace.
fn proven_impacts() -> csv::Reader<std::fs::File> {
    let package = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let paths = ["data", "../../data"].map(|data| package.join(data).join("reference/proven_impacts.csv"));
    let path = paths.iter().find(|path| path.exists()).expect("the table of reference");
    csv::Reader::from_path(path).expect("the table of reference")
}

/// How many impacts of each case of the workload.
pub const IMPACTS: usize = 60;

/// The workload: seeded cases with `a` in [1.005, 1.035], `ω` in [0.5, 8], `η` in [0.80, 0.95], 60 impacts of each.
pub fn workload(cases: usize) -> Vec<Case> {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[6; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let strategy = (1.005..1.035, 0.5..8.0, 0.80..0.95).prop_map(|(a, omega, eta)| {
        let slenderness = Slenderness::new(0.1, Normalisation::Threshold).expect("in range");
        Case::from_amplitude(a, omega, eta).expect("in range").with_slenderness(slenderness)
    });
    (0..cases).map(|_| strategy.new_tree(&mut runner).expect("a case").current()).collect()
}

/// Makes sure that an oracle has the proven impacts of the model that it solves, each interval to within `tolerance`, relative.
pub fn verify_impacts(name: &str, model: Model, run: &dyn Fn(&Case) -> Option<History>, tolerance: f64) {
    let mut compared = 0;
    for row in proven_impacts().deserialize() {
        let row: ProvenImpact = row.expect("a row of the table");
        let case = Case::from_epsilon(row.epsilon, row.omega, row.eta).expect("a case");
        let case = case.with_max_impacts(row.n).expect("in range");
        let case = match (model, row.alpha, row.normalisation.as_deref()) {
            (Model::Linear, None, _) => case,
            (Model::Nonlinear, Some(alpha), Some("threshold")) => {
                case.with_slenderness(Slenderness::new(alpha, Normalisation::Threshold).expect("in range"))
            }
            _ => continue,
        };
        let Some(history) = run(&case) else { continue };
        let exact: f64 = row.interval.parse().expect("a number");
        let Some(impact) = history.impacts.get(row.n - 1) else { panic!("{name} has no impact {} of {case:?}", row.n) };
        let error = (impact.interval / exact - 1.0).abs();
        assert!(error <= tolerance, "{name} is off by {error:e} at impact {} of {case:?}", row.n);
        compared += 1;
    }
    assert!(compared >= 100, "{name} was compared with {compared} impacts only");
}

/// The workload as a batch, with room for its answer.
pub struct Batched {
    columns: [Vec<f64>; 3],
    rows: [Vec<f64>; 3],
    pub sequences: Vec<Sequence>,
    impacts: usize,
}

impl Batched {
    pub fn new(cases: &[Case], impacts: usize) -> Self {
        let columns = [Case::epsilon, Case::omega, Case::eta].map(|of| cases.iter().map(of).collect());
        let row = vec![0.0; cases.len() * impacts];
        let rows = [row.clone(), row.clone(), row];
        Self { columns, rows, sequences: vec![Sequence::default(); cases.len()], impacts }
    }

    pub fn run(&mut self, set: InstructionSet) -> Tally {
        let [epsilon, omega, eta] = &self.columns;
        let [time, interval, velocity] = &mut self.rows;
        let batch = Batch::new(epsilon, omega, eta, self.impacts).expect("cases").with_instruction_set(set);
        batch.run(Rows { time, interval, velocity, sequences: &mut self.sequences }).expect("rows")
    }

    /// Makes sure that the answer for the table of reference is right, to within `tolerance` in each interval.
    pub fn verify(set: InstructionSet, tolerance: f64) {
        let run = |case: &Case| {
            let mut batched = Self::new(&[*case], case.max_impacts());
            batched.run(set);
            let [time, interval, velocity] = &batched.rows;
            let count = batched.sequences.first().map_or(0, |sequence| sequence.impacts);
            let uncertainty = contract::Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
            let impacts = time.iter().zip(interval).zip(velocity).take(count).map(|((time, interval), velocity)| {
                contract::Impact { time: *time, interval: *interval, velocity: *velocity, uncertainty }
            });
            let ending = batched.sequences.first()?.ending;
            Some(History { impacts: impacts.collect(), ending, chattering_time: None })
        };
        verify_impacts(&format!("batch/{set:?}"), Model::Linear, &run, tolerance);
    }
}

/// A pool of one thread, whatever else rayon is set to.
pub fn one_thread() -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread")
}
