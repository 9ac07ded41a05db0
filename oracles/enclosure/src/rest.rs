//! A proof that the chattering is complete, and bounds on the time that is left.
//!
//! After an impact that leaves speed `v` take a window `r` of time, and bounds on the pull for each sign of flight and every time in the window. If the sum of
//! the longest durations of all flights to come is within `r`, no flight has left the window, the sequence is infinite, and what is left of it lies between the
//! sums of two geometric series. And what is proven to end within less than `r` never left that: bounds over the shorter window are narrower.
//!
//! **Eq. 4**, `x'' = x - b`: with `m <= b <= M` a flight lasts between `2 atanh(v/M)` and `2 atanh(v/m)`, as against a constant pull. It lands with `w`, where
//! `w - v = ∫ [b(c + y) - b(c - y)] sinh y dy / sinh a` over half of the flight, from its middle `c` on; the bracket is at most `2 y` times the largest slope
//! `j` of the pull, so `w/v <= 1 + j 2 (A coth A - 1)/v`, `A = atanh(v/m)`, and likewise from below.
//!
//! **Eq. 2**: with `0 < m <= -x'' <= M`, for every distance that a flight can reach too, a flight lasts between `2v/M` and `2v/m`, rises no higher than
//! `v²/(2m)`, and lands with a speed between `v sqrt(m/M)` and `v sqrt(M/m)`.

use crate::{
    directed::Directed,
    ground::{Ground, Window},
    interval::Interval,
    piece::Motion,
    pull::Side,
};

/// Bounds for the flights of one sign.
struct Flights<F> {
    /// `m` to `M`.
    acceleration: Interval<F>,
    /// The speed after a flight of the speed before it, and the impact: `η sqrt(m/M)` to `η sqrt(M/m)`.
    decay: Interval<F>,
}

/// The time from an impact that leaves `speed` to the end of the chattering; `None` if it is not proven that there is one.
pub fn time_left<F: Directed, G: Ground<F>>(
    motion: &Motion<F>,
    ground: &G,
    moment: &G::Moment,
    side: Side,
    speed: &Interval<F>,
    eta: f64,
) -> Option<Interval<F>> {
    // The sum for constant pulls, with some room; a larger one leaves the bounds wider.
    let decay = Interval::exactly(eta);
    let [first, second] = [side, side.other()].map(|side| ground.pull(moment, side));
    let [at_first, at_second] =
        [&first, &second].map(|pull| motion.equation.towards_base(&Interval::zero(), &pull.value));
    if !(at_first.is_positive() && at_second.is_positive()) {
        return None;
    }
    let estimate = geometric([&at_first, &at_second], [&decay, &decay], speed);
    let within = |window: f64| {
        let length = Interval::exactly(window);
        let ours = ground.window(moment, side, &first, &length)?;
        let others = ground.window(moment, side.other(), &second, &length)?;
        let left = if motion.equation.is_linear() {
            linear(&ours, &others, speed, eta)?
        } else {
            let (ours, others) = (flights(motion, &ours, speed, eta)?, flights(motion, &others, speed, eta)?);
            let one = Interval::exactly(1.0);
            let falls = ours.decay.is_below(&one) && others.decay.is_below(&one);
            falls.then(|| geometric([&ours.acceleration, &others.acceleration], [&ours.decay, &others.decay], speed))?
        };
        (left.upper.double_above() <= window).then_some(left)
    };
    let window = 1.5 * estimate.upper.double_above();
    let left = Some(window).filter(|window| window.is_finite()).and_then(within)?;
    Some(within(left.upper.double_above()).map_or_else(|| left.clone(), |narrower| narrower.and(&left)))
}

