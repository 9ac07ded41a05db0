//! Colours, and those of everything that is not a series.

use std::fmt;

/// A colour: its red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Colour(pub(super) u8, pub(super) u8, pub(super) u8);

impl Colour {
    /// Half-way to white and a little further.
    pub(super) fn pale(self) -> Self {
        let of = |part: u8| 255 - (255 - part) / 5 * 2;
        Self(of(self.0), of(self.1), of(self.2))
    }
}

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(red, green, blue) = self;
        write!(f, "#{red:02X}{green:02X}{blue:02X}")
    }
}

/// Of text and frames.
pub(super) const BLACK: Colour = Colour(0x1A, 0x1A, 0x1A);
/// Of marks.
pub(super) const DARK: Colour = Colour(0x55, 0x55, 0x55);
/// Of grid lines.
pub(super) const LIGHT: Colour = Colour(0xE2, 0xE2, 0xE2);
/// Behind points that are off the scale.
pub(super) const PALE: Colour = Colour(0xF5, 0xF5, 0xF5);
/// Of hatching.
pub(super) const GREY: Colour = Colour(0x99, 0x99, 0x99);
/// Of paper.
pub(super) const WHITE: Colour = Colour(0xFF, 0xFF, 0xFF);
/// Behind what lasts.
pub(super) const COOL: Colour = Colour(0xDF, 0xE9, 0xF2);
/// Behind what is strong.
pub(super) const WARM: Colour = Colour(0xFC, 0xE6, 0xD2);

/// What is seen in the dark in the place of each colour; a colour of a series that is not here is seen well enough on both.
const IN_THE_DARK: [(Colour, Colour); 11] = [
    (BLACK, Colour(0xE4, 0xE8, 0xEC)),
    (DARK, Colour(0xA8, 0xB2, 0xBC)),
    (LIGHT, Colour(0x2B, 0x33, 0x3B)),
    (PALE, Colour(0x1E, 0x25, 0x2C)),
    (GREY, Colour(0x77, 0x80, 0x88)),
    (WHITE, Colour(0x17, 0x1C, 0x21)),
    (COOL, Colour(0x22, 0x31, 0x40)),
    (WARM, Colour(0x43, 0x2C, 0x18)),
    // Of series: black, blue, vermilion.
    (Colour(0x00, 0x00, 0x00), Colour(0xF4, 0xF6, 0xF8)),
    (Colour(0x00, 0x72, 0xB2), Colour(0x5A, 0xB4, 0xEE)),
    (Colour(0xD5, 0x5E, 0x00), Colour(0xFF, 0x93, 0x47)),
];

/// A style by which a drawing turns dark where its reader likes that. A viewer that knows no styles shows it as it is.
pub(super) fn dark_style() -> String {
    let rules = IN_THE_DARK
        .iter()
        .map(|(light, dark)| format!("svg [fill=\"{light}\"]{{fill:{dark}}}svg [stroke=\"{light}\"]{{stroke:{dark}}}"));
    format!("@media (prefers-color-scheme:dark){{{}}}", rules.collect::<String>())
}
