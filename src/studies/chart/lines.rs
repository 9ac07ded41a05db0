//! Line charts: series in panels.

use super::{
    Axis, Error, Mark, Point, Scale, Series,
    canvas::Canvas,
    geometry::Rect,
    legend::{Entry, Swatch},
    marker::Shape,
    palette::Ink,
    series::slots,
    sheet::{Head, Sheet},
    stroke::{Plot, is_off},
};

/// The height that the points of one series off the scale take.
const STRIP_ROW: f64 = 11.0;

/// A chart of lines or markers in one or more panels with the same axes.
///
/// - A point without a value is a cross in a strip above the axes, one row a series.
/// - On a logarithmic second axis a value of exactly 0 is an open triangle in a strip below; a negative one is an error, as is any
///   place that is not positive on a logarithmic first axis.
/// - What is outside a given range is cut off; where a line leaves it upwards or downwards stands an arrow.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// What the chart shows, above it.
    pub title: String,
    /// One sentence below it.
    pub caption: String,
    /// The first axis.
    pub x: Axis,
    /// The second axis.
    pub y: Axis,
    /// How many panels stand side by side.
    pub columns: usize,
    /// What a point without a value means, for the legend: `failed`, `declined`.
    pub missing: String,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
}

/// One panel of a [`LineChart`].
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What stands above it; may be empty.
    pub title: String,
    /// What is drawn in it.
    pub series: Vec<Series>,
    /// Reference lines.
    pub marks: Vec<Mark>,
}

impl Panel {
    /// A panel without reference lines.
    pub fn new(title: impl Into<String>, series: Vec<Series>) -> Self {
        Self { title: title.into(), series, marks: Vec::new() }
    }

    /// This panel with reference lines.
    pub fn with_marks(self, marks: Vec<Mark>) -> Self {
        Self { marks, ..self }
    }
}

impl LineChart {
    /// The chart as SVG.
    ///
    /// # Errors
    /// When there is nothing to draw, a given range is none, or a value has no place on its axis.
    pub fn svg(&self) -> Result<String, Error> {
        self.check()?;
        let slots = slots(self.series());
        let failing = self.rows(&slots, |point| point.y.is_none());
        let zero = self.rows(&slots, |point| point.y.is_some_and(|y| is_off(self.y.scale, y)));
        let legend = slots.iter().map(|(name, slot, draw)| Entry {
            swatch: Swatch::Series(Ink::of(*slot), *draw),
            name: (*name).to_owned(),
        });
        let remark = |shape, name: &str, rows: &[&str]| {
            (!rows.is_empty()).then(|| Entry { swatch: Swatch::Marker(shape), name: name.to_owned() })
        };
        let marks = || self.panels.iter().flat_map(|panel| &panel.marks);
        let x = self.series().flat_map(|series| &series.points).map(|point| point.x).chain(marks().filter_map(Mark::x));
        let y = self.series().flat_map(|series| &series.points).filter_map(|point| point.y);
        let y = y.chain(marks().filter_map(Mark::y));
        let (x, y) = (self.x.span(&self.title, x, 0.03)?, self.y.span(&self.title, y, 0.05)?);
        // Whether, not where: any area will do.
        let plot = Plot { area: Rect { left: 0.0, top: 0.0, right: 1e3, bottom: 1e3 }, x: &x, y: &y };
        let such = |is_such: &dyn Fn(&Series) -> bool| -> Vec<&str> {
            self.series().filter(|series| is_such(series)).map(|series| series.name.as_str()).collect()
        };
        let lone = such(&|series| plot.has_lone(series));
        let leaving = such(&|series| !plot.leaves(series).is_empty());
        let legend = legend
            .chain(remark(Shape::Cross, &self.missing, &failing))
            .chain(remark(Shape::OpenTriangleDown, "exactly 0", &zero))
            .chain(remark(Shape::LeavesUp, "goes on beyond the axis", &leaving))
            .chain(remark(Shape::Disc, "a value between two without", &lone))
            .collect();
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            x: (&self.x, x),
            y: (&self.y, y),
            columns: self.columns,
            panels: self.panels.iter().map(|panel| Head { title: &panel.title, marks: &panel.marks }).collect(),
            legend,
            strips: (strip(&failing), strip(&zero)),
            is_filled: false,
            side: 0.0,
        };
        let off = Off { scale: self.y.scale, failing, zero };
        sheet.svg(
            |canvas, index, plot| {
                for series in self.panels.get(index).map_or(&[][..], |panel| &panel.series) {
                    let slot = slots.iter().find(|(name, ..)| *name == series.name).map_or(0, |(_, slot, _)| *slot);
                    plot.series(canvas, series, Ink::of(slot), slot);
                    off.draw(canvas, plot, series, Ink::of(slot));
                }
            },
            |_, _| {},
        )
    }

    fn series(&self) -> impl Iterator<Item = &Series> + Clone {
        self.panels.iter().flat_map(|panel| &panel.series)
    }

    /// Refuses what has no place.
    fn check(&self) -> Result<(), Error> {
        if self.series().all(|series| series.points.is_empty()) {
            return Err(Error::Nothing { chart: self.title.clone() });
        }
        for series in self.series() {
            for point in &series.points {
                self.x.check(&self.title, &series.name, point.x)?;
                if let Some(y) = point.y.filter(|y| !is_off(self.y.scale, *y)) {
                    self.y.check(&self.title, &series.name, y)?;
                }
            }
        }
        self.panels.iter().try_for_each(|panel| check_marks(&self.title, &self.x, &self.y, &panel.marks))
    }

    /// The names of the series with such points, each of which gets a row in a strip.
    fn rows<'a>(&self, slots: &[(&'a str, usize, super::Draw)], is_such: impl Fn(&Point) -> bool) -> Vec<&'a str> {
        let has_such =
            |name: &str| self.series().any(|series| series.name == name && series.points.iter().any(&is_such));
        slots.iter().map(|(name, ..)| *name).filter(|name| has_such(name)).collect()
    }
}

