//! How much of a run a JUnit file has room for.
//!
//! - Up to [`MOST_LISTED`] test cases, each is listed. Above, those that passed are summed up in one test case a class, and so are those that were skipped.
//! - What failed is listed always: with its whole text as long as the texts fit into [`TEXTS`], the rest with one line each as long as those fit into
//!   [`LINES`], and what is left as a number, in a test case that failed.
//! - One text has at most [`LONGEST`] letters, and says how many were cut off.

use crate::gate::report::cut::{cut, one_line};

/// GitLab reads no larger file, in bytes.
pub const LARGEST: usize = 30_000_000;
/// How many test cases are listed one by one, if none failed.
pub const MOST_LISTED: usize = 50_000;
/// For the whole texts of what failed, in bytes.
const TEXTS: usize = 12_000_000;
/// For single lines of what failed, in bytes.
const LINES: usize = 4_000_000;
/// The letters of one text,
const LONGEST: usize = 10_000;
/// of one line,
const LONGEST_LINE: usize = 300;
/// and of one name.
const LONGEST_NAME: usize = 200;
/// What an element takes beside its texts, about.
const ELEMENT: usize = 150;

/// What is left of the room for what failed.
pub(super) struct Room {
    pub(super) lists_all: bool,
    texts: usize,
    lines: usize,
}

/// How much of a test case that failed is shown.
pub(super) enum Shown {
    Whole,
    Line,
    Counted,
}

impl Room {
    /// For so many test cases.
    pub(super) fn for_cases(cases: usize) -> Self {
        Self { lists_all: cases <= MOST_LISTED, texts: TEXTS, lines: LINES }
    }

    /// Takes the room for a test case that failed.
    pub(super) fn take(&mut self, name: &str, message: &str, text: &str) -> Shown {
        let line = ELEMENT + written(name) + 2 * written(message);
        let whole = line + written(text);
        let takes = |room: &mut usize, size: usize| room.checked_sub(size).map(|left| *room = left).is_some();
        if takes(&mut self.texts, whole) {
            Shown::Whole
        } else if takes(&mut self.lines, line) {
            Shown::Line
        } else {
            Shown::Counted
        }
    }
}

/// How many bytes a text takes in XML.
fn written(text: &str) -> usize {
    text.chars().map(|c| if matches!(c, '<' | '>' | '&' | '"' | '\'') { 6 } else { c.len_utf8() }).sum()
}

/// A text that is not endless.
pub(super) fn text(text: &str) -> String {
    cut(text, LONGEST, "\n")
}

/// One line of it.
pub(super) fn line(text: &str) -> String {
    cut(&one_line(text), LONGEST_LINE, " ")
}

/// A name that is not endless.
pub(super) fn name(text: &str) -> String {
    cut(text, LONGEST_NAME, " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Texts are given up before lines, and lines before nothing but a number.
    #[test]
    fn room_runs_out_in_order() {
        let mut room = Room { lists_all: true, texts: 1000, lines: 400 };
        let shown: Vec<u8> = (0..6)
            .map(|_| match room.take("name", "line", &"x".repeat(300)) {
                Shown::Whole => 0,
                Shown::Line => 1,
                Shown::Counted => 2,
            })
            .collect();
        assert_eq!(shown, [0, 0, 1, 1, 2, 2]);
    }
}
