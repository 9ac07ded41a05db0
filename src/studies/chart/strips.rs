//! Panels one above the other, each with a second axis of its own: what happens at the same time stands below each other.

use super::{
    Axis, Error, Mark, Series,
    axis::Span,
    canvas::{Anchor, Canvas},
    caption::Paragraph,
    colour::{COOL, Colour, WARM},
    frame::{Frame, LABEL, LINE, TEXT, beside},
    geometry::Rect,
    legend::{Entry, Legend, Swatch},
    lines::check_marks,
    palette::Ink,
    sheet::{MARGIN, TITLE},
    stroke::{Plot, at_foot},
    text, thin,
    ticks::Ticks,
};

/// The width of the sheet: its letters can be read where it is as wide as a phone.
const WIDTH: f64 = 560.0;
/// Between the label of an axis and its values, and between these and the frame.
const GAPS: (f64, f64) = (6.0, 9.0);
/// Between two strips with the same first axis.
const BETWEEN: f64 = 16.0;

/// Strips, one above the other; light, or dark where the reader likes that. Those that follow each other with the same first axis share its values.
#[derive(Debug, Clone, PartialEq)]
pub struct Strips {
    /// What they show, above them.
    pub title: String,
    /// One sentence below them.
    pub caption: String,
    /// From above.
    pub strips: Vec<Strip>,
}

/// One of [`Strips`].
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// What stands above it; may be empty.
    pub title: String,
    /// In pixels, of 560 across the sheet.
    pub height: f64,
    /// The first axis.
    pub x: Axis,
    /// The second axis.
    pub y: Axis,
    /// Another scale of the second axis, at the right.
    pub right: Option<Right>,
    /// What is drawn in it; what each is says the second axis.
    pub series: Vec<Series>,
    /// What is shaded behind it.
    pub shades: Vec<Shade>,
    /// Level lines, with their labels at the right.
    pub marks: Vec<Mark>,
    /// What short strokes at its foot are, and where.
    pub strokes: (&'static str, Vec<f64>),
}

/// Another scale of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Right {
    /// What it is.
    pub label: String,
    /// One of it, in what the axis is in.
    pub unit: f64,
}

/// A stretch of an axis that is shaded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shade {
    /// Of the first axis: what it is, from and to.
    Across(&'static str, f64, f64),
    /// Of the second.
    Up(&'static str, f64, f64),
}

impl Shade {
    fn name(self) -> &'static str {
        let (Self::Across(name, ..) | Self::Up(name, ..)) = self;
        name
    }

    fn colour(self) -> Colour {
        if matches!(self, Self::Across(..)) { COOL } else { WARM }
    }

    /// The part of a plot that is shaded.
    fn area(self, plot: &Plot) -> Option<Rect> {
        let Rect { left, top, right, bottom } = plot.area;
        let shaded = match self {
            Self::Across(_, from, to) => {
                let x = |value| plot.area.at(plot.x.fraction(value), 0.0).0;
                Rect { left: x(from), right: x(to), top, bottom }
            }
            Self::Up(_, from, to) => {
                let y = |value| plot.area.at(0.0, plot.y.fraction(value)).1;
                Rect { top: y(to), bottom: y(from), left, right }
            }
        };
        shaded.within(&plot.area)
    }
}

/// A strip with its scales.
struct Scaled<'a> {
    strip: &'a Strip,
    x: Span,
    y: Span,
    y_ticks: Ticks,
    y_label: Paragraph,
    right: Option<(Span, Ticks, Paragraph)>,
}

impl<'a> Scaled<'a> {
    fn new(strip: &'a Strip, chart: &str) -> Result<Self, Error> {
        let Strip { x, y, series, marks, .. } = strip;
        for (name, point) in series.iter().flat_map(|one| one.points.iter().map(move |point| (&one.name, point))) {
            x.check(chart, name, point.x)?;
            point.y.map_or(Ok(()), |value| y.check(chart, name, value))?;
        }
        check_marks(chart, x, y, marks)?;
        let points = || series.iter().flat_map(|series| &series.points);
        let values = points().filter_map(|point| point.y).chain(marks.iter().filter_map(Mark::y));
        let across = x.span(chart, points().map(|point| point.x), 0.0)?;
        let up = y.span(chart, values, 0.06)?;
        let ticks = |axis: &Axis, span: &Span| Ticks::of(axis, span, strip.height, |_| 27.0);
        let right = strip.right.as_ref().map(|Right { label, unit }| {
            let span = Span { from: up.from / unit, to: up.to / unit, ..up };
            let ticks = ticks(&Axis::linear(label.as_str()), &span);
            (span, ticks, Paragraph::even(label, LABEL, strip.height))
        });
        let y_label = Paragraph::even(&y.label, LABEL, strip.height);
        Ok(Self { strip, x: across, y_ticks: ticks(y, &up), y: up, y_label, right })
    }

