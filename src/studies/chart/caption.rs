//! The title above a chart and the caption below it: text wrapped to the width.

use super::{
    canvas::{Anchor, Canvas},
    text,
};

/// The height of a line, by the size of its letters.
const LEADING: f64 = 1.35;

/// Lines of text of one size.
pub(super) struct Paragraph {
    lines: Vec<String>,
    size: f64,
}

impl Paragraph {
    /// `text` in lines no wider than `room`.
    pub(super) fn new(text: &str, size: f64, room: f64) -> Self {
        Self { lines: text::wrap(text, size, room), size }
    }

    /// As [`Paragraph::new`], with lines of about the same length.
    pub(super) fn even(text: &str, size: f64, room: f64) -> Self {
        let mut paragraph = Self::new(text, size, room);
        for percent in (40..100).rev() {
            let narrower = Self::new(text, size, room * f64::from(percent) / 100.0);
            if narrower.lines.len() > paragraph.lines.len() {
                break;
            }
            paragraph = narrower;
        }
        paragraph
    }

    /// As [`Paragraph::even`], for text that will be bold.
    pub(super) fn bold(text: &str, size: f64, room: f64) -> Self {
        /// How much wider bold letters are.
        const WIDER: f64 = 1.12;
        Self::even(text, size, room / WIDER)
    }

    /// The height of all lines.
    pub(super) fn height(&self) -> f64 {
        self.lines.len() as f64 * self.size * LEADING
    }

    /// The place of the middle of each line, with the first line's top at 0.
    fn lines(&self) -> impl Iterator<Item = (f64, &String)> {
        let middle = |index: usize| (index as f64 + 0.5) * self.size * LEADING;
        self.lines.iter().enumerate().map(move |(index, line)| (middle(index), line))
    }

    /// Lines below each other, the first one's top at `top`.
    pub(super) fn draw(&self, canvas: &mut Canvas, x: f64, top: f64, anchor: Anchor) {
        self.lines().for_each(|(down, line)| canvas.text(line, (x, top + down), self.size, anchor));
    }

    /// As [`Paragraph::draw`], in bold.
    pub(super) fn draw_bold(&self, canvas: &mut Canvas, x: f64, top: f64, anchor: Anchor) {
        self.lines().for_each(|(down, line)| canvas.bold(line, (x, top + down), self.size, anchor));
    }

    /// Lines read from below, beside each other, the first one's left edge at `left`.
    pub(super) fn draw_upright(&self, canvas: &mut Canvas, left: f64, y: f64) {
        self.lines().for_each(|(over, line)| canvas.text(line, (left + over, y), self.size, Anchor::Upright));
    }
}
