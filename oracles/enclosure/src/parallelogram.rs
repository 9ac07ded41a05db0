//! Every state that a block can be in just after an impact, as a parallelogram in time and speed about a point (Lohner's method), on Eq. 4.
//!
//! Intervals forget that time and speed are off together: bounds that are fed back from flight to flight grow faster than what they bound. Here the flight of
//! the point is enclosed by itself, and a state a little beside it lands a little beside it, by the derivatives of a flight. With `C` and `c` the pull at take-off and
//! at landing, `x(s) = v sinh s - ∫ b(t + y) sinh(s - y) dy`, `x(T) = 0` and `x'(T) = -w` give
//!
//! ```text
//! dT/dv = sinh T/w                     dT/dt = (C sinh T - v cosh T - w)/w
//! dw/dv = c dT/dv - cosh T             dw/dt = c dT/dt + c - C cosh T + v sinh T
//! ```
//!
//! Short flights last as long and land as fast a little later, so that those by time are next to nothing, and these formulas cancel. But they are also
//! `-j (cosh T - 1)/w` and `j sinh T - j c (cosh T - 1)/w`, each `j` one of the slopes of the pull in the flight.

use crate::{
    directed::Directed,
    excitation::{Excitation, HalfPhase},
    flight::{From, Outcome, Takeoff},
    functions::sinh_cosh,
    ground::Ground,
    interval::Interval,
    piece::Motion,
    pull::Side,
    scene::{Flown, Scene},
};

/// Something of time and something of speed; or of one side of a parallelogram and of the other.
type Pair<F> = [Interval<F>; 2];
/// Its rows.
type Matrix<F> = [Pair<F>; 2];

/// The states after an impact.
pub struct Parallelogram<F> {
    /// When the point is, and its speed away from the base: single numbers, but for the rounding of sums.
    time: Interval<F>,
    phase: HalfPhase<F>,
    speed: Interval<F>,
    /// The units of time and of speed.
    units: [f64; 2],
    /// The direction of the first side in these units, of length 1 but for rounding; the second is at a right angle to it.
    direction: [f64; 2],
    /// How far the states reach along each side.
    reach: Pair<F>,
    /// How far beside the point they are therefore, in time and in speed.
    beside: Pair<F>,
}

/// What is common to the flights of all states, in doubles.
struct Together {
    interval: Interval<f64>,
    takeoff_speed: Interval<f64>,
    landing_speed: Interval<f64>,
    takeoff_pull: Interval<f64>,
    landing_pull: Interval<f64>,
    /// Every slope of the pull on the way.
    slope: Interval<f64>,
}

impl<F: Directed> Parallelogram<F> {
    /// After the flight from initiation, which starts in a single state.
    pub fn first(scene: &Scene<'_, F>, interval: &Interval<F>, landing_speed: &Interval<F>) -> Self {
        let zero = Interval::zero;
        let initiation = Self {
            time: zero(),
            phase: HalfPhase::start(),
            speed: zero(),
            units: [0.0, 0.0],
            direction: [1.0, 0.0],
            reach: [zero(), zero()],
            beside: [zero(), zero()],
        };
        initiation.landed(scene, interval, landing_speed, [[0.0; 2]; 2].map(|row| row.map(Interval::exactly)))
    }

    /// Every time.
    pub fn time(&self) -> Interval<F> {
        let [later, _] = &self.beside;
        &self.time + later
    }

    /// Every phase.
    pub fn phase(&self, scene: &Scene<'_, F>) -> HalfPhase<F> {
        let [later, _] = &self.beside;
        scene.excitation.later(&self.phase, later)
    }

    /// Every speed away from the base.
    pub fn speed(&self) -> Interval<F> {
        let [_, faster] = &self.beside;
        &self.speed + faster
    }

