//! Bounds on the time that is left, proven.
//!
//! On a window of time let `m <= G <= M` on each side, and let the pull of a side grow and fall no faster than `j`. For Eq. 4 a flight lasts between `2 atanh(v/M)` and
//! `2 atanh(v/m)`, as against a constant pull, and by `w - v = ∫ [G(c + x) - G(c - x)] cosh x dx / sinh a` about the middle `c` of the flight it lands with no more
//! than `κ v`, `κ = 1 + j 2(A coth A - 1)/v`, `A = atanh(v/m)`. For Eq. 2 the acceleration towards the base is between two bounds `A` that differ from those of the
//! pull by what the height adds, and a flight is between two parabolas. Where two flights multiply the speed by `q < 1` at the most, all later ones are slower, what is left
//! is between two geometric sums, and all of that is proven if the larger of them is no longer than the window.
// `!(x < y)` is meant: it also holds where `x` is not a number.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use crate::ground::Piece;

/// How often the window is fitted to what is left.
const FITS: usize = 16;
/// What rounding does to a few operations, relative.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// What bounds the pull on one side over a window.
#[derive(Debug, Clone, Copy)]
struct Side {
    least: f64,
    most: f64,
    /// The fastest that it grows, and that it falls; below 0 where it does not.
    grows: f64,
    falls: f64,
}

/// What two flights, one on each side, may do.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// How long they last.
    lasts: [f64; 2],
    /// By what they multiply the speed, with the impacts after them.
    gain: f64,
}

/// The least and the most that is left after an impact that the block leaves with the speed `v`, to the side that comes first in `sides`, the place of a
/// pull of `piece`; `None` where that is not proven. `slenderness` is that of Eq. 2.
pub fn time_left(piece: &Piece, place: usize, v: f64, eta: f64, slenderness: Option<f64>) -> Option<(f64, f64)> {
    let pull = |place: usize| piece.pulls.get(place).copied().filter(|pull| *pull > 0.0);
    let (own, other) = (pull(place)?, pull(1 - place)?);
    let mut window = 2.0 * v * (1.0 / own + eta / other) / (1.0 - eta * eta);
    for _ in 0..FITS {
        // A little wider than it has to be, so that it is not fitted for ever.
        window *= 1.0 + 1e-3;
        let sides = [Side::of(piece, place, window), Side::of(piece, 1 - place, window)];
        let (least, most) = match slenderness {
            None => linear(sides, v, eta)?,
            Some(alpha) => nonlinear(sides, v, eta, alpha)?,
        };
        if most <= window {
            return Some((least, most));
        }
        window = most;
    }
    None
}

impl Side {
    fn of(piece: &Piece, place: usize, window: f64) -> Self {
        let pull = piece.pulls.get(place).copied().unwrap_or(0.0);
        let slope = if place == 0 { piece.slope() } else { -piece.slope() };
        let bow = piece.curvature * window;
        let unsure = ROUNDING * piece.steepness;
        let (grows, falls) = (slope + bow + unsure, bow + unsure - slope);
        let later = |change: f64| pull + change * window;
        let most = pull.max(later(slope + 0.5 * bow + unsure));
        let least = pull.min(later(slope - 0.5 * bow - unsure));
        Self { least: least * (1.0 - ROUNDING), most: most * (1.0 + ROUNDING), grows, falls }
    }
}

/// The sums over all later pairs of flights.
fn sums(short: Limits, long: Limits) -> Option<(f64, f64)> {
    let sum = |of: Limits| of.lasts.iter().sum::<f64>() / (1.0 - of.gain);
    let outward = 1.0 + ROUNDING / (1.0 - long.gain);
    (long.gain < 1.0).then(|| (sum(short) / outward, sum(long) * outward))
}

fn linear([own, other]: [Side; 2], v: f64, eta: f64) -> Option<(f64, f64)> {
    let lasts = |side: Side, v: f64| (v < side.least).then(|| 2.0 * (v / side.least).atanh());
    let gain = |lasts: f64, v: f64, change: f64| 1.0 + change * 2.0 * coth_less_one(0.5 * lasts) / v;
    let first = lasts(own, v)?;
    let (fastest, slowest) = (gain(first, v, own.grows.max(0.0)), gain(first, v, -own.falls.max(0.0)).max(0.0));
    let next = eta * fastest * v;
    let second = lasts(other, next)?;
    let (fastest_of_other, slowest_of_other) =
        (gain(second, next, other.grows.max(0.0)), gain(second, next, -other.falls.max(0.0)).max(0.0));
    let short = Limits {
        lasts: [2.0 * v / own.most, 2.0 * eta * slowest * v / other.most],
        gain: eta * eta * slowest * slowest_of_other,
    };
    sums(short, Limits { lasts: [first, second], gain: eta * eta * fastest * fastest_of_other })
}

/// `a coth a - 1`, which is `a²/3 - a⁴/45 + ..`, never less.
fn coth_less_one(a: f64) -> f64 {
    if a < 0.1 { a * a / 3.0 } else { (a / a.tanh() - 1.0) * (1.0 + 1e3 * ROUNDING) }
}

fn nonlinear([own, other]: [Side; 2], v: f64, eta: f64, alpha: f64) -> Option<(f64, f64)> {
    let (sin, cos) = alpha.sin_cos();
    let base = sin / alpha;
    let weakest = base * own.least.min(other.least);
    // No flight rises higher while half of the pull is left to it.
    let height = v * v / weakest;
    let angle = alpha * height;
    // -u'' = K G cos(αu) - sin(αu)/α (1 - G sin²α)/cos α
    let towards = |side: Side| {
        let least = base * side.least * (1.0 - 0.5 * angle * angle) - height / cos;
        let most = base * side.most + height * (side.most * sin * sin - 1.0).max(0.0) / cos;
        (least >= 0.5 * weakest).then_some((least * (1.0 - ROUNDING), most * (1.0 + ROUNDING)))
    };
    if !(weakest > 0.0 && angle < 1.0) {
        return None;
    }
    let ((least, most), (least_of_other, most_of_other)) = (towards(own)?, towards(other)?);
    let (gain, gain_of_other) = ((most / least).sqrt(), (most_of_other / least_of_other).sqrt());
    // The next flight may rise no higher either.
    if !(eta * gain <= 1.0) {
        return None;
    }
    let short = Limits {
        lasts: [2.0 * v / most, 2.0 * eta / gain * v / most_of_other],
        gain: eta * eta / (gain * gain_of_other),
    };
    let long = Limits {
        lasts: [2.0 * v / least, 2.0 * eta * gain * v / least_of_other],
        gain: eta * eta * gain * gain_of_other,
    };
    sums(short, long)
}
