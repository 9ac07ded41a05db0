//! The one place where the command line writes to stdout and stderr.
//!
//! Data goes to stdout. A reader that has seen enough, as in `chattercheck simulate | head`, is no error and changes no exit status; anything else that
//! keeps data from being written is. Notes go to stderr, and what becomes of them never matters: a closed or full stderr changes nothing.

use std::{
    fmt,
    io::{self, BufWriter, Write},
};

use chattercheck::cases::toml_error::{is_control, printable};
use clap::ValueEnum;
use serde::Serialize;

/// That an output could not be written to: the fault of the machine, not of the request.
#[derive(Debug)]
pub(super) struct Unwritten(pub io::Error);

impl fmt::Display for Unwritten {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write to stdout: {}", self.0)
    }
}

impl std::error::Error for Unwritten {}

/// Writes to stdout what `content` writes.
///
/// # Errors
/// When stdout can't be written to, other than for a reader that has gone away.
pub(super) fn write(content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Unwritten> {
    let mut stdout = BufWriter::new(io::stdout().lock());
    written(content(&mut stdout).and_then(|()| stdout.flush()))
}

/// What became of writing to stdout.
///
/// # Errors
/// When it can't be written to, other than for a reader that has gone away.
pub(super) fn written(result: io::Result<()>) -> Result<(), Unwritten> {
    match result {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result.map_err(Unwritten),
    }
}

/// Prints a text to stdout.
///
/// # Errors
/// As [`write`].
pub(super) fn print(text: &str) -> Result<(), Unwritten> {
    write(|stdout| stdout.write_all(text.as_bytes()))
}

/// Prints a text for people to stdout: what comes from files and other programs is in it, and nothing that a terminal would obey.
///
/// # Errors
/// As [`write`].
pub(super) fn say(text: &str) -> Result<(), Unwritten> {
    print(&shown(text))
}

/// A text as people may see it: lines and tabs, without anything that a terminal would obey.
fn shown(text: &str) -> String {
    text.chars()
        .map(|c| if !matches!(c, '\n' | '\t') && is_control(c) { char::REPLACEMENT_CHARACTER } else { c })
        .collect()
}

/// Prints rows as CSV, under the names of their fields.
///
/// # Errors
/// As [`write`].
pub(super) fn print_csv<Row: Serialize>(rows: &[Row]) -> Result<(), Unwritten> {
    write(|stdout| {
        let mut csv = csv::Writer::from_writer(stdout);
        rows.iter().try_for_each(|row| csv.serialize(row)).map_err(of_csv)?;
        csv.flush()
    })
}

/// What went wrong with stdout itself: as the csv crate converts its errors, a pipe that was closed looks like anything else.
pub(super) fn of_csv(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// Tells people something, on stderr, if anybody listens.
pub(super) fn note(text: impl fmt::Display) {
    let _ = writeln!(io::stderr().lock(), "{}", shown(&text.to_string()));
}

/// Says what is wrong, in one line that is not endless, and without anything that a terminal would obey.
pub(super) fn complain(text: &str) {
    // What is too long is what was typed, in the middle.
    const KEPT: usize = 300;
    let text: Vec<char> = printable(text).chars().collect();
    let line = |part: &[char]| part.iter().collect::<String>();
    match (text.first_chunk::<KEPT>(), text.last_chunk::<KEPT>()) {
        (Some(first), Some(last)) if text.len() > 2 * KEPT => {
            note(format_args!("chattercheck: {}...{}", line(first), line(last)));
        }
        _ => note(format_args!("chattercheck: {}", line(&text))),
    }
}

/// How a command that answers one question prints its answer.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
    /// JSON on one line, for answers that are collected
    JsonLine,
}

/// How a command that answers with a table prints it.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum TableFormat {
    Csv,
    Json,
    /// JSON on one line, for answers that are collected
    JsonLine,
}

/// An answer as JSON with a line feed: over many lines, to be read, or on one, to be collected.
pub(super) fn json(answer: &impl Serialize, is_one_line: bool) -> serde_json::Result<String> {
    let text = if is_one_line { serde_json::to_string(answer) } else { serde_json::to_string_pretty(answer) };
    Ok(text? + "\n")
}

impl Format {
    /// Prints the answer: as JSON, or as `text` says it.
    pub fn print<Answer: Serialize>(self, answer: &Answer, text: impl Fn(&Answer) -> String) -> anyhow::Result<()> {
        match self {
            Self::Json => print(&json(answer, false)?)?,
            Self::JsonLine => print(&json(answer, true)?)?,
            Self::Text => say(&(text(answer) + "\n"))?,
        }
        Ok(())
    }
}
