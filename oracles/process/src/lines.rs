//! Bytes become lines, none longer than its limit.

/// How far the end of a line that is too long is looked for.
const MOST_SKIPPED: usize = 1 << 31;

/// What came out of the bytes so far.
#[derive(Debug, PartialEq)]
pub enum Cut {
    /// A line, without its end.
    Line(Vec<u8>),
    /// A line that was too long, and how long.
    TooLong(usize),
    /// More than any line could be, and no end.
    Endless,
}

/// Bytes that wait to become lines. Holds no more than the limit and one piece of what is added.
#[derive(Debug, Default)]
pub struct Lines {
    bytes: Vec<u8>,
    /// Where the next line starts.
    start: usize,
    /// Up to where no end of a line was found.
    looked: usize,
    /// How much of a line that is too long was dropped.
    skipped: usize,
}

impl Lines {
    /// Adds what was read.
    pub fn add(&mut self, bytes: &[u8]) {
        if self.start > 0 {
            self.bytes.drain(..self.start);
            self.looked -= self.start;
            self.start = 0;
        }
        self.bytes.extend_from_slice(bytes);
    }

    /// The next line of at most `limit` bytes, if its end is there.
    pub fn next(&mut self, limit: usize) -> Option<Cut> {
        let end = self.bytes.iter().skip(self.looked).position(|byte| *byte == b'\n').map(|at| self.looked + at);
        let Some(end) = end else {
            self.looked = self.bytes.len();
            if self.skipped > 0 || self.bytes.len() - self.start > limit {
                self.skipped += self.bytes.len() - self.start;
                (self.bytes, self.start, self.looked) = (Vec::new(), 0, 0);
            }
            return (self.skipped > MOST_SKIPPED).then_some(Cut::Endless);
        };
        let length = self.skipped + end - self.start;
        let cut = if length > limit { Cut::TooLong(length) } else { Cut::Line(self.line(end)) };
        self.skipped = 0;
        self.start = (end + 1).min(self.bytes.len());
        self.looked = self.start;
        Some(cut)
    }

    /// The line that ends here. One that fills the memory is moved, not copied: it may be long.
    fn line(&mut self, end: usize) -> Vec<u8> {
        if self.start == 0 && end + 1 == self.bytes.len() {
            let mut line = std::mem::take(&mut self.bytes);
            line.truncate(end);
            return line;
        }
        self.bytes.get(self.start..end).unwrap_or_default().to_vec()
    }

    /// How much there is of a line whose end has not come.
    pub fn unfinished(&self) -> usize {
        self.skipped + self.bytes.len() - self.start
    }

    /// Whether the line whose end has not come is too long already.
    pub fn overflows(&self) -> bool {
        self.skipped > 0
    }

    /// The start of the line whose end has not come.
    pub fn rest(&self) -> &[u8] {
        self.bytes.get(self.start..).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str) -> Option<Cut> {
        Some(Cut::Line(text.as_bytes().to_vec()))
    }

    /// However the bytes are cut into pieces, the lines are the same.
    #[test]
    fn pieces_do_not_matter() {
        let all = b"one\n\ntwo three\nfour\nfive";
        for size in 1..=all.len() {
            let mut lines = Lines::default();
            let mut found = Vec::new();
            for piece in all.chunks(size) {
                lines.add(piece);
                while let Some(cut) = lines.next(9) {
                    found.push(Some(cut));
                }
            }
            assert_eq!(found, [line("one"), line(""), line("two three"), line("four")], "{size}");
            assert_eq!((lines.unfinished(), lines.rest()), (4, &b"five"[..]));
        }
    }

    /// A line over the limit is told with its length, kept nowhere, and the next one is read.
    #[test]
    fn a_long_line_is_dropped() {
        let mut lines = Lines::default();
        for _ in 0..1_000 {
            lines.add(&[b'a'; 1_000]);
            assert_eq!(lines.next(10_000), None);
            assert!(lines.bytes.capacity() <= 32_000);
        }
        assert!(lines.overflows());
        lines.add(b"a\nnext\n");
        assert_eq!(lines.next(10_000), Some(Cut::TooLong(1_000_001)));
        assert_eq!(lines.next(10_000), line("next"));
        lines.add(b"12345678901\n");
        assert_eq!(lines.next(10), Some(Cut::TooLong(11)));
    }

    /// The end is not looked for for ever.
    #[test]
    fn a_line_without_end_is_given_up() {
        let mut lines = Lines { skipped: MOST_SKIPPED, ..Lines::default() };
        lines.add(b"a");
        assert_eq!(lines.next(10), Some(Cut::Endless));
    }
}
