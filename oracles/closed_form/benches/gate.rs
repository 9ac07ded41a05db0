//! The throughput gate: fails when stepping has become slower than what is recorded in `data/record/throughput.csv`, by more than is allowed there.
//!
//! A time says as much about the machine as about the program, so no time is compared. Where valgrind is installed, the instructions for one impact
//! are counted, which noise can't change. Elsewhere the time for one impact is divided by that of a fixed piece of plain arithmetic, measured
//! in turns with it, each the shortest of many short runs.
//!
//! ```text
//! cargo bench -p closed_form --bench gate                    compare
//! cargo bench -p closed_form --bench gate -- --planted 30    the same with 30 % of the work done twice: has to fail
//! cargo bench -p closed_form --bench gate -- --ratio         by the ratio of times even where valgrind is installed
//! cargo bench -p closed_form --bench gate -- --record        write the record anew
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

mod workload;

use std::{
    fmt,
    hint::black_box,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
    time::{Duration, Instant},
};

use closed_form::{ClosedForm, batch::InstructionSet};
use contract::{Case, Model, Oracle};
use serde::{Deserialize, Serialize};

use workload::{Batched, IMPACTS, one_thread, verify_impacts, workload};

/// What is gated: neither depends on which instruction sets a machine has beyond the baseline.
const PATHS: [&str; 3] = ["oracle", "scalar", "baseline"];

/// One row of the record.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Row {
    path: String,
    measure: Measure,
    /// Instructions for one impact, or its time by that of the fixed arithmetic.
    value: f64,
    /// What it may be larger by, as a share.
    allowed: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Measure {
    Instructions,
    Ratio,
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Instructions => "instructions",
            Self::Ratio => "ratio",
        })
    }
}

/// Work to be measured.
struct Work {
    path: String,
    cases: Vec<Case>,
    batched: Batched,
    /// A share of the cases that is done again, uncounted.
    planted: Batched,
}

impl Work {
    fn new(path: &str, count: usize, planted: f64) -> Self {
        let cases = workload(count);
        let again = cases.iter().take((planted * count as f64) as usize).copied().collect::<Vec<_>>();
        let batched = Batched::new(&cases, IMPACTS);
        Self { path: path.to_owned(), cases, batched, planted: Batched::new(&again, IMPACTS) }
    }

    /// Does the work once, and says how many impacts that were.
    fn run(&mut self) -> u64 {
        let set = match self.path.as_str() {
            "scalar" => InstructionSet::Scalar,
            "baseline" => InstructionSet::Baseline,
            "fastest" => InstructionSet::fastest(),
            _ => {
                for case in self.cases.iter().take(self.planted.sequences.len()) {
                    drop(black_box(ClosedForm.history(black_box(case))));
                }
                let run = |case| ClosedForm.history(black_box(case)).map_or(0, |history| history.impacts.len() as u64);
                return self.cases.iter().map(run).sum();
            }
        };
        black_box(self.planted.run(set));
        self.batched.run(set).impacts
    }
}

/// The fixed arithmetic: polynomials and quotients in a mix like that of a flight, each result the start of the next.
#[inline(never)]
fn arithmetic(rounds: u32) -> f64 {
    let mut s = black_box(0.3f64);
    for _ in 0..rounds {
        let z = s * s;
        let (mut value, mut slope) = (1.0, 0.5);
        for coefficient in [0.02, 0.05, 0.11, 0.23, 0.31, 0.47] {
            slope = slope * z + value;
            value = value * z + coefficient;
        }
        let step = value / (slope + 2.0);
        s = 0.3 + 0.1 * step * (1.0 - 0.5 * step / (1.0 + z));
    }
    s
}

/// The shortest of many short runs of the work, for one impact, by the same of the fixed arithmetic, for one round.
fn ratio(path: &str, planted: f64) -> f64 {
    const REPETITIONS: usize = 600;
    const ROUNDS: u32 = 2000;
    let mut work = Work::new(path, 20, planted);
    let (mut shortest, mut shortest_arithmetic) = (Duration::MAX, Duration::MAX);
    let mut impacts = 0;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        impacts = work.run();
        shortest = shortest.min(start.elapsed());
        let start = Instant::now();
        black_box(arithmetic(ROUNDS));
        shortest_arithmetic = shortest_arithmetic.min(start.elapsed());
    }
    (shortest.as_secs_f64() / impacts as f64) / (shortest_arithmetic.as_secs_f64() / f64::from(ROUNDS))
}

