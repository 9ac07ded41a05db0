//! One flight: from the base or from the air to the first time the distance from the base returns to zero.

use crate::{
    directed::Directed,
    equation::Start,
    ground::Ground,
    interval::Interval,
    piece::{FirstRoot, Motion},
    pull::Side,
};

/// How many pieces a flight is followed for. A block is in the air for a few dozen units of time at the most before it lands or overturns, but the ground
/// may change often.
const MOST_PIECES: usize = 20_000;

/// How a flight starts.
pub struct Takeoff<F, M> {
    pub moment: M,
    pub side: Side,
    pub from: From<F>,
    /// How long the flight is followed at the least.
    pub horizon: Interval<F>,
}

/// From where.
#[derive(Clone)]
pub enum From<F> {
    /// From the base, with this speed away from it.
    Impact(Interval<F>),
    /// From rest, where the pull vanishes: at initiation distance, velocity and acceleration vanish together.
    Threshold,
    /// From rest, where the ground pushes the block away at once.
    Jump,
    /// From the air, with this distance and velocity.
    Air(Interval<F>, Interval<F>),
}

/// How it ends.
pub enum Outcome<F, M> {
    Landing {
        /// How long the flight lasted.
        interval: Interval<F>,
        /// The speed at which the block lands.
        speed: Interval<F>,
        /// When it lands.
        moment: M,
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
    pub fn fly<G: Ground<F>>(&self, ground: &G, takeoff: Takeoff<F, G::Moment>) -> Outcome<F, G::Moment> {
        let Takeoff { mut moment, side, from, horizon } = takeoff;
        let mut pull = ground.pull(&moment, side);
        let zero = Interval::zero;
        let (mut deflation, mut state) = match from {
            From::Impact(speed) => (1, (zero(), speed)),
            From::Threshold => {
                // The moment is known to be that at which it vanishes.
                pull.value = zero();
                (3, (zero(), zero()))
            }
            From::Jump => (2, (zero(), zero())),
            From::Air(distance, velocity) => (0, (distance, velocity)),
        };
        let mut elapsed = zero();
        for _ in 0..MOST_PIECES {
            let left = (&horizon - &elapsed).upper.double_above();
            if !(left > 0.0) {
                return if horizon.is_below(&elapsed) { Outcome::Aloft } else { Outcome::Unclear };
            }
            let change = ground.change(&moment);
            // Past the horizon by more than the widths, so as to be beyond it for certain; but never past a change of the ground.
            let mut most = 1.001 * left + 1e-9;
            if let Some((until, _)) = &change {
                most = most.min(until.upper.double_above());
            }
            let start = Start { distance: state.0, velocity: state.1, pull };
            let any_pull = |length| ground.any_pull(&moment, side, length);
            let Some(piece) = self.piece(&start, &any_pull, deflation, most) else { return Outcome::Unclear };
            match piece.first_root() {
                FirstRoot::In(from, to) => {
                    let root = piece.narrow(from, to);
                    let speed = -&piece.velocity_at_root(&root);
                    let in_time = change.is_none_or(|(until, _)| root.is_below(&until));
                    if !(root.is_positive() && speed.is_positive() && in_time) {
                        return Outcome::Unclear;
                    }
                    let moment = ground.later(&moment, &root);
                    return Outcome::Landing { interval: &elapsed + &root, speed, moment };
                }
                FirstRoot::Unclear => return Outcome::Unclear,
                FirstRoot::None => {
                    let Some((length, next)) = end(&piece.length, &change) else { return Outcome::Unclear };
                    state = piece.at(&length);
                    elapsed = &elapsed + &length;
                    moment = next.unwrap_or_else(|| ground.later(&moment, &length));
                    if self.equation.overturned(&state.0, &state.1, ground.amplitude()) {
                        return Outcome::Overturned;
                    }
                    pull = ground.pull(&moment, side);
                    deflation = 0;
                }
            }
        }
        Outcome::Unclear
    }
}

/// How far a piece is followed, and the moment there if it is that of a change; `None` if there is no telling which of the two comes first.
fn end<F: Directed, M: Clone>(length: &f64, change: &Option<(Interval<F>, M)>) -> Option<(Interval<F>, Option<M>)> {
    let whole = Interval::exactly(*length);
    match change {
        Some((until, next)) if *length >= until.upper.double_above() => Some((until.clone(), Some(next.clone()))),
        Some((until, _)) if !whole.is_below(until) => {
            let before = until.lower.double_below();
            (before > 0.0).then(|| (Interval::exactly(before), None))
        }
        _ => Some((whole, None)),
    }
}
