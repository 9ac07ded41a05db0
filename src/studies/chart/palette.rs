//! How series are told apart: by colour, and by dash and marker too, so that a chart reads in grey and to the colour-blind.

use plotters::style::RGBColor;

/// Of text and frames.
pub(super) const BLACK: RGBColor = RGBColor(0x1A, 0x1A, 0x1A);
/// Of marks.
pub(super) const DARK: RGBColor = RGBColor(0x55, 0x55, 0x55);
/// Of grid lines.
pub(super) const LIGHT: RGBColor = RGBColor(0xE2, 0xE2, 0xE2);
/// Behind points that are off the scale.
pub(super) const PALE: RGBColor = RGBColor(0xF5, 0xF5, 0xF5);
/// Of hatching.
pub(super) const GREY: RGBColor = RGBColor(0x99, 0x99, 0x99);
/// Of paper.
pub(super) const WHITE: RGBColor = RGBColor(0xFF, 0xFF, 0xFF);

/// The colours of Okabe and Ito, the yellow, which is hardly seen on white, replaced by a grey.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0x00, 0x72, 0xB2), // blue
    RGBColor(0xD5, 0x5E, 0x00), // vermilion
    RGBColor(0x00, 0x9E, 0x73), // bluish green
    RGBColor(0x00, 0x00, 0x00), // black
    RGBColor(0xE6, 0x9F, 0x00), // orange
    RGBColor(0xCC, 0x79, 0xA7), // reddish purple
    RGBColor(0x56, 0xB4, 0xE9), // sky blue
    RGBColor(0x80, 0x80, 0x80), // grey
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
}

/// How one series looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ink {
    pub(super) colour: RGBColor,
    pub(super) dash: &'static [f64],
    pub(super) shape: Shape,
}

impl Ink {
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
