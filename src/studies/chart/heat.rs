//! Heat maps: a value at each place of a grid, as a colour.

use super::{
    Axis, Error, Mark, Series,
    axis::Span,
    canvas::Canvas,
    colour::BLACK,
    colour_bar::{ColourBar, OVERLAP},
    colour_map::colour,
    geometry::Rect,
    legend::{Entry, Swatch},
    lines::check_marks,
    number,
    palette::Ink,
    series::slots,
    sheet::{Head, Sheet},
    stroke::{self, Plot, is_off},
};

/// A chart of coloured cells in one or more panels with the same axes and colours.
///
/// - The cell of a value reaches half-way to its neighbours (on the scale of the axis). The grid of a panel is spanned by all places
///   that occur in it; a place without a cell, or whose cell has no value, is hatched.
/// - On a logarithmic colour scale exactly 0 has the colour of the lower end; a negative value is an error.
/// - A value beyond a given range has the colour of the nearer end.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// What the chart shows, above it.
    pub title: String,
    /// One sentence below it.
    pub caption: String,
    /// The first axis.
    pub x: Axis,
    /// The second axis.
    pub y: Axis,
    /// What the colours mean.
    pub colour: Axis,
    /// How many panels stand side by side.
    pub columns: usize,
    /// What a cell without a value means, for the legend: `failed`, `declined`; each is hatched in a way of its own.
    pub missing: Vec<String>,
    /// The panels, row by row.
    pub panels: Vec<HeatPanel>,
}

/// One panel of a [`HeatMap`].
#[derive(Debug, Clone, PartialEq)]
pub struct HeatPanel {
    /// What stands above it; may be empty.
    pub title: String,
    /// The values.
    pub cells: Vec<Cell>,
    /// Lines drawn over the cells, such as a boundary; in black, without markers.
    pub curves: Vec<Series>,
    /// Reference lines.
    pub marks: Vec<Mark>,
}

/// A value at a place; without a value, a failure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// The place along the first axis.
    pub x: f64,
    /// The place along the second axis.
    pub y: f64,
    /// The value, if there is one.
    pub value: Option<f64>,
    /// Which of [`HeatMap::missing`] it is if there is none.
    pub why: usize,
}

/// What is drawn at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Filled {
    Value(f64),
    Missing(usize),
}

impl HeatPanel {
    /// A panel of cells only.
    pub fn new(title: impl Into<String>, cells: Vec<Cell>) -> Self {
        Self { title: title.into(), cells, curves: Vec::new(), marks: Vec::new() }
    }

    /// This panel with lines over its cells.
    pub fn with_curves(self, curves: Vec<Series>) -> Self {
        Self { curves, ..self }
    }

    /// This panel with reference lines.
    pub fn with_marks(self, marks: Vec<Mark>) -> Self {
        Self { marks, ..self }
    }
}

