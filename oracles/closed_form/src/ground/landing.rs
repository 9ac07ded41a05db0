//! The first time at which a flight is back on the base, and a proof that there is none before.
//!
//! Between two changes the pull is within bounds that follow from its value, its slope and its curvature, and so is the acceleration `u - c`. Where that has one
//! sign, the rotation is concave, and has one root at most after its start; or convex, and is searched down to its lowest point. A stretch in which the sign is
//! not known is halved, unless the rotation stays above the base by what its acceleration can do at most.

use super::flight::Flight;

/// How a stretch ends.
pub enum Search {
    /// On the base, so long after the start.
    Root(f64),
    /// In the air.
    None,
}

/// Shorter parts than this share of a stretch are as good as nothing: what happens within is rounding.
const SHORTEST: f64 = 1e-9;

/// The first root in `(from, to]`, in which the pull does not change but smoothly.
pub fn first_root(flight: &Flight, from: f64, to: f64) -> Search {
    search(flight, from, to, SHORTEST * (to - from))
}

fn search(flight: &Flight, from: f64, to: f64, shortest: f64) -> Search {
    let (low, high) = (flight.at(from), flight.at(to));
    match Shape::of(flight, (from, low), (to, high)) {
        Shape::Above => Search::None,
        Shape::Concave if high.0 > 0.0 => Search::None,
        Shape::Concave => Search::Root(root(flight, from, to)),
        Shape::Convex if high.0 <= 0.0 => Search::Root(root(flight, from, to)),
        Shape::Convex if low.1 >= 0.0 || high.1 <= 0.0 => Search::None,
        Shape::Convex => {
            let lowest = falling(flight, from, to);
            if flight.at(lowest).0 <= 0.0 { Search::Root(root(flight, from, lowest)) } else { Search::None }
        }
        Shape::Unknown if to - from <= shortest => {
            if high.0 <= 0.0 {
                Search::Root(root(flight, from, to))
            } else {
                Search::None
            }
        }
        Shape::Unknown => {
            let middle = from + 0.5 * (to - from);
            match search(flight, from, middle, shortest) {
                Search::None => search(flight, middle, to, shortest),
                found @ Search::Root(_) => found,
            }
        }
    }
}

/// What is known of the rotation over a stretch.
enum Shape {
    /// It is not back on the base.
    Above,
    Concave,
    Convex,
    Unknown,
}

impl Shape {
    fn of(flight: &Flight, (from, low): (f64, (f64, f64)), (to, high): (f64, (f64, f64))) -> Self {
        let length = to - from;
        let Some((least, most)) = pull_between(flight, from, to) else { return Self::Unknown };
        // |u| between: the larger end and what the acceleration adds, |u''| <= |u| + |c|. For stretches below 1 the sum of the series is below 1.2.
        let pull = least.abs().max(most.abs());
        let bend = length * length / 8.0;
        let size = (low.0.abs().max(high.0.abs()) + pull * bend) * 1.2;
        let acceleration = size + pull;
        let (bottom, top) = (low.0.min(high.0) - acceleration * bend, low.0.max(high.0) + acceleration * bend);
        // From the base, or from rest on it, it rises first.
        let rises = from == 0.0 && low.0 == 0.0 && (low.1 > 0.5 * acceleration * length || most <= 0.0);
        if bottom > 0.0 || rises {
            Self::Above
        } else if top < least {
            Self::Concave
        } else if bottom > most {
            Self::Convex
        } else {
            Self::Unknown
        }
    }
}

/// Between what the pull is from one time to another.
pub fn pull_between(flight: &Flight, from: f64, to: f64) -> Option<(f64, f64)> {
    let (change, _) = flight.piece(from)?;
    let (length, half) = (to - from, 0.5 * (to - from));
    // Just after a change at that time.
    let (start, middle) = (flight.pull(from.next_up()), flight.pull(from + half));
    let bow = 0.5 * change.curvature * half * half;
    let by_middle = (middle.value - middle.slope.abs() * half - bow, middle.value + middle.slope.abs() * half + bow);
    let (straight, bow) = (start.value + start.slope * length, 0.5 * change.curvature * length * length);
    let by_start = (start.value.min(straight - bow), start.value.max(straight + bow));
    Some((by_middle.0.max(by_start.0), by_middle.1.min(by_start.1)))
}

/// The root of the rotation between two times, of which it is above the base up to a root at the first, and on it or below at the second.
fn root(flight: &Flight, from: f64, to: f64) -> f64 {
    // From the base the rotation is divided by the time, so that the start is no root.
    let is_from_base = from == 0.0 && flight.start.0 == 0.0;
    let (mut low, mut high) = (from, to);
    // The landing under the pull at the start is near where the flight is short.
    let guess = 2.0 * flight.start.1 / flight.pull(0.0).value;
    let mut s = if is_from_base && guess > low && guess < high { guess } else { to };
    for _ in 0..200 {
        let (u, rate) = flight.at(s);
        if u > 0.0 {
            low = s
        } else {
            high = s
        }
        let slope = if is_from_base { rate - u / s } else { rate };
        let newton = s - u / slope;
        let next = if newton > low && newton < high { newton } else { low + 0.5 * (high - low) };
        if (next - s).abs() <= 0.5 * f64::EPSILON * s || high - low <= f64::EPSILON * high {
            return next;
        }
        s = next;
    }
    high
}

/// When the velocity, which grows, passes 0.
fn falling(flight: &Flight, from: f64, to: f64) -> f64 {
    let (mut low, mut high) = (from, to);
    while high - low > f64::EPSILON * high {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            break;
        }
        if flight.at(middle).1 < 0.0 { low = middle } else { high = middle }
    }
    high
}
