//! One flight: from an impact (or from initiation) to the next, in as many steps as its series need.

use contract::Loss;

use crate::equation::{Block, Forcing};
use crate::series::{ORDER, Scale, Terms, evaluate, expand};

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Landing {
    /// With an impact.
    Impact {
        /// How long the flight lasted.
        interval: f64,
        /// The speed just before the impact.
        speed: f64,
        /// How many steps it took.
        steps: u32,
    },
    /// In the air at the horizon.
    Flying,
    /// Past the point of no return.
    Overturned,
    /// Nowhere: the solver lost it.
    Lost(Loss),
}

/// How many steps one flight may take.
const MOST_STEPS: u32 = 2_000_000;
/// How many parts of a step are searched for a sign change.
const PARTS: u32 = 12;
/// What the series may leave off, in multiples of its leading term.
const TRUNCATION: f64 = 1e-18;
/// The longest step, in units of the flight's own time.
const LONGEST: f64 = 2.0;

/// A flight as far as it was followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// How it ended.
    pub landing: Landing,
    /// For how long it was followed.
    pub elapsed: f64,
    /// The rotation and velocity then, away from the base; those of the impact if it ended with one.
    pub state: (f64, f64),
}

/// The flight of sign `side` that leaves at `tau` with speed `speed`, or with jerk if `speed` is 0 (initiation), and may last
/// until `remaining` later.
pub fn fly(block: &Block, side: f64, tau: f64, speed: f64, remaining: f64) -> Landing {
    follow(block, side, tau, (0.0, speed), remaining).landing
}

/// The flight from anywhere: from the rotation and velocity given, both away from the base. From rest on the base it leaves with the acceleration
/// that pushes it away, or where none does, with jerk.
pub fn follow(block: &Block, side: f64, tau: f64, (rotation, speed): (f64, f64), remaining: f64) -> Course {
    let start = block.forcing(side, tau);
    let at_rest = rotation == 0.0 && speed == 0.0;
    let Start { scale, rate, mut multiplicity } = if rotation > 0.0 {
        Start { scale: scale_aloft(block, &start, (rotation, speed)), rate: 1.0, multiplicity: 0 }
    } else if !at_rest {
        let (scale, rate) = scale(block, &start, speed);
        Start { scale, rate, multiplicity: 1 }
    } else if start.gravity < 0.0 {
        Start { scale: scale_pushed(block, &start), rate: 1.0, multiplicity: 2 }
    } else {
        let (scale, rate) = first_scale(block);
        Start { scale, rate, multiplicity: 3 }
    };
    let most = order(rate);
    let unit = scale.velocity * scale.time;
    let mut state =
        if rotation > 0.0 { (rotation / unit, speed / scale.velocity) } else { (0.0, speed / scale.velocity) };
    let mut forcing = start;
    if multiplicity == 3 {
        forcing.gravity = 0.0;
    }
    let mut elapsed = 0.0;
    let course = |landing, elapsed, state: (f64, f64)| Course {
        landing,
        elapsed,
        state: (state.0 * unit, state.1 * scale.velocity),
    };
    for steps in 1..=MOST_STEPS {
        // From rest on the base neither the rotation nor the velocity at the start tells the size of the series.
        let negligible = if multiplicity <= 1 { TRUNCATION } else { 0.0 };
        let series = expand(block, &forcing, &scale, state, Terms { most, negligible });
        let deflated = series.from(multiplicity);
        if !deflated.iter().all(|c| c.is_finite()) {
            return course(Landing::Lost(Loss::NotFinite), elapsed, state);
        }
        let step = reliable(deflated, leading(multiplicity, &forcing));
        let ends = elapsed + step * scale.time >= remaining;
        let step = if ends { ((remaining - elapsed) / scale.time).min(step) } else { step };
        match first_root(deflated, step) {
            Root::At(x) => {
                let arrival = evaluate(series.from(0), x).1;
                let interval = elapsed + x * scale.time;
                let landing = Landing::Impact { interval, speed: -arrival * scale.velocity, steps };
                return course(landing, interval, (0.0, arrival));
            }
            Root::Below => return course(Landing::Lost(Loss::FellThrough), elapsed, state),
            Root::None => {}
        }
        state = evaluate(series.from(0), step);
        if block.overturned(state.0 * unit, state.1) {
            return course(Landing::Overturned, elapsed + step * scale.time, state);
        }
        if ends {
            return course(Landing::Flying, remaining, state);
        }
        let before = elapsed;
        elapsed += step * scale.time;
        if elapsed <= before {
            return course(Landing::Lost(Loss::Stalled), elapsed, state);
        }
        multiplicity = 0;
        forcing = block.forcing(side, tau + elapsed);
    }
    course(Landing::Lost(Loss::SolverFailed), elapsed, state)
}

