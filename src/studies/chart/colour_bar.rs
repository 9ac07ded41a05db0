//! The colours of a heat map beside it, with the values that they stand for.

use super::{
    Axis,
    axis::Span,
    canvas::{Anchor, Canvas, Stroke},
    caption::Paragraph,
    colour::BLACK,
    colour_map::colour,
    frame::{LABEL, TEXT},
    geometry::Rect,
    text,
    ticks::Ticks,
};

/// Rectangles reach this far under the next one, so that no seam shows between them.
pub(super) const OVERLAP: f64 = 2.0;

/// The width of the colours themselves,
const BAR: f64 = 22.0;
/// and of what is free before them, before the tick labels, and before the label.
const BEFORE: [f64; 3] = [24.0, 9.0, 8.0];
/// No bar is lower than this.
const LOWEST: f64 = 290.0;

/// A colour bar.
pub(super) struct ColourBar {
    colours: Span,
    ticks: Ticks,
    label: Paragraph,
}

impl ColourBar {
    /// The bar of the range `colours` of `axis`.
    pub(super) fn new(axis: &Axis, colours: Span) -> Self {
        let ticks = Ticks::of(axis, &colours, LOWEST, |_| 28.0);
        Self { colours, ticks, label: Paragraph::even(&axis.label, LABEL, LOWEST) }
    }

    /// The room that it takes beside the panels.
    pub(super) fn width(&self) -> f64 {
        let labels = self.ticks.major.iter().map(|tick| text::width(&tick.label, TEXT)).fold(0.0, f64::max);
        BAR + BEFORE.iter().sum::<f64>() + labels + self.label.height()
    }

    /// The bar, at the right edge of `area` and as high.
    pub(super) fn draw(&self, canvas: &mut Canvas, area: &Rect) {
        const STEPS: usize = 128;
        let [before, before_ticks, _] = BEFORE;
        let left = area.right - self.width() + before;
        let bar = Rect { left, right: left + BAR, ..*area };
        for step in 0..STEPS {
            let height = |index: usize| bar.at(0.0, index as f64 / STEPS as f64).1;
            let rect = Rect { top: (height(step + 1) - OVERLAP).max(bar.top), bottom: height(step), ..bar };
            canvas.fill(&rect, colour((step as f64 + 0.5) / STEPS as f64));
        }
        canvas.frame(&bar, Stroke::whole(BLACK, 1.0));
        for tick in &self.ticks.major {
            let (_, y) = bar.at(0.0, self.colours.fraction(tick.value));
            canvas.line(&[(bar.right, y), (bar.right + 5.0, y)], Stroke::whole(BLACK, 1.0));
            canvas.text(&tick.label, (bar.right + before_ticks, y), TEXT, Anchor::Left);
        }
        self.label.draw_upright(canvas, area.right - self.label.height(), bar.at(0.0, 0.5).1);
    }
}
