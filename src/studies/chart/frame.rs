//! The frame of a panel, what is drawn behind its content, and what is written around it.

use super::{
    Mark,
    axis::Span,
    canvas::{Anchor, Canvas, Stroke},
    colour::{BLACK, DARK, LIGHT, PALE, WHITE},
    geometry::Rect,
    stroke::Plot,
    text,
    ticks::{Tick, Ticks},
};

pub(super) const LABEL: f64 = 18.0;
pub(super) const TEXT: f64 = 16.0;
/// The height of a line of [`TEXT`].
pub(super) const LINE: f64 = 20.0;
const MARK_DASH: &[f64] = &[7.0, 4.0];

/// A panel without its content.
pub(super) struct Frame<'a> {
    /// Its edge; the area of the plot is within it, between the strips for what is off the scale.
    pub(super) rect: Rect,
    pub(super) plot: &'a Plot<'a>,
    pub(super) x_ticks: &'a Ticks,
    pub(super) y_ticks: &'a Ticks,
    /// Whether it is filled, so that marks must be seen on any colour and strokes would be lost inside.
    pub(super) is_filled: bool,
}

impl Frame<'_> {
    /// The lines behind what is drawn.
    pub(super) fn grid(&self, canvas: &mut Canvas) {
        let Plot { area, x: across, y: up } = self.plot;
        for tick in &self.x_ticks.major {
            let (x, _) = area.at(across.fraction(tick.value), 0.0);
            canvas.line(&[(x, area.top), (x, area.bottom)], Stroke::whole(LIGHT, 1.0));
        }
        for tick in &self.y_ticks.major {
            let (_, y) = area.at(0.0, up.fraction(tick.value));
            canvas.line(&[(area.left, y), (area.right, y)], Stroke::whole(LIGHT, 1.0));
        }
        for strip in [Rect { bottom: area.top, ..self.rect }, Rect { top: area.bottom, ..self.rect }] {
            if strip.height() > 0.0 {
                canvas.fill(&strip, PALE);
                canvas.frame(&strip, Stroke::whole(DARK, 0.6));
            }
        }
    }

    /// The dashed lines of a panel.
    pub(super) fn marks(&self, canvas: &mut Canvas, marks: &[Mark]) {
        let (Plot { area, x: across, y: up }, frame) = (self.plot, &self.rect);
        for mark in marks {
            let path = match mark {
                Mark::At { x, .. } if across.holds(*x) => {
                    let (x, _) = area.at(across.fraction(*x), 0.0);
                    [(x, frame.bottom), (x, frame.top)]
                }
                Mark::Level { y, .. } if up.holds(*y) => {
                    let (_, y) = area.at(0.0, up.fraction(*y));
                    [(frame.left, y), (frame.right, y)]
                }
                _ => continue,
            };
            if self.is_filled {
                canvas.line(&path, Stroke::whole(WHITE, 3.0));
            }
            canvas.line(&path, Stroke { colour: DARK, thick: 1.5, dash: MARK_DASH });
        }
    }

    /// The edge, and strokes at the ticks: inward, or outward where they would lie on colours.
    pub(super) fn edge(&self, canvas: &mut Canvas) {
        let (plot, frame) = (self.plot, &self.rect);
        let (short, long) = if self.is_filled { (-3.0, -6.0) } else { (4.0, 7.0) };
        let strokes = |ticks: &Ticks| {
            let major = ticks.major.iter().map(|tick| (tick.value, long));
            major.chain(ticks.minor.iter().map(|value| (*value, short))).collect::<Vec<_>>()
        };
        for (value, length) in strokes(self.x_ticks) {
            let (x, _) = plot.area.at(plot.x.fraction(value), 0.0);
            canvas.line(&[(x, frame.bottom), (x, frame.bottom - length)], Stroke::whole(BLACK, 1.0));
        }
        for (value, length) in strokes(self.y_ticks) {
            let (_, y) = plot.area.at(0.0, plot.y.fraction(value));
            canvas.line(&[(frame.left, y), (frame.left + length, y)], Stroke::whole(BLACK, 1.0));
        }
        canvas.frame(frame, Stroke::whole(BLACK, 1.2));
    }

    /// The values of the first axis.
    pub(super) fn below(&self, canvas: &mut Canvas) {
        for Tick { value, label } in &self.x_ticks.major {
            let (x, _) = self.plot.area.at(self.plot.x.fraction(*value), 0.0);
            canvas.text(label, (x, self.rect.bottom + 9.0 + 0.5 * TEXT), TEXT, Anchor::Middle);
        }
    }

    /// The values of the second axis.
    pub(super) fn left(&self, canvas: &mut Canvas) {
        for Tick { value, label } in &self.y_ticks.major {
            let (_, y) = self.plot.area.at(0.0, self.plot.y.fraction(*value));
            canvas.text(label, (self.rect.left - 8.0, y), TEXT, Anchor::Right);
        }
    }

    /// The values of another scale of the second axis, at its other side.
    pub(super) fn right(&self, canvas: &mut Canvas, span: &Span, ticks: &Ticks) {
        let right = self.rect.right;
        for Tick { value, label } in &ticks.major {
            let (_, y) = self.plot.area.at(0.0, span.fraction(*value));
            canvas.line(&[(right - 7.0, y), (right, y)], Stroke::whole(BLACK, 1.0));
            canvas.text(label, (right + 8.0, y), TEXT, Anchor::Left);
        }
    }

    /// The labels of the level marks.
    pub(super) fn beside(&self, canvas: &mut Canvas, marks: &[Mark]) {
        let mut level: Vec<_> = shown(marks, self.plot.y, Mark::y)
            .map(|(y, label)| (self.plot.area.at(0.0, self.plot.y.fraction(y)).1, label))
            .collect();
        level.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut free = f64::NEG_INFINITY;
        for (y, label) in level {
            let y = y.max(free);
            free = y + LINE;
            canvas.text(label, (self.rect.right + 6.0, y), TEXT, Anchor::Left);
        }
    }
}

/// The places and labels of those marks that have one on `span`.
pub(super) fn shown<'m>(
    marks: &'m [Mark],
    span: &Span,
    place: impl Fn(&Mark) -> Option<f64>,
) -> impl Iterator<Item = (f64, &'m str)> {
    marks
        .iter()
        .filter_map(move |mark| Some((place(mark)?, mark.label())))
        .filter(|(value, label)| span.holds(*value) && !label.is_empty())
}

/// The width of the labels of level marks beside a panel.
pub(super) fn beside<'m>(marks: impl IntoIterator<Item = &'m Mark>) -> f64 {
    let level = marks.into_iter().filter(|mark| mark.y().is_some());
    level.map(|mark| text::width(mark.label(), TEXT) + 6.0).fold(0.0, f64::max)
}
