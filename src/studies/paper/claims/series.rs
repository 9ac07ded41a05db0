//! Section 3.3: the cubic of every second flight, and the chattering time by Eq. 65.

use std::f64::consts::SQRT_2;

use asymptotic::{Asymptotic, Coefficients};
use contract::{Case, Ending, Impact, Model, Oracle};

use super::{Measured, Measurement};
use crate::studies::{
    diagnose::truth::proven,
    paper::{
        Error, half_period,
        limits::{at_zero, order},
        missing,
    },
};

pub(super) const ALL: &[Measurement] = &[
    ("eq-62-velocity", orders_of_velocity),
    ("eq-62-cubic", cubic),
    ("eq-62-one-root", one_positive_root),
    ("eq-64", opposite_flights),
    ("step-3", negative_solution),
    ("eq-65-first", first_sum),
    ("eq-65-second", second_sum),
    ("eq-65", at_fig_2),
];

const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
const ETAS: [f64; 5] = [0.5, 0.7, 0.8, 0.92, 0.97];
const EPSILON: f64 = 1e-5;

/// A flight of the series to the lowest order, free of `ω` and `ε`.
pub(super) struct ScaledFlight {
    /// `ω σ_{n;1}`: when it begins.
    pub start: f64,
    /// `ω Φ_{n;3}^(1)`: the velocity that it begins with.
    pub velocity: f64,
    /// `ω T_{n;1}` of a flight with the sign of the first, `ω T_{n;3}` of the others.
    pub duration: f64,
}

/// The first flights of the series of the paper, from the oracle's answer so near to the threshold that nothing else is left.
pub(super) fn scaled_flights(eta: f64, flights: usize) -> Result<Vec<ScaledFlight>, Error> {
    const EPSILON: f64 = 1e-20;
    let series = Asymptotic::new();
    let case = Case::from_epsilon(EPSILON, OMEGA, eta)?.with_max_impacts(flights)?;
    let impacts = series.history(&case)?.impacts;
    let at_rest = (0.0, 0.0);
    let starts = std::iter::once(at_rest).chain(impacts.iter().map(|impact| (impact.time, impact.velocity)));
    let first = OMEGA / EPSILON.sqrt();
    let scaled = starts.zip(&impacts).enumerate().map(|(n, ((time, velocity), impact))| ScaledFlight {
        start: time * first,
        velocity: velocity * first / EPSILON,
        duration: impact.interval * if n % 2 == 0 { first } else { first / EPSILON },
    });
    Ok(scaled.collect())
}

/// Impact `n`, proven.
fn impact(epsilon: f64, n: usize) -> Result<Impact, Error> {
    let case = Case::from_epsilon(epsilon, OMEGA, ETA)?.with_max_impacts(n)?;
    let history = enclosure::Enclosure::new(Model::Linear).history(&case)?;
    history.impacts.get(n.wrapping_sub(1)).copied().ok_or_else(|| missing(format!("impact {n}")))
}

fn orders_of_velocity() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for n in [1, 2, 9, 10, 39, 40] {
        let power = at_zero(|step| order(|epsilon| Ok(impact(epsilon, n)?.velocity), step), 1e-4)?;
        worst = worst.max((power - 1.5).abs());
    }
    Ok(Measured::to_digits(worst, 5, "proven velocities after impacts 1 to 40 fall as ε^(3/2)"))
}

fn cubic() -> Result<Measured, Error> {
    let flights = scaled_flights(ETA, 41)?;
    let mut worst: f64 = 0.0;
    for n in [0, 2, 4, 10, 20, 40] {
        let exact = at_zero(|epsilon| Ok(impact(epsilon, n + 1)?.interval * OMEGA / epsilon.sqrt()), EPSILON)?;
        let printed = flights.get(n).map_or(f64::NAN, |flight| flight.duration);
        worst = worst.max((printed / exact - 1.0).abs());
    }
    Ok(Measured::to_digits(worst, 7, "proven intervals up to flight 40 tend to its root"))
}

/// The cubic of Eq. 62 for an even flight, times `ω`, from the highest power down: with Eqs 51 and 60 there is no `ω` left in it.
fn coefficients(flight: &ScaledFlight) -> [f64; 4] {
    let x = flight.start;
    [1.0 / 24.0, (x - SQRT_2) / 6.0, x * (x - 2.0 * SQRT_2) / 4.0, flight.velocity]
}

/// The even flights after the first, so many for each restitution, as the series goes on.
fn even_flights(each: usize) -> Result<Vec<ScaledFlight>, Error> {
    let mut even = Vec::new();
    for eta in ETAS {
        even.extend(scaled_flights(eta, 2 * each)?.into_iter().step_by(2).skip(1));
    }
    Ok(even)
}

