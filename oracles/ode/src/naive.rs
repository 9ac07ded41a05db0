//! The global clock: one solver runs over absolute time in the units of the problem, stops at a root, has its state set and continues,
//! as in the bouncing ball of diffsol's own examples. It is kept to be studied; it loses the sequence, and says so where it can tell.

use core::cell::Cell;

use contract::Loss;
use diffsol::{OdeSolverMethod, OdeSolverStopReason};

use crate::Restart;
use crate::equation::Motion;
use crate::flight::Scaled;
use crate::launch::{Equations, Flight, Launch, Outcome};

/// It bounds the work in a flight, as steps on this clock can become arbitrarily small.
const MOST_STEPS: usize = 20_000;
/// The share of the expected flight that the first step covers. With one that covers all of it the event function has the sign of the
/// fall at the end and none at the start, and diffsol misses the impact without a word.
const FIRST_STEP: f64 = 0.25;

/// A solver on the global clock. The equations of its problem read the sign of the flight from `sign`.
pub(crate) struct Naive<'c, S> {
    pub solver: S,
    pub sign: &'c Cell<f64>,
    pub restart: Restart,
}

impl<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>> Flight<'a, E> for Naive<'_, S> {
    fn fly(&mut self, motion: &Motion, launch: &Launch, time_left: f64) -> Outcome {
        let &Launch { i, velocity, .. } = launch;
        self.sign.set(i);
        let state = self.solver.state_mut();
        let start = *state.t;
        let phi = match self.restart {
            // The first flight starts from rest, where there is nothing to lift.
            Restart::Lifted(by) if velocity != 0.0 => i * by,
            _ => 0.0,
        };
        (state.y[0], state.y[1]) = (phi, velocity);
        (state.dy[0], state.dy[1]) = (velocity, motion.shape.acceleration(i, motion.excess(i, start), phi));
        if self.restart != Restart::OldStep || velocity == 0.0 {
            *state.h = FIRST_STEP * Scaled::of_case(motion, &Launch { tau: start, ..*launch }).time;
        }
        let mut last = start;
        for _ in 0..MOST_STEPS {
            let Ok(reason) = self.solver.step() else {
                return Outcome::Lost(Loss::SolverFailed);
            };
            if let OdeSolverStopReason::RootFound(t, _) = reason {
                if self.solver.state_mut_back(t).is_err() {
                    return Outcome::Lost(Loss::SolverFailed);
                }
                return Outcome::landed(t - start, -i * self.solver.state().y[1], time_left);
            }
            let state = self.solver.state();
            let (t, u, du) = (state.t, i * state.y[0], i * state.y[1]);
            if !(t + u + du).is_finite() {
                return Outcome::Lost(Loss::NotFinite);
            }
            if t <= last {
                return Outcome::Lost(Loss::Stalled);
            }
            if u <= 0.0 {
                return Outcome::Lost(Loss::FellThrough);
            }
            if t - start >= time_left {
                return Outcome::TimeIsUp;
            }
            if motion.shape.is_past_return(motion.a, u, du) {
                return Outcome::Overturned { after: t - start };
            }
            last = t;
        }
        Outcome::Lost(Loss::SolverFailed)
    }
}
