//! What is wrong with a TOML file, said in one line and in the words of who wrote it: the line, the field, what is allowed, and what stands there. The
//! first of several errors in the file comes first.

use serde::de::DeserializeOwned;

/// A field, and what is allowed for it. A field of a table that has others of the same name elsewhere is named with it: `exact.omega`.
pub type Allowed = (&'static str, &'static str);

/// What a parser for programmers calls the kinds of values, and what people call them.
const KINDS: [(&str, &str); 12] = [
    ("expected f64", "a number"),
    ("expected i64", "a whole number"),
    ("expected u64", "a whole number from 0 on"),
    ("expected usize", "a whole number from 0 on"),
    ("expected i128", "a whole number"),
    ("expected u32", "a whole number from 0 on"),
    ("expected a string", "a text in quotes"),
    ("expected a sequence", "a list in [ ]"),
    ("expected a boolean", "true or false"),
    ("expected a map", "a table"),
    ("expected struct", "a table"),
    ("wanted string", "a word in quotes"),
];

/// Reads a file of fields, of which `allowed` says what may stand there.
///
/// # Errors
/// What is wrong with the first line that is.
pub fn read<T: DeserializeOwned>(text: &str, allowed: &[Allowed]) -> Result<T, String> {
    let error = match toml::from_str(text) {
        Ok(read) => return Ok(read),
        Err(error) => error,
    };
    let mut first = (line_of(&error, text), one_line(&error, text, allowed));
    // The parser goes through the fields by name, not from top to bottom: without the line that it stumbled on, it may stumble on an earlier one.
    let mut rest = text.to_owned();
    let mut last = error;
    for _ in 0..50 {
        let Some(number) = line_of(&last, &rest).filter(|_| !is_missing(&last)) else { break };
        rest = without(&rest, number);
        match (toml::from_str::<T>(&rest), rest.parse::<toml::Table>()) {
            (Err(next), Ok(_)) if !is_missing(&next) => last = next,
            _ => break,
        }
        let line = line_of(&last, &rest);
        if line.is_some() && (line < first.0 || first.0.is_none()) {
            first = (line, one_line(&last, &rest, allowed));
        }
    }
    Err(first.1)
}

/// What is wrong, in one line and without the parser's picture of it; with the line that it is in, if it is in one.
pub fn one_line(error: &toml::de::Error, text: &str, allowed: &[Allowed]) -> String {
    const LONGEST: usize = 100;
    if is_missing(error) {
        return printable(&missing(error, text, allowed));
    }
    let number = line_of(error, text);
    let line = number.and_then(|number| text.lines().nth(number)).unwrap_or_default().trim();
    let field = number.map_or_else(String::new, |number| field_at(text, number, allowed));
    let message = printable(&in_words(error.message(), &field, allowed));
    let Some(number) = number else { return message };
    let shown: String = line.chars().take(LONGEST).collect();
    let dots = if shown.len() < line.len() { "..." } else { "" };
    let quoted = if line.is_empty() { String::new() } else { format!(", in `{}{dots}`", printable(&shown)) };
    format!("line {}: {message}{quoted}", number + 1)
}

/// What is missing, and the table that it is missing in, where that is not the whole file.
fn missing(error: &toml::de::Error, text: &str, allowed: &[Allowed]) -> String {
    let field = error.message().trim_start_matches("missing field ").replace('`', "");
    let said = allowed.iter().find(|(name, _)| *name == field);
    let said = said.map_or(String::new(), |(_, allowed)| format!("; allowed is {allowed}"));
    // The parser points at the table, and at nothing for the whole file.
    let Some(span) = error.span().filter(|span| !span.is_empty()) else { return format!("{field} is missing") };
    let number = line_of(error, text).unwrap_or_default();
    let table = match text.get(span).unwrap_or_default() {
        header if header.starts_with('[') => header.replace("[[", "[").replace("]]", "]"),
        _ => field_at(text, number, allowed),
    };
    format!("line {}: {field} is missing in {table}{said}", number + 1)
}

/// What is missing is in no line, whatever the parser points at.
fn is_missing(error: &toml::de::Error) -> bool {
    error.message().starts_with("missing field")
}

/// The line that an error is in, the first being 0.
fn line_of(error: &toml::de::Error, text: &str) -> Option<usize> {
    Some(text.get(..error.span()?.start)?.matches('\n').count())
}

/// The text with an empty line in place of one.
fn without(text: &str, number: usize) -> String {
    let lines = text.lines().enumerate().map(|(place, line)| if place == number { "" } else { line });
    lines.collect::<Vec<_>>().join("\n")
}