    /// The next flight of all states, on `side`, looked at for `horizon`.
    pub fn fly(&self, scene: &Scene<'_, F>, side: Side, horizon: &Interval<F>) -> Flown<F, Self> {
        let together = match self.together(scene, side, horizon) {
            Ok(together) => together,
            Err(otherwise) => return otherwise,
        };
        let from = From::Impact(self.speed.clone());
        let takeoff = Takeoff { moment: self.phase.clone(), side, from, horizon: horizon.clone() };
        let Outcome::Landing { interval, speed, .. } = scene.motion.fly(scene.excitation, takeoff) else {
            return Flown::Unclear;
        };
        let derivatives = together.derivatives();
        let [later, faster] = &self.beside;
        let [[by_time, by_speed], _] = convert(&derivatives);
        let every = &interval + &(&(&by_time * later) + &(&by_speed * faster));
        let states = self.landed(scene, &interval, &speed, derivatives);
        Flown::Landed(every.and(&together.interval.convert()), states)
    }

    /// The flights of all states as one, with the speed and the phase as intervals: in doubles, or with all digits where doubles can't tell.
    fn together(&self, scene: &Scene<'_, F>, side: Side, horizon: &Interval<F>) -> Result<Together, Flown<F, Self>> {
        let (phase, speed) = (self.phase(scene), self.speed());
        let [later, _] = &self.beside;
        let coarse_phase = scene.coarse_excitation.later(&self.phase.convert(), &later.convert());
        let coarse = (coarse_phase, speed.convert(), horizon.convert());
        match together(&scene.coarse_motion, &scene.coarse_excitation, side, coarse) {
            Err(Flown::Unclear) => together(scene.motion, scene.excitation, side, (phase, speed, horizon.clone())),
            clear => clear,
        }
    }

    /// The states after a flight in which the point landed so, from its derivatives by time and by speed.
    fn landed(
        &self,
        scene: &Scene<'_, F>,
        interval: &Interval<F>,
        landing_speed: &Interval<F>,
        derivatives: Matrix<f64>,
    ) -> Self {
        let every_speed = &Interval::exactly(scene.eta) * landing_speed;
        let (lasted, speed) = (interval.centre(), every_speed.centre());
        let units = [lasted.middle(), speed.middle()];
        let [time_unit, speed_unit] = units.map(Interval::exactly);
        let off = [&(interval - &lasted) / &time_unit, &(&every_speed - &speed) / &speed_unit];

        let [[longer_by_time, longer_by_speed], faster] = derivatives;
        let eta = Interval::exactly(scene.eta);
        let [faster_by_time, faster_by_speed] = faster.map(|by| &eta * &by);
        let moved = [[&Interval::exactly(1.0) + &longer_by_time, longer_by_speed], [faster_by_time, faster_by_speed]];
        // In the units, from the sides of before; in this order nothing is the product of what is tiny.
        let [[to_time, to_speed], [of_time, of_speed]] = [units, self.units].map(|pair| pair.map(Interval::exactly));
        let [times, speeds] = moved;
        let moved = [times.map(|by| &by / &to_time), speeds.map(|by| &by / &to_speed)];
        let moved = moved.map(|[by_time, by_speed]| [&by_time * &of_time, &by_speed * &of_speed]);
        let from = product(&moved, &along(self.direction));
        let direction = longest(&from, &self.reach);
        let back = against(direction);
        let [one, other] = apply(&convert(&product(&back, &from)), &self.reach);
        let [one_off, other_off] = apply(&convert(&back), &off);
        let reach = [&one + &one_off, &other + &other_off];
        let beside = beside(units, direction, &reach);
        Self {
            time: &self.time + &lasted,
            phase: scene.excitation.later(&self.phase, &lasted),
            speed,
            units,
            direction,
            reach,
            beside,
        }
    }
}

/// The flights from all these phases with all these speeds.
fn together<F, K, G: Directed>(
    motion: &Motion<G>,
    excitation: &Excitation<G>,
    side: Side,
    (phase, speed, horizon): (HalfPhase<G>, Interval<G>, Interval<G>),
) -> Result<Together, Flown<F, K>> {
    let takeoff = Takeoff { moment: phase.clone(), side, from: From::Impact(speed.clone()), horizon };
    let (interval, landing_speed, landing) = match motion.fly(excitation, takeoff) {
        Outcome::Landing { interval, speed, moment } => (interval, speed, moment),
        Outcome::Aloft => return Err(Flown::Aloft),
        Outcome::Overturned => return Err(Flown::Overturned),
        Outcome::Unclear => return Err(Flown::Unclear),
    };
    let pull = excitation.pull(&phase, side);
    let Some(window) = excitation.window(&phase, side, &pull, &interval) else { return Err(Flown::Unclear) };
    Ok(Together {
        interval: interval.convert(),
        takeoff_speed: speed.convert(),
        landing_speed: landing_speed.convert(),
        takeoff_pull: pull.value.convert(),
        landing_pull: excitation.pull(&landing, side).value.convert(),
        slope: window.slope.convert(),
    })
}