    /// The room that is taken beside its frame.
    fn beside(&self) -> (f64, f64) {
        let room = |label: &Paragraph, ticks: &Ticks| label.height() + GAPS.0 + ticks.widest(TEXT) + GAPS.1;
        let right = self.right.as_ref().map_or(0.0, |(_, ticks, label)| room(label, ticks));
        (room(&self.y_label, &self.y_ticks), right.max(beside(&self.strip.marks)))
    }

    fn draw(&self, canvas: &mut Canvas, rect: Rect, says_x: bool) {
        let Self { strip, x, y, y_ticks, .. } = self;
        let plot = Plot { area: rect, x, y };
        let x_ticks = Ticks::of(&strip.x, x, rect.width(), |label| text::width(label, TEXT) + 14.0);
        for shade in &strip.shades {
            if let Some(area) = shade.area(&plot) {
                canvas.fill(&area, shade.colour());
            }
        }
        let frame = Frame { rect, plot: &plot, x_ticks: &x_ticks, y_ticks, is_filled: false };
        frame.grid(canvas);
        frame.marks(canvas, &strip.marks);
        // Two columns a pixel.
        let column = |value: f64| (2.0 * rect.width() * x.fraction(value)).floor() as i64;
        for (slot, series) in strip.series.iter().enumerate() {
            let slot = series.slot.unwrap_or(slot);
            let series = Series { points: thin::seen(&series.points, column), ..series.clone() };
            // Lines in strips of their own need no dashes to be told apart.
            plot.series(canvas, &series, Ink { dash: &[], ..Ink::of(slot) }, 0);
        }
        let mut columns: Vec<i64> = strip.strokes.1.iter().filter(|at| x.holds(**at)).map(|at| column(*at)).collect();
        columns.dedup();
        for column in columns {
            at_foot(canvas, (rect.left + 0.5 * column as f64, rect.bottom));
        }
        frame.edge(canvas);
        frame.left(canvas);
        let (_, middle) = rect.at(0.0, 0.5);
        self.y_label.draw_upright(canvas, MARGIN, middle);
        if let Some((span, ticks, label)) = &self.right {
            frame.right(canvas, span, ticks);
            label.draw_upright(canvas, WIDTH - MARGIN - label.height(), middle);
        }
        frame.beside(canvas, &strip.marks);
        if says_x {
            frame.below(canvas);
        }
    }
}

