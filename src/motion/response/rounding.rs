//! What rounding in every flight does to when a bout ends: each error of a flight times the sensitivity of the end to it, all with one sign.
//!
//! The sensitivities go back from the end, flight by flight, by the derivatives of a flight of `u'' = u - c`, seen from the side on which the block is: from the time `t`,
//! the rotation `u` and the velocity `v` with which it starts, to its length `T` and the speed `w` at its end. With the pulls `C` and `c` at its start and end,
//!
//! ```text
//! w dT = cosh T du + sinh T dv + [(C - u) sinh T - v cosh T - w] dt
//!   dw = c dT - sinh T du - cosh T dv + [c - (C - u) cosh T + v sinh T] dt
//! ```
//!
//! At the last impact, with the speed `v` after it and the pulls `C` ahead and `D` behind, the block rests at `t + 2 (1/C + e/D)/(1 - e²) v`. Of Eq. 2 this is an estimate,
//! as good as its linearisation.

use contract::{Arrival, Ground, Model, Motion, Oracle, Stretch};

use super::{Bout, Flight, OnMotion, Shaken};

/// Roundings of the length of a flight, of the speed at its end and of the ground acceleration.
const INTERVAL: f64 = 8.0;
const SPEED: f64 = 24.0;
const PULL: f64 = 4.0;
/// Roundings of the time at which a flight starts, and of each angle that a sum of sinusoids makes of it.
const CLOCK: f64 = 2.0;
/// How many times more a flight leaves behind that is integrated to a tolerance, which narrows a root down to some hundred roundings of a clock.
const INTEGRATED: f64 = 100.0;
/// How a bout was followed.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// The coefficient of restitution.
    eta: f64,
    /// Whether the flights are integrated to a tolerance.
    is_integrated: bool,
    /// Whether they are those of the linear equation.
    is_linear: bool,
}

impl Way {
    pub(super) fn of(oracle: &dyn Oracle, request: &OnMotion) -> Self {
        let (is_integrated, is_linear) = (oracle.coarser().is_some(), oracle.model() == Model::Linear);
        Self { eta: request.body.eta(), is_integrated, is_linear }
    }
}

/// What a bout ends with, by what starts or ends a flight.
#[derive(Clone, Copy, Default)]
struct Sensitivity {
    time: f64,
    rotation: f64,
    velocity: f64,
}

/// What rounding does to when a bout ends that ends with rest, absolute in `τ`; infinite where that can't be told.
pub(super) fn of_rest(bout: &Bout, ground: &Shaken, way: Way) -> f64 {
    let around = Around { bout, ground, is_linear: way.is_linear };
    let Some(mut next) = bout.flights.last().and_then(|last| around.at_rest(last, way.eta)) else {
        return f64::INFINITY;
    };
    let turning = turning(ground);
    let more = if way.is_integrated { INTEGRATED } else { 1.0 };
    let mut sum = f64::EPSILON * CLOCK * bout.end();
    for flight in bout.flights.iter().rev() {
        let (pulls, now) = (around.pulls(flight), (bout.lobe.start + flight.end).abs());
        let flown = Flown { flight, pulls, eta: way.eta, next };
        let mut landing = 0.0;
        if let Arrival::Impact { interval, speed } = flight.arrival {
            landing = INTERVAL * interval * next.time.abs() + SPEED * way.eta * speed * next.velocity.abs();
        }
        let strength = PULL * (pulls.0 - 1.0).abs().max((pulls.1 - 1.0).abs()).max(1.0) + CLOCK * turning * now;
        let of = flown.sensitivity();
        // A later clock: the flight is that of a later ground, but ends no later for that.
        let later = of.time - if flown.lands() { next.time } else { 0.0 };
        sum += f64::EPSILON * (more * landing + strength * flown.by_pull().abs() + CLOCK * now * later.abs());
        next = of;
    }
    sum
}

/// A flight, and what the end of its bout owes to what follows it.
struct Flown<'a> {
    flight: &'a Flight,
    /// The pulls at its start and at its end.
    pulls: (f64, f64),
    eta: f64,
    next: Sensitivity,
}

