//! Cases a second through the protocol, of ten impacts each, to an engine that answers at once: in batches of 64 and one at a time, by one process.
//! What came back is checked before a number is printed.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::cast_precision_loss)] // A bench may break, and counts little.

use std::time::Instant;

use contract::{Case, Model};
use process::{Engine, Launch};

const FAKE: &str = env!("CARGO_BIN_EXE_fake_engine");
const IMPACTS: usize = 10;
const ROUNDS: usize = 5;

/// Cases that differ from all others.
fn cases(count: usize) -> Vec<Case> {
    let case = |k: usize| {
        let eta = 0.5 + 0.4 * k as f64 / count as f64;
        Case::from_epsilon(0.25, 2.0, eta).unwrap().with_max_impacts(IMPACTS).unwrap()
    };
    (0..count).map(case).collect()
}

/// The cases a second of the median round.
fn measured(how: &str, count: usize) -> f64 {
    let engine = Engine::start(Launch::new("fake", [FAKE, how], Model::Linear), None).unwrap();
    let cases = cases(count);
    let mut seconds: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            engine.forget();
            let began = Instant::now();
            engine.ask_all(&cases);
            let seconds = began.elapsed().as_secs_f64();
            for case in &cases {
                let history = engine.answer(case).told().unwrap();
                let ratio = history.impacts[9].interval / history.impacts[8].interval;
                assert_eq!(history.impacts.len(), IMPACTS);
                assert!((ratio / (case.eta() * case.eta()) - 1.0).abs() < 1e-14);
            }
            seconds
        })
        .collect();
    seconds.sort_unstable_by(f64::total_cmp);
    count as f64 / seconds[ROUNDS / 2]
}

fn main() {
    // `cargo test --benches` only wants to know whether it runs.
    let share = if std::env::args().any(|argument| argument == "--bench") { 1 } else { 100 };
    println!("in batches of 64   {:8.0} cases a second (goal 20000)", measured("batch", 40_000 / share));
    println!("one at a time      {:8.0} cases a second (goal  2000)", measured("well", 10_000 / share));
}
