//! Flights one after another, no more of them than the sum needs to be closed as well as asked.

use contract::{Arrival, Case, Departure, Ending, Estimate, FlightSolver, Ground, History, Impact, Uncertainty};

use crate::measure::zeno;

/// The fewest impacts that a sum is closed from.
const FEWEST: usize = 8;
/// How many more are made before it is tried again: it takes about as long as that.
const STEP: usize = 4;
/// More do not help.
const MOST: usize = 4000;
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
    let half_period = std::f64::consts::PI / case.omega();
    let mut departure = Departure { ground: Ground::Shaking, time: 0.0, side: -1.0, rotation: 0.0, velocity: 0.0 };
    let mut history = History { impacts: Vec::with_capacity(64), ending: Ending::AtRest, chattering_time: None };
    let mut low = 0.0;
    while history.impacts.len() < MOST {
        let left = half_period - departure.time;
        let (interval, speed) = match solver.fly(&departure, left) {
            Arrival::Impact { interval, speed } => (interval, speed),
            Arrival::Aloft { .. } => return Found::Incomplete(history.impacts.len()),
            Arrival::Overturned { .. } => return Found::Overturned(history.impacts.len()),
            Arrival::Lost(_) => break,
        };
        // Neumaier's sum: the intervals are soon far below the time.
        let high = departure.time + interval;
        low += if departure.time >= interval {
            (departure.time - high) + interval
        } else {
            (interval - high) + departure.time
        };
        let velocity = case.eta() * speed;
        departure = Departure { time: high, side: -departure.side, velocity, ..departure };
        let uncertainty = Uncertainty { time: f64::EPSILON * high, interval: ROUNDING, velocity: ROUNDING };
        history.impacts.push(Impact { time: high + low, interval, velocity: departure.side * velocity, uncertainty });
        let count = history.impacts.len();
        if count < FEWEST || !count.is_multiple_of(STEP) || !(known_complete || solver.rests(&departure)) {
            continue;
        }
        if let Some(sum) = zeno::close(&history, case.eta()).filter(|sum| sum.uncertainty <= accuracy * sum.value) {
            return Found::Complete(sum, count);
        }
        // Deeper there is nothing that a sum could use.
        if interval < 1e-14 * accuracy * high {
            break;
        }
    }
    Found::Undecided
}
