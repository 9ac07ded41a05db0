//! Numbers in columns of a fixed width, which may touch: `8F10.5` is eight of ten characters a line.

use super::{MOST_SAMPLES, RecordError, error, number, text::Text};

/// How a block of numbers is laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// How many numbers a full line has.
    pub a_line: usize,
    /// How many characters a number has.
    pub width: usize,
}

impl Layout {
    /// Reads a Fortran format such as `(8F10.5)`, `(1E15.6)` or `(1P5E14.7E1)` that stands somewhere in a line.
    pub fn of(line: &[u8]) -> Option<Self> {
        line.split(|byte| *byte == b'(').skip(1).find_map(Self::of_format)
    }

    fn of_format(text: &[u8]) -> Option<Self> {
        let (a_line, rest) = whole(text)?;
        let (a_line, rest) = match rest {
            // A scale factor, which moves the point of what is printed and says nothing of the columns.
            [b'p' | b'P', rest @ ..] => whole(rest.strip_prefix(b",").unwrap_or(rest))?,
            _ => (a_line, rest),
        };
        let rest = match rest {
            [b'e' | b'E', b's' | b'S' | b'n' | b'N', rest @ ..] => rest,
            [b'e' | b'E' | b'f' | b'F' | b'g' | b'G' | b'i' | b'I' | b'd' | b'D', rest @ ..] => rest,
            _ => return None,
        };
        let (width, _) = whole(rest)?;
        ((1..=1000).contains(&a_line) && (1..=100).contains(&width)).then_some(Self { a_line, width })
    }

    /// How many lines so many numbers take.
    pub const fn lines(self, count: usize) -> usize {
        count.div_ceil(self.a_line)
    }
}

/// The whole number that a text begins with, and the rest.
fn whole(text: &[u8]) -> Option<(usize, &[u8])> {
    let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let (number, rest) = text.split_at_checked(digits)?;
    Some((std::str::from_utf8(number).ok()?.parse().ok()?, rest))
}

/// Reads a block of `count` numbers that begins at a line; `said` is the line that says how many there are.
///
/// # Errors
/// When a field is no number, or there are fewer lines or fields than there should be.
pub fn read(text: &Text<'_>, first: usize, count: usize, said: usize, layout: Layout) -> Result<Vec<f64>, RecordError> {
    if count > MOST_SAMPLES {
        return Err(error::too_many());
    }
    let mut numbers = Vec::with_capacity(count.min(text.len().saturating_mul(layout.a_line)));
    for (line, content) in text.from(first).take(layout.lines(count)) {
        let wanted = layout.a_line.min(count - numbers.len());
        if content.len() > wanted * layout.width {
            let expected = format!("{wanted} columns of {} characters", layout.width);
            return Err(RecordError::at(line, format!("`{}`; expected are {expected}", error::shown(content))));
        }
        for field in content.chunks(layout.width).map(<[u8]>::trim_ascii) {
            numbers.push(number::value(field).ok_or_else(|| number::error(line, field))?);
        }
        if content.len().div_ceil(layout.width) < wanted {
            break;
        }
    }
    if numbers.len() == count { Ok(numbers) } else { Err(fewer(said, count, numbers.len())) }
}

/// There are fewer numbers than a header says.
pub fn fewer(said: usize, count: usize, found: usize) -> RecordError {
    RecordError::at(said, format!("{count} numbers are announced, and {found} follow; expected is as many"))
}