fn one_positive_root() -> Result<Measured, Error> {
    let flights = even_flights(300)?;
    let changes = |flight: &&ScaledFlight| {
        let signs: Vec<bool> = coefficients(flight).into_iter().filter(|c| *c != 0.0).map(|c| c > 0.0).collect();
        signs.windows(2).filter(|two| two.first() != two.last()).count()
    };
    let others = flights.iter().filter(|flight| changes(flight) != 1).count();
    let found = format!(
        "its coefficients change their sign once (Descartes), whatever ω σ_{{n;1}} is; so in all of {} flights with η from 0.5 to 0.97",
        flights.len()
    );
    Ok(Measured::new(others as f64, found))
}

fn negative_solution() -> Result<Measured, Error> {
    let flights = even_flights(300)?;
    let positive = flights.iter().filter(|flight| flight.duration > 0.0 && flight.velocity < 0.0).count();
    let shortest = flights.iter().map(|flight| flight.duration).fold(f64::INFINITY, f64::min);
    let found = format!(
        "never: positive in {positive} of {} flights, down to 10^{:.0}, and for ever, as the velocity that it begins with keeps its sign; \
         a program that waits for it waits for a rounding error",
        flights.len(),
        shortest.log10()
    );
    Ok(Measured::new(positive as f64, found))
}

fn opposite_flights() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for n in [1, 3, 9, 39] {
        // -Φ_{n;3}/Φ_{n;0}^(2) with Φ_{n;0}^(2) = i_0: the interval over the velocity that it begins with.
        let ratio = |epsilon: f64| Ok(impact(epsilon, n + 1)?.interval / impact(epsilon, n)?.velocity);
        worst = worst.max((at_zero(ratio, EPSILON)? - 1.0).abs());
    }
    Ok(Measured::to_digits(worst, 6, "proven intervals of flights 1 to 39 are of order ε^(3/2), with this coefficient"))
}

fn sums(eta: f64) -> Result<Coefficients, Error> {
    asymptotic::coefficients(eta).ok_or_else(|| missing(format!("the sums of Eq. 65 at eta = {eta}")))
}

/// `ω τ_ch/ε^(1/2)`, proven.
fn scaled_chattering_time(epsilon: f64, eta: f64) -> Result<f64, Error> {
    let time = proven(epsilon, OMEGA, eta).ok_or_else(|| missing(format!("tau_ch at epsilon = {epsilon}")))?;
    Ok(time * OMEGA / epsilon.sqrt())
}

fn first_sum() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for eta in ETAS {
        let exact = at_zero(|epsilon| scaled_chattering_time(epsilon, eta), 1e-6)?;
        worst = worst.max((sums(eta)?.x / exact - 1.0).abs());
    }
    let found = format!("proven ω τ_ch/ε^(1/2) tends to it for η from 0.5 to 0.97 ({:.7} at η = 0.92)", sums(ETA)?.x);
    Ok(Measured::to_digits(worst, 8, &found))
}

fn second_sum() -> Result<Measured, Error> {
    let exact = |eta: f64| {
        let first = sums(eta)?.x;
        at_zero(|epsilon| Ok((scaled_chattering_time(epsilon, eta)? - first) / epsilon), EPSILON)
    };
    let (printed, consistent) = (sums(ETA)?.u, exact(ETA)?);
    let found = format!(
        "at η = 0.92, ω = 2 the ε^(3/2) of ω τ_ch has {consistent:.4}, the second sum is {printed:.4}: the T_{{n;3}} of the other flights, \
         of the same order, are dropped"
    );
    Ok(Measured::new((printed / consistent - 1.0).abs(), found))
}

fn at_fig_2() -> Result<Measured, Error> {
    let epsilon = 1.03 - 1.0;
    let case = Case::from_epsilon(epsilon, OMEGA, ETA)?.with_max_impacts(80)?;
    let enclosed = enclosure::Enclosure::new(Model::Linear).enclose(&case)?;
    let exact = enclosed.chattering_time.filter(|_| enclosed.ending == Ending::AtRest);
    let exact = exact.ok_or_else(|| missing("tau_ch of Fig. 2"))?.middle().0;
    let printed = sums(ETA)?.chattering_time(epsilon, OMEGA);
    let share = |time: f64| time / half_period(OMEGA);
    let found = format!("τ_ch/(T/2) of Fig. 2 is {:.5}, by Eq. 65 {:.5}", share(exact), share(printed));
    Ok(Measured::new((printed / exact - 1.0).abs(), found))
}
