//! A proof that the chattering is complete, and bounds on the time that is left.
//!
//! After an impact that leaves speed `v` take a window `r` of time, and bounds `0 < m <= -x'' <= M` on the acceleration towards the base for
//! each sign of flight, every time in the window and every distance that a flight can reach. A flight that leaves with speed `v` lasts between
//! `2v/M` and `2v/m`, rises no higher than `v²/(2m)`, and lands with a speed between `v sqrt(m/M)` and `v sqrt(M/m)`: so the next one leaves
//! with at most `q v`, `q = η sqrt(M/m)`. If `q < 1` for both signs and the sum of the longest durations is within `r`, no flight has left the
//! window, the sequence is infinite, and what is left of it lies between the two geometric sums.

use crate::{
    directed::Directed,
    excitation::{Pull, Side},
    interval::Interval,
    piece::Motion,
};

/// Bounds for the flights of one sign.
struct Flights<F> {
    /// `m` to `M`.
    acceleration: Interval<F>,
    /// The speed after a flight of the speed before it, and the impact: `η sqrt(m/M)` to `η sqrt(M/m)`.
    decay: Interval<F>,
}

/// The time from an impact that leaves `speed` to the end of the chattering; `None` if it is not proven that there is one.
pub fn time_left<F: Directed>(
    motion: &Motion<F>,
    pull_of: impl Fn(Side) -> Pull<F>,
    side: Side,
    speed: &Interval<F>,
    eta: f64,
) -> Option<Interval<F>> {
    let pulls = [side, side.other()].map(pull_of);
    // The sum for constant pulls, with some room; a larger one leaves the bounds wider.
    let [first, second] = &pulls;
    let one = Interval::exactly(1.0);
    let decay = Interval::exactly(eta);
    let [at_first, at_second] =
        [first, second].map(|pull| motion.equation.towards_base(&Interval::zero(), &pull.value));
    let estimate = geometric([&at_first, &at_second], [&decay, &decay], speed);
    let window = 1.5 * estimate.upper.double_above();
    if !(at_first.is_positive() && at_second.is_positive() && window.is_finite()) {
        return None;
    }
    let [ours, others] = &pulls;
    let (ours, others) = (flights(motion, ours, speed, window, eta)?, flights(motion, others, speed, window, eta)?);
    let left = geometric([&ours.acceleration, &others.acceleration], [&ours.decay, &others.decay], speed);
    let falls = |flights: &Flights<F>| flights.decay.is_below(&one);
    (falls(&ours) && falls(&others) && left.upper.double_above() <= window).then_some(left)
}

/// Bounds for the flights of one sign within the window.
fn flights<F: Directed>(
    motion: &Motion<F>,
    pull: &Pull<F>,
    speed: &Interval<F>,
    window: f64,
    eta: f64,
) -> Option<Flights<F>> {
    // b' changes by at most a ω² r, b by at most the integral of that.
    let time = Interval::between(0.0, window);
    let bend = &motion.excitation.amplitude * &motion.excitation.omega.squared();
    let slope = &pull.slope + &(&Interval::within(bend.magnitude()) * &time);
    let pull = &pull.value + &(&slope * &time);
    // A height that is not exceeded if the acceleration below it is as found.
    let square = speed.squared();
    let highest = (&square / &pull).down_to_zero();
    if !pull.is_positive() {
        return None;
    }
    let acceleration = motion.equation.towards_base(&highest, &pull);
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