/// The units in which a flight is followed, how fast its series converges at most, and how many factors of time divide its rotation at the start.
struct Start {
    scale: Scale,
    rate: f64,
    multiplicity: usize,
}

/// The longest time in which every term of the equation stays expandable: the excitation and the block itself.
fn cap(block: &Block) -> f64 {
    block.cos_alpha.sqrt() / block.omega.max(1.0)
}

/// The units of the first flight, and how fast its series converges at most. `u = K (qω s³/6 - ω² s⁴/24 + ...)` lands near
/// `s = 4q/ω`; `P = K qω T³`.
fn first_scale(block: &Block) -> (Scale, f64) {
    let jerk = block.slope * block.q * block.omega;
    let time = (4.0 * block.q / block.omega).min(cap(block)).min((1.0 / (block.alpha * jerk)).cbrt());
    (Scale { time, velocity: jerk * time * time }, 1.0)
}

/// The units of a later flight: those of the parabola that lands at `s = 2 v/(K G)`, or of the cubic where `G` is near 0.
/// Where `G < 0` pushes the block away, it lands no sooner than `s = 3 |G|/(ω f')`, however slowly it left.
fn scale(block: &Block, forcing: &Forcing, speed: f64) -> (Scale, f64) {
    let pull = block.slope * forcing.gravity.abs();
    let jerk = block.slope * block.omega * forcing.slope.abs();
    let landing = (2.0 * speed / pull).min((6.0 * speed / jerk).sqrt());
    let pushed = if forcing.gravity < 0.0 { (3.0 * pull / jerk).min((block.alpha * pull).sqrt().recip()) } else { 0.0 };
    let cap = cap(block);
    let time = cap.min(1.0 / (block.alpha * speed)).min(landing.max(pushed));
    let rate = if forcing.gravity < 0.0 { 1.0 } else { (time / cap).max(block.alpha * speed * time) };
    (Scale { time, velocity: speed }, rate)
}

/// The units of a flight that is pushed from rest on the base, `u = K |G| s²/2` and more: if the push falls, until it has turned and the block lands,
/// however soon; if it grows, those of the first flight, which it then is but for its start.
fn scale_pushed(block: &Block, forcing: &Forcing) -> Scale {
    let pull = block.slope * forcing.gravity.abs();
    // Of G, which is negative: a falling G is a growing push.
    let jerk = block.slope * block.omega * forcing.slope;
    if jerk < 0.0 {
        return first_scale(block).0;
    }
    let time = cap(block).min(3.0 * pull / jerk).min((block.alpha * pull).sqrt().recip());
    Scale { time, velocity: pull * time }
}

/// The units of a flight that starts in the air: the speed with which it would land, and the time in which it would, under the pull that there is.
fn scale_aloft(block: &Block, forcing: &Forcing, (rotation, speed): (f64, f64)) -> Scale {
    let pull = block.slope * forcing.gravity.abs();
    let velocity = speed.hypot((2.0 * pull * rotation).sqrt()).max(rotation / cap(block));
    let time = cap(block).min(1.0 / (block.alpha * velocity)).min(2.0 * velocity / pull);
    Scale { time, velocity }
}

/// The order that a series needs whose terms fall off as `rate^k`, at twice its unit of time; five terms more for what is
/// not of that size.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn order(rate: f64) -> usize {
    let digits = -(2.0 * rate).ln();
    if digits <= 2.2 { ORDER } else { (5.0 + 42.0 / digits).ceil() as usize }
}

/// How many terms of a series tell its size: the first one when it starts from a root, two when it is pushed away from it.
fn leading(multiplicity: usize, forcing: &Forcing) -> usize {
    match multiplicity {
        0 | 2 => 3,
        1 if forcing.gravity < 0.0 => 2,
        _ => 1,
    }
}

