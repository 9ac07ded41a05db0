//! Numbers in rows, one or several a line, in the order of time.

use std::cmp::Ordering;

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

/// Numbers in rows.
#[derive(Debug)]
pub struct Block {
    /// In their order.
    pub numbers: Vec<f64>,
    /// The last line that has any.
    pub last: usize,
    /// The first line but the last that has not as many as the first line, and how many both have.
    uneven: Option<(usize, usize, usize)>,
}

impl Block {
    /// The numbers, if all lines but the last have as many: a line that has not may be a header in numbers.
    pub fn even(self) -> Result<Self, RecordError> {
        match self.uneven {
            Some((line, here, first)) => {
                let message =
                    format!("{here} numbers, after {first} in the first line of numbers; expected are as many in each");
                Err(RecordError::at(line, message))
            }
            None => Ok(self),
        }
    }
}

/// Reads all numbers from a line on.
///
/// # Errors
/// When something else stands there, except a mark of the end after the last number.
pub fn numbers(text: &Text<'_>, from: usize) -> Result<Block, RecordError> {
    let mut block = Block { numbers: Vec::new(), last: from, uneven: None };
    let (mut a_line, mut short) = (0, None);
    for (line, content) in text.from(from) {
        let before = block.numbers.len();
        for mut rest in fields(content) {
            while !rest.is_empty() {
                let Field::Number(value, after) = number::field(rest) else {
                    return if is_end(text, line) { Ok(block) } else { Err(not_a_number(line, rest, content)) };
                };
                (rest, block.last) = (after, line);
                block.numbers.push(value);
            }
        }
        if block.numbers.len() > MOST_SAMPLES {
            return Err(error::too_many());
        }
        let here = block.numbers.len() - before;
        if here == 0 {
            continue;
        }
        // A short line is the last, or it is uneven.
        block.uneven = block.uneven.or(short.take());
        a_line = if before == 0 { here } else { a_line };
        match here.cmp(&a_line) {
            Ordering::Less => short = Some((line, here, a_line)),
            Ordering::Equal => {}
            Ordering::Greater => block.uneven = block.uneven.or(Some((line, here, a_line))),
        }
    }
    Ok(block)
}

/// Whether a line is a mark of the end, such as `*** End Data ***`, after which no numbers come.
pub fn is_end(text: &Text<'_>, line: usize) -> bool {
    let content = text.line(line);
    if matches!(content.trim_ascii_start().first(), Some(b'0'..=b'9' | b'.' | b'"')) {
        return false;
    }
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