/// The field that a line is about: named on it, or where the list begins that it is a line of.
fn field_at(text: &str, number: usize, allowed: &[Allowed]) -> String {
    let before: Vec<&str> = text.lines().take(number + 1).collect();
    let Some((line, above)) = before.split_last() else { return String::new() };
    let mut open = 0_i32;
    let begins = above.iter().rev().find(|line| {
        let (opened, closed) = (line.matches('[').count() as i32, line.matches(']').count() as i32);
        open += opened - closed;
        open > 0 || line.contains('=')
    });
    let named = begins.filter(|begins| open > 0 && begins.contains('=') && !line.contains('='));
    let field = field_of(named.unwrap_or(line));
    let table = above.iter().rev().find(|line| line.trim().starts_with('[')).map_or("", |line| field_of(line));
    let whole = format!("{table}.{field}");
    if allowed.iter().any(|(name, _)| *name == whole) { whole } else { field.to_owned() }
}

/// The field that a line names.
fn field_of(line: &str) -> &str {
    let name = line.split('=').next().unwrap_or_default().trim();
    let name = name.trim_matches(['[', ']', '"', '\'', ' ']);
    name.rsplit('.').next().unwrap_or_default().trim()
}

/// The message of the parser in the words of the trade.
fn in_words(message: &str, field: &str, allowed: &[Allowed]) -> String {
    let of_field = allowed.iter().find(|(name, _)| *name == field).map(|(_, allowed)| *allowed);
    let plain = |text: &str| text.replace('`', "");
    if let Some(rest) = message.strip_prefix("unknown field ") {
        let (name, known) = rest.split_once(", expected ").unwrap_or((rest, ""));
        let known = plain(known).replacen("one of ", "", 1).replace(" or ", ", ");
        let near =
            known.split(", ").filter(|known| is_near(known, &plain(name))).map(|near| format!(" (perhaps {near})"));
        return format!("{} is not known here{}; known are {known}", plain(name), near.take(1).collect::<String>());
    }
    if message.starts_with("duplicate key") {
        return format!("{field} is given twice");
    }
    let about_values = ["invalid type", "invalid value", "invalid length", "unknown variant", "wanted "];
    if about_values.iter().any(|start| message.starts_with(start)) {
        let kind = KINDS.iter().find(|(theirs, _)| message.contains(theirs)).map(|(_, ours)| (*ours).to_owned());
        let words = message.split_once(", expected ").map(|(_, words)| plain(words).replacen("one of ", "", 1));
        let said = of_field.map(str::to_owned).or(kind).or(words).unwrap_or_else(|| "something else".to_owned());
        return format!("{field}: allowed is {said}");
    }
    if message.contains("overflow") {
        let said = of_field.unwrap_or("a number that a computer can hold");
        return format!("{field}: the number is too large; allowed is {said}");
    }
    // What the author of the format says about it himself.
    if message.contains("; allowed is ") || message.contains(": allowed is ") {
        return message.to_owned();
    }
    // Everything else is not TOML at all.
    match of_field {
        Some(said) => format!("{field}: not TOML; allowed is {said}"),
        None => {
            "not TOML; allowed is field = value, a value being a number as 0.25, a text in quotes, or { unit = number }"
                .to_owned()
        }
    }
}

/// Whether two names differ by little: a letter, two that are swapped, or what joins their words.
fn is_near(one: &str, other: &str) -> bool {
    let letters = |name: &str| {
        let mut letters: Vec<char> = name.chars().filter(|letter| letter.is_alphanumeric()).collect();
        letters.sort_unstable();
        letters
    };
    let (one, other) = (letters(one), letters(other));
    let missing = |from: &[char], of: &[char]| {
        let mut of = of.to_vec();
        from.iter()
            .filter(|letter| of.iter().position(|other| other == *letter).map(|at| of.remove(at)).is_none())
            .count()
    };
    one.len() > 2 && missing(&one, &other).max(missing(&other, &one)) <= 1
}

/// A text of a file as it may be shown: in one line, and without what a terminal would obey.
pub fn printable(text: &str) -> String {
    let shown = |c: char| if is_control(c) { char::REPLACEMENT_CHARACTER } else { c };
    text.replace('\n', " ").chars().map(shown).collect()
}

