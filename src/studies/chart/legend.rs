//! The legend: below the panels, in as many columns as the width allows.

use super::{
    Draw,
    canvas::{Anchor, Canvas},
    colour::{Colour, DARK},
    geometry::{Place, Rect},
    marker::Shape,
    palette::Ink,
    stroke, text,
};

const SIZE: f64 = 16.0;
const ROW: f64 = 25.0;
const SWATCH: f64 = 54.0;
const GAP: f64 = 9.0;
const BETWEEN: f64 = 26.0;

/// A sample and what it stands for.
pub(super) struct Entry {
    pub(super) swatch: Swatch,
    pub(super) name: String,
}

/// What is drawn before a name.
pub(super) enum Swatch {
    /// A piece of a series.
    Series(Ink, Draw),
    /// A marker that any series may have.
    Marker(Shape),
    /// A shaded area.
    Shade(Colour),
    /// Short strokes at the foot of a panel.
    Strokes,
    /// A cell without a value, of a kind.
    Hatch(usize),
    /// Nothing: a remark.
    Remark,
}

impl Entry {
    fn width(&self) -> f64 {
        self.indent() + text::width(&self.name, SIZE)
    }

    fn indent(&self) -> f64 {
        match self.swatch {
            Swatch::Remark => 0.0,
            _ => SWATCH + GAP,
        }
    }
}

/// The entries, column by column.
pub(super) struct Legend<'a> {
    entries: &'a [Entry],
    rows: usize,
    /// The widths of the columns.
    widths: Vec<f64>,
}

impl<'a> Legend<'a> {
    /// `entries` in as few rows as make a legend no wider than `room`; in one column if there is no such.
    pub(super) fn new(entries: &'a [Entry], room: f64) -> Self {
        let widths = |rows: usize| -> Vec<f64> {
            entries.chunks(rows).map(|column| column.iter().map(Entry::width).fold(0.0, f64::max)).collect()
        };
        let last = entries.len().max(1);
        let rows = (1..last).find(|rows| total(&widths(*rows)) <= room).unwrap_or(last);
        Self { entries, rows, widths: widths(rows) }
    }

    pub(super) fn height(&self) -> f64 {
        self.rows.min(self.entries.len()) as f64 * ROW
    }

    pub(super) fn width(&self) -> f64 {
        total(&self.widths)
    }

    /// The legend with its top left corner at a place.
    pub(super) fn draw(&self, canvas: &mut Canvas, left: f64, top: f64) {
        let mut x = left;
        for (column, width) in self.entries.chunks(self.rows).zip(&self.widths) {
            for (row, entry) in column.iter().enumerate() {
                let y = top + (row as f64 + 0.5) * ROW;
                swatch(canvas, &entry.swatch, x, y);
                canvas.text(&entry.name, (x + entry.indent(), y), SIZE, Anchor::Left);
            }
            x += width + BETWEEN;
        }
    }
}

/// The width of columns side by side.
fn total(widths: &[f64]) -> f64 {
    widths.iter().sum::<f64>() + widths.len().saturating_sub(1) as f64 * BETWEEN
}

/// A sample of an area.
fn around((x, y): Place) -> Rect {
    Rect { left: x - 14.0, top: y - 8.0, right: x + 14.0, bottom: y + 8.0 }
}

fn swatch(canvas: &mut Canvas, swatch: &Swatch, x: f64, y: f64) {
    let middle = (x + 0.5 * SWATCH, y);
    match swatch {
        Swatch::Series(ink, draw) => {
            if *draw != Draw::Markers {
                canvas.line(&[(x, y), (x + SWATCH, y)], ink.stroke(*draw));
            }
            if matches!(draw, Draw::Both | Draw::Markers) {
                canvas.marker(ink.shape, middle, ink.colour);
            }
        }
        Swatch::Marker(shape) => canvas.marker(*shape, middle, DARK),
        Swatch::Shade(colour) => canvas.fill(&around(middle), *colour),
        Swatch::Strokes => {
            for place in [-14.0, -4.0, 4.0, 9.0, 12.0, 14.0] {
                stroke::at_foot(canvas, (middle.0 + place, y + 5.0));
            }
        }
        Swatch::Hatch(kind) => stroke::hatch(canvas, &around(middle), *kind),
        Swatch::Remark => {}
    }
}
