//! The talk with engines, kept: in a file, a JSON object a line, or in memory, to be shown.

use std::{
    io::{self, Write},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use process::{Direction, Line, Sink};
use serde::Serialize;

/// Where the talk with an engine is kept, if anywhere.
#[derive(Clone, Default)]
pub struct Keeper(pub(super) Option<Arc<dyn Sink>>);

impl Keeper {
    /// In a recording or a transcript.
    pub fn of<S: Sink + 'static>(kept: &Arc<S>) -> Self {
        let sink: Arc<dyn Sink> = kept.clone();
        Self(Some(sink))
    }
}

/// A line of the talk, as it is written.
#[derive(Serialize)]
struct Row<'a> {
    engine: &'a str,
    process: usize,
    direction: &'static str,
    line: &'a str,
}

/// Writes the talk.
pub struct Recording<W> {
    out: Mutex<(W, io::Result<()>)>,
}

impl<W: Write + Send> Recording<W> {
    /// Writes to `out`.
    pub fn new(out: W) -> Self {
        Self { out: Mutex::new((out, Ok(()))) }
    }

    /// Whether everything was written; asked once, at the end.
    ///
    /// # Errors
    /// The first that was not.
    pub fn finish(&self) -> io::Result<()> {
        let mut out = locked(&self.out);
        let (out, result) = &mut *out;
        std::mem::replace(result, Ok(())).and_then(|()| out.flush())
    }
}

impl<W: Write + Send> Sink for Recording<W> {
    fn keep(&self, line: &Line<'_>) {
        let row = Row { engine: line.engine, process: line.process, direction: word(line.direction), line: line.text };
        let mut out = locked(&self.out);
        let (out, result) = &mut *out;
        if result.is_ok() {
            *result = serde_json::to_string(&row)
                .map_err(io::Error::from)
                .and_then(|text| out.write_all((text + "\n").as_bytes()));
        }
    }
}

fn word(direction: Direction) -> &'static str {
    match direction {
        Direction::To => "to",
        Direction::From => "from",
    }
}

/// Keeps the talk, to show it.
#[derive(Default)]
pub struct Transcript {
    lines: Mutex<Vec<String>>,
}

impl Transcript {
    /// The lines so far: those to the engine after `>`, those from it after `<`.
    pub fn lines(&self) -> Vec<String> {
        locked(&self.lines).clone()
    }
}

impl Sink for Transcript {
    fn keep(&self, line: &Line<'_>) {
        let arrow = match line.direction {
            Direction::To => '>',
            Direction::From => '<',
        };
        locked(&self.lines).push(format!("{arrow} {}", line.text));
    }
}

/// What is kept is whole after a panic too: a line is added at once.
fn locked<T>(kept: &Mutex<T>) -> MutexGuard<'_, T> {
    kept.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(direction: Direction, text: &str) -> Line<'_> {
        Line { engine: "mine", process: 1, direction, text }
    }

    #[test]
    fn a_recording_has_a_line_of_json_for_each() {
        let recording = Recording::new(Vec::new());
        recording.keep(&line(Direction::To, "{\"cmd\":\"stop\"}"));
        recording.keep(&line(Direction::From, "no \"JSON\""));
        recording.finish().unwrap();
        let (out, _) = recording.out.into_inner().unwrap();
        let expected = [
            r#"{"engine":"mine","process":1,"direction":"to","line":"{\"cmd\":\"stop\"}"}"#,
            r#"{"engine":"mine","process":1,"direction":"from","line":"no \"JSON\""}"#,
        ];
        assert_eq!(String::from_utf8(out).unwrap().lines().collect::<Vec<_>>(), expected);
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_disk_that_is_full_is_told_at_the_end() {
        let recording = Recording::new(Full);
        recording.keep(&line(Direction::To, "x"));
        recording.keep(&line(Direction::To, "y"));
        assert_eq!(recording.finish().unwrap_err().kind(), io::ErrorKind::StorageFull);
    }
}
