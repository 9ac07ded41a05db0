//! The sheet that is drawn on: lines, areas and text in pixels, through the SVG backend of plotters.

use plotters::{
    backend::{DrawingBackend, SVGBackend},
    style::{
        Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle,
        text_anchor::{HPos, Pos, VPos},
    },
};

use super::{
    Error,
    geometry::{Place, Rect},
    palette::{BLACK, Shape, WHITE},
    text,
};

/// The backend draws on whole units, so a unit is a tenth of a pixel.
const UNITS: f64 = 10.0;

/// Where text stands relative to its place; its middle is always at the height of the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Middle,
    Right,
    /// In the middle, read from below.
    Upright,
}

/// A sheet that is being drawn.
pub(super) struct Canvas<'a> {
    backend: SVGBackend<'a>,
}

impl Canvas<'_> {
    /// The SVG of a white sheet with what `draw` draws on it.
    pub(super) fn svg(
        width: f64,
        height: f64,
        draw: impl FnOnce(&mut Canvas) -> Result<(), Error>,
    ) -> Result<String, Error> {
        let (width, height) = (width.ceil(), height.ceil());
        let units = ((width * UNITS) as u32, (height * UNITS) as u32);
        let mut svg = String::new();
        {
            let mut canvas = Canvas { backend: SVGBackend::with_string(&mut svg, units) };
            canvas.fill(&Rect { left: 0.0, top: 0.0, right: width, bottom: height }, WHITE)?;
            draw(&mut canvas)?;
            canvas.backend.present().map_err(refused)?;
        }
        let head = format!(r#"width="{}" height="{}""#, units.0, units.1);
        let in_pixels = format!(r#"width="{width}" height="{height}" stroke-linejoin="round""#);
        Ok(text::decode(&svg.replacen(&head, &in_pixels, 1)))
    }

    /// A line through `places`.
    pub(super) fn line(&mut self, places: &[Place], colour: RGBColor, thick: f64) -> Result<(), Error> {
        self.backend.draw_path(places.iter().map(units), &stroke(colour, thick)).map_err(refused)
    }

    /// An area, and nothing at its edge.
    pub(super) fn area(&mut self, places: &[Place], colour: RGBColor) -> Result<(), Error> {
        self.backend.fill_polygon(places.iter().map(units), &colour.filled()).map_err(refused)
    }

    /// A filled rectangle.
    pub(super) fn fill(&mut self, rect: &Rect, colour: RGBColor) -> Result<(), Error> {
        let (from, to) = ((rect.left, rect.top), (rect.right, rect.bottom));
        self.backend.draw_rect(units(&from), units(&to), &colour.filled(), true).map_err(refused)
    }

    /// The edge of a rectangle.
    pub(super) fn frame(&mut self, rect: &Rect, colour: RGBColor, thick: f64) -> Result<(), Error> {
        let Rect { left, top, right, bottom } = *rect;
        self.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], colour, thick)
    }

    /// One line of text.
    pub(super) fn text(&mut self, line: &str, place: Place, size: f64, anchor: Anchor) -> Result<(), Error> {
        self.styled(line, place, size, anchor, FontStyle::Normal)
    }

    /// One line of bold text.
    pub(super) fn bold(&mut self, line: &str, place: Place, size: f64, anchor: Anchor) -> Result<(), Error> {
        self.styled(line, place, size, anchor, FontStyle::Bold)
    }

    fn styled(&mut self, line: &str, place: Place, size: f64, anchor: Anchor, weight: FontStyle) -> Result<(), Error> {
        /// The backend divides sizes by this.
        const SHRINK: f64 = 1.24;
        let across = match anchor {
            Anchor::Left => HPos::Left,
            Anchor::Middle | Anchor::Upright => HPos::Center,
            Anchor::Right => HPos::Right,
        };
        let turn = if anchor == Anchor::Upright { FontTransform::Rotate270 } else { FontTransform::None };
        let font = FontDesc::new(FontFamily::SansSerif, size * UNITS * SHRINK, weight).transform(turn);
        let style = TextStyle::from(font).color(&BLACK).pos(Pos::new(across, VPos::Center));
        self.backend.draw_text(&text::encode(line), &style, units(&place)).map_err(refused)
    }

    /// A marker at a place.
    pub(super) fn marker(&mut self, shape: Shape, (x, y): Place, colour: RGBColor) -> Result<(), Error> {
        const THICK: f64 = 1.7;
        let around = |places: &[Place]| places.iter().map(|(dx, dy)| (x + dx, y + dy)).collect::<Vec<_>>();
        let square = |half: f64| around(&[(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half)]);
        let diamond = |half: f64| around(&[(0.0, -half), (half, 0.0), (0.0, half), (-half, 0.0), (0.0, -half)]);
        let triangle = |up: f64| around(&[(0.0, -5.4 * up), (5.2, 3.9 * up), (-5.2, 3.9 * up), (0.0, -5.4 * up)]);
        let mut open = |edge: Vec<Place>| {
            self.area(&edge, WHITE)?;
            self.line(&edge, colour, THICK)
        };
        match shape {
            Shape::OpenSquare => open(square(4.2)),
            Shape::OpenDiamond => open(diamond(5.8)),
            Shape::OpenTriangleDown => open(triangle(-1.0)),
            Shape::Square => self.area(&square(4.6), colour),
            Shape::Diamond => self.area(&diamond(6.4), colour),
            Shape::Triangle => self.area(&triangle(1.0), colour),
            Shape::Disc => self.disc((x, y), 4.8, colour),
            Shape::OpenDisc => {
                self.disc((x, y), 4.4, WHITE)?;
                let edge = stroke(colour, THICK);
                self.backend.draw_circle(units(&(x, y)), (4.4 * UNITS) as u32, &edge, false).map_err(refused)
            }
            Shape::Plus => {
                self.line(&around(&[(-5.5, 0.0), (5.5, 0.0)]), colour, 2.4)?;
                self.line(&around(&[(0.0, -5.5), (0.0, 5.5)]), colour, 2.4)
            }
            Shape::Cross => {
                self.line(&around(&[(-3.6, -3.6), (3.6, 3.6)]), colour, THICK)?;
                self.line(&around(&[(-3.6, 3.6), (3.6, -3.6)]), colour, THICK)
            }
        }
    }

    fn disc(&mut self, place: Place, radius: f64, colour: RGBColor) -> Result<(), Error> {
        self.backend.draw_circle(units(&place), (radius * UNITS) as u32, &colour.filled(), true).map_err(refused)
    }
}

fn stroke(colour: RGBColor, thick: f64) -> ShapeStyle {
    colour.stroke_width((thick * UNITS) as u32)
}

fn units(place: &Place) -> (i32, i32) {
    ((place.0 * UNITS).round() as i32, (place.1 * UNITS).round() as i32)
}

fn refused(error: impl std::error::Error) -> Error {
    Error::Drawing(error.to_string())
}
