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
    /// The mark of the end after it, if there is one, in words: what is no number is not left out in silence.
    pub end: Option<String>,
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
    let mut block = Block { numbers: Vec::new(), last: from, end: None, uneven: None };
    let (mut a_line, mut short) = (0, None);
    for (line, content) in text.from(from) {
        let before = block.numbers.len();
        for mut rest in fields(content) {
            while !rest.is_empty() {
                let Field::Number(value, after) = number::field(rest) else {
                    block.end = end(text, line);
                    return if block.end.is_some() { Ok(block) } else { Err(not_a_number(line, rest, content)) };
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

/// What to tell of a line that is a mark of the end, such as `*** End Data ***` or a comment, after which no numbers come; `None` for any other line.
pub fn end(text: &Text<'_>, line: usize) -> Option<String> {
    let content = text.line(line);
    let begins_otherwise =
        fields(content).next().is_some_and(|field| !matches!(number::field(field), Field::Number(..)));
    let speaks = speaks_of_end(content) || content.starts_with(b"#");
    let is_end = kind(content) == Kind::Prose
        && begins_otherwise
        && !content.starts_with(b"\"")
        && speaks
        && first(text, line + 1).is_none();
    is_end.then(|| format!("line {line}, `{}`, ends the numbers", shown(content)))
}

/// Whether a line has a word such as `End`.
fn speaks_of_end(line: &[u8]) -> bool {
    let mut words = line.split(|byte| !byte.is_ascii_alphabetic());
    words.any(|word| word.get(..3).is_some_and(|start| start.eq_ignore_ascii_case(b"end")))
}

/// Refuses what should be numbers among the lines between a header and the first line of numbers: more numbers than words, or a mark of the end.
pub fn check_between(text: &Text<'_>, from: usize, to: usize) -> Result<(), RecordError> {
    for (line, content) in text.from(from).take(to.saturating_sub(from)) {
        let is_number = |field: &&[u8]| number::field(field) != Field::Other;
        let (all, numbers) = (fields(content).count(), fields(content).filter(is_number).count());
        let word = fields(content).find(|field| !is_number(field));
        if let Some(word) = word.filter(|_| 2 * numbers > all || speaks_of_end(content)) {
            return Err(not_a_number(line, word, content));
        }
    }
    Ok(())
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
