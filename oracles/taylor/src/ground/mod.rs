//! Blocks on ground that moves in another way than a sinusoid: sums of sinusoids, Ricker wavelets, records. Where the motion changes, a series ends; no step goes
//! over it.

mod motion;
mod rest;

use std::sync::Arc;

use contract::{Arrival, Body, Decline, Departure, Estimate, FlightSolver, Ground, Loss, Motion};

use crate::{
    equation::Block,
    flight::{Root, first_root, reliable},
    series::{Scale, Series, Terms, evaluate, expand_under},
    still::Still,
};
use motion::{Piece, piece, strongest};

/// The slenderness of the linear equation: so small that nothing of it is left.
const SLENDER: f64 = 1e-100;
/// How many steps one flight may take.
const MOST_STEPS: usize = 1_000_000;
/// The longest step, in units of the time in which the block or the ground changes.
const STEP: f64 = 0.4;

/// The flights of a block on ground that moves so.
pub(crate) struct Flights {
    block: Block,
    motion: Arc<Motion>,
}

/// A step: the series of the rotation in its units, how many factors of time divide it at the start, and how far it goes in those units.
struct Step {
    series: Series,
    scale: Scale,
    multiplicity: usize,
    length: f64,
}

impl Flights {
    /// Of the linear equation where no slenderness is given.
    pub fn new(body: &Body, motion: &Motion) -> Result<Self, Decline> {
        let alpha = body.alpha().unwrap_or(SLENDER);
        let block = Block::new(0.0, 1.0, body.eta(), alpha);
        let block = Block { amplitude: strongest(motion), ..block };
        Ok(Self { block, motion: Arc::new(motion.clone()) })
    }

    /// Free rocking is that of the block alone.
    fn on_still_ground(&self) -> Motion {
        Motion::Sinusoids(Vec::new())
    }

    /// The step from a state at a time; `None` from rest where nothing pushes.
    fn step(&self, motion: &Motion, side: f64, time: f64, (rotation, velocity): (f64, f64), left: f64) -> Option<Step> {
        let Piece { powers, end, rate, .. } = piece(motion, time);
        let block = &self.block;
        let longest = STEP / rate.max(1.0 / block.cos_alpha.sqrt());
        let longest = longest.min(end - time).min(left);
        let [value, slope, ..] = powers;
        let mut pull = 1.0 + side * value;
        let jerk = side * slope;
        // From rest it begins where the pull vanishes, if it does not jump: the time of that is rounded, and the pull there is nothing but rounding.
        let at_rest = rotation == 0.0 && velocity == 0.0;
        let noise = 8.0 * f64::EPSILON * (1.0 + block.amplitude + slope.abs() * time);
        if at_rest && pull.abs() <= noise {
            pull = 0.0;
        }
        let (multiplicity, time_scale, speed_scale) = if rotation > 0.0 {
            let speed = velocity.abs().max((2.0 * rotation).sqrt());
            (0, longest.min(1.0 / (block.alpha * speed)), speed)
        } else if velocity > 0.0 {
            // Twice as long as a short flight lasts.
            let landing = if pull > 0.0 { 4.0 * velocity / (block.slope * pull) } else { f64::INFINITY };
            (1, longest.min(landing).min(0.5 / (block.alpha * velocity)), velocity)
        } else if pull < 0.0 {
            (2, longest, block.slope * pull.abs() * longest)
        } else if pull == 0.0 && jerk < 0.0 {
            (3, longest, block.slope * jerk.abs() * longest * longest)
        } else {
            return None;
        };
        let scale = Scale { time: time_scale, velocity: speed_scale };
        let mut gravity = Series::new();
        let mut power = side;
        for (k, coefficient) in powers.iter().enumerate() {
            gravity.push(if k == 0 { pull } else { coefficient * power });
            power *= time_scale;
        }
        let unit = scale.velocity * scale.time;
        let state = (rotation / unit, velocity / scale.velocity);
        let all = Terms { most: crate::series::ORDER, negligible: 0.0 };
        let series = expand_under(block, &gravity, &scale, state, all);
        let deflated = series.from(multiplicity);
        let length = reliable(deflated, 3).min((longest / time_scale).min(1.0));
        Some(Step { series, scale, multiplicity, length })
    }

