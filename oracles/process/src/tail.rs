//! The end of an output of any length.

/// How much is kept.
const KEPT: usize = 64 * 1024;

/// The last 64 KiB of what was added.
#[derive(Debug, Default)]
pub struct Tail {
    bytes: Vec<u8>,
}

impl Tail {
    /// Adds to the end.
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
        // Twice as much is let in before the front is dropped, so that many short pieces cost little.
        if self.bytes.len() > 2 * KEPT {
            self.bytes.drain(..self.bytes.len() - KEPT);
        }
    }

    /// The last bytes, `most` at the most, as text.
    pub fn text(&self, most: usize) -> String {
        let from = self.bytes.len().saturating_sub(most.min(KEPT));
        String::from_utf8_lossy(self.bytes.get(from..).unwrap_or_default()).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However much is written, the end is kept and no more.
    #[test]
    fn the_end_is_kept_and_no_more() {
        let mut tail = Tail::default();
        for _ in 0..100 {
            tail.add(&[b'a'; 5_000]);
        }
        tail.add(b"end");
        assert_eq!(tail.text(5), "aaend");
        assert_eq!(tail.text(usize::MAX).len(), KEPT);
        assert!(tail.bytes.len() <= 2 * KEPT);
    }
}
