//! Parts of a sweep: stretches of its points, so that their tables one after another are the table of the whole, byte for byte.

use std::ops::Range;

/// A part of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stretch {
    /// Its points.
    pub points: Range<usize>,
    /// Whether the head of the table is its own.
    pub has_head: bool,
}

impl Stretch {
    /// The `part`-th of `parts`, from 1 on, of so many points.
    pub fn new(points: usize, part: usize, parts: usize) -> Self {
        Self { points: range(points, part, parts), has_head: part == 1 }
    }
}

fn range(points: usize, part: usize, parts: usize) -> Range<usize> {
    let start = |part: usize| (points as u128 * part as u128 / parts.max(1) as u128) as usize;
    start(part.saturating_sub(1))..start(part)
}

#[cfg(test)]
mod tests {
    use super::range;

    #[test]
    fn parts_follow_each_other_and_are_all() {
        for (points, parts) in [(10, 3), (2, 5), (0, 2), (1, 1), (usize::MAX, 7)] {
            assert_eq!((range(points, 1, parts).start, range(points, parts, parts).end), (0, points));
            assert!((1..parts).all(|part| range(points, part, parts).end == range(points, part + 1, parts).start));
        }
    }
}