impl Together {
    /// Those of how long a flight lasts and of the speed it lands with, each by time and by speed.
    fn derivatives(&self) -> Matrix<f64> {
        let Self { interval, takeoff_speed: v, landing_speed: w, takeoff_pull, landing_pull, slope } = self;
        let (sinh, cosh) = sinh_cosh(interval);
        let longer_by_speed = &sinh / w;
        let faster_by_speed = &(landing_pull * &longer_by_speed) - &cosh;
        // (cosh T - 1)/w, which has no square of what is tiny.
        let risen = &longer_by_speed * &(&sinh / &(&cosh + &Interval::exactly(1.0)));
        let longer_by_time = (&(&(takeoff_pull * &sinh) - &(&(v * &cosh) + w)) / w).and(&-&(slope * &risen));
        let gained = &(&(landing_pull * &longer_by_time) + landing_pull) - &(&(takeoff_pull * &cosh) - &(v * &sinh));
        let faster_by_time = gained.and(&(&(slope * &sinh) - &(slope * &(landing_pull * &risen))));
        [[longer_by_time, longer_by_speed], [faster_by_time, faster_by_speed]]
    }
}

/// How far beside its point a parallelogram reaches.
fn beside<F: Directed>(units: [f64; 2], direction: [f64; 2], reach: &Pair<F>) -> Pair<F> {
    let [later, faster] = apply(&convert(&along(direction)), reach);
    let [time, speed] = units.map(Interval::exactly);
    [&time * &later, &speed * &faster]
}

/// From the sides of a parallelogram to its units.
fn along([cosine, sine]: [f64; 2]) -> Matrix<f64> {
    [[cosine, -sine], [sine, cosine]].map(|row| row.map(Interval::exactly))
}

/// The inverse of that.
fn against([cosine, sine]: [f64; 2]) -> Matrix<f64> {
    let [c, s] = [cosine, sine].map(Interval::<f64>::exactly);
    let square = &c.squared() + &s.squared();
    let (c, s) = (&c / &square, &s / &square);
    [[c.clone(), s.clone()], [-&s, c]]
}

/// The direction of the longer of two sides of a parallelogram that reaches so far along each; that of time, if there is none.
fn longest<F: Directed>([times, speeds]: &Matrix<f64>, reach: &Pair<F>) -> [f64; 2] {
    let [[time, other_time], [speed, other_speed]] = [times, speeds].map(|row| row.each_ref().map(Interval::middle));
    let [one, other] = reach.each_ref().map(Interval::width);
    let longer = if one * time.hypot(speed) >= other * other_time.hypot(other_speed) {
        (time, speed)
    } else {
        (other_time, other_speed)
    };
    let length = longer.0.hypot(longer.1);
    if length.is_normal() { [longer.0 / length, longer.1 / length] } else { [1.0, 0.0] }
}

fn apply<F: Directed>(matrix: &Matrix<F>, [one, other]: &Pair<F>) -> Pair<F> {
    matrix.each_ref().map(|[a, b]| &(a * one) + &(b * other))
}

fn product<F: Directed>(left: &Matrix<F>, [[a, b], [c, d]]: &Matrix<F>) -> Matrix<F> {
    left.each_ref().map(|[x, y]| [&(x * a) + &(y * c), &(x * b) + &(y * d)])
}

fn convert<F: Directed>(matrix: &Matrix<f64>) -> Matrix<F> {
    matrix.each_ref().map(|row| row.each_ref().map(Interval::convert))
}

#[cfg(test)]
mod tests;
