//! Flights on ground that moves in any way. Where the motion is another function from there on, a step ends: no step is over a breakpoint.

use contract::{Arrival, Body, Decline, Departure, Estimate, FlightSolver, Ground, Loss, Motion};

use crate::Equation;
use crate::ending::Pulls;
use crate::equation::Shape;
use crate::flight::{Leg, Scaled};
use crate::flights::{Single, arrival, launch};
use crate::forcing::{Forcing, Wave};
use crate::ground::{Span, steepest, strongest};
use crate::launch::Outcome;

/// Where less than this of the time in which a flight changes is left of a span, the acceleration is the same until its end.
const NOTHING: f64 = 1e-12;

/// The flights of one block under one motion of the ground.
pub(crate) struct OnMotion {
    single: Single,
    eta: f64,
    shape: Shape,
    motion: Motion,
    strongest: f64,
}

impl OnMotion {
    pub fn new(single: Single, equation: Equation, body: &Body, motion: &Motion) -> Result<Self, Decline> {
        let shape = match equation {
            Equation::Linear => Shape::Slender,
            Equation::Nonlinear => Shape::exact(body.alpha().ok_or(Decline::NeedsSlenderness)?),
        };
        Ok(Self { single, eta: body.eta(), shape, motion: motion.clone(), strongest: strongest(motion) })
    }

    /// Where a flight ends within `horizon`, and with what state.
    fn follow(&self, departure: &Departure, horizon: f64, watched: bool) -> (Outcome, (f64, f64)) {
        if departure.ground == Ground::Still {
            let launch = launch(departure);
            let leg = Leg { lasts: horizon, breaks: false, strongest: (!watched).then_some(0.0) };
            return self.single.follow(Scaled::new(self.shape, Forcing::still(launch.i), &launch), leg);
        }
        let (mut from, mut waves) = (*departure, Vec::new());
        loop {
            let elapsed = from.time - departure.time;
            let span = Span::at(&self.motion, from.time);
            let (left, lasts) = (horizon - elapsed, span.until - from.time);
            let breaks = lasts < left;
            let leg = Leg { lasts: lasts.min(left), breaks, strongest: (!watched).then_some(self.strongest) };
            let (outcome, (rotation, velocity)) = self.leg(&from, &span, leg, &mut waves);
            match outcome {
                Outcome::TimeIsUp if breaks => from = Departure { time: span.until, rotation, velocity, ..from },
                Outcome::Impact { interval, speed } => {
                    return (Outcome::Impact { interval: elapsed + interval, speed }, (rotation, velocity));
                }
                Outcome::Overturned { after } => {
                    return (Outcome::Overturned { after: elapsed + after }, (rotation, velocity));
                }
                other => return (other, (rotation, velocity)),
            }
        }
    }

    /// A flight as far as a span of the motion goes.
    fn leg(&self, from: &Departure, span: &Span, leg: Leg, waves: &mut Vec<Wave>) -> (Outcome, (f64, f64)) {
        let Departure { time, side, rotation, velocity, .. } = *from;
        let mut forcing = span.forcing(side, time, waves);
        if rotation == 0.0 && velocity == 0.0 {
            // From rest it begins where the pull vanishes, if it does not jump. That time is rounded, and the pull there is nothing but rounding.
            if forcing.excess.abs() <= span.rounding(time) {
                forcing.excess = 0.0;
            }
            let (slope, curvature) = forcing.derivatives();
            let pushed = [forcing.excess, slope, curvature].into_iter().find(|part| *part != 0.0);
            if pushed.is_none_or(|part| side * part > 0.0) {
                return (Outcome::Lost(Loss::Stalled), (0.0, 0.0));
            }
        }
        let scaled = Scaled::new(self.shape, forcing, &launch(from));
        if leg.breaks && leg.lasts < NOTHING * scaled.time {
            let acceleration = side * self.shape.acceleration(side, forcing.excess, side * rotation);
            let s = leg.lasts;
            return (
                Outcome::TimeIsUp,
                (rotation + s * (velocity + 0.5 * s * acceleration), velocity + s * acceleration),
            );
        }
        self.single.follow(scaled, leg)
    }
}

impl FlightSolver for OnMotion {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let (outcome, state) = self.follow(departure, horizon, false);
        arrival(outcome, state)
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        if s > 0.0 { self.follow(departure, s, true).1 } else { (departure.rotation, departure.velocity) }
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.time_to_rest(departure).is_some(),
            Ground::Still => self.shape.comes_to_rest_on_still_ground(departure.velocity),
        }
    }

    /// On shaking ground: between bounds that close in as the block slows down, whatever kinks the motion has in between.
    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        let Departure { ground, time, side, rotation, velocity } = *departure;
        if ground == Ground::Still || rotation != 0.0 {
            return None;
        }
        let (span, waves) = (Span::at(&self.motion, time), &mut Vec::new());
        let own = side * span.forcing(side, time, waves).excess;
        let other = -side * span.forcing(-side, time, waves).excess;
        let pulls = Pulls { own, other, rounding: span.rounding(time) };
        let (least, most) =
            self.shape.time_to_rest(self.eta, &pulls, velocity, |window| steepest(&self.motion, time, window))?;
        Some(Estimate { value: 0.5 * (least + most), uncertainty: 0.5 * (most - least) })
    }
}
