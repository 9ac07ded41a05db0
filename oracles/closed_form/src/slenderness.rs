//! What the linear model leaves out: how each impact moves with `μ = 2(1/cos α - 1)`, to the third power, along the linear solution.
//!
//! `μ = α² + 5α⁴/12 + ...`, so to first order it is `α²`. It is the parameter in which the equation is simplest where the excitation is weak and the
//! rotation small: there the block is stiffer by `1/cos α = 1 + μ/2`.
//!
//! The impacts at `μ = 0` are those that the oracle found. Between them the nonlinear equation is solved by a Taylor series in local time, all of
//! whose coefficients are power series in `μ` (see [`series`]). Its start is the last impact, whose time and speed are power series as well; the
//! impact at its end is where the series in time vanishes. So `μ⁰` is the closed form, `μ¹` the perturbation of Eq. 2 about it,
//! `u₁'' = u₁ - (1/2 + i f) u₀ + (1 + i f) u₀²/2 - u₀³/6`, and the other powers are what that leaves out in turn.

mod jet;
mod series;

use contract::SlendernessShift;

use crate::{forcing::Forcing, sequence::Follower, takeoff::Takeoff};
use jet::Jet;
use series::{Units, evaluate, expand};

/// How many coefficients of `G` are used for a stretch `T` with `max(1, ω) T` up to 1, and up to a smaller one. The first of `w³/6`, whose frequencies are
/// three times those of `w`, that is left out is of the order `(3 max(1, ω) T)^n/n!`.
const TERMS: usize = 24;
const FEW: (usize, f64) = (10, 0.03);

/// Follows the impacts of one case.
pub(crate) struct Shifts {
    omega: f64,
    /// By how much the last impact moved, in `τ`: its value is 0.
    time: Jet,
    /// The speed after it, in multiples of that of the linear model: its value is 1.
    speed: Jet,
    /// What was found so far.
    pub found: Vec<SlendernessShift>,
}

impl Shifts {
    /// At initiation, which is at the threshold of every block.
    pub fn new(omega: f64) -> Self {
        Self { omega, time: Jet::ZERO, speed: Jet::ONE, found: Vec::new() }
    }

    /// The coefficients of `G = 1 + i f` by the powers of time in units of `stretch`, from the forcing of the linear flight at the start. The flight
    /// itself starts later, by the shift `d`: `G^(k) + d G^(k+1) + d² G^(k+2)/2 + d³ G^(k+3)/6`.
    fn pull(&self, forcing: &Forcing, stretch: f64) -> Vec<Jet> {
        let Forcing { acceleration, jerk, snap, .. } = *forcing;
        let terms = if self.omega.max(1.0) * stretch < FEW.1 { FEW.0 } else { TERMS };
        let square = (self.time * self.time).scaled(0.5);
        let cube = (square * self.time).scaled(1.0 / 3.0);
        let mut derivatives = [-acceleration, -jerk, -snap];
        let mut power = 1.0;
        (1..=terms)
            .map(|k| {
                let [this, next, second] = derivatives;
                let third = -self.omega * self.omega * next;
                let moved = Jet::ONE.scaled(this) + self.time.scaled(next) + square.scaled(second) + cube.scaled(third);
                let coefficient = moved.scaled(power);
                derivatives = [next, second, third];
                power *= stretch / k as f64;
                coefficient
            })
            .collect()
    }
}

impl Follower for Shifts {
    #[cold]
    #[inline(never)]
    fn land(&mut self, takeoff: &Takeoff, interval: f64) {
        let stretches = (interval * self.omega.max(1.0)).ceil().max(1.0);
        let stretch = interval / stretches;
        let at_rest = takeoff.speed == 0.0;
        let velocity = if at_rest { takeoff.forcing.jerk * interval * interval } else { takeoff.speed };
        let units = Units { time: stretch, velocity };
        let mut state = (Jet::ZERO, if at_rest { Jet::ZERO } else { self.speed });
        let mut flight = expand(units, state, &self.pull(&takeoff.forcing, stretch));
        let mut elapsed = stretch;
        while elapsed + 0.5 * stretch < interval {
            state = evaluate(&flight, Jet::ONE);
            let half = takeoff.excitation.half_phase(takeoff.time.plus(elapsed));
            let here = takeoff.excitation.forcing(takeoff.sign, half);
            flight = expand(units, state, &self.pull(&here, stretch));
            elapsed += stretch;
        }
        // The root at the start of a flight of one stretch is divided out.
        let deflated = flight.get(if stretches == 1.0 { 1.. } else { 0.. }).unwrap_or_default();
        let (_, slope) = evaluate(deflated, Jet::ONE);
        let mut impact = Jet::ONE;
        // Each step gains a power of μ. At μ = 0 the impact is known.
        for _ in 0..Jet::ORDER {
            let (left, _) = evaluate(deflated, impact);
            impact = impact - left.shift().scaled(1.0 / slope.value());
        }
        let (_, landing) = evaluate(&flight, impact);
        self.time = self.time + impact.shift().scaled(stretch);
        self.speed = landing.scaled(1.0 / landing.value());
        self.found.push(SlendernessShift {
            time: self.time.shifts(),
            interval: impact.scaled(1.0 / stretches).shifts(),
            velocity: self.speed.shifts(),
        });
    }
}
