//! The state at the start of a step, and what becomes of it.

use super::{problem::Problem, stepping::step};

/// The state at the start of a step: the sign of the rotation, and how far and how fast away from the base.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    pub time: f64,
    pub side: f64,
    pub state: (f64, f64),
}

impl Knot {
    /// How fast the rotation away from the base accelerates, `s` later, with the ground as it is now.
    pub fn acceleration(&self, problem: &Problem, s: f64, u: f64) -> f64 {
        let ground = problem.ground_after(self.time, s);
        self.side * problem.acceleration(self.side, ground, self.side * u)
    }

    /// The state `h` later.
    pub fn advanced(&self, problem: &Problem, h: f64) -> Self {
        let state = step(|s, u| self.acceleration(problem, s, u), self.state, h);
        // A change is met exactly.
        let left = problem.until_change(self.time);
        let time = if h >= left { problem.change(self.time) } else { self.time + h };
        Self { time, state, ..*self }
    }
}
