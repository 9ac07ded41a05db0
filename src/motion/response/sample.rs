//! A response as rows: densely enough to look right at the size of a window, and not more densely.

use contract::{Arrival, Decline, FlightSolver, Ground, Oracle};
use serde::Serialize;

use super::{Bout, Flight, OnMotion, Request, Response};

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

/// One row of a response. Time never decreases from one to the next. At an impact, and where the ground stops, there are two of the same time: just before
/// and just after it.
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
    /// It lies on its side, at rest: the end of the response.
    Lying,
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
        self.rows(window, || oracle.flights(&request.case))
    }

    /// The rows of a window of a response to another motion than a sinusoid.
    ///
    /// # Errors
    /// When `oracle`, which the response is of, declines it.
    pub fn samples_on_motion(
        &self,
        oracle: &dyn Oracle,
        request: &OnMotion,
        window: &Window,
    ) -> Result<Vec<Sample>, Decline> {
        self.rows(window, || oracle.flights_on(&request.body, &request.motion))
    }

    fn rows(
        &self,
        window: &Window,
        solver: impl FnOnce() -> Result<Box<dyn FlightSolver>, Decline>,
    ) -> Result<Vec<Sample>, Decline> {
        let mut rows = Rows { response: self, window: *window, rows: Vec::new() };
        if self.bouts.is_empty() {
            rows.rest(0.0, self.end);
            return Ok(rows.rows);
        }
        let solver = solver()?;
        let mut now = 0.0;
        for bout in &self.bouts {
            rows.rest(now, bout.begin());
            rows.bout(bout, &self.ground.seen(solver.as_ref(), bout.lobe));
            now = bout.end();
        }
        if self.bouts.last().is_some_and(|bout| bout.outcome.is_rest()) {
            rows.rest(now, self.end);
            // It may come to rest just as the response ends.
            if rows.inside(now, now).is_some() && now >= self.end {
                rows.push(now, self.ground_at(now), (0.0, 0.0), State::Rest);
            }
        }
        if let Some(rotation) = self.lying.filter(|_| rows.inside(now, now).is_some()) {
            rows.push(now, self.ground_at(now), (rotation, 0.0), State::Lying);
        }
        Ok(rows.rows)
    }

    /// What the ground does at `tau`.
    fn ground_at(&self, tau: f64) -> Ground {
        if self.lasts.is_some_and(|lasts| tau > lasts) { Ground::Still } else { Ground::Shaking }
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

    fn push(&mut self, tau: f64, ground: Ground, (phi, phi_velocity): (f64, f64), state: State) {
        let ground_acceleration = match ground {
            Ground::Shaking => self.response.ground.acceleration(tau),
            Ground::Still => 0.0,
        };
        self.rows.push(Sample { tau, phi, phi_velocity, ground_acceleration, state });
    }

    fn rest(&mut self, from: f64, to: f64) {
        let Some((from, to)) = self.inside(from, to) else { return };
        if from == to {
            return;
        }
        let parts = ((to - from) / self.step()).ceil().max(1.0);
        let ground = self.response.ground_at(0.5 * (from + to));
        for tau in steps((from, to), parts) {
            self.push(tau, ground, (0.0, 0.0), State::Rest);
        }
    }

    fn bout(&mut self, bout: &Bout, solver: &dyn FlightSolver) {
        let mut last = f64::NEG_INFINITY;
        for flight in bout.flights.iter() {
            let (begin, end) = (bout.lobe.start + flight.start, bout.lobe.start + flight.end);
            let Some((from, to)) = self.inside(begin, end) else { continue };
            if to - last < LEAST_STEPS * self.step() && matches!(flight.arrival, Arrival::Impact { .. }) {
                continue;
            }
            last = to;
            let parts = if to - from < LEAST_STEPS * self.step() {
                1.0
            } else {
                ((to - from) / self.step()).ceil().max(LEAST_PARTS)
            };
            for tau in steps((from, to), parts) {
                // The end of the flight is a time of its own: the difference of two times has fewer digits than its duration.
                let s = if tau == end { flight.duration } else { (tau - begin).min(flight.duration) };
                self.flight(bout.lobe.mirror, flight, (tau, s), solver);
            }
        }
    }

    /// The row at `tau`, a time `s` after the start of a flight.
    fn flight(&mut self, mirror: f64, flight: &Flight, (tau, s): (f64, f64), solver: &dyn FlightSolver) {
        let sign = mirror * flight.departure.side;
        let (rotation, velocity) = match flight.arrival {
            // On the base itself, to the last digit.
            Arrival::Impact { speed, .. } if s >= flight.duration => (0.0, -speed),
            _ => solver.motion(&flight.departure, s),
        };
        let state = match flight.arrival {
            Arrival::Overturned { after } if s >= after => State::Overturned,
            _ => State::Rocking,
        };
        self.push(tau, flight.departure.ground, (sign * rotation, sign * velocity), state);
    }
}

/// Times that divide a stretch into equal parts, both of its ends to the last digit.
fn steps((from, to): (f64, f64), parts: f64) -> impl Iterator<Item = f64> {
    let mut part = 0.0;
    std::iter::from_fn(move || {
        let tau = if part < parts { (from + (to - from) * (part / parts)).min(to) } else { to };
        part += 1.0;
        (part <= parts + 1.0).then_some(tau)
    })
}