impl Flown<'_> {
    fn lands(&self) -> bool {
        matches!(self.flight.arrival, Arrival::Impact { .. })
    }

    /// What a change `(δu, δu')` of rotation and velocity at the end of the flight, at that very time, does to the end of the bout.
    fn at_end(&self, rotation: f64, velocity: f64) -> f64 {
        let Arrival::Impact { speed, .. } = self.flight.arrival else {
            return self.next.rotation * rotation + self.next.velocity * velocity;
        };
        let later = rotation / speed;
        self.next.time * later + self.next.velocity * self.eta * (self.pulls.1 * later - velocity)
    }

    fn sensitivity(&self) -> Sensitivity {
        let (sinh, cosh) = (self.flight.duration.sinh(), self.flight.duration.cosh());
        let departure = &self.flight.departure;
        let (speed, pull) = (departure.velocity, self.pulls.0 - departure.rotation);
        Sensitivity {
            time: self.at_end(pull * sinh - speed * cosh, pull * cosh - speed * sinh),
            rotation: self.at_end(cosh, sinh),
            velocity: self.at_end(sinh, cosh),
        }
    }

    /// What a pull does that is stronger by 1 all the while.
    fn by_pull(&self) -> f64 {
        let half = (0.5 * self.flight.duration).sinh();
        self.at_end(-2.0 * half * half, -self.flight.duration.sinh())
    }
}

/// How fast the terms of a sum of sinusoids turn, or the lines of a record rise and fall: each angle and each line is rounded by itself, so what they do need not cancel
/// as they do.
fn turning(ground: &Shaken) -> f64 {
    let Shaken::Motion(motion) = ground else { return 0.0 };
    match motion.as_ref() {
        Motion::Sinusoids(stretches) => {
            let of = |stretch: &Stretch| stretch.terms.iter().map(|term| (term.amplitude * term.omega).abs()).sum();
            stretches.iter().map(of).fold(0.0, f64::max)
        }
        Motion::Record(record) => {
            let changes =
                record.samples.iter().zip(record.samples.iter().skip(1)).map(|(one, next)| (next - one).abs());
            record.scale.abs() * changes.sum::<f64>() / motion.duration()
        }
        Motion::Ricker(_) => 0.0,
    }
}

struct Around<'a> {
    bout: &'a Bout,
    ground: &'a Shaken,
    is_linear: bool,
}

impl Around<'_> {
    /// `1 + i f`, what pulls the block back at the start and at the end of a flight.
    fn pulls(&self, flight: &Flight) -> (f64, f64) {
        let Flight { departure, duration, .. } = flight;
        let lobe = self.bout.lobe;
        if let Arrival::Impact { speed, .. } = flight.arrival
            && !self.is_linear
            && departure.rotation == 0.0
        {
            // Those of Eq. 4 are off by what is not linear in Eq. 2, flight after flight, and the sum would grow with it. The straight line of a pull with which a flight takes so long and ends so fast is not.
            let half = 0.5 * duration;
            let (mean, tanh) = (0.5 * (departure.velocity + speed), half.tanh());
            let bend = half / tanh - 1.0;
            let change = if bend > 0.0 { 0.5 * half * (speed - departure.velocity) / bend } else { 0.0 };
            return (mean / tanh - change, mean / tanh + change);
        }
        let pull = |time: f64| match departure.ground {
            Ground::Still => 1.0,
            Ground::Shaking => 1.0 + lobe.mirror * departure.side * self.ground.acceleration(lobe.start + time),
        };
        (pull(flight.start), pull(flight.end))
    }

    /// After the last impact, `None` if there is none or rest is not possible there.
    fn at_rest(&self, last: &Flight, eta: f64) -> Option<Sensitivity> {
        let behind = self.pulls(last).1;
        let ahead = 2.0 - behind;
        let left = 2.0 * (1.0 / ahead + eta / behind) / (1.0 - eta * eta);
        let possible = matches!(last.arrival, Arrival::Impact { .. }) && ahead > 0.0 && behind > 0.0;
        possible.then_some(Sensitivity { time: 1.0, rotation: 0.0, velocity: left })
    }
}
