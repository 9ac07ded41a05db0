//! One step of a flight, so short that the block can't land and leave again unseen within it; and where it lands.

use super::{knot::Knot, problem::Problem};

/// Newton's method, held in a bracket, needs a handful.
const MOST_ITERATIONS: usize = 100;

/// What a step came to.
pub(super) enum Advance {
    /// The block is still in the air.
    Aloft { knot: Knot, peak: Option<f64> },
    /// It landed so long after the start of the step, with this speed.
    Landed { after: f64, speed: f64, peak: Option<f64> },
}

impl Advance {
    /// The largest rotation within the step, if it was passed there.
    pub fn peak(&self) -> Option<f64> {
        match self {
            Self::Aloft { peak, .. } | Self::Landed { peak, .. } => *peak,
        }
    }
}

/// A step from `from`, `limit` long at the most. Only a peak that may be above `highest` is looked for.
pub(super) fn advance(problem: &Problem, from: &Knot, limit: f64, highest: f64) -> Advance {
    let (lands, length) = length(problem, from);
    let h = length.min(limit);
    let to = from.advanced(problem, h);
    let at = |s: f64| from.advanced(problem, s).state;
    let from_rest = from.state == (0.0, 0.0);
    let most = from.state.0 + (from.state.1 + problem.push(from.time, from.state.0) * h) * h;
    let turns_down = from_rest || (from.state.1 > 0.0 && most > highest);
    if to.state.0 <= 0.0 {
        let after = first_below(&at, h, lands);
        let (_, w) = at(after);
        let peak = (turns_down && w < 0.0).then(|| at(where_velocity_turns(&at, after, 1.0)).0);
        return Advance::Landed { after, speed: -w, peak };
    }
    // From falling to rising: was the base reached between?
    if from.state.1 < 0.0 && to.state.1 > 0.0 {
        let lowest = where_velocity_turns(&at, h, -1.0);
        if at(lowest).0 <= 0.0 {
            let after = first_below(&at, lowest, lands);
            return Advance::Landed { after, speed: -at(after).1, peak: None };
        }
    }
    let peak = (turns_down && to.state.1 <= 0.0).then(|| at(where_velocity_turns(&at, h, 1.0)).0);
    Advance::Aloft { knot: to, peak }
}

/// When the block lands if it goes on as it accelerates now, and how long a step may be: up to where it then turns, or to where it lands.
fn length(problem: &Problem, from: &Knot) -> (f64, f64) {
    let (u, w) = from.state;
    let longest = problem.longest_step();
    let towards = -from.acceleration(problem, 0.0, u);
    if towards <= 0.0 || (u == 0.0 && w == 0.0) {
        return (longest, problem.step_of_push(from.time));
    }
    let lands = (w + (w * w + 2.0 * towards * u).sqrt()) / towards;
    let step = if w > 0.0 { (w / towards).max(0.3 * lands) } else { 1.2 * lands };
    (lands, step.min(longest))
}

/// The first time within `end` at which the rotation is 0 again, where it is above 0 just after the start and not above it at `end`, and falls there;
/// near `guess`, perhaps.
fn first_below(at: &impl Fn(f64) -> (f64, f64), end: f64, guess: f64) -> f64 {
    let (mut above, mut below, mut s) = (0.0, end, guess.min(end));
    for _ in 0..MOST_ITERATIONS {
        let (u, w) = at(s);
        if u > 0.0 {
            above = s
        } else {
            below = s
        }
        let newton = s - u / w;
        let next = if newton > above && newton < below { newton } else { 0.5 * (above + below) };
        if (next - s).abs() <= 4.0 * f64::EPSILON * s {
            return next;
        }
        s = next;
    }
    s
}

/// Where the velocity changes its sign from that of `sign`, by halving; where it does not, one of the ends.
fn where_velocity_turns(at: &impl Fn(f64) -> (f64, f64), end: f64, sign: f64) -> f64 {
    let (mut before, mut after) = (0.0, end);
    for _ in 0..30 {
        let middle = 0.5 * (before + after);
        if sign * at(middle).1 > 0.0 { before = middle } else { after = middle }
    }
    0.5 * (before + after)
}
