//! What line charts and heat maps share: title, panels with axes and marks in a grid, legend and caption; and where each of them stands.
//!
//! All panels have the same ranges, so only the outer ones are labelled.

use super::{
    Axis, Error, Mark,
    axis::Span,
    canvas::{Anchor, Canvas},
    caption::Paragraph,
    frame::{Frame, LABEL, LINE, TEXT, beside, shown},
    geometry::Rect,
    legend::{Entry, Legend},
    stroke::Plot,
    text,
    ticks::Ticks,
};

pub(super) const TITLE: f64 = 20.0;
pub(super) const MARGIN: f64 = 16.0;

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
            let around = Frame {
                rect: *frame,
                plot: &plot,
                x_ticks: &layout.x_ticks,
                y_ticks: &layout.y_ticks,
                is_filled: self.is_filled,
            };
            if !self.is_filled {
                around.grid(&mut canvas);
                around.marks(&mut canvas, head.marks);
            }
            content(&mut canvas, index, &plot);
            if self.is_filled {
                around.marks(&mut canvas, head.marks);
            }
            around.edge(&mut canvas);
            if index + self.columns() >= self.panels.len() {
                around.below(&mut canvas);
            }
            if index.is_multiple_of(self.columns()) {
                around.left(&mut canvas);
            }
            self.mark_labels(&mut canvas, frame, head);
            around.beside(&mut canvas, head.marks);
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
        let beside = beside(self.panels.iter().flat_map(|head| head.marks));
        let between = GAP.max(x_ticks.widest(TEXT) + 8.0).max(beside + 12.0);

        let titles: Vec<_> =
            self.panels.iter().map(|head| Paragraph::even(head.title, LABEL, width + 0.5 * between)).collect();
        let title_height = titles.iter().map(Paragraph::height).fold(0.0, f64::max);
        let above = title_height + self.mark_rows(width) as f64 * LINE + 4.0;
        let grid_height = rows as f64 * (above + frame_height) + (rows - 1) as f64 * GAP * 0.7;
        let grid_width = columns as f64 * width + (columns - 1) as f64 * between;

        let y_label = Paragraph::even(&self.y.0.label, LABEL, grid_height);
        let left = MARGIN + y_label.height() + 6.0 + y_ticks.widest(TEXT) + 9.0;
        let right = left + grid_width;
        let narrowest = right + (beside + 4.0).max(0.5 * x_ticks.widest(TEXT)) + self.side + MARGIN;
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

    fn mark_labels(&self, canvas: &mut Canvas, frame: &Rect, head: &Head) {
        for (label, x, row) in self.above(head, frame.left, frame.width()) {
            canvas.text(label, (x, frame.top - 4.0 - (row as f64 + 0.5) * LINE), TEXT, Anchor::Middle);
        }
    }
}
