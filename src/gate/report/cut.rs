//! Texts that come from outside may be endless; a report is not.

use crate::cases::toml_error::printable;

/// The text, or its first letters and how many more there were, with `before` between them.
pub fn cut(text: &str, longest: usize, before: &str) -> String {
    match text.char_indices().nth(longest) {
        None => text.to_owned(),
        Some((end, _)) => {
            let (kept, rest) = text.split_at(end);
            format!("{kept}{before}[{} more letters are cut off]", rest.chars().count())
        }
    }
}

/// A text on one line, and without what a terminal would obey.
pub fn one_line(text: &str) -> String {
    printable(&text.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_cut_says_so() {
        assert_eq!(cut("abc", 3, " "), "abc");
        assert_eq!(cut("äöüß", 3, " "), "äöü [1 more letters are cut off]");
        assert_eq!(one_line("a\n  b\t c\u{1b}[31m"), "a b c\u{fffd}[31m");
    }
}
