//! The sheet that is drawn on, written as plain SVG that every viewer draws alike.
//!
//! No definitions, nothing nested, and no style that is needed: lengths in pixels, colours as attributes. A line with subscripts or superscripts is one
//! text with its pieces side by side, each shifted against the one before; it starts at a place of ours, because renderers disagree about what a
//! line of several pieces is centred on.

use std::fmt::{self, Display, Write as _};

use super::{
    colour::{BLACK, Colour, WHITE, dark_style},
    geometry::{Place, Rect},
    text::{self, Level, Piece},
};

/// Where text stands relative to its place; its middle is always at the height of the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Middle,
    Right,
    /// In the middle, read from below.
    Upright,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub(super) colour: Colour,
    pub(super) thick: f64,
    /// Lengths drawn and left out in turn; whole if empty.
    pub(super) dash: &'static [f64],
}

impl Stroke {
    /// A whole line.
    pub(super) fn whole(colour: Colour, thick: f64) -> Self {
        Self { colour, thick, dash: &[] }
    }
}

/// A sheet that is being drawn.
#[derive(Debug)]
pub(super) struct Canvas {
    width: f64,
    height: f64,
    /// An element before all others, if any.
    style: String,
    body: String,
}

impl Canvas {
    /// A white sheet of this size.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let (width, height) = (width.ceil(), height.ceil());
        let mut canvas = Self { body: String::new(), style: String::new(), width, height };
        canvas.fill(&Rect { left: 0.0, top: 0.0, right: canvas.width, bottom: canvas.height }, WHITE);
        canvas
    }

    /// The sheet, dark where its reader likes that.
    pub(super) fn light_or_dark(self) -> Self {
        Self { style: format!("<style>{}</style>\n", dark_style()), ..self }
    }

    /// The file, with a title and a description for those who cannot see it.
    pub(super) fn file(&self, title: &str, description: &str) -> String {
        let Self { width, height, style, body } = self;
        let (title, description) = (text::plain(title), text::plain(description));
        // Several charts may be put into one page, where names have to differ.
        let name: String =
            title.to_lowercase().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             role=\"img\" aria-labelledby=\"title-{name} text-{name}\" font-family=\"sans-serif\" stroke-linejoin=\"round\">\n\
             <title id=\"title-{name}\">{}</title>\n<desc id=\"text-{name}\">{}</desc>\n{style}{}</svg>\n",
            Escaped(&title),
            Escaped(&description),
            body
        )
    }

    /// An open line through places.
    pub(super) fn line(&mut self, places: &[Place], stroke: Stroke) {
        self.element(format_args!("<polyline points=\"{}\" fill=\"none\"{stroke}/>", Points(places)));
    }

    /// An area with an edge, or without.
    pub(super) fn area(&mut self, places: &[Place], fill: Colour, edge: Option<Stroke>) {
        self.element(format_args!("<polygon points=\"{}\" fill=\"{fill}\"{}/>", Points(places), Edge(edge)));
    }

    /// A filled rectangle.
    pub(super) fn fill(&mut self, rect: &Rect, fill: Colour) {
        let (x, y, width, height) = (Px(rect.left), Px(rect.top), Px(rect.width()), Px(rect.height()));
        self.element(format_args!("<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"/>"));
    }

    /// The edge of a rectangle.
    pub(super) fn frame(&mut self, rect: &Rect, stroke: Stroke) {
        let Rect { left, top, right, bottom } = *rect;
        self.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], stroke);
    }

    /// A disc with an edge, or without.
    pub(super) fn disc(&mut self, (x, y): Place, radius: f64, fill: Colour, edge: Option<Stroke>) {
        let (x, y, radius) = (Px(x), Px(y), Px(radius));
        self.element(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{fill}\"{}/>", Edge(edge)));
    }

    /// One line of text.
    pub(super) fn text(&mut self, line: &str, place: Place, size: f64, anchor: Anchor) {
        self.styled(line, place, size, anchor, "");
    }

    /// One line of bold text.
    pub(super) fn bold(&mut self, line: &str, place: Place, size: f64, anchor: Anchor) {
        self.styled(line, place, size, anchor, " font-weight=\"bold\"");
    }

    fn styled(&mut self, line: &str, (x, y): Place, size: f64, anchor: Anchor, weight: &str) {
        /// From the middle of a line down to where its letters stand, by their size.
        const BASELINE: f64 = 0.36;
        /// What text takes of the room that it may take, in most fonts.
        const USUAL: f64 = 0.92;
        let pieces = text::pieces(line);
        let is_plain = pieces.iter().all(|(level, _)| *level == Level::Base);
        let room = USUAL * text::width(line, size);
        let (name, shift) = match (anchor, is_plain) {
            (Anchor::Left, _) => ("start", 0.0),
            (Anchor::Right, true) => ("end", 0.0),
            (Anchor::Right, false) => ("start", -room),
            (Anchor::Middle | Anchor::Upright, true) => ("middle", 0.0),
            (Anchor::Middle | Anchor::Upright, false) => ("start", -0.5 * room),
        };
        let place = if anchor == Anchor::Upright {
            let turn = format!("transform=\"translate({},{}) rotate(-90)\"", Px(x), Px(y));
            format!("x=\"{}\" y=\"{}\" {turn}", Px(shift), Px(BASELINE * size))
        } else {
            format!("x=\"{}\" y=\"{}\"", Px(x + shift), Px(y + BASELINE * size))
        };
        let content = Pieces { pieces: &pieces, size };
        self.element(format_args!(
            "<text {place} font-size=\"{}\" text-anchor=\"{name}\" fill=\"{BLACK}\"{weight}>{content}</text>",
            Px(size)
        ));
    }

    fn element(&mut self, element: fmt::Arguments) {
        // Writing to a string can't fail.
        let _ = writeln!(self.body, "{element}");
    }
}

