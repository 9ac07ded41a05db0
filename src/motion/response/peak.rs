//! The largest rotation of a response.

use contract::{Arrival, FlightSolver};

use super::{Flight, Response};

/// The largest rotation, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// When, `τ` since the start of the motion.
    pub time: f64,
    /// `φ`, with its sign.
    pub rotation: f64,
}

/// In how many parts a flight is looked at.
const PARTS: u32 = 16;

impl Response {
    /// The largest rotation while the block rocks, on whichever side, by the solver that the response is of; `None` if it never rocks. One that lies on its side
    /// in the end has turned as far as that.
    pub(super) fn peak_by(&self, solver: &dyn FlightSolver) -> Option<Peak> {
        let mut largest: Option<Peak> = None;
        for bout in &self.bouts {
            let solver = self.ground.seen(solver, bout.lobe);
            for flight in bout.flights.iter() {
                let (s, rotation) = highest(&solver, flight);
                if largest.is_none_or(|largest| rotation > largest.rotation.abs()) {
                    let side = bout.lobe.mirror * flight.departure.side;
                    largest = Some(Peak { time: bout.lobe.start + flight.start + s, rotation: side * rotation });
                }
            }
        }
        match self.lying {
            Some(rotation) => Some(Peak { time: self.end, rotation }),
            None => largest,
        }
    }
}

/// When in a flight the rotation is largest, and how large.
fn highest(solver: &dyn FlightSolver, flight: &Flight) -> (f64, f64) {
    let at = |s: f64| solver.motion(&flight.departure, s);
    let mut best = (0.0, flight.departure.rotation);
    let mut before = (0.0, flight.departure.velocity);
    for part in 1..=PARTS {
        let s = flight.duration * f64::from(part) / f64::from(PARTS);
        let lands = part == PARTS && matches!(flight.arrival, Arrival::Impact { .. });
        let (rotation, velocity) = if lands { (0.0, -1.0) } else { at(s) };
        if rotation > best.1 {
            best = (s, rotation);
        }
        if before.1 >= 0.0 && velocity < 0.0 {
            // The top is between: where the velocity changes its sign.
            let (mut low, mut high) = (before.0, s);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if at(middle).1 > 0.0 { low = middle } else { high = middle }
            }
            let top = at(low).0;
            if top > best.1 {
                best = (low, top);
            }
        }
        before = (s, velocity);
    }
    best
}
