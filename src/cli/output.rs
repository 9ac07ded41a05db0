//! Printing for people, where a reader that has gone away must not change the exit status.

use std::io::{self, Write as _};

use clap::ValueEnum;
use serde::Serialize;

/// Prints a text to stdout. A reader that has seen enough, as in `chattercheck verify | head`, is no error.
///
/// # Errors
/// When stdout can't be written to for any other reason.
pub(super) fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// How a command that answers one question prints its answer.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
}

impl Format {
    /// Prints the answer: as JSON, or as `text` says it.
    pub fn print<Answer: Serialize>(self, answer: &Answer, text: impl Fn(&Answer) -> String) -> anyhow::Result<()> {
        match self {
            Self::Json => print(&(serde_json::to_string_pretty(answer)? + "\n"))?,
            Self::Text => print(&(text(answer) + "\n"))?,
        }
        Ok(())
    }
}
