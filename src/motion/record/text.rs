//! A file as lines.

/// A line with its number, the first being 1.
pub type Numbered<'a> = (usize, &'a [u8]);

/// The lines of a file, without their ends: LF, CR LF, CR CR LF, or CR alone where there is no LF.
#[derive(Debug)]
pub struct Text<'a> {
    lines: Vec<&'a [u8]>,
}

impl<'a> Text<'a> {
    /// Splits a file; a byte order mark before it and a DOS end-of-file mark after it are not part of it.
    pub fn new(bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let bytes = bytes.strip_suffix(b"\x1a").unwrap_or(bytes);
        let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        let lines = bytes.split(|byte| *byte == end).map(<[u8]>::trim_ascii_end).collect();
        Self { lines }
    }

    /// How many lines there are.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// A line, the first being 1; empty after the end.
    pub fn line(&self, number: usize) -> &'a [u8] {
        number.checked_sub(1).and_then(|place| self.lines.get(place)).copied().unwrap_or_default()
    }

    /// The lines from one on, with their numbers.
    pub fn from(&self, first: usize) -> impl Iterator<Item = Numbered<'a>> {
        self.lines.iter().enumerate().skip(first.saturating_sub(1)).map(|(place, line)| (place + 1, *line))
    }

    /// The lines before one, which are a header.
    pub fn before(&self, line: usize) -> Vec<Numbered<'a>> {
        self.from(1).take(line.saturating_sub(1)).collect()
    }

    /// The first of some lines that contains a text, whatever the case.
    pub fn find(&self, first: usize, lines: usize, what: &str) -> Option<usize> {
        self.from(first).take(lines).find(|(_, line)| contains(line, what)).map(|(number, _)| number)
    }
}

/// Where a line contains a text, whatever the case of its ASCII letters.
pub fn place_of(line: &[u8], what: &str) -> Option<usize> {
    line.windows(what.len().max(1)).position(|window| window.eq_ignore_ascii_case(what.as_bytes()))
}

/// Whether a line contains a text, whatever the case of its ASCII letters.
pub fn contains(line: &[u8], what: &str) -> bool {
    place_of(line, what).is_some()
}

/// The words of a line.
pub fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The first number in a text, and what follows it.
pub fn first_number(text: &[u8]) -> Option<(f64, &[u8])> {
    let start = text.iter().position(|byte| byte.is_ascii_digit() || b"+-.".contains(byte))?;
    let text = text.get(start..)?;
    let length = text.iter().take_while(|byte| byte.is_ascii_alphanumeric() || b"+-.".contains(byte)).count();
    // A unit may touch its number, as in `200Hz`.
    (1..=length).rev().find_map(|length| {
        let (number, rest) = text.split_at_checked(length)?;
        Some((super::number::value(number)?, rest))
    })
}
