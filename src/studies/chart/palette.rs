//! How series are told apart: by colour, and by dash and marker too, so that a chart reads in grey and to the colour-blind.

use super::{
    Draw,
    canvas::Stroke,
    colour::{BLACK, Colour},
    marker::Shape,
};

/// The thickness of the line of a series,
pub(super) const LINE: f64 = 2.0;
/// and of a broad one.
const BROAD: f64 = 7.0;

/// The colours of Okabe and Ito, the yellow, which is hardly seen on white, replaced by a grey.
const COLOURS: [Colour; 8] = [
    Colour(0x00, 0x72, 0xB2), // blue
    Colour(0xD5, 0x5E, 0x00), // vermilion
    Colour(0x00, 0x9E, 0x73), // bluish green
    Colour(0x00, 0x00, 0x00), // black
    Colour(0xE6, 0x9F, 0x00), // orange
    Colour(0xCC, 0x79, 0xA7), // reddish purple
    Colour(0x56, 0xB4, 0xE9), // sky blue
    Colour(0x80, 0x80, 0x80), // grey
];

/// Lengths drawn and left out in turn.
const DASHES: [&[f64]; 6] =
    [&[], &[11.0, 5.0], &[2.5, 4.0], &[13.0, 4.0, 2.5, 4.0], &[6.0, 3.0], &[18.0, 4.0, 6.0, 4.0]];

const SHAPES: [Shape; 8] = [
    Shape::Disc,
    Shape::OpenSquare,
    Shape::Triangle,
    Shape::OpenDiamond,
    Shape::Square,
    Shape::OpenDisc,
    Shape::Diamond,
    Shape::Plus,
];

/// How one series looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ink {
    pub(super) colour: Colour,
    pub(super) dash: &'static [f64],
    pub(super) shape: Shape,
}

impl Ink {
    /// Its line, as thick as lines are, or broad and pale.
    pub(super) fn stroke(self, draw: Draw) -> Stroke {
        if draw == Draw::Broad {
            return Stroke::whole(self.colour.pale(), BROAD);
        }
        Stroke { colour: self.colour, thick: LINE, dash: self.dash }
    }

    /// The look of the series in a slot; the first 24 differ in colour and dash.
    pub(super) fn of(slot: usize) -> Self {
        let pick = |len: usize| slot % len;
        Self {
            colour: COLOURS.get(pick(COLOURS.len())).copied().unwrap_or(BLACK),
            dash: DASHES.get(pick(DASHES.len())).copied().unwrap_or_default(),
            shape: SHAPES.get((slot + slot / SHAPES.len()) % SHAPES.len()).copied().unwrap_or(Shape::Disc),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_series_look_alike() {
        let inks: Vec<Ink> = (0..24).map(Ink::of).collect();
        for (index, ink) in inks.iter().enumerate() {
            assert!(!inks[..index].contains(ink), "{index}");
            assert!(!inks[..index].iter().any(|other| (other.colour, other.dash) == (ink.colour, ink.dash)), "{index}");
        }
    }
}
