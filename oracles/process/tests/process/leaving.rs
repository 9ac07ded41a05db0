//! The end: nothing of an engine is left.

use std::{
    path::Path,
    time::{Duration, Instant},
};

use process::{Engine, Verdict};

use crate::common::{case, engine, launch, verdict};

#[test]
fn an_engine_that_stops_is_not_blamed() {
    assert_eq!(engine("well").stop(), []);
}

#[test]
fn an_engine_that_does_not_stop_is_killed() {
    let mut launch = launch("ignores-stop");
    launch.grace = Duration::from_millis(200);
    launch.processes = 2;
    let broke = Engine::start(launch, None).unwrap().stop();
    assert_eq!(broke.iter().map(|broke| broke.verdict).collect::<Vec<_>>(), [Verdict::DoesNotStop]);
}

/// A child of the engine that outlives it and holds its pipes neither hangs the gate nor stays.
#[test]
fn children_that_survive_are_killed() {
    let engine = engine("leaves-a-child");
    let answer = engine.answer(&case(0.9));
    assert_eq!(verdict(&answer), Verdict::Crashed);
    let stderr = &answer.breakdown().unwrap().stderr;
    let child = stderr.trim().rsplit(' ').next().unwrap();
    let state = Path::new("/proc").join(child).join("stat");
    let began = Instant::now();
    // Killed, it may wait for a moment to be reaped.
    while std::fs::read_to_string(&state).is_ok_and(|stat| !stat.contains(") Z ")) {
        assert!(began.elapsed() < Duration::from_secs(10), "process {child} still lives");
        std::thread::sleep(Duration::from_millis(5));
    }
}