impl HeatMap {
    /// The chart as SVG.
    ///
    /// # Errors
    /// When there is nothing to draw, a given range is none, a value has no place on its axis, or two cells have the same place.
    pub fn svg(&self) -> Result<String, Error> {
        self.check()?;
        let grids = self.panels.iter().map(|panel| self.grid(panel)).collect::<Result<Vec<_>, _>>()?;
        let cells = || self.panels.iter().flat_map(|panel| &panel.cells);
        let values = || cells().filter_map(|cell| cell.value);
        let colours = self.colour.span(&self.title, values(), 0.0)?;
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        let slots = slots(curves);
        let bar = ColourBar::new(&self.colour, colours);
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            x: (&self.x, self.span(&self.x, grids.iter().map(|grid| &grid.columns))?),
            y: (&self.y, self.span(&self.y, grids.iter().map(|grid| &grid.rows))?),
            columns: self.columns,
            panels: self.panels.iter().map(|panel| Head { title: &panel.title, marks: &panel.marks }).collect(),
            legend: self.legend(&slots, &grids, values(), &colours),
            strips: (0.0, 0.0),
            is_filled: true,
            side: bar.width(),
        };
        sheet.svg(
            |canvas, index, plot| {
                if let Some(grid) = grids.get(index) {
                    grid.draw(canvas, plot, &colours);
                }
                for series in self.panels.get(index).map_or(&[][..], |panel| &panel.curves) {
                    let slot = slots.iter().find(|(name, ..)| *name == series.name).map_or(0, |(_, slot, _)| *slot);
                    plot.outlined(canvas, series, Ink { colour: BLACK, ..Ink::of(slot) });
                }
            },
            |canvas, area| bar.draw(canvas, area),
        )
    }

    /// Refuses what has no place.
    fn check(&self) -> Result<(), Error> {
        if self.panels.iter().all(|panel| panel.cells.is_empty()) {
            return Err(Error::Nothing { chart: self.title.clone() });
        }
        for panel in &self.panels {
            for cell in &panel.cells {
                self.x.check(&self.title, &panel.title, cell.x)?;
                self.y.check(&self.title, &panel.title, cell.y)?;
                if let Some(value) = cell.value.filter(|value| !is_off(self.colour.scale, *value)) {
                    self.colour.check(&self.title, &panel.title, value)?;
                }
            }
            for (series, point) in
                panel.curves.iter().flat_map(|series| series.points.iter().map(move |point| (series, point)))
            {
                self.x.check(&self.title, &series.name, point.x)?;
                point.y.map_or(Ok(()), |y| self.y.check(&self.title, &series.name, y))?;
            }
            check_marks(&self.title, &self.x, &self.y, &panel.marks)?;
        }
        Ok(())
    }

    /// The given range of an axis, or that of the `edges` of all cells.
    fn span<'a>(&self, axis: &Axis, edges: impl Iterator<Item = &'a Edges>) -> Result<Span, Error> {
        if axis.range.is_some() {
            return axis.span(&self.title, std::iter::empty(), 0.0);
        }
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for edge in edges.flat_map(|edges| &edges.edges) {
            (from, to) = (from.min(*edge), to.max(*edge));
        }
        Ok(Span { scale: axis.scale, from, to })
    }

    fn grid(&self, panel: &HeatPanel) -> Result<Grid, Error> {
        let columns = Edges::new(&self.x, panel.cells.iter().map(|cell| cell.x));
        let rows = Edges::new(&self.y, panel.cells.iter().map(|cell| cell.y));
        let mut cells = vec![None; columns.places.len() * rows.places.len()];
        for Cell { x, y, value, why } in &panel.cells {
            let index = columns.index(*x).zip(rows.index(*y)).map(|(column, row)| row * columns.places.len() + column);
            match index.and_then(|index| cells.get_mut(index)) {
                Some(cell @ None) => *cell = Some(value.map_or(Filled::Missing(*why), Filled::Value)),
                _ => {
                    let (chart, panel) = (self.title.clone(), panel.title.clone());
                    return Err(Error::CellTwice { chart, panel, x: *x, y: *y });
                }
            }
        }
        Ok(Grid { columns, rows, cells: cells.into_iter().map(|cell| cell.unwrap_or(Filled::Missing(0))).collect() })
    }

    fn legend(
        &self,
        slots: &[(&str, usize, super::Draw)],
        grids: &[Grid],
        values: impl Iterator<Item = f64>,
        colours: &Span,
    ) -> Vec<Entry> {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let mut legend = Vec::new();
        if low <= high {
            let ends = if colours.holds(low) && colours.holds(high) { "" } else { ", some beyond the colours shown" };
            let (low, high) = (number::short(low, 2), number::short(high, 2));
            legend.push(Entry { swatch: Swatch::Remark, name: format!("Values from {low} to {high}{ends}") });
        }
        legend.extend(slots.iter().map(|(name, slot, _)| Entry {
            swatch: Swatch::Series(Ink { colour: BLACK, ..Ink::of(*slot) }, super::Draw::Line),
            name: (*name).to_owned(),
        }));
        let of_this_kind = |kind| grids.iter().any(|grid| grid.cells.contains(&Filled::Missing(kind)));
        let missing = self.missing.iter().enumerate().filter(|(kind, _)| of_this_kind(*kind));
        legend.extend(missing.map(|(kind, name)| Entry { swatch: Swatch::Hatch(kind), name: name.clone() }));
        legend
    }
}

/// The places along an axis at which a panel has cells, and the edges between them on the scale of the axis.
struct Edges {
    places: Vec<f64>,
    edges: Vec<f64>,
}