/// Bounds on the time that is left on Eq. 4.
fn linear<F: Directed>(ours: &Window<F>, others: &Window<F>, speed: &Interval<F>, eta: f64) -> Option<Interval<F>> {
    if !(ours.value.is_positive() && others.value.is_positive()) {
        return None;
    }
    let (one, two, eta) = (Interval::exactly(1.0), Interval::exactly(2.0), Interval::exactly(eta));
    let fastest = Interval::at(&speed.upper);
    // `A` from above, `w/v` from above and from below.
    let bounds = |window: &Window<F>, v: &Interval<F>| {
        let longest = arctangent_above(&(v / &Interval::at(&window.value.lower)))?;
        // a coth a - 1 <= a²/3
        let gain = &(&two * &longest.squared()) / &(&Interval::exactly(3.0) * v);
        // From 1 to what the largest slope makes of it, and the least one: flights that are shorter than this one gain less.
        let grown = &one + &(&gain * &window.slope).with_zero();
        Some((longest, Interval::at(&grown.upper), Interval::at(&grown.lower).not_below_zero()))
    };
    let (first, most, least) = bounds(ours, &fastest)?;
    let next = Interval::at(&(&(&eta * &most) * &fastest).upper);
    let (second, most_next, least_next) = bounds(others, &next)?;
    let square = eta.squared();
    let (slow, fast) = (&(&square * &least) * &least_next, &(&square * &most) * &most_next);
    if !fast.is_below(&one) {
        return None;
    }
    let longest = &(&two * &(&first + &second)) / &(&one - &fast);
    let slowest = Interval::at(&speed.lower);
    let pair = &(&slowest / &Interval::at(&ours.value.upper))
        + &(&(&(&eta * &least) * &slowest) / &Interval::at(&others.value.upper));
    let shortest = &(&two * &pair) / &(&one - &slow);
    Some(Interval { lower: shortest.lower, upper: longest.upper })
}

/// `atanh x` from above, for small `x`: `x + x³/3 + x⁵/5 + ..  <= x + x³/(3 (1 - x²))`.
fn arctangent_above<F: Directed>(x: &Interval<F>) -> Option<Interval<F>> {
    let square = x.squared();
    let rest = &Interval::exactly(1.0) - &square;
    let most = x + &(&(x * &square) / &(&Interval::exactly(3.0) * &rest));
    rest.is_positive().then(|| Interval::at(&most.upper))
}

/// Bounds for the flights of one sign within the window, on Eq. 2.
fn flights<F: Directed>(motion: &Motion<F>, window: &Window<F>, speed: &Interval<F>, eta: f64) -> Option<Flights<F>> {
    let pull = &window.value;
    if !pull.is_positive() {
        return None;
    }
    // A height that is not exceeded if the acceleration below it is as found.
    let square = speed.squared();
    let highest = (&square / pull).down_to_zero();
    let acceleration = motion.equation.towards_base(&highest, pull);
    // v²/(2m) <= highest
    let slowed = &(&Interval::exactly(2.0) * &acceleration) * &Interval::at(&highest.upper);
    if !(acceleration.is_positive() && slowed.lower >= square.upper) {
        return None;
    }
    let (least, most) = (Interval::at(&acceleration.lower), Interval::at(&acceleration.upper));
    let stretch = (&most / &least).root();
    let eta = Interval::exactly(eta);
    let decay = Interval { lower: (&eta / &stretch).lower, upper: (&eta * &stretch).upper };
    Some(Flights { acceleration, decay })
}

/// `(2v/g₁ + 2v q₁/g₂)/(1 - q₁ q₂)`, for every acceleration `g` and decay `q` given. It falls with each `g` and grows with each `q`, so its
/// bounds are at the ends; the interval arithmetic would take different `q` in different places.
fn geometric<F: Directed>(
    accelerations: [&Interval<F>; 2],
    decays: [&Interval<F>; 2],
    speed: &Interval<F>,
) -> Interval<F> {
    let sum = |[g1, g2]: [&F; 2], [q1, q2]: [&F; 2], speed: &F| {
        let [g1, g2, q1, q2, v] = [g1, g2, q1, q2, speed].map(Interval::at);
        let pair = &(&v / &g1) + &(&(&v * &q1) / &g2);
        &(&Interval::exactly(2.0) * &pair) / &(&Interval::exactly(1.0) - &(&q1 * &q2))
    };
    let [g1, g2] = accelerations;
    let [q1, q2] = decays;
    Interval {
        lower: sum([&g1.upper, &g2.upper], [&q1.lower, &q2.lower], &speed.lower).lower,
        upper: sum([&g1.lower, &g2.lower], [&q1.upper, &q2.upper], &speed.upper).upper,
    }
}

#[cfg(test)]
mod tests;