/// The instructions for one impact: what more cases take more. `None` without valgrind.
fn instructions(path: &str, planted: f64) -> Option<f64> {
    let counts = [200, 500].map(|cases| {
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(std::env::current_exe().expect("this program"))
            .args(["--work", path, &cases.to_string(), &planted.to_string()])
            .output()
            .ok()?;
        let report = String::from_utf8_lossy(&output.stderr).into_owned();
        let count = report.lines().find_map(|line| line.split_once("Collected :"))?.1.trim().parse::<f64>().ok()?;
        let impacts = String::from_utf8_lossy(&output.stdout).trim().parse::<f64>().ok()?;
        Some((count, impacts))
    });
    let [Some((few, few_impacts)), Some((more, more_impacts))] = counts else { return None };
    Some((more - few) / (more_impacts - few_impacts))
}

fn record() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/record/throughput.csv")
}

fn measured(path: &str, measure: Measure, planted: f64) -> f64 {
    match measure {
        Measure::Instructions => instructions(path, planted).expect("valgrind, which was found before"),
        Measure::Ratio => one_thread().install(|| ratio(path, planted)),
    }
}

fn write_record() {
    let mut writer = csv::Writer::from_path(record()).expect("a file to write");
    for path in PATHS {
        // A count is hardly different from one compiler or C library to the next; a ratio is, from one machine to another.
        for (measure, allowed) in [(Measure::Instructions, 0.10), (Measure::Ratio, 0.15)] {
            let value = measured(path, measure, 0.0);
            let value = (value * 1000.0).round() / 1000.0;
            writer.serialize(Row { path: path.to_owned(), measure, value, allowed }).expect("a row written");
        }
    }
    writer.flush().expect("the record written");
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let after =
        |flag: &str| arguments.iter().position(|argument| argument == flag).and_then(|at| arguments.get(at + 1..));
    if let Some([path, count, planted, ..]) = after("--work") {
        let mut work = Work::new(path, count.parse().expect("a number"), planted.parse().expect("a number"));
        println!("{}", one_thread().install(move || work.run()));
        return ExitCode::SUCCESS;
    }
    verify_impacts("closed-form", Model::Linear, &|case| ClosedForm.history(case).ok(), 1e-12);
    for set in InstructionSet::available() {
        Batched::verify(set, 1e-12);
    }
    if after("--record").is_some() {
        write_record();
        return ExitCode::SUCCESS;
    }
    let planted = after("--planted")
        .map_or(0.0, |rest| rest.first().map_or(0.3, |percent| percent.parse::<f64>().expect("a number") / 100.0));
    let counted = after("--ratio").is_none() && Command::new("valgrind").arg("--version").output().is_ok();
    let measure = if counted { Measure::Instructions } else { Measure::Ratio };
    let mut reader = csv::Reader::from_path(record()).expect("data/record/throughput.csv");
    let rows: Vec<Row> = reader.deserialize().collect::<Result<_, _>>().expect("rows of the record");
    let mut compared = 0;
    let mut slower = 0;
    for row in rows.iter().filter(|row| row.measure == measure) {
        let value = measured(&row.path, measure, planted);
        let change = value / row.value - 1.0;
        let verdict = if change > row.allowed { "SLOWER" } else { "ok" };
        println!(
            "{:<9} {measure} for one impact: {value:.3}, recorded {:.3}: {:+.1} %, allowed {:+.0} %: {verdict}",
            row.path,
            row.value,
            100.0 * change,
            100.0 * row.allowed
        );
        compared += 1;
        slower += usize::from(change > row.allowed);
    }
    let fastest = InstructionSet::fastest();
    println!(
        "{fastest:?} {measure} for one impact: {:.3}, not gated: not every machine has it",
        measured("fastest", measure, 0.0)
    );
    if compared == PATHS.len() && slower == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