/// A length to a tenth of a pixel, which is finer than can be seen.
struct Px(f64);

impl Display for Px {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Without the sign of a zero.
        write!(f, "{}", (self.0 * 10.0).round() / 10.0 + 0.0)
    }
}

struct Points<'a>(&'a [Place]);

impl Display for Points<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0
            .iter()
            .enumerate()
            .try_for_each(|(index, (x, y))| write!(f, "{}{},{}", if index == 0 { "" } else { " " }, Px(*x), Px(*y)))
    }
}

impl Display for Stroke {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, " stroke=\"{}\" stroke-width=\"{}\"", self.colour, Px(self.thick))?;
        if self.dash.is_empty() {
            return Ok(());
        }
        let lengths: Vec<String> = self.dash.iter().map(|length| Px(*length).to_string()).collect();
        write!(f, " stroke-dasharray=\"{}\"", lengths.join(" "))
    }
}

struct Edge(Option<Stroke>);

impl Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |stroke| stroke.fmt(f))
    }
}

/// The pieces of a line side by side, those that stand lower or higher in spans.
struct Pieces<'a> {
    pieces: &'a [Piece],
    size: f64,
}

impl Display for Pieces<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut before = Level::Base;
        for (level, text) in self.pieces {
            let text = Escaped(text);
            if *level == before && before == Level::Base {
                write!(f, "{text}")?;
                continue;
            }
            let down = Px((level.below() - before.below()) * self.size);
            write!(f, "<tspan dy=\"{down}\" font-size=\"{}\">{text}</tspan>", Px(level.size() * self.size))?;
            before = *level;
        }
        Ok(())
    }
}

/// Text without what SVG would read as its own.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(line: &str, anchor: Anchor) -> String {
        let mut canvas = Canvas::new(10.0, 20.0);
        canvas.text(line, (100.0, 50.0), 10.0, anchor);
        canvas.body
    }

    #[test]
    fn a_line_with_scripts_is_one_text_of_flat_pieces_from_its_left_end() {
        let body = text("τ_{ch}/ε^{3/2} < 1", Anchor::Left);
        let pieces = "τ<tspan dy=\"2.4\" font-size=\"7.2\">ch</tspan><tspan dy=\"-2.4\" font-size=\"10\">/ε</tspan>\
                      <tspan dy=\"-3.8\" font-size=\"7.2\">3/2</tspan><tspan dy=\"3.8\" font-size=\"10\"> &lt; 1</tspan></text>";
        assert!(body.contains("\n<text x=\"100\" y=\"53.6\" ") && body.trim_end().ends_with(pieces), "{body}");
        for anchor in [Anchor::Middle, Anchor::Right, Anchor::Upright] {
            assert!(text("a_{cr}", anchor).contains("text-anchor=\"start\""), "{anchor:?}");
            assert!(!text("plain", anchor).contains("text-anchor=\"start\""), "{anchor:?}");
        }
    }

    #[test]
    fn the_file_says_what_it_shows() {
        let mut canvas = Canvas::new(10.0, 20.0);
        canvas.line(&[(0.0, 0.04), (1.0, -0.04)], Stroke { dash: &[2.0, 1.5], ..Stroke::whole(BLACK, 1.0) });
        let file = canvas.file("Error of τ_{ch}", "A < B.");
        for part in [
            "width=\"10\" height=\"20\" viewBox=\"0 0 10 20\" role=\"img\" aria-labelledby=\"title-error-of---ch text-error-of---ch\"",
            "<title id=\"title-error-of---ch\">Error of τ_ch</title>",
            "<desc id=\"text-error-of---ch\">A &lt; B.</desc>",
            "points=\"0,0 1,0\"",
            "stroke-dasharray=\"2 1.5\"",
        ] {
            assert!(file.contains(part), "{part} in {file}");
        }
    }
}
