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
