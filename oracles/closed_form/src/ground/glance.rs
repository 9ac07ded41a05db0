//! A cheap look at what comes next of a long flight over the lines of a record.
//!
//! The state is handed over from line to line, so that each costs the same however many lie behind it, and a bound on what that rounds grows along. It tells one
//! thing: that the block is above its base over a stretch, by more than that bound. All else is left to the search, which hands nothing over.

use super::flight::{Flight, Pull};

/// Roundings of a step, of the largest number in it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Where a flight is, so long after its start, nearly.
pub struct Glance {
    at: f64,
    state: (f64, f64),
    pull: Pull,
    /// A bound on the error of the rotation and of the velocity, each.
    error: f64,
    /// How many changes lie behind.
    passed: usize,
}

impl Glance {
    /// From a time at which the flight is known; `None` where what comes is no straight line.
    pub fn new(flight: &Flight, at: f64, state: (f64, f64)) -> Option<Self> {
        let passed = flight.changes.partition_point(|change| change.at <= at);
        if flight.changes.iter().any(|change| !change.waves.is_empty()) {
            return None;
        }
        let pull = flight.pull(at.next_up());
        Some(Self { at, state, pull, error: rounding(flight, at), passed })
    }

    /// Goes on to `to`, no further than to the next change of the flight, and says where it is there if the block has been above its base all the while.
    pub fn above(&mut self, flight: &Flight, to: f64) -> Option<(f64, f64)> {
        let (h, (u, v)) = (to - self.at, self.state);
        let Pull { value, slope } = self.pull;
        let half = (0.5 * h).sinh();
        let cosh_less_one = 2.0 * half * half;
        let sinh = h.sinh();
        // sinh h - h: what it loses for a short h is rounding of what it is added to.
        let state = (
            u + (u - value) * cosh_less_one + v * sinh - slope * (sinh - h),
            v + v * cosh_less_one + (u - value) * sinh - slope * cosh_less_one,
        );
        let pull = value + slope * h;
        let strongest = value.abs().max(pull.abs());
        let size = u.abs().max(state.0.abs()) + v.abs().max(state.1.abs()) + strongest;
        // e^h <= 1 + h + h² for h below 1.
        self.error = (self.error + ROUNDING * size) * (1.0 + h + h * h);
        // As in the search: |u''| <= |u| + |c|.
        let bend = h * h / 8.0;
        let acceleration = (u.abs().max(state.0.abs()) + strongest * bend) * 1.2 + strongest;
        let bottom = u.min(state.0) - acceleration * bend;
        (self.at, self.state, self.pull.value) = (to, state, pull);
        while let Some(change) = flight.changes.get(self.passed).filter(|change| change.at <= to) {
            self.pull.value += change.level;
            self.pull.slope += change.slope;
            self.passed += 1;
        }
        let above = h < 1.0 && bottom > self.error;
        above.then_some(state)
    }

    /// By how much the state may be off.
    pub fn error(&self) -> f64 {
        self.error
    }
}

/// What rounding does to the state of a flight without anything handed over: it is the sum of what all changes do.
pub fn rounding(flight: &Flight, s: f64) -> f64 {
    let before = flight.changes.iter().take_while(|change| change.at < s);
    let pulls: f64 = before.map(|change| change.level.abs() + change.slope.abs() * (s - change.at)).sum();
    ROUNDING * s.cosh() * (flight.start.0.abs() + flight.start.1.abs() + pulls)
}
