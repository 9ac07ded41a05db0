//! The cases that the peers are asked, with proven impacts, and the project's own oracles on the same cases. Run by `benches/peers/run.py` and `record.py`.
//!
//! `peers cases DIR` writes `cases.csv` and `truth.csv`; `peers grid DIR` those of the record of engines, of both models, into a folder for each;
//! `peers time DIR` prints a line of JSON for each oracle, with its answers, which are judged where those of the peers are, and with how long the
//! workload took.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)] // A program of the benches: it ends at the first surprise.

use std::{env, fs, hint::black_box, time::Instant};

use asymptotic::{Asymptotic, Order};
use closed_form::{
    ClosedForm,
    batch::{Batch, InstructionSet, Rows, Sequence},
};
use contract::{Case, Decline, Ending, History, Model, Normalisation, Oracle, Slenderness};
use enclosure::Enclosure;
use ode::{Equation, Flights, Ode, Solver};
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};
use serde_json::json;

/// How many cases the workload has, and how many impacts of each.
const WORKLOAD: (usize, usize) = (100, 60);
/// How deep the sequence of (1.03, 2, 0.92) is followed: to intervals of 1e-29.
const DEEP: usize = 800;
/// How far the cases of the work-precision charts are from the threshold to the critical amplitude, and how many impacts are listed there.
const SHARES: [(&str, f64, usize); 3] = [("50 %", 0.5, 80), ("90 %", 0.9, 120), ("99.9 %", 0.999, 200)];
const REPEATS: usize = 5;

