//! One flight: from just after an impact to the first time the distance from the base returns to zero.

use crate::{
    directed::Directed,
    equation::Start,
    excitation::{HalfPhase, Side},
    interval::Interval,
    piece::{FirstRoot, Motion},
};

/// How many pieces a flight is followed for. A block is in the air for a few dozen units of time at the most before it lands or overturns.
const MOST_PIECES: usize = 2000;

/// How a flight starts.
pub struct Takeoff<F> {
    pub phase: HalfPhase<F>,
    pub side: Side,
    /// The speed away from the base: zero only at initiation.
    pub speed: Interval<F>,
    /// How long the flight is followed at the least.
    pub horizon: Interval<F>,
}

/// How it ends.
pub enum Outcome<F> {
    Landing {
        /// How long the flight lasted.
        interval: Interval<F>,
        /// The speed at which the block lands.
        speed: Interval<F>,
        /// The phase at the impact.
        phase: HalfPhase<F>,
    },
    /// It is in the air at the horizon.
    Aloft,
    /// No return is possible.
    Overturned,
    /// Not with these digits.
    Unclear,
}

impl<F: Directed> Motion<F> {
    /// Follows a flight to its first impact.
    pub fn fly(&self, takeoff: Takeoff<F>) -> Outcome<F> {
        let Takeoff { mut phase, side, speed, horizon } = takeoff;
        // At initiation distance, velocity and acceleration vanish together.
        let mut deflation = if speed.is_positive() { 1 } else { 3 };
        let mut start = Start { distance: Interval::zero(), velocity: speed, pull: self.excitation.pull(&phase, side) };
        let mut elapsed = Interval::zero();
        for _ in 0..MOST_PIECES {
            let left = (&horizon - &elapsed).upper.double_above();
            if !(left > 0.0) {
                return if horizon.is_below(&elapsed) { Outcome::Aloft } else { Outcome::Unclear };
            }
            // Past the horizon by more than the widths, so as to be beyond it for certain.
            let Some(piece) = self.piece(&start, deflation, 1.001 * left + 1e-9) else { return Outcome::Unclear };
            match piece.first_root() {
                FirstRoot::In(from, to) => {
                    let root = piece.narrow(from, to);
                    let speed = -&piece.velocity_at_root(&root);
                    if !(root.is_positive() && speed.is_positive()) {
                        return Outcome::Unclear;
                    }
                    let phase = self.excitation.later(&phase, &root);
                    return Outcome::Landing { interval: &elapsed + &root, speed, phase };
                }
                FirstRoot::Unclear => return Outcome::Unclear,
                FirstRoot::None => {
                    let length = Interval::exactly(piece.length);
                    let (distance, velocity) = piece.end();
                    elapsed = &elapsed + &length;
                    phase = self.excitation.later(&phase, &length);
                    if self.equation.overturned(&distance, &velocity, &self.excitation.amplitude) {
                        return Outcome::Overturned;
                    }
                    start = Start { distance, velocity, pull: self.excitation.pull(&phase, side) };
                    deflation = 0;
                }
            }
        }
        Outcome::Unclear
    }
}
