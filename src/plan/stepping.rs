//! Flights one after another, no more of them than the sum needs to be closed as well as asked.

use contract::{Arrival, Case, Ending, Estimate, FlightSolver, History, Impact, Uncertainty};

use crate::{
    measure::{excitation::half_period, zeno},
    motion::walk::Walk,
};

/// The fewest impacts that a sum is closed from.
const FEWEST: usize = 8;
/// How many more are made before it is tried again: it takes about as long as that.
const STEP: usize = 4;
/// Where there are many, a share of them.
const SHARE: usize = 16;
/// With hardly any damping it takes tens of thousands.
const MOST: usize = 200_000;
/// What a flight leaves of rounding in its interval, relative.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What stepping found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Found {
    /// Complete chattering, with the chattering time and what is expected to be wrong with it, absolute; and the impacts that it took.
    Complete(Estimate, usize),
    /// The block still rocks at `T/2`.
    Incomplete(usize),
    /// It has overturned before.
    Overturned(usize),
    /// The limit of impacts came first, or a flight was lost.
    Undecided,
}

/// Steps from the threshold until the sum can be closed to the relative error `accuracy`. Unless it is known that the chattering is complete, rest has to be
/// proven too.
pub fn step(solver: &dyn FlightSolver, case: &Case, accuracy: f64, known_complete: bool) -> Found {
    let half_period = half_period(case.omega());
    let mut walk = Walk::from_rest(solver, case.eta(), 0.0, f64::INFINITY, half_period);
    let mut history = History { impacts: Vec::with_capacity(64), ending: Ending::AtRest, chattering_time: None };
    let mut next = FEWEST;
    while history.impacts.len() < MOST {
        let interval = match walk.fly().map(|flight| flight.arrival) {
            Some(Arrival::Impact { interval, .. }) => interval,
            Some(Arrival::Aloft { .. }) | None => return Found::Incomplete(history.impacts.len()),
            Some(Arrival::Overturned { .. }) => return Found::Overturned(history.impacts.len()),
            Some(Arrival::Lost(_)) => break,
        };
        let (time, departure) = (walk.now(), walk.departure());
        let uncertainty = Uncertainty { time: f64::EPSILON * time, interval: ROUNDING, velocity: ROUNDING };
        history.impacts.push(Impact { time, interval, velocity: departure.side * departure.velocity, uncertainty });
        let count = history.impacts.len();
        if count < next || !(known_complete || solver.rests(&departure)) {
            continue;
        }
        next = count + STEP.max(count / SHARE);
        if let Some(sum) = zeno::close(&history, case.eta()).filter(|sum| sum.uncertainty <= accuracy * sum.value) {
            return Found::Complete(sum, count);
        }
        // Deeper there is nothing that a sum could use.
        if interval < 1e-14 * accuracy * time {
            break;
        }
    }
    Found::Undecided
}
