//! Colours of values: viridis, even to the eye and safe for the colour-blind.

use super::colour::Colour;

/// Viridis (matplotlib, CC0) at every tenth.
const VIRIDIS: [[u8; 3]; 11] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x24, 0x75],
    [0x41, 0x44, 0x87],
    [0x35, 0x5F, 0x8D],
    [0x2A, 0x78, 0x8E],
    [0x21, 0x91, 0x8C],
    [0x22, 0xA8, 0x84],
    [0x44, 0xBF, 0x70],
    [0x7A, 0xD1, 0x51],
    [0xBD, 0xDF, 0x26],
    [0xFD, 0xE7, 0x25],
];

/// The colour at a fraction of the range; beyond its ends, that of the end.
pub(super) fn colour(fraction: f64) -> Colour {
    let place = fraction.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = place.floor();
    let pick = |index: f64| VIRIDIS.get(index as usize).or(VIRIDIS.last()).copied().unwrap_or_default();
    let ([r, g, b], [r1, g1, b1]) = (pick(below), pick(below + 1.0));
    let mix =
        |one: u8, other: u8| (f64::from(one) + (place - below) * (f64::from(other) - f64::from(one))).round() as u8;
    Colour(mix(r, r1), mix(g, g1), mix(b, b1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_grows() {
        let light = |step: u8| {
            let Colour(r, g, b) = colour(f64::from(step) / 50.0);
            0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
        };
        assert!((0..50).all(|step| light(step) < light(step + 1)));
        assert_eq!(colour(-3.0), colour(0.0));
        assert_eq!(colour(f64::INFINITY), colour(1.0));
    }
}
