//! What is wrong with a record, in one line.

use std::fmt;

use super::MOST_SAMPLES;

/// What is wrong with the file of a record: the line where it can be named, what stands there, and what is expected.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordError {
    file: Option<String>,
    line: Option<usize>,
    message: String,
}

impl RecordError {
    /// About a line, the first being 1.
    pub(super) fn at(line: usize, message: impl Into<String>) -> Self {
        Self { file: None, line: Some(line), message: message.into() }
    }

    /// About the whole file.
    pub(super) fn whole(message: impl Into<String>) -> Self {
        Self { file: None, line: None, message: message.into() }
    }

    /// With the file in front.
    pub(super) fn of_file(self, file: &str) -> Self {
        Self { file: Some(shown(file.as_bytes())), ..self }
    }

    /// With more to say, if there is any.
    pub(super) fn and(self, more: Option<String>) -> Self {
        Self { message: self.message + &more.unwrap_or_default(), ..self }
    }

    /// The line that is wrong, the first being 1; `None` if it is the whole file.
    #[must_use]
    pub const fn line(&self) -> Option<usize> {
        self.line
    }
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{file}: ")?;
        }
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for RecordError {}

/// More samples than are read.
pub(super) fn too_many() -> RecordError {
    RecordError::whole(format!("more than {MOST_SAMPLES} samples; allowed are 2 to {MOST_SAMPLES}"))
}

/// What stands in a file, as it may be shown: in one line, shortened, and without what a terminal would obey.
pub(super) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 80;
    let text = String::from_utf8_lossy(bytes.get(..bytes.len().min(8 * LONGEST)).unwrap_or_default());
    let text = text.trim();
    let mut shown: String = text.chars().take(LONGEST).map(printable).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push_str("...");
    }
    shown
}

/// The character, or a replacement for one that does something instead of being seen.
fn printable(c: char) -> char {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    match c {
        '\t' => ' ',
        c if c.is_control() || turns => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}
