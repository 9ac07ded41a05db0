//! A response as rows: densely enough to look right at the size of a window, and not more densely.

use contract::{Arrival, Decline, FlightSolver, Oracle};
use serde::Serialize;

use super::{Bout, Flight, Request, Response};

/// A part of a response, and how many rows it is to have about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// From when, `τ`.
    pub from: f64,
    /// Until when, `τ`.
    pub to: f64,
    /// Into how many steps it is divided. A flight much shorter than a step is left out, one of its length has some rows of its own: the file is a few
    /// times as long as this at the most.
    pub steps: usize,
}

/// One row of a response. At an impact there are two: just before and just after it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Sample {
    /// The time since the start of the motion.
    pub tau: f64,
    /// The rotation.
    pub phi: f64,
    /// Its velocity.
    pub phi_velocity: f64,
    /// In multiples of the acceleration at which this block of this model begins to rock; 0 once the motion is over.
    pub ground_acceleration: f64,
    /// What the block does.
    pub state: State,
}

/// What the block does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// It stands still on its base.
    Rest,
    /// It rocks.
    Rocking,
    /// It can't return any more.
    Overturned,
}

/// A flight of at least this many steps has rows of its own.
const LEAST_STEPS: f64 = 0.25;
/// The fewest parts that such a flight is divided into.
const LEAST_PARTS: f64 = 8.0;

impl Response {
    /// The rows of a window.
    ///
    /// # Errors
    /// When `oracle`, which the response is of, declines the case.
    pub fn samples(&self, oracle: &dyn Oracle, request: &Request, window: &Window) -> Result<Vec<Sample>, Decline> {
        let mut rows = Rows { response: self, window: *window, rows: Vec::new() };
        if self.bouts.is_empty() {
            rows.rest(0.0, self.end);
            return Ok(rows.rows);
        }
        let solver = oracle.flights(&request.case)?;
        let mut now = 0.0;
        for bout in &self.bouts {
            rows.rest(now, bout.begin());
            rows.bout(bout, solver.as_ref());
            now = bout.end();
        }
        if self.bouts.last().is_some_and(|bout| bout.outcome.is_rest()) {
            rows.rest(now, self.end);
            // It may come to rest just as the response ends.
            if rows.inside(now, now).is_some() && now >= self.end {
                rows.push(now, 0.0, 0.0, State::Rest);
            }
        }
        Ok(rows.rows)
    }
}

struct Rows<'a> {
    response: &'a Response,
    window: Window,
    rows: Vec<Sample>,
}

impl Rows<'_> {
    fn step(&self) -> f64 {
        ((self.window.to - self.window.from) / self.window.steps.max(1) as f64).max(f64::MIN_POSITIVE)
    }

    /// The part of a stretch that is in the window.
    fn inside(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let (from, to) = (from.max(self.window.from), to.min(self.window.to));
        (from <= to).then_some((from, to))
    }

    fn push(&mut self, tau: f64, phi: f64, phi_velocity: f64, state: State) {
        let over = self.response.lasts.is_some_and(|lasts| tau > lasts);
        let ground_acceleration = if over { 0.0 } else { self.response.lobes.acceleration(tau) };
        self.rows.push(Sample { tau, phi, phi_velocity, ground_acceleration, state });
    }

    fn rest(&mut self, from: f64, to: f64) {
        let Some((from, to)) = self.inside(from, to) else { return };
        if from == to {
            return;
        }
        let parts = ((to - from) / self.step()).ceil().max(1.0);
        let mut part = 0.0;
        while part <= parts {
            self.push(from + (to - from) * (part / parts), 0.0, 0.0, State::Rest);
            part += 1.0;
        }
    }

    fn bout(&mut self, bout: &Bout, solver: &dyn FlightSolver) {
        let mut last = f64::NEG_INFINITY;
        for flight in bout.flights.iter() {
            let begin = bout.lobe.start + flight.start;
            let Some((from, to)) = self.inside(begin, begin + flight.duration) else { continue };
            if to - last < LEAST_STEPS * self.step() && matches!(flight.arrival, Arrival::Impact { .. }) {
                continue;
            }
            last = to;
            self.flight(bout, flight, (from - begin, to - begin), solver);
        }
    }

    fn flight(&mut self, bout: &Bout, flight: &Flight, (from, to): (f64, f64), solver: &dyn FlightSolver) {
        let sign = bout.lobe.mirror * flight.departure.side;
        let begin = bout.lobe.start + flight.start;
        let parts = if to - from < LEAST_STEPS * self.step() {
            1.0
        } else {
            ((to - from) / self.step()).ceil().max(LEAST_PARTS)
        };
        let mut part = 0.0;
        while part <= parts {
            let s = from + (to - from) * (part / parts);
            let (rotation, velocity) = match flight.arrival {
                // On the base itself, to the last digit.
                Arrival::Impact { speed, .. } if s >= flight.duration => (0.0, -speed),
                _ => solver.motion(&flight.departure, s),
            };
            let state = match flight.arrival {
                Arrival::Overturned { after } if s >= after => State::Overturned,
                _ => State::Rocking,
            };
            self.push(begin + s, sign * rotation, sign * velocity, state);
            part += 1.0;
        }
    }
}