impl Edges {
    fn new(axis: &Axis, places: impl Iterator<Item = f64>) -> Self {
        let mut places: Vec<f64> = places.map(|place| place + 0.0).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let scaled: Vec<f64> = places.iter().map(|place| axis.scale.apply(*place)).collect();
        let middles: Vec<f64> =
            scaled.iter().zip(scaled.iter().skip(1)).map(|(one, next)| 0.5 * (one + next)).collect();
        let beyond = |end: Option<&f64>, middle: Option<&f64>, alone: f64| {
            end.map(|end| middle.map_or(end + alone, |middle| 2.0 * end - middle))
        };
        let first = beyond(scaled.first(), middles.first(), -0.5);
        let last = beyond(scaled.last(), middles.last(), 0.5);
        Self { places, edges: first.into_iter().chain(middles).chain(last).collect() }
    }

    fn index(&self, place: f64) -> Option<usize> {
        self.places.binary_search_by(|other| other.total_cmp(&(place + 0.0))).ok()
    }

    /// From edge to edge, as fractions of `span`.
    fn cells(&self, span: &Span) -> Vec<(f64, f64)> {
        let fraction = |edge: &f64| (edge - span.from) / (span.to - span.from);
        self.edges.iter().zip(self.edges.iter().skip(1)).map(|(from, to)| (fraction(from), fraction(to))).collect()
    }
}

/// The cells of a panel, row by row.
struct Grid {
    columns: Edges,
    rows: Edges,
    cells: Vec<Filled>,
}

impl Grid {
    fn draw(&self, canvas: &mut Canvas, plot: &Plot, colours: &Span) {
        let (columns, rows) = (self.columns.cells(plot.x), self.rows.cells(plot.y));
        let places = rows.iter().flat_map(|row| columns.iter().map(move |column| (column, row)));
        for ((column, row), value) in places.zip(&self.cells) {
            let ((left, bottom), (right, top)) = (plot.area.at(column.0, row.0), plot.area.at(column.1, row.1));
            let whole = Rect { left, top: top - OVERLAP, right: right + OVERLAP, bottom };
            if let Some(area) = whole.within(&plot.area) {
                match value {
                    Filled::Value(value) => canvas.fill(&area, colour(colours.fraction(*value))),
                    Filled::Missing(kind) => stroke::hatch(canvas, &area, *kind),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{super::Table, *};

    const CSV: &str = "omega,eta,error\n1,0.8,1e-6\n2,0.8,1e-4\n4,0.8,\n1,0.9,1e-2\n2,0.9,0\n";

    fn map() -> HeatMap {
        let cells = Table::from_reader("map.csv", CSV.as_bytes()).unwrap().cells("omega", "eta", "error").unwrap();
        HeatMap {
            title: "Error".into(),
            caption: "Where the series fails.".into(),
            x: Axis::log("ω"),
            y: Axis::linear("η"),
            colour: Axis::log("relative error"),
            columns: 3,
            missing: vec!["declined".into()],
            panels: vec![HeatPanel::new("ε = 0.01", cells)],
        }
    }

    #[test]
    fn everything_is_named_and_the_same_twice() {
        let svg = map().svg().unwrap();
        for text in [
            "Error",
            "Where the series fails.",
            "ω",
            "η",
            "relative error",
            "declined",
            "ε = 0.01",
            "Values from 0 to 0.01, some beyond the colours shown",
        ] {
            assert!(svg.contains(&format!(">{text}<")), "{text}");
        }
        assert_eq!(svg, map().svg().unwrap());
    }

    #[test]
    fn cells_reach_half_way_on_the_scale() {
        let edges = Edges::new(&Axis::log("ω"), [4.0, 1.0, 2.0, 1.0].into_iter());
        assert_eq!(edges.places, [1.0, 2.0, 4.0]);
        for (edge, expected) in edges.edges.iter().zip([0.5_f64.sqrt(), 2_f64.sqrt(), 8_f64.sqrt(), 32_f64.sqrt()]) {
            assert!((10_f64.powf(*edge) - expected).abs() < 1e-12);
        }
        assert_eq!(Edges::new(&Axis::linear("η"), [0.9].into_iter()).edges.len(), 2);
    }

    #[test]
    fn what_has_no_place_is_refused() {
        let mut twice = map();
        twice.panels[0].cells.push(Cell { x: 1.0, y: 0.9, value: None, why: 0 });
        assert_eq!(twice.svg().unwrap_err().to_string(), "chart \"Error\", panel \"ε = 0.01\": two cells at (1, 0.9)");
        let mut negative = map();
        negative.panels[0].cells[0].value = Some(-1.0);
        assert!(matches!(negative.svg(), Err(Error::NotPositive { .. })));
        assert!(matches!(HeatMap { panels: Vec::new(), ..map() }.svg(), Err(Error::Nothing { .. })));
    }
}