impl Strips {
    /// The strips as SVG.
    ///
    /// # Errors
    /// When there is nothing to draw, or a value has no place on its axis.
    pub fn svg(&self) -> Result<String, Error> {
        let points = |strip: &Strip| strip.series.iter().map(|series| series.points.len()).sum::<usize>();
        if self.strips.is_empty() || self.strips.iter().any(|strip| points(strip) == 0) {
            return Err(Error::Nothing { chart: self.title.clone() });
        }
        let scaled = self.strips.iter().map(|strip| Scaled::new(strip, &self.title));
        let scaled = scaled.collect::<Result<Vec<_>, _>>()?;
        let room = scaled.iter().map(Scaled::beside);
        let (left, right) = room.fold((0.0, 0.0), |(left, right), one| (f64::max(left, one.0), f64::max(right, one.1)));
        let (left, right) = (MARGIN + left, WIDTH - MARGIN - right);

        let inside = WIDTH - 2.0 * MARGIN;
        let title = Paragraph::bold(&self.title, TITLE, inside);
        let mut top = MARGIN + title.height() + 10.0;
        let mut places = Vec::new();
        for (index, strip) in self.strips.iter().enumerate() {
            let says_x = self.strips.get(index + 1).is_none_or(|next| next.x != strip.x);
            let head = Paragraph::even(&strip.title, LABEL, inside);
            let label = Paragraph::even(&strip.x.label, LABEL, right - left);
            let from = top + head.height() + if strip.title.is_empty() { 0.0 } else { 4.0 };
            let rect = Rect { left, top: from, right, bottom: from + strip.height };
            let below = if says_x { GAPS.1 + LINE + 2.0 + label.height() } else { 0.0 };
            places.push((rect, says_x, (head, top), label));
            top = rect.bottom + below + BETWEEN;
        }
        let entries = self.entries();
        let legend = Legend::new(&entries, inside);
        let caption = Paragraph::new(&self.caption, TEXT, inside);
        let caption_top = top + legend.height() + 8.0;

        let mut canvas = Canvas::new(WIDTH, caption_top + caption.height() + MARGIN).light_or_dark();
        title.draw_bold(&mut canvas, MARGIN, MARGIN, Anchor::Left);
        for (scaled, (rect, says_x, (head, head_top), label)) in scaled.iter().zip(&places) {
            let (middle, _) = rect.at(0.5, 0.0);
            head.draw(&mut canvas, middle, *head_top, Anchor::Middle);
            scaled.draw(&mut canvas, *rect, *says_x);
            if *says_x {
                label.draw(&mut canvas, middle, rect.bottom + GAPS.1 + LINE + 2.0, Anchor::Middle);
            }
        }
        legend.draw(&mut canvas, MARGIN, top);
        caption.draw(&mut canvas, MARGIN, caption_top, Anchor::Left);
        Ok(canvas.file(&self.title, &self.caption))
    }

    /// What the shades and the strokes are.
    fn entries(&self) -> Vec<Entry> {
        let mut entries: Vec<Entry> = Vec::new();
        let mut add = |swatch: Swatch, name: &str| {
            if !entries.iter().any(|entry| entry.name == name) {
                entries.push(Entry { swatch, name: name.to_owned() });
            }
        };
        for strip in &self.strips {
            strip.shades.iter().for_each(|shade| add(Swatch::Shade(shade.colour()), shade.name()));
            if !strip.strokes.1.is_empty() {
                add(Swatch::Strokes, strip.strokes.0);
            }
        }
        entries
    }
}

#[cfg(test)]
mod tests {
    use super::{super::Point, *};

    fn strip(label: &str, x: Axis) -> Strip {
        let points = (0..5000).map(|k| Point { x: f64::from(k) / 5000.0, y: Some((f64::from(k) * 0.3).sin()) });
        Strip {
            title: String::new(),
            height: 100.0,
            x,
            y: Axis::linear(label),
            right: None,
            series: vec![Series::new(label, points.collect()).with_draw(super::super::Draw::Line)],
            shades: vec![Shade::Across("quiet", 0.2, 0.4), Shade::Up("strong", 0.5, 9.0)],
            marks: vec![Mark::level(0.5, "strong enough")],
            strokes: ("hits", vec![0.5, 0.5, 0.6, 7.0]),
        }
    }

    #[test]
    fn strips_with_one_axis_share_its_values_and_everything_is_named() {
        let time = || Axis::linear("time").with_range(0.0, 1.0);
        let right = Some(Right { label: "share".into(), unit: 2.0 });
        let last = Strip { shades: Vec::new(), ..strip("third", Axis::linear("another time").with_range(0.0, 0.5)) };
        let strips = Strips {
            title: "What happens".into(),
            caption: "And <why>.".into(),
            strips: vec![strip("first", time()), Strip { right, ..strip("second", time()) }, last],
        };
        let svg = strips.svg().unwrap();
        for (text, times) in
            [("time", 1), ("another time", 1), ("first", 1), ("share", 1), ("quiet", 1), ("strong", 1), ("hits", 1)]
        {
            assert_eq!(svg.matches(&format!(">{text}<")).count(), times, "{text}");
        }
        assert!(svg.contains("prefers-color-scheme:dark") && svg.contains("And &lt;why&gt;."));
        // No more points than can be seen: four in each of two columns a pixel.
        let longest = svg.lines().map(|line| line.matches(',').count()).max().unwrap();
        assert!((500..8 * 560).contains(&longest), "{longest}");
        assert_eq!(svg, strips.svg().unwrap());
        assert!(Strips { strips: Vec::new(), ..strips }.svg().is_err());
    }
}
