//! The linear block (Eq. 4) on ground that moves in another way than a sinusoid: sums of sinusoids, and records, in closed form.

mod flight;
mod glance;
mod kernels;
mod landing;
mod pull;
mod rest;

use contract::{Arrival, Decline, Departure, Estimate, FlightSolver, Ground as State, Loss, Motion};

use crate::still;
use flight::Flight;
use glance::Glance;
use landing::{Search, first_root};
use pull::{Change, Ground};

/// The flights of a block on ground that moves so.
pub(crate) struct Flights {
    ground: Ground,
    eta: f64,
}

/// The longest stretch that is searched at once, in units of the time in which the block or the ground changes.
const STRETCH: f64 = 0.5;

impl Flights {
    pub fn new(motion: &Motion, eta: f64) -> Result<Self, Decline> {
        Ok(Self { ground: Ground::new(motion)?, eta })
    }

    /// The flight as far as `window` after its departure.
    fn flight(&self, departure: &Departure, window: f64) -> Flight {
        let mut changes = self.ground.pull(departure.side, departure.time, window);
        let start = (departure.rotation, departure.velocity);
        // From rest it begins where the pull vanishes, if it does not jump: the time of that is rounded, and the pull there is nothing but rounding.
        if start == (0.0, 0.0)
            && let Some(first) = changes.first_mut()
            && first.level.abs() <= self.rounding(departure.time, first)
        {
            first.level = 0.0;
        }
        Flight { start, changes }
    }

    /// What the pull at a time may be off by.
    fn rounding(&self, time: f64, first: &Change) -> f64 {
        let rate = first.slope.abs() + first.waves.iter().map(|wave| wave.rate.abs()).sum::<f64>();
        8.0 * f64::EPSILON * (1.0 + self.ground.strongest(time) + rate * time)
    }

    /// Whether the block cannot come back from there, whatever the ground does of what it will, or if it stops: `u + u'` is no less than any pull to come, and grows.
    fn is_overturned(&self, time: f64, (rotation, velocity): (f64, f64)) -> bool {
        rotation + velocity >= 1.0 + self.ground.strongest(time)
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        if departure.ground == State::Still {
            return still::fly((departure.rotation, departure.velocity), horizon);
        }
        // A short flight lasts about twice this.
        let short = departure.velocity / self.ground.level(departure.side, departure.time);
        let is_short = departure.rotation == 0.0 && short > 0.0;
        let mut window = if is_short { STRETCH.min(4.0 * short).min(horizon) } else { 0.0 };
        let mut elapsed = 0.0;
        let mut ahead: Option<Glance> = None;
        let mut flight = self.flight(departure, window);
        if flight.start == (0.0, 0.0) {
            let pull = flight.pull(0.0);
            // Nothing pushes it away.
            if pull.value > 0.0 || pull.value == 0.0 && pull.slope >= 0.0 {
                return Arrival::Lost(Loss::Stalled);
            }
        }
        loop {
            let Some((change, end)) = flight.piece(elapsed) else { return Arrival::Lost(Loss::NotFinite) };
            let mut stretch = STRETCH / change.rate;
            let first = 2.0 * departure.velocity / change.level;
            if elapsed == 0.0 && first > 0.0 && departure.rotation == 0.0 {
                // Twice as long as a short flight lasts.
                stretch = stretch.min(2.0 * first);
            }
            let to = end.min(elapsed + stretch).min(horizon);
            if to > window && window < horizon {
                // The changes are looked up as far as the flight gets.
                window = (2.0 * window).max(to + stretch).min(horizon);
                flight = self.flight(departure, window);
                continue;
            }
            if to < horizon
                && let Some(glance) = &mut ahead
                && let Some(state) = glance.above(&flight, to)
                && !self.is_overturned(departure.time + to, (state.0 + 2.0 * glance.error(), state.1))
            {
                elapsed = to;
                continue;
            }
            match first_root(&flight, elapsed, to) {
                Search::Root(interval) => {
                    let speed = -flight.at(interval).1;
                    if !(speed > 0.0 && interval > 0.0) {
                        return Arrival::Lost(Loss::NotFinite);
                    }
                    return Arrival::Impact { interval, speed };
                }
                Search::None => {}
            }
            let state = flight.at(to);
            if self.is_overturned(departure.time + to, state) {
                return Arrival::Overturned { after: to };
            }
            if to >= horizon {
                let (rotation, velocity) = state;
                return Arrival::Aloft { rotation, velocity };
            }
            if !(state.0.is_finite() && state.1.is_finite()) {
                return Arrival::Lost(Loss::NotFinite);
            }
            ahead = Glance::new(&flight, to, state);
            elapsed = to;
        }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        if departure.ground == State::Still {
            return still::motion((departure.rotation, departure.velocity), s);
        }
        self.flight(departure, s).at(s)
    }

    fn rests(&self, departure: &Departure) -> bool {
        self.time_to_rest(departure).is_some()
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        let Departure { ground, side, time, rotation, velocity } = *departure;
        if ground == State::Still && rotation == 0.0 {
            return still::time_to_rest(velocity, self.eta);
        }
        if rotation != 0.0 {
            return None;
        }
        let (least, most) = rest::time_left(&self.ground, self.eta, (side, time, velocity))?;
        Some(Estimate { value: 0.5 * (least + most), uncertainty: 0.5 * (most - least) })
    }
}

#[cfg(test)]
mod tests;
