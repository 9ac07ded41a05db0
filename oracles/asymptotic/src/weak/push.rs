//! A push out of rest as the flights see it: scaled so that it is of order 1.

use contract::{Decline, Motion};

use super::{flight::Push, ground::pieces, sum::Powers, threshold::Start};
use crate::series::Series;

/// A push, and the units that it is in.
pub(super) struct Scaled {
    pub push: Push,
    pub powers: Powers,
    /// Of time.
    pub unit: f64,
    /// By how much of itself the push may be wrong, of rounding.
    pub unsure: f64,
    /// When the motion is another than the push knows.
    pub until: f64,
}

impl Scaled {
    /// The push that begins at `start`, with as many terms as an answer of that order needs.
    ///
    /// # Errors
    /// A [`Decline`] where the push has no peak that it falls from.
    pub fn new(motion: &Motion, start: &Start, order: usize) -> Result<Self, Decline> {
        if start.piece.is_straight() { of_lines(motion, start, order) } else { of_curve(start, order) }
    }
}

/// `f - 1 = g_0 + g_1 s - G s²/2 + g_3 s³/6 + ..`: with `h² = g_1² + 2 G g_0` times are counted in `h/G`, and the push in `h²/G`, twice what the peak is above the
/// threshold.
fn of_curve(start: &Start, order: usize) -> Result<Scaled, Decline> {
    let Start { time, sign, crosses, piece } = start;
    let powers = Powers::Roots;
    let terms = powers.needed(order);
    let mut derivatives: Vec<f64> = piece.derivatives(*time, terms + 2).iter().map(|value| sign * value).collect();
    if let Some(value) = derivatives.first_mut() {
        *value = if *crosses { 0.0 } else { *value - 1.0 };
    }
    let [above, slope, bend, ..] = *derivatives.as_slice() else { return Err(no_peak(*time)) };
    let bends_down = bend < 0.0;
    if !bends_down {
        return Err(no_peak(*time));
    }
    let height = (slope * slope - 2.0 * bend * above).sqrt();
    let (unit, level) = (-height / bend, -height * height / bend);
    let mut size = 1.0 / level;
    let scaled = derivatives.iter().enumerate().map(|(k, derivative)| {
        let series = at_place(k.saturating_sub(2), derivative * size, terms);
        size *= unit;
        series
    });
    Ok(Scaled {
        push: Push {
            derivatives: scaled.collect(),
            kinks: Vec::new(),
            lift: at_place(2, unit * unit, terms),
            level: at_place(2, level, terms),
        },
        powers,
        unit,
        unsure: 4.0 * piece.unsure / level,
        until: piece.to,
    })
}

/// Straight lines with kinks while they are above the threshold; the last of them falls below it. With its slope times are counted in the time that it takes from
/// the peak.
fn of_lines(motion: &Motion, start: &Start, order: usize) -> Result<Scaled, Decline> {
    let Start { time, sign, crosses, .. } = start;
    let powers = Powers::Whole;
    let terms = powers.needed(order);
    let (value, slope) = start.piece.at(*time);
    let above = if *crosses { 0.0 } else { sign * value - 1.0 };
    let (mut level, mut before, mut unsure) = (above, sign * slope, start.piece.unsure);
    let mut kinks = Vec::new();
    for piece in pieces(motion, *time) {
        let slope = sign * piece.at(piece.from).1;
        if piece.from > *time {
            kinks.push((piece.from - time, slope - before));
            level = level.max(sign * piece.at(piece.from).0 - 1.0);
            (before, unsure) = (slope, unsure.max(piece.unsure));
        }
        if sign * piece.at(piece.to).0 >= 1.0 {
            continue;
        }
        let unit = -level / slope;
        let falls = unit > 0.0;
        if !falls {
            break;
        }
        let rate = unit / level;
        return Ok(Scaled {
            push: Push {
                derivatives: vec![
                    at_place(0, above / level, terms),
                    at_place(0, sign * start.piece.at(*time).1 * rate, terms),
                ],
                kinks: kinks.iter().map(|(at, change)| (at / unit, change * rate)).collect(),
                lift: at_place(2, unit * unit, terms),
                level: at_place(1, level, terms),
            },
            powers,
            unit,
            unsure: 4.0 * unsure / level,
            until: piece.to,
        });
    }
    Err(no_peak(*time))
}

fn no_peak(time: f64) -> Decline {
    Decline::NotConvergent {
        why: format!("the push that begins at tau = {time} has no peak that it falls from before the motion changes"),
    }
}

/// A term at its place.
fn at_place(place: usize, value: f64, terms: usize) -> Series<f64> {
    let mut series = Series::constant(0.0, terms);
    if let Some(term) = series.0.get_mut(place) {
        *term = value;
    }
    series
}
