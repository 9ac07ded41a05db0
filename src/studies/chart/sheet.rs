//! What line charts and heat maps share: title, panels with axes and marks in a grid, legend and caption; and where each of them stands.
//!
//! All panels have the same ranges, so only the outer ones are labelled.

use super::{
    Axis, Error, Mark,
    axis::Span,
    canvas::{Anchor, Canvas, Stroke},
    caption::Paragraph,
    colour::{BLACK, DARK, LIGHT, PALE, WHITE},
    geometry::Rect,
    legend::{Entry, Legend},
    stroke::Plot,
    text,
    ticks::Ticks,
};

const TITLE: f64 = 20.0;
pub(super) const LABEL: f64 = 18.0;
pub(super) const TEXT: f64 = 16.0;
/// The height of a line of [`TEXT`].
const LINE: f64 = 20.0;
const MARGIN: f64 = 16.0;
const MARK_DASH: &[f64] = &[7.0, 4.0];

/// A chart without what is in its panels.
pub(super) struct Sheet<'a> {
    pub(super) title: &'a str,
    pub(super) caption: &'a str,
    pub(super) x: (&'a Axis, Span),
    pub(super) y: (&'a Axis, Span),
    pub(super) columns: usize,
    pub(super) panels: Vec<Head<'a>>,
    pub(super) legend: Vec<Entry>,
    /// The heights of the strips above and below the axes for what is off the scale.
    pub(super) strips: (f64, f64),
    /// Whether the panels are filled, so that a grid would not be seen and marks must lie on top.
    pub(super) is_filled: bool,
    /// The width of what stands to the right of all panels.
    pub(super) side: f64,
}

/// A panel without its content.
pub(super) struct Head<'a> {
    pub(super) title: &'a str,
    pub(super) marks: &'a [Mark],
}

/// Where things stand.
struct Layout {
    x_ticks: Ticks,
    y_ticks: Ticks,
    /// The frame of each panel.
    frames: Vec<Rect>,
    /// Around all frames.
    grid: Rect,
    titles: Vec<Paragraph>,
    title: Paragraph,
    x_label: Paragraph,
    y_label: Paragraph,
    caption: Paragraph,
    x_label_top: f64,
    legend_top: f64,
    caption_top: f64,
    width: f64,
    height: f64,
}

