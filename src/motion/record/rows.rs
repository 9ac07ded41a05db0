//! Numbers in rows, one or several a line, in the order of time.

use super::{MOST_SAMPLES, RecordError, error, error::shown, number, number::Field, text::Text};

/// No number is printed with more characters.
const LONGEST_NUMBER: usize = 30;

/// What a line of a block of numbers is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Nothing.
    Blank,
    /// Only numbers, or what is meant as such.
    Numbers,
    /// Prose.
    Prose,
}

/// The fields of a line, between blanks, commas and semicolons.
pub fn fields(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| byte.is_ascii_whitespace() || matches!(byte, b',' | b';')).filter(|field| !field.is_empty())
}

/// What a line is.
pub fn kind(line: &[u8]) -> Kind {
    let mut fields = fields(line).peekable();
    if fields.peek().is_none() {
        return Kind::Blank;
    }
    // A long line of asterisks is drawn, not printed for lack of room.
    let is_rule = line.len() > LONGEST_NUMBER && line.iter().all(|byte| *byte == b'*');
    if !is_rule && fields.all(|field| number::field(field) != Field::Other) { Kind::Numbers } else { Kind::Prose }
}

/// The first line of numbers from a line on.
pub fn first(text: &Text<'_>, from: usize) -> Option<usize> {
    text.from(from).find(|(_, line)| kind(line) == Kind::Numbers).map(|(line, _)| line)
}

/// Reads all numbers from a line on; and the last line that has any.
///
/// # Errors
/// When something else stands there, except a mark of the end after the last number.
pub fn numbers(text: &Text<'_>, from: usize) -> Result<(Vec<f64>, usize), RecordError> {
    let (mut numbers, mut last) = (Vec::new(), from);
    for (line, content) in text.from(from) {
        for mut rest in fields(content) {
            while !rest.is_empty() {
                let Field::Number(value, after) = number::field(rest) else {
                    return if is_end(text, line) {
                        Ok((numbers, last))
                    } else {
                        Err(not_a_number(line, rest, content))
                    };
                };
                (rest, last) = (after, line);
                numbers.push(value);
            }
        }
        if numbers.len() > MOST_SAMPLES {
            return Err(error::too_many());
        }
    }
    Ok((numbers, last))
}

/// Whether a line is a mark of the end, such as `*** End Data ***`, after which no numbers come.
pub fn is_end(text: &Text<'_>, line: usize) -> bool {
    let content = text.line(line);
    let speaks = super::text::contains(content, "end") || content.starts_with(b"#");
    speaks && kind(content) == Kind::Prose && first(text, line + 1).is_none()
}

/// What is wrong with a field among numbers.
fn not_a_number(line: usize, field: &[u8], content: &[u8]) -> RecordError {
    match (kind(content), number::field(field)) {
        (Kind::Prose, Field::Other) if fields(content).count() > 1 => RecordError::at(
            line,
            format!("`{}` in `{}`; expected are numbers up to the end of the data", shown(field), shown(content)),
        ),
        _ => number::error(line, field),
    }
}
