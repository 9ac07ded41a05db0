//! Nothing that an engine prints makes the gate grow: a line of a gigabyte, a flood, error output without end, ten million impacts.
//! In a process of its own, whose memory is that of this test alone.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic)] // Test code fails by panicking.
#![cfg(target_os = "linux")]

use std::time::Duration;

use contract::{Case, Model};
use process::{Engine, Launch, Verdict};

/// The most memory that this process ever had, in megabytes.
fn most_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    line.split_whitespace().next().unwrap().parse::<u64>().unwrap() / 1024
}

#[test]
fn no_engine_makes_the_gate_grow() {
    let case = Case::from_epsilon(0.25, 2.0, 0.9).unwrap();
    for (how, patience, expected) in [
        ("gigabyte-line", 60_000, Some(Verdict::LineTooLong)),
        ("ten-million-impacts", 60_000, Some(Verdict::LineTooLong)),
        ("flood", 300, Some(Verdict::Flood)),
        ("floods-stderr", 60_000, None),
    ] {
        let mut launch = Launch::new("fake", [env!("CARGO_BIN_EXE_fake_engine"), how], Model::Linear);
        launch.case_timeout = Duration::from_millis(patience);
        let answer = Engine::start(launch, None).unwrap().answer(&case);
        assert_eq!(answer.breakdown().map(|broke| broke.verdict), expected, "{how}");
    }
    assert!(most_memory() < 32, "{} MB", most_memory());
}