impl Sheet<'_> {
    /// The SVG: `content` draws in each panel, `side` to the right of all.
    pub(super) fn svg(
        &self,
        mut content: impl FnMut(&mut Canvas, usize, &Plot),
        side: impl FnOnce(&mut Canvas, &Rect),
    ) -> Result<String, Error> {
        if self.panels.is_empty() {
            return Err(Error::Nothing { chart: self.title.to_owned() });
        }
        let layout = self.layout();
        let mut canvas = Canvas::new(layout.width, layout.height);
        layout.title.draw_bold(&mut canvas, MARGIN, MARGIN, Anchor::Left);
        for (index, (head, frame)) in self.panels.iter().zip(&layout.frames).enumerate() {
            let plot = Plot { area: self.inner(frame), x: &self.x.1, y: &self.y.1 };
            if !self.is_filled {
                grid(&mut canvas, frame, &plot, &layout);
                self.marks(&mut canvas, frame, &plot, head);
            }
            content(&mut canvas, index, &plot);
            if self.is_filled {
                self.marks(&mut canvas, frame, &plot, head);
            }
            self.axes(&mut canvas, index, frame, &plot, &layout);
            self.mark_labels(&mut canvas, frame, &plot, head);
            let above = frame.top - self.mark_rows(frame.width()) as f64 * LINE - 4.0;
            if let Some(title) = layout.titles.get(index) {
                title.draw(&mut canvas, 0.5 * (frame.left + frame.right), above - title.height(), Anchor::Middle);
            }
        }
        let (middle_x, middle_y) = layout.grid.at(0.5, 0.5);
        layout.x_label.draw(&mut canvas, middle_x, layout.x_label_top, Anchor::Middle);
        layout.y_label.draw_upright(&mut canvas, MARGIN, middle_y);
        side(&mut canvas, &Rect { left: layout.grid.right, right: layout.width - MARGIN, ..layout.grid });
        let room = layout.width - 2.0 * MARGIN;
        Legend::new(&self.legend, room).draw(&mut canvas, MARGIN, layout.legend_top);
        layout.caption.draw(&mut canvas, MARGIN, layout.caption_top, Anchor::Left);
        Ok(canvas.file(self.title, self.caption))
    }

    /// The columns there really are.
    fn columns(&self) -> usize {
        self.columns.clamp(1, self.panels.len().max(1))
    }

    /// The width and height of a panel's frame, without strips.
    fn size(&self) -> (f64, f64) {
        match self.columns() {
            1 => (540.0, 390.0),
            2 => (430.0, 330.0),
            _ => (380.0, 300.0),
        }
    }

    fn inner(&self, frame: &Rect) -> Rect {
        Rect { top: frame.top + self.strips.0, bottom: frame.bottom - self.strips.1, ..*frame }
    }

    fn layout(&self) -> Layout {
        const GAP: f64 = 26.0;
        let columns = self.columns();
        let rows = self.panels.len().div_ceil(columns);
        let (width, height) = self.size();
        let frame_height = height + self.strips.0 + self.strips.1;

        let x_ticks = Ticks::of(self.x.0, &self.x.1, width, |label| text::width(label, TEXT) + 14.0);
        let y_ticks = Ticks::of(self.y.0, &self.y.1, height, |_| 27.0);
        let widest = |ticks: &Ticks| ticks.major.iter().map(|tick| text::width(&tick.label, TEXT)).fold(0.0, f64::max);
        let level = self.panels.iter().flat_map(|head| head.marks).filter(|mark| mark.y().is_some());
        let beside = level.map(|mark| text::width(mark.label(), TEXT) + 6.0).fold(0.0, f64::max);
        let between = GAP.max(widest(&x_ticks) + 8.0).max(beside + 12.0);

        let titles: Vec<_> =
            self.panels.iter().map(|head| Paragraph::even(head.title, LABEL, width + 0.5 * between)).collect();
        let title_height = titles.iter().map(Paragraph::height).fold(0.0, f64::max);
        let above = title_height + self.mark_rows(width) as f64 * LINE + 4.0;
        let grid_height = rows as f64 * (above + frame_height) + (rows - 1) as f64 * GAP * 0.7;
        let grid_width = columns as f64 * width + (columns - 1) as f64 * between;

        let y_label = Paragraph::even(&self.y.0.label, LABEL, grid_height);
        let left = MARGIN + y_label.height() + 6.0 + widest(&y_ticks) + 9.0;
        let right = left + grid_width;
        let narrowest = right + (beside + 4.0).max(0.5 * widest(&x_ticks)) + self.side + MARGIN;
        let sheet = narrowest.max(Legend::new(&self.legend, narrowest - 2.0 * MARGIN).width() + 2.0 * MARGIN);
        let room = sheet - 2.0 * MARGIN;

        let title = Paragraph::bold(self.title, TITLE, room);
        let x_label = Paragraph::even(&self.x.0.label, LABEL, grid_width);
        let caption = Paragraph::new(self.caption, TEXT, room);
        let legend = Legend::new(&self.legend, room);

        let grid_top = MARGIN + title.height() + 8.0;
        let grid = Rect { left, top: grid_top + above, right, bottom: grid_top + grid_height };
        let frames = (0..self.panels.len()).map(|index| {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let left = left + column * (width + between);
            let top = grid.top + row * (frame_height + above + 0.7 * GAP);
            Rect { left, top, right: left + width, bottom: top + frame_height }
        });
        let x_label_top = grid.bottom + 9.0 + LINE + 2.0;
        let legend_top = x_label_top + x_label.height() + 10.0;
        let caption_top = legend_top + legend.height() + 10.0;
        Layout {
            frames: frames.collect(),
            height: caption_top + caption.height() + MARGIN,
            width: sheet,
            x_ticks,
            y_ticks,
            grid,
            titles,
            title,
            x_label,
            y_label,
            caption,
            x_label_top,
            legend_top,
            caption_top,
        }
    }

    /// The frame of a panel and what is written at its axes.
    fn axes(&self, canvas: &mut Canvas, index: usize, frame: &Rect, plot: &Plot, layout: &Layout) {
        // Inward, or outward where they would lie on colours.
        let (short, long) = if self.is_filled { (-3.0, -6.0) } else { (4.0, 7.0) };
        let strokes = |ticks: &Ticks| {
            let major = ticks.major.iter().map(|tick| (tick.value, long));
            major.chain(ticks.minor.iter().map(|value| (*value, short))).collect::<Vec<_>>()
        };
        for (value, length) in strokes(&layout.x_ticks) {
            let (x, _) = plot.area.at(plot.x.fraction(value), 0.0);
            canvas.line(&[(x, frame.bottom), (x, frame.bottom - length)], Stroke::whole(BLACK, 1.0));
        }
        for (value, length) in strokes(&layout.y_ticks) {
            let (_, y) = plot.area.at(0.0, plot.y.fraction(value));
            canvas.line(&[(frame.left, y), (frame.left + length, y)], Stroke::whole(BLACK, 1.0));
        }
        canvas.frame(frame, Stroke::whole(BLACK, 1.2));
        if index + self.columns() >= self.panels.len() {
            for tick in &layout.x_ticks.major {
                let (x, _) = plot.area.at(plot.x.fraction(tick.value), 0.0);
                canvas.text(&tick.label, (x, frame.bottom + 9.0 + 0.5 * TEXT), TEXT, Anchor::Middle);
            }
        }
        if index.is_multiple_of(self.columns()) {
            for tick in &layout.y_ticks.major {
                let (_, y) = plot.area.at(0.0, plot.y.fraction(tick.value));
                canvas.text(&tick.label, (frame.left - 8.0, y), TEXT, Anchor::Right);
            }
        }
    }

    /// The dashed lines of a panel.
    fn marks(&self, canvas: &mut Canvas, frame: &Rect, plot: &Plot, head: &Head) {
        let area = plot.area;
        for mark in head.marks {
            let path = match mark {
                Mark::At { x, .. } if plot.x.holds(*x) => {
                    let (x, _) = area.at(plot.x.fraction(*x), 0.0);
                    [(x, frame.bottom), (x, frame.top)]
                }
                Mark::Level { y, .. } if plot.y.holds(*y) => {
                    let (_, y) = area.at(0.0, plot.y.fraction(*y));
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

    /// The labels of the upright marks of a panel from `left` to `left + width`: the middle and the row of each.
    fn above<'m>(&self, head: &'m Head, left: f64, width: f64) -> Vec<(&'m str, f64, usize)> {
        let mut places: Vec<_> = shown(head.marks, &self.x.1, Mark::x)
            .map(|(x, label)| (label, left + self.x.1.fraction(x) * width, 0.5 * text::width(label, TEXT)))
            .map(|(label, x, half)| {
                let room = (width / 2.0 - half + 8.0).max(0.0);
                let middle = left + width / 2.0;
                (label, x.clamp(middle - room, middle + room), half)
            })
            .collect();
        places.sort_by(|one, other| one.1.total_cmp(&other.1));
        let mut ends: Vec<f64> = Vec::new();
        let mut labels = Vec::new();
        for (label, x, half) in places {
            let row = ends.iter().position(|end| end + 10.0 <= x - half).unwrap_or(ends.len());
            match ends.get_mut(row) {
                Some(end) => *end = x + half,
                None => ends.push(x + half),
            }
            labels.push((label, x, row));
        }
        labels
    }

    /// How many rows the labels above any panel take.
    fn mark_rows(&self, width: f64) -> usize {
        let rows = |head| self.above(head, 0.0, width).iter().map(|(.., row)| row + 1).max();
        self.panels.iter().filter_map(rows).max().unwrap_or(0)
    }

    fn mark_labels(&self, canvas: &mut Canvas, frame: &Rect, plot: &Plot, head: &Head) {
        for (label, x, row) in self.above(head, frame.left, frame.width()) {
            canvas.text(label, (x, frame.top - 4.0 - (row as f64 + 0.5) * LINE), TEXT, Anchor::Middle);
        }
        let mut level: Vec<_> = shown(head.marks, plot.y, Mark::y)
            .map(|(y, label)| (plot.area.at(0.0, plot.y.fraction(y)).1, label))
            .collect();
        level.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut free = f64::NEG_INFINITY;
        for (y, label) in level {
            let y = y.max(free);
            free = y + LINE;
            canvas.text(label, (frame.right + 6.0, y), TEXT, Anchor::Left);
        }
    }
}

/// The places and labels of those marks that have one on `span`.
fn shown<'m>(
    marks: &'m [Mark],
    span: &Span,
    place: impl Fn(&Mark) -> Option<f64>,
) -> impl Iterator<Item = (f64, &'m str)> {
    marks
        .iter()
        .filter_map(move |mark| Some((place(mark)?, mark.label())))
        .filter(|(value, label)| span.holds(*value) && !label.is_empty())
}

/// The lines behind what is drawn.
fn grid(canvas: &mut Canvas, frame: &Rect, plot: &Plot, layout: &Layout) {
    let area = plot.area;
    for tick in &layout.x_ticks.major {
        let (x, _) = area.at(plot.x.fraction(tick.value), 0.0);
        canvas.line(&[(x, area.top), (x, area.bottom)], Stroke::whole(LIGHT, 1.0));
    }
    for tick in &layout.y_ticks.major {
        let (_, y) = area.at(0.0, plot.y.fraction(tick.value));
        canvas.line(&[(area.left, y), (area.right, y)], Stroke::whole(LIGHT, 1.0));
    }
    for strip in [Rect { bottom: area.top, ..*frame }, Rect { top: area.bottom, ..*frame }] {
        if strip.height() > 0.0 {
            canvas.fill(&strip, PALE);
            canvas.frame(&strip, Stroke::whole(DARK, 0.6));
        }
    }
}
