//! Every line of the talk can be kept.

use std::sync::Arc;

/// Which way a line goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// To the engine.
    To,
    /// From the engine.
    From,
}

/// A line of the talk, without its end. What is not UTF-8 is replaced, and what is too long is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Line<'a> {
    /// The name of the engine.
    pub engine: &'a str,
    /// Which of its processes side by side, from 0.
    pub process: usize,
    /// Which way it goes.
    pub direction: Direction,
    /// What it says.
    pub text: &'a str,
}

/// Where lines are kept. Processes side by side call it at the same time.
pub trait Sink: Send + Sync {
    /// Keeps a line.
    fn keep(&self, line: &Line<'_>);
}

/// A sink, and whose lines it gets.
#[derive(Clone)]
pub struct Recorder {
    pub sink: Option<Arc<dyn Sink>>,
    pub engine: Arc<str>,
    pub process: usize,
}

impl Recorder {
    /// Keeps a line, if anybody wants it.
    pub fn keep(&self, direction: Direction, text: &[u8]) {
        if let Some(sink) = &self.sink {
            let text = String::from_utf8_lossy(text);
            let text = text.trim_end_matches(['\n', '\r']);
            sink.keep(&Line { engine: &self.engine, process: self.process, direction, text });
        }
    }
}