/// Refuses reference lines that have no place.
pub(super) fn check_marks(chart: &str, x: &Axis, y: &Axis, marks: &[Mark]) -> Result<(), Error> {
    for mark in marks {
        if let Some(place) = mark.x() {
            x.check(chart, mark.label(), place)?;
        }
        if let Some(place) = mark.y() {
            y.check(chart, mark.label(), place)?;
        }
    }
    Ok(())
}

fn strip(rows: &[&str]) -> f64 {
    if rows.is_empty() { 0.0 } else { rows.len() as f64 * STRIP_ROW + 4.0 }
}

/// What is drawn beside the axes: the series that have such points, by name.
struct Off<'a> {
    scale: Scale,
    failing: Vec<&'a str>,
    zero: Vec<&'a str>,
}

impl Off<'_> {
    fn draw(&self, canvas: &mut Canvas, plot: &Plot, series: &Series, ink: Ink) {
        let row = |names: &[&str]| {
            let index = names.iter().position(|name| *name == series.name).unwrap_or(0);
            2.0 + (index as f64 + 0.5) * STRIP_ROW
        };
        for point in series.points.iter().filter(|point| plot.x.holds(point.x)) {
            let (x, _) = plot.area.at(plot.x.fraction(point.x), 0.0);
            match point.y {
                None => canvas.marker(Shape::Cross, (x, plot.area.top - row(&self.failing)), ink.colour),
                Some(y) if is_off(self.scale, y) => {
                    canvas.marker(Shape::OpenTriangleDown, (x, plot.area.bottom + row(&self.zero)), ink.colour);
                }
                Some(_) => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{super::Table, *};

    const CSV: &str = "method,a,error\nexact,1.01,1e-16\nexact,1.02,2e-16\nfit,1.01,1e-3\nfit,1.02,\nfit,1.03,2e-3\n";

    fn chart() -> LineChart {
        let series = Table::from_reader("errors.csv", CSV.as_bytes()).unwrap().series("method", "a", "error").unwrap();
        LineChart {
            title: "Error of τ_{ch}".into(),
            caption: "The fit <errs>.".into(),
            x: Axis::linear("a"),
            y: Axis::log("error of τ_ch/(T/2)"),
            columns: 2,
            missing: "failed".into(),
            panels: vec![
                Panel::new("η = 0.9", series)
                    .with_marks(vec![Mark::at(1.025, "critical"), Mark::level(1e-8, "wanted")]),
            ],
        }
    }

    #[test]
    fn everything_is_named_and_the_same_twice() {
        let svg = chart().svg().unwrap();
        for text in
            ["exact", "fit", "failed", "η = 0.9", "error of τ_ch/(T/2)", "The fit &lt;errs&gt;.", "critical", "wanted"]
        {
            assert!(svg.contains(&format!(">{text}<")), "{text}");
        }
        assert!(svg.contains("Error of τ<tspan"));
        assert_eq!(svg, chart().svg().unwrap());
    }

    #[test]
    fn zero_is_shown_below_a_logarithmic_axis() {
        let mut chart = chart();
        assert!(!chart.svg().unwrap().contains("exactly 0"));
        chart.panels[0].series[0].points[0].y = Some(0.0);
        assert!(chart.svg().unwrap().contains("exactly 0"));
        chart.y = Axis::linear("error");
        assert!(!chart.svg().unwrap().contains("exactly 0"));
    }

    #[test]
    fn what_has_no_place_is_refused() {
        let mut negative = chart();
        negative.panels[0].series[1].points[0].y = Some(-1.0);
        let error = negative.svg().unwrap_err().to_string();
        assert!(error.contains("-1e0") && error.contains("\"fit\"") && error.contains("Error of"), "{error}");
        let mut zero = chart();
        zero.x = Axis::log("a");
        zero.panels[0].series[0].points[0].x = 0.0;
        assert!(matches!(zero.svg(), Err(Error::NotPositive { .. })));
        let mut mark = chart();
        mark.panels[0].marks.push(Mark::level(0.0, "zero"));
        assert!(matches!(mark.svg(), Err(Error::NotPositive { .. })));
        let empty = LineChart { panels: Vec::new(), ..chart() };
        assert!(matches!(empty.svg(), Err(Error::Nothing { .. })));
    }

    #[test]
    fn a_chart_of_failures_only_is_drawn() {
        let mut chart = chart();
        for series in &mut chart.panels[0].series {
            series.points.iter_mut().for_each(|point| point.y = None);
        }
        chart.panels[0].marks.clear();
        assert!(chart.svg().unwrap().contains("failed"));
    }
}
