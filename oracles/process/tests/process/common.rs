//! Engines that misbehave in a way that is named, with little patience for them.

use std::{
    path::PathBuf,
    sync::atomic::{AtomicUsize, Ordering},
    time::Duration,
};

use contract::{Case, Model};
use process::{Answer, Breakdown, Engine, Launch, Verdict};

pub const FAKE: &str = env!("CARGO_BIN_EXE_fake_engine");

/// An engine that misbehaves so.
pub fn launch(how: &str) -> Launch {
    let mut launch = Launch::new("fake", [FAKE, how], Model::Linear);
    // What hangs is noticed in no time; what answers has far more time than it needs, on a busy machine too.
    let hangs =
        ["silent", "half-line", "flood", "closes-", "hangs", "one-missing"].iter().any(|word| how.contains(word));
    launch.case_timeout = Duration::from_millis(if hangs { 300 } else { 20_000 });
    launch.start_timeout = if how.starts_with("start-") { launch.case_timeout } else { Duration::from_secs(20) };
    launch.grace = Duration::from_secs(10);
    launch
}

pub fn engine(how: &str) -> Engine {
    Engine::start(launch(how), None).unwrap()
}

/// How an engine breaks that misbehaves so at the start.
pub fn refused(how: &str) -> Breakdown {
    Engine::start(launch(how), None).map(drop).unwrap_err()
}

pub fn case(eta: f64) -> Case {
    Case::from_epsilon(0.25, 2.0, eta).unwrap().with_max_impacts(4).unwrap()
}

/// So many different cases.
pub fn cases(count: u32) -> Vec<Case> {
    (0..count).map(|k| case(0.5 + 0.4 * f64::from(k) / f64::from(count))).collect()
}

/// How an answer broke.
pub fn verdict(answer: &Answer) -> Verdict {
    answer.breakdown().unwrap_or_else(|| panic!("an answer: {answer:?}")).verdict
}

/// A file that is not there yet.
pub fn mark() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let name = format!("mark-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let mark = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_file(&mark);
    mark
}