/// Whether a character does something instead of being seen: control characters, and those that turn the direction of writing.
pub fn is_control(c: char) -> bool {
    c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::case_file::{ALLOWED, CaseFields};

    fn told(text: &str) -> String {
        read::<CaseFields>(text, &ALLOWED).unwrap_err()
    }

    #[test]
    fn the_field_what_is_allowed_and_what_stands_there_are_said() {
        let told = told("# first\nomega = \"fast\" # why\n");
        assert_eq!(told, "line 2: omega: allowed is a number, omega > 0, in `omega = \"fast\" # why`");
    }

    #[test]
    fn a_value_in_a_list_of_several_lines_is_named_by_its_field() {
        const WHAT: [Allowed; 1] = [("what", "one of two")];
        #[derive(serde::Deserialize)]
        #[serde(rename_all = "kebab-case")]
        enum Word {
            One,
        }
        #[derive(serde::Deserialize)]
        struct List {
            #[serde(rename = "what")]
            _what: Vec<Word>,
        }
        for text in ["what = [\n\"one\",\n\"three\"\n]\n", "other = [\n1]\nwhat = [\n\"three\" ]\n"] {
            let told = read::<List>(text, &WHAT).err().unwrap_or_default();
            assert!(told.contains(": what: allowed is one of two, in `\"three\""), "{told}");
        }
    }

    #[test]
    fn what_is_missing_is_in_no_line() {
        assert_eq!(told("# only a comment\nomega = 2.0\n"), "eta is missing");
    }

    #[test]
    fn what_is_missing_in_a_table_is_told_with_it() {
        #[derive(serde::Deserialize)]
        struct Inner {
            #[serde(rename = "size")]
            _size: f64,
        }
        #[derive(serde::Deserialize)]
        struct Outer {
            #[serde(rename = "block")]
            _block: Inner,
            #[serde(rename = "parts")]
            _parts: Vec<Inner>,
        }
        const SIZE: [Allowed; 1] = [("size", "a number")];
        for (text, said) in [
            ("# a\n[block]\n", "line 2: size is missing in [block]; allowed is a number"),
            ("block = { }\n", "line 1: size is missing in block; allowed is a number"),
            ("[block]\nsize = 1.0\n", "parts is missing"),
            (
                "parts = [ { size = 1.0 },\n { } ]\n[block]\nsize = 1.0\n",
                "line 2: size is missing in parts; allowed is a number",
            ),
            ("[block]\nsize = 1.0\n[[parts]]\n", "line 3: size is missing in [parts]; allowed is a number"),
        ] {
            assert_eq!(read::<Outer>(text, &SIZE).err().unwrap_or_default(), said);
        }
    }

    #[test]
    fn the_first_error_in_the_file_comes_first() {
        // By name alpha would be first.
        for text in ["omega = []\neta = 0.9\nalpha = \"a\"\n", "omegas = 2\neta = 0.9\nalpha = true\na = true"] {
            assert!(told(text).starts_with("line 1: omega"), "{}", told(text));
        }
    }

    #[test]
    fn a_name_that_is_nearly_right_is_named() {
        assert!(
            told("a = 1.0\nomgea = 2.0\neta = 0.9\n")
                .contains("omgea is not known here (perhaps omega); known are a, ")
        );
        assert!(!told("a = 1.0\ncolour = 2.0\neta = 0.9\n").contains("perhaps"));
    }

    #[test]
    fn no_word_of_a_programmer_is_said() {
        let values = [
            "1,5",
            "−1",
            "0x",
            "1e400",
            "true",
            "[1]",
            "{ m = 1 }",
            "2020-01-01",
            "\"x\"",
            "0.2 m",
            "=",
            "99999999999999999999",
        ];
        for field in ["omega", "impacts", "normalisation", "alpha"] {
            for value in values {
                let told = told(&format!("{field} = {value}\na = \"x\"\neta = 0.9\n"));
                assert!(told.starts_with("line 1: ") || told.contains("in `a ="), "{told}");
                for word in [
                    "f64",
                    "i64",
                    "usize",
                    "variant",
                    "struct",
                    "expected",
                    "invalid type",
                    "sequence",
                    "literal",
                    "target",
                ] {
                    assert!(!told.contains(word), "{told}");
                }
            }
        }
    }

    #[test]
    fn nothing_that_a_terminal_obeys_is_shown() {
        for hidden in ['\u{1b}', '\u{9b}', '\u{202e}', '\r'] {
            let told = told(&format!("omega = \"fast\" # {hidden}[31m"));
            assert!(!told.contains(hidden), "{told:?}");
        }
        let told = told(&format!("omega = \"{}\"", "ü".repeat(500)));
        assert!(told.ends_with("...`") && told.lines().count() == 1, "{told}");
    }
}