    /// Follows a flight for `horizon` at the most: how it ends, and the state then.
    fn follow(&self, departure: &Departure, horizon: f64) -> (Arrival, f64, (f64, f64)) {
        let still;
        let motion: &Motion = match departure.ground {
            Ground::Shaking => &self.motion,
            Ground::Still => {
                still = self.on_still_ground();
                &still
            }
        };
        let mut state = (departure.rotation, departure.velocity);
        let mut elapsed = 0.0;
        for _ in 0..MOST_STEPS {
            let now = departure.time + elapsed;
            let Some(step) = self.step(motion, departure.side, now, state, horizon - elapsed) else {
                return (Arrival::Lost(Loss::Stalled), elapsed, state);
            };
            let Step { series, scale, multiplicity, length } = step;
            let unit = scale.velocity * scale.time;
            match first_root(series.from(multiplicity), length) {
                Root::At(x) => {
                    let speed = -evaluate(series.from(0), x).1 * scale.velocity;
                    let interval = elapsed + x * scale.time;
                    if !(speed > 0.0 && interval > 0.0 && interval.is_finite()) {
                        return (Arrival::Lost(Loss::NotFinite), elapsed, state);
                    }
                    return (Arrival::Impact { interval, speed }, interval, (0.0, -speed));
                }
                Root::Below => return (Arrival::Lost(Loss::FellThrough), elapsed, state),
                Root::None => {}
            }
            let (u, w) = evaluate(series.from(0), length);
            state = (u * unit, w * scale.velocity);
            let before = elapsed;
            elapsed += length * scale.time;
            if !(state.0.is_finite() && state.1.is_finite()) {
                return (Arrival::Lost(Loss::NotFinite), elapsed, state);
            }
            let strongest = if departure.ground == Ground::Still { 0.0 } else { self.block.amplitude };
            if (Block { amplitude: strongest, ..self.block }).overturned(state.0, state.1) {
                return (Arrival::Overturned { after: elapsed }, elapsed, state);
            }
            if elapsed >= horizon * (1.0 - f64::EPSILON) {
                let (rotation, velocity) = state;
                return (Arrival::Aloft { rotation, velocity }, horizon, state);
            }
            if elapsed <= before {
                return (Arrival::Lost(Loss::Stalled), elapsed, state);
            }
        }
        (Arrival::Lost(Loss::SolverFailed), elapsed, state)
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        self.follow(departure, horizon).0
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        if s <= 0.0 || s.is_nan() {
            return (departure.rotation, departure.velocity);
        }
        let (mut from, mut left) = (*departure, s);
        loop {
            let (arrival, elapsed, (rotation, velocity)) = self.follow(&from, left);
            // It is certain that the block overturns before it has: from there on it is followed piece by piece.
            if !matches!(arrival, Arrival::Overturned { .. }) || elapsed >= left || elapsed <= 0.0 {
                return (rotation, velocity);
            }
            left -= elapsed;
            from = Departure { time: from.time + elapsed, rotation, velocity, ..from };
        }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.time_to_rest(departure).is_some(),
            Ground::Still => departure.velocity < Still::new(self.block.alpha).fastest(),
        }
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        let Departure { ground, time, side, rotation, velocity } = *departure;
        if rotation != 0.0 {
            return None;
        }
        if ground == Ground::Still {
            return Still::new(self.block.alpha).time_to_rest(velocity, self.block.eta);
        }
        let (least, most) = rest::time_left(&self.block, &self.motion, (side, time, velocity))?;
        Some(Estimate { value: 0.5 * (least + most), uncertainty: 0.5 * (most - least) })
    }
}

#[cfg(test)]
mod tests;
