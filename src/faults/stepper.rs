//! An event stepper for Eq. 4 that can be told to make mistakes. Without one it is an honest method: it passes the gate in the place of the
//! closed form, with the same claims up to a factor that `tests/gate/detection_floor.rs` relies on.
//!
//! A flight is followed in local time `s` as the distance from the base, `u = i φ`, by its Taylor series: with `g = -1 - i f`, Eq. 4 is
//! `u'' = κ u + g`, `κ = 1`, so each derivative follows from the last but one. The printed solution, Eq. 6, is the same function:
//! a fault `ΔA`, `ΔB` in the coefficients of Eq. 10 adds `ΔA e^-s + ΔB e^s` to `φ`, which is to start with `Δφ = ΔA + ΔB` and
//! `Δφ' = ΔB - ΔA`.

mod flight;
mod forcing;

use contract::{Case, Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};

use crate::measure::{clock::Sum, excitation::half_period};
use flight::{Flight, Landfall};
use forcing::Excitation;

/// The stepper's claims, in those of the closed form. It rounds a little more often.
const CLAIMED: f64 = 2.0;

/// What is wrong with the stepper. All zero is nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrong {
    /// Shares lost of the terms of `A_n` (Eq. 10).
    pub a: Terms,
    /// Shares lost of the terms of `B_n` (Eq. 10).
    pub b: Terms,
    /// Share lost of the particular solution (Eq. 8); 2 turns its sign.
    pub forcing: f64,
    /// Half of what is subtracted from `ω² + 1` in Eq. 8; 1 makes it `ω² - 1`.
    pub denominator: f64,
    /// Share lost of what the forcing changes by during a flight.
    pub change: f64,
    /// Share lost of `φ` in Eq. 4.
    pub stiffness: f64,
    /// Share lost of `ε²` in `a cos ψ = sqrt(2ε + ε²)` (Eq. 24).
    pub square: f64,
    /// Half the share lost of `a cos ψ`; 1 turns its sign: the other quadrant.
    pub quadrant: f64,
    /// How much later the shaking is than the clock, in `τ`.
    pub origin: f64,
    /// How much of the last flight the forcing lags behind; 1 is the forcing at the previous impact.
    pub stale: f64,
    /// How far off the base each flight starts, in `φ`.
    pub lift: f64,
    /// How late each impact is noticed, in `τ`.
    pub late: f64,
    /// How late each impact is noticed, as a share of the flight.
    pub slack: f64,
    /// Share by which the landing speed is taken for the speed of departure, as if Eq. 68 were exact.
    pub bounce: f64,
    /// Share of the exponent of `η` that is missing at every second impact (Eq. 13).
    pub spared: f64,
    /// Whether a rotation beyond `|φ| = 1` counts as overturned.
    pub brittle: bool,
}

/// Shares lost of the three terms of a coefficient of Eq. 10.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Terms {
    /// Of `Ξ`.
    pub forcing: f64,
    /// Of `Ξ'`.
    pub rate: f64,
    /// Of `i`.
    pub side: f64,
}

/// The history by a stepper with what is `wrong`; its claims are those of the `honest` closed form.
pub fn history(case: &Case, wrong: &Wrong, honest: &History) -> History {
    if case.epsilon() <= 0.0 {
        return History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None };
    }
    let (impacts, ending) = follow(case, wrong, honest);
    History { impacts, ending, chattering_time: None }
}

fn follow(case: &Case, wrong: &Wrong, honest: &History) -> (Vec<Impact>, Ending) {
    let excitation = Excitation::new(case, wrong);
    let (horizon, beyond) = match case.horizon() {
        Horizon::HalfPeriod => (half_period(case.omega()), Ending::Incomplete),
        Horizon::Until(time) => (time, Ending::LimitReached(Limit::Time)),
    };
    let mut impacts: Vec<Impact> = Vec::new();
    let mut time = Sum::default();
    let mut speed = Sum::default();
    let mut side = -1.0;
    let mut last = 0.0;
    let mut resting = false;
    loop {
        let phase_time = time.plus(wrong.origin - wrong.stale * last);
        let flight = Flight { excitation: &excitation, wrong, side, time: phase_time, speed: speed.value() };
        let landing = match flight.land(horizon - time.value()) {
            Landfall::Landing(landing) => landing,
            Landfall::Aloft => return (impacts, beyond),
            Landfall::Overturned => return (impacts, Ending::Overturned),
            Landfall::FellThrough => return (impacts, Ending::Lost(Loss::FellThrough)),
        };
        time = time.plus(landing.interval);
        if time.value() >= horizon || (case.horizon() == Horizon::HalfPeriod && excitation.half(time).1 <= 0.0) {
            return (impacts, beyond);
        }
        let eta = if side > 0.0 { case.eta().powf(1.0 - wrong.spared) } else { case.eta() };
        let landed = landing.speed(speed);
        let bounced = landed.plus(wrong.bounce * (speed.value() - landed.value()));
        speed = bounced.times(eta);
        side = -side;
        last = landing.interval;
        let (now, departure) = (time.value(), speed.value());
        if !(last > 0.0 && departure > 0.0 && now.is_finite() && departure.is_finite()) {
            return (impacts, Ending::Lost(Loss::NotFinite));
        }
        let claimed = honest.impacts.get(impacts.len()).or(honest.impacts.last());
        let uncertainty = claimed.map_or(Uncertainty { time: 1e-15, interval: 1e-15, velocity: 1e-15 }, |honest| {
            let Uncertainty { time, interval, velocity } = honest.uncertainty;
            Uncertainty { time: CLAIMED * time, interval: CLAIMED * interval, velocity: CLAIMED * velocity }
        });
        impacts.push(Impact { time: now, interval: last, velocity: side * departure, uncertainty });
        resting = resting || excitation.holds_down(time, departure, case.eta());
        if impacts.len() >= case.max_impacts() || departure < 1e-280 {
            return (impacts, if resting { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) });
        }
    }
}
