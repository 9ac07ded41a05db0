//! Markers: the shapes of points.

use super::{
    canvas::{Canvas, Stroke},
    colour::{Colour, WHITE},
    geometry::Place,
};

/// From the middle of an arrow to its tip.
pub(super) const ARROW: f64 = 5.0;

/// The shape of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Disc,
    OpenDisc,
    Square,
    OpenSquare,
    Triangle,
    Diamond,
    OpenDiamond,
    Plus,
    /// Kept for failures.
    Cross,
    /// Kept for zeros below a logarithmic axis.
    OpenTriangleDown,
    /// Kept for lines that leave the panel: where they leave it upwards,
    LeavesUp,
    /// and downwards.
    LeavesDown,
}

impl Canvas {
    /// A marker at a place.
    pub(super) fn marker(&mut self, shape: Shape, (x, y): Place, colour: Colour) {
        let edge = Stroke::whole(colour, 1.7);
        let around = |places: &[Place]| places.iter().map(|(dx, dy)| (x + dx, y + dy)).collect::<Vec<_>>();
        let square = |half: f64| around(&[(-half, -half), (half, -half), (half, half), (-half, half)]);
        let diamond = |half: f64| around(&[(0.0, -half), (half, 0.0), (0.0, half), (-half, 0.0)]);
        let triangle = |up: f64| around(&[(0.0, -5.4 * up), (5.2, 3.9 * up), (-5.2, 3.9 * up)]);
        let arrow = |up: f64| around(&[(0.0, -ARROW * up), (5.6, ARROW * up), (-5.6, ARROW * up)]);
        match shape {
            Shape::OpenSquare => self.area(&square(4.2), WHITE, Some(edge)),
            Shape::OpenDiamond => self.area(&diamond(5.8), WHITE, Some(edge)),
            Shape::OpenTriangleDown => self.area(&triangle(-1.0), WHITE, Some(edge)),
            Shape::OpenDisc => self.disc((x, y), 4.4, WHITE, Some(edge)),
            Shape::Square => self.area(&square(4.6), colour, None),
            Shape::Diamond => self.area(&diamond(6.4), colour, None),
            Shape::Triangle => self.area(&triangle(1.0), colour, None),
            Shape::Disc => self.disc((x, y), 4.8, colour, None),
            Shape::LeavesUp => self.area(&arrow(1.0), colour, None),
            Shape::LeavesDown => self.area(&arrow(-1.0), colour, None),
            Shape::Plus => {
                let thick = Stroke::whole(colour, 2.4);
                self.line(&around(&[(-5.5, 0.0), (5.5, 0.0)]), thick);
                self.line(&around(&[(0.0, -5.5), (0.0, 5.5)]), thick);
            }
            Shape::Cross => {
                self.line(&around(&[(-3.6, -3.6), (3.6, 3.6)]), edge);
                self.line(&around(&[(-3.6, 3.6), (3.6, -3.6)]), edge);
            }
        }
    }
}