/// Every case with its name: those of the workload are numbers.
fn cases() -> Vec<(String, Case)> {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[6; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let strategy = (1.005..1.035, 0.5..8.0, 0.80..0.95);
    let (count, impacts) = WORKLOAD;
    let case = |epsilon: f64, omega, eta, impacts| {
        Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(impacts).unwrap()
    };
    let mut cases: Vec<_> = (0..count)
        .map(|number| {
            let (a, omega, eta): (f64, f64, f64) = strategy.new_tree(&mut runner).unwrap().current();
            (number.to_string(), case(a - 1.0, omega, eta, impacts))
        })
        .collect();
    cases.push(("deep".into(), case(1.03 - 1.0, 2.0, 0.92, DEEP)));
    let critical = chattercheck::measure::critical::interpolated(2.0, 0.92).unwrap();
    cases.extend(
        SHARES.map(|(name, share, impacts)| (format!("share {name}"), case(share * critical, 2.0, 0.92, impacts))),
    );
    cases
}

/// The grid of the record of engines: on both sides of the critical amplitude, of blocks that exist: `1 - eta` of one that neither slides nor
/// bounces is `2 sin^2(alpha)` over its moment of inertia about a corner, which is at least 1.
const BLOCKS: [(f64, f64); 3] = [(0.85, 0.35), (0.92, 0.25), (0.97, 0.2)];
const FREQUENCIES: [f64; 2] = [0.7, 3.0];
const OF_THE_WAY: [f64; 9] = [0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 1.03, 1.2, 1.6];
const GRID_IMPACTS: usize = 300;

fn grid() -> Vec<(String, Case)> {
    let mut cases = Vec::new();
    for ((eta, alpha), omega) in BLOCKS.into_iter().flat_map(|block| FREQUENCIES.map(|omega| (block, omega))) {
        let critical = chattercheck::measure::critical::interpolated(omega, eta).unwrap();
        for share in OF_THE_WAY {
            let slenderness = Slenderness::new(alpha, Normalisation::Threshold).unwrap();
            let case = Case::from_epsilon(share * critical, omega, eta).unwrap().with_slenderness(slenderness);
            let name = format!("eta {eta}, alpha {alpha}, omega {omega}, share {share}");
            cases.push((name, case.with_max_impacts(GRID_IMPACTS).unwrap()));
        }
    }
    cases
}

fn write(folder: &str, cases: &[(String, Case)], model: Model) {
    let judge = Enclosure::new(model);
    let (mut listed, mut truth) =
        ("case,epsilon,omega,eta,alpha,impacts,tau_ch,ending\n".to_owned(), "case,n,tau,interval\n".to_owned());
    for (name, case) in cases {
        let history = judge.history(case).expect("decided");
        let tau_ch = history.chattering_time.map_or(String::new(), |time| time.value.to_string());
        let (epsilon, omega, eta, impacts) = (case.epsilon(), case.omega(), case.eta(), case.max_impacts());
        let slenderness = case.slenderness().filter(|_| model == Model::Nonlinear);
        let alpha = slenderness.map_or(String::new(), |slenderness| slenderness.alpha().to_string());
        listed += &format!("{name:?},{epsilon},{omega},{eta},{alpha},{impacts},{tau_ch},{}\n", history.ending);
        for (n, impact) in (1..).zip(&history.impacts) {
            truth += &format!("{name:?},{n},{},{:e}\n", impact.time, impact.interval);
        }
    }
    fs::create_dir_all(folder).unwrap();
    fs::write(format!("{folder}/cases.csv"), listed).unwrap();
    fs::write(format!("{folder}/truth.csv"), truth).unwrap();
}

/// The grid as a file of cases for `chattercheck verify --case-file`.
fn case_file(cases: &[(String, Case)]) -> String {
    let table = |(name, case): &(String, Case)| {
        let alpha = case.slenderness().map_or(f64::NAN, |slenderness| slenderness.alpha());
        let (epsilon, omega, eta) = (case.epsilon(), case.omega(), case.eta());
        format!(
            "[[case]]\nname = {name:?}\nwhy = \"The grid of data/record/engines.md\"\nepsilon = {epsilon:?}\nomega = {omega:?}\neta = {eta:?}\nalpha = {alpha:?}\nimpacts = {GRID_IMPACTS}\n"
        )
    };
    cases.iter().map(table).collect::<Vec<_>>().join("\n")
}

fn write_grid(folder: &str) {
    fs::create_dir_all(folder).unwrap();
    fs::write(format!("{folder}/cases.toml"), case_file(&grid())).unwrap();
    for (name, model) in [("linear", Model::Linear), ("nonlinear", Model::Nonlinear)] {
        write(&format!("{folder}/{name}"), &grid(), model);
    }
}

type Run = Box<dyn Fn(&Case) -> Result<History, Decline>>;

/// The oracles of the linear model; diffsol in a single run, without the two coarser ones that its claims are made from.
fn oracles() -> Vec<(String, Run)> {
    let mut oracles: Vec<(String, Run)> = vec![
        ("closed-form, with its claims".into(), Box::new(|case| ClosedForm.history(case))),
        ("enclosure, proven".into(), Box::new(|case| Enclosure::new(Model::Linear).history(case))),
    ];
    let series = Asymptotic::new().with_order(Order::Terms(16)).expect("in range");
    oracles.push(("asymptotic/order-16, with its claims".into(), Box::new(move |case| series.history(case))));
    let mut add = |method: Solver, rtol, flights| {
        let ode = Ode::new(Equation::Linear, method).with_flights(flights).with_rtol(rtol).expect("in range");
        oracles.push((format!("{}, rtol {rtol:e}", ode.name()), Box::new(move |case| ode.impacts(case))));
    };
    add(Solver::Tsit45, 1e-12, Flights::Rescaled);
    add(Solver::Tsit45, 1e-10, Flights::Rescaled);
    add(Solver::Esdirk34, 1e-10, Flights::Rescaled);
    add(Solver::Bdf, 1e-9, Flights::Rescaled);
    add(Solver::TrBdf2, 1e-8, Flights::Rescaled);
    add(Solver::Tsit45, 1e-12, Flights::Naive);
    oracles
}

fn ended(history: &History) -> String {
    match history.ending {
        Ending::Lost(loss) => format!("loud: {loss}"),
        ending => ending.to_string(),
    }
}

fn time(folder: &str) {
    // That the cases are those of the files is what makes it one run.
    let listed = fs::read_to_string(format!("{folder}/cases.csv")).expect("cases");
    let cases = cases();
    assert_eq!(listed.lines().count(), cases.len() + 1);
    for (setting, run) in oracles() {
        let answers: serde_json::Map<_, _> = cases
            .iter()
            .map(|(name, case)| {
                let answer = run(case).map(|history| {
                    let times: Vec<f64> = history.impacts.iter().map(|impact| impact.time).collect();
                    let intervals: Vec<f64> = history.impacts.iter().map(|impact| impact.interval).collect();
                    json!([times, intervals, ended(&history)])
                });
                (name.clone(), answer.unwrap_or_else(|decline| json!([[], [], format!("declined: {decline}")])))
            })
            .collect();
        let workload: Vec<_> = cases.iter().filter(|(name, _)| name.parse::<usize>().is_ok()).collect();
        // The best of some repeats of each case, so that what else runs on the machine counts little.
        let seconds: f64 = workload
            .iter()
            .map(|(_, case)| {
                let once = || {
                    let start = Instant::now();
                    drop(black_box(run(black_box(case))));
                    start.elapsed().as_secs_f64()
                };
                (0..REPEATS).map(|_| once()).fold(f64::INFINITY, f64::min)
            })
            .sum();
        println!("{}", json!({ "setting": setting, "seconds": seconds, "answers": answers }));
    }
    time_batch(&cases);
}

/// The impacts of several cases at once, without claims.
fn batched(cases: &[&Case], impacts: usize) -> Vec<(Vec<f64>, Vec<f64>, String)> {
    let of = |quantity: fn(&Case) -> f64| cases.iter().map(|case| quantity(case)).collect::<Vec<_>>();
    let (epsilon, omega, eta) = (of(Case::epsilon), of(Case::omega), of(Case::eta));
    let mut time = vec![0.0; cases.len() * impacts];
    let (mut interval, mut velocity) = (time.clone(), time.clone());
    let mut sequences = vec![Sequence::default(); cases.len()];
    let rows = Rows { time: &mut time, interval: &mut interval, velocity: &mut velocity, sequences: &mut sequences };
    Batch::new(&epsilon, &omega, &eta, impacts).expect("in range").run(rows).expect("of this shape");
    let lists = time.chunks(impacts).zip(interval.chunks(impacts)).zip(&sequences);
    let list = |row: &[f64], sequence: &Sequence| row.iter().take(sequence.impacts).copied().collect();
    lists
        .map(|((time, interval), sequence)| {
            (list(time, sequence), list(interval, sequence), sequence.ending.to_string())
        })
        .collect()
}

/// The line of the closed form in batches: the workload in one, the others one by one.
fn time_batch(cases: &[(String, Case)]) {
    let (workload, others): (Vec<_>, Vec<_>) = cases.iter().partition(|(name, _)| name.parse::<usize>().is_ok());
    let together: Vec<&Case> = workload.iter().map(|(_, case)| case).collect();
    let mut answers = batched(&together, WORKLOAD.1);
    answers.extend(others.iter().flat_map(|(_, case)| batched(&[case], case.max_impacts())));
    let names = workload.iter().chain(&others).map(|(name, _)| name.clone());
    let answers: serde_json::Map<_, _> = names.zip(answers.into_iter().map(|answer| json!(answer))).collect();
    let seconds = (0..20 * REPEATS).map(|_| {
        let start = Instant::now();
        drop(black_box(batched(black_box(&together), WORKLOAD.1)));
        start.elapsed().as_secs_f64()
    });
    let seconds = seconds.fold(f64::INFINITY, f64::min);
    let setting = format!("closed-form in a batch, {:?}", InstructionSet::fastest());
    println!("{}", json!({ "setting": setting, "seconds": seconds, "answers": answers }));
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["cases", folder] => write(folder, &cases(), Model::Linear),
        ["grid", folder] => write_grid(folder),
        ["time", folder] => time(folder),
        _ => panic!("peers cases DIR, peers grid DIR, or peers time DIR"),
    }
}
