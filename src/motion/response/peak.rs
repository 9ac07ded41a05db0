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
    /// in the end has turned as far as that. `alpha` is the slenderness, if it has one.
    pub(super) fn peak_by(&self, solver: &dyn FlightSolver, alpha: Option<f64>) -> Option<Peak> {
        let mut largest: Option<Peak> = None;
        // On either equation |φ''| <= |φ| + this.
        let pull = 1.0 + self.ground.strongest() * alpha.map_or(1.0, |alpha| alpha.tan() / alpha);
        for bout in &self.bouts {
            let solver = self.ground.seen(solver, bout.lobe);
            for flight in bout.flights.iter() {
                if largest.is_some_and(|largest| no_higher_than(flight, pull) < largest.rotation.abs()) {
                    continue;
                }
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

/// A height that a flight does not reach: `φ0 cosh T + |φ'0| sinh T + pull (cosh T - 1)`, and what rounding may take from that.
fn no_higher_than(flight: &Flight, pull: f64) -> f64 {
    let half = (0.5 * flight.duration).sinh();
    let (cosh_less_one, sinh) = (2.0 * half * half, flight.duration.sinh());
    let (rotation, speed) = (flight.departure.rotation, flight.departure.velocity.abs());
    (rotation + (rotation + pull) * cosh_less_one + speed * sinh) * (1.0 + 1e-9)
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
