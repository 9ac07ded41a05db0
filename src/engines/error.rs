//! What is wrong with a manifest.

use std::{ops::Range, path::Path};

/// What is wrong with a manifest, and in which line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {what}")]
pub struct ManifestError {
    /// The file.
    pub file: String,
    /// The line, and what is wrong there.
    pub what: String,
}

/// A manifest that is being read: where it is, and what it says.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub path: &'a Path,
    pub text: &'a str,
}

impl Source<'_> {
    /// An error of the whole file.
    pub fn error(&self, what: impl Into<String>) -> ManifestError {
        ManifestError { file: self.path.display().to_string(), what: what.into() }
    }

    /// An error of the line where this stands.
    pub fn error_at(&self, span: &Range<usize>, what: impl std::fmt::Display) -> ManifestError {
        self.error(format!("line {}: {what}", self.line(span)))
    }

    /// The line where this stands; the first is 1.
    pub fn line(&self, span: &Range<usize>) -> usize {
        self.text.get(..span.start).map_or(0, |before| before.matches('\n').count()) + 1
    }

    /// The file and the line where this stands, as one reads it.
    pub fn place(&self, span: &Range<usize>) -> String {
        format!("{}, line {}", self.path.display(), self.line(span))
    }
}
