//! The command that tells the version of an engine: what it prints is the receipt in a report.

use std::time::{Duration, Instant};

use crate::{
    child::{Child, Heard},
    exit,
    launch::Launch,
    lines::Cut,
    verdict::{Breakdown, Verdict},
};

/// How long a line of it may be.
const LONGEST_LINE: usize = 4 * 1024;

/// How many lines are read.
const MOST_LINES: usize = 200;

/// How much of its error output is used.
const STDERR: usize = 4 * 1024;

/// What this command prints, run where the engine is run: its lines, or those of its error output if it prints nothing else.
///
/// # Errors
/// When it can't be started, fails, prints nothing, or does not end in the time that the engine has for its start.
pub fn version(launch: &Launch, command: &[String]) -> Result<Vec<String>, Breakdown> {
    let launch = Launch { run: command.to_vec(), ..launch.clone() };
    let deadline = Instant::now() + launch.start_timeout;
    let mut child = Child::start(&launch)?;
    child.close();
    let mut lines = Vec::new();
    loop {
        match child.hear(LONGEST_LINE, deadline) {
            Heard::Cut(Cut::Line(line)) if lines.len() < MOST_LINES => {
                lines.push(String::from_utf8_lossy(&line).trim().to_owned());
            }
            Heard::Cut(_) => return Err(failed("it prints more than a version")),
            Heard::Late => return Err(late(launch.start_timeout)),
            Heard::End if child.lines().overflows() => return Err(failed("it prints more than a version")),
            Heard::End => break,
        }
    }
    // A last line without an end.
    lines.push(String::from_utf8_lossy(child.lines().rest()).trim().to_owned());
    let Some(status) = child.ended(deadline) else { return Err(late(launch.start_timeout)) };
    let stderr = child.stderr(STDERR);
    if !exit::is_success(&status) {
        return Err(failed(exit::told(&status)).with_stderr(stderr));
    }
    lines.retain(|line| !line.is_empty());
    if lines.is_empty() {
        lines.extend(stderr.lines().map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned));
    }
    if lines.is_empty() { Err(failed("it prints nothing")) } else { Ok(lines) }
}

fn failed(happened: impl Into<String>) -> Breakdown {
    Breakdown::new(Verdict::NoVersion, happened)
}

fn late(patience: Duration) -> Breakdown {
    failed(format!("it did not end in {} s", patience.as_secs_f64()))
}