/// How far the series may be trusted: where its last two terms are negligible against the largest of the `leading` first ones.
pub(crate) fn reliable(deflated: &[f64], leading: usize) -> f64 {
    let lead = deflated.iter().take(leading).fold(0.0, |m: f64, c| m.max(c.abs()));
    let allowed = TRUNCATION * lead;
    deflated.iter().enumerate().rev().take(2).fold(LONGEST, |step, (k, c)| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
        let power = k as i32;
        if c.abs() * LONGEST.powi(power) <= allowed {
            step
        } else {
            step.min((allowed / c.abs()).powf(1.0 / f64::from(power)))
        }
    })
}

/// Where the polynomial is first 0 in a step.
pub(crate) enum Root {
    /// Nowhere.
    None,
    /// It is not positive at the start.
    Below,
    /// Here.
    At(f64),
}

/// The first root in `(0, step]` of the deflated polynomial, which has to be positive at 0.
pub(crate) fn first_root(deflated: &[f64], step: f64) -> Root {
    let (value, slope) = match *deflated {
        [value, slope, ..] => (value, slope),
        [value] => (value, 0.0),
        [] => (0.0, 0.0),
    };
    if value <= 0.0 {
        return Root::Below;
    }
    if slope < 0.0
        && let Some(x) = fallen(deflated, step)
    {
        return Root::At(x);
    }
    let (end, _) = evaluate(deflated, step);
    if falls(deflated, step) {
        return if end > 0.0 { Root::None } else { Root::At(polish(deflated, 0.0, step)) };
    }
    let (mut left, mut left_slope) = (0.0, slope);
    for part in 1..=PARTS {
        let right = step * f64::from(part) / f64::from(PARTS);
        let (value, slope) = evaluate(deflated, right);
        if value <= 0.0 {
            return Root::At(polish(deflated, left, right));
        }
        if left_slope < 0.0 && slope > 0.0 {
            // A minimum in between: it may dip below 0.
            let lowest = minimum(deflated, left, right);
            if evaluate(deflated, lowest).0 <= 0.0 {
                return Root::At(polish(deflated, left, lowest));
            }
        }
        (left, left_slope) = (right, slope);
    }
    Root::None
}

/// Whether the higher terms cannot turn the linear one round: the polynomial falls all the way to `x` and has one root at most.
fn falls(deflated: &[f64], x: f64) -> bool {
    let slope = deflated.get(1).copied().unwrap_or(0.0);
    let (mut bend, mut power, mut k) = (0.0, x, 2.0);
    for c in deflated.iter().skip(2) {
        bend += k * c.abs() * power;
        power *= x;
        k += 1.0;
    }
    bend < -slope
}

/// The first root if the polynomial falls all the way to it and Newton's method finds it from where the parabola has its own; nothing if not.
fn fallen(deflated: &[f64], step: f64) -> Option<f64> {
    let [value, slope, ..] = *deflated else { return None };
    let mut x = -value / slope;
    for _ in 0..8 {
        if !(x > 0.0 && x <= step) {
            return None;
        }
        let (value, slope) = evaluate(deflated, x);
        let next = x - value / slope;
        let moved = (next - x).abs();
        x = next;
        // The next step would be of the order of the square of this one.
        if moved <= 1e-9 * x {
            let (value, slope) = evaluate(deflated, x);
            let x = x - value / slope;
            return (x <= step && falls(deflated, x)).then_some(x);
        }
    }
    None
}

/// The minimum between two points, by bisection of the slope.
fn minimum(polynomial: &[f64], mut left: f64, mut right: f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (left + right);
        if evaluate(polynomial, middle).1 < 0.0 { left = middle } else { right = middle }
    }
    0.5 * (left + right)
}

/// The root between a positive and a non-positive value, by Newton steps that stay inside the bracket.
fn polish(polynomial: &[f64], mut left: f64, mut right: f64) -> f64 {
    let mut x = 0.5 * (left + right);
    for _ in 0..80 {
        let (value, slope) = evaluate(polynomial, x);
        if value > 0.0 {
            left = x
        } else {
            right = x
        }
        let newton = x - value / slope;
        let next = if newton >= left && newton <= right { newton } else { 0.5 * (left + right) };
        let moved = (next - x).abs();
        x = next;
        if moved <= 1e-16 * x {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests;
