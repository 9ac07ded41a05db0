//! Flights one at a time, under one sinusoid of any phase and on still ground: Eqs 6-13 from wherever a flight starts, with so many digits that a double is left of
//! the end.

use contract::{Arrival, Body, Decline, Departure, FlightSolver, Ground, Loss, Motion, Sinusoid, Stretch};

use crate::arithmetic::{Arithmetic, double};
use crate::follow::{Search, root};
use crate::motion::{Excitation, Flight};
use crate::rest;

/// The flights of a block under a sinusoid, which ends if it does.
pub(crate) struct Flights {
    eta: f64,
    term: Sinusoid,
    /// When the ground comes to rest.
    until: f64,
}

/// No motion of the ground: a sinusoid of no amplitude.
const STILL: Sinusoid = Sinusoid { amplitude: 0.0, omega: 0.0, phase: 0.0 };
/// Bits of a flight of order one: those of a double, and as many more for what cancels in absolute time under a strong motion, and for rounding.
const BITS: f64 = 192.0;
/// Longer numbers are not needed by what a double can say of a flight's start.
const MOST_BITS: f64 = 4096.0;
/// By how much the search for the end of a flight grows its step each time, and the longest one, in units of the time in which the ground or the block changes.
const GROWTH: f64 = 1.15;
const LONGEST: f64 = 0.1;
/// The first step of a flight from rest, in that unit: from there on steps grow.
const FROM_REST: f64 = 1e-7;
/// It bounds the work.
const MOST_STEPS: usize = 100_000;

/// A flight under way.
struct Begun {
    ar: Arithmetic,
    excitation: Excitation,
    flight: Flight,
}

impl Flights {
    /// Under this motion.
    pub fn new(body: &Body, motion: &Motion) -> Result<Self, Decline> {
        let one = match motion {
            Motion::Sinusoids(stretches) => match stretches.as_slice() {
                [Stretch { until, terms }] => match terms.as_slice() {
                    [] => Some((STILL, *until)),
                    [term] => Some((*term, *until)),
                    _ => None,
                },
                _ => None,
            },
            Motion::Ricker(_) | Motion::Record(_) => None,
        };
        let (term, until) = one.ok_or(Decline::Unsupported {
            what: "motions of the ground that are more than one sinusoid: Eqs 6-13 are of that",
        })?;
        Ok(Self { eta: body.eta(), term, until })
    }

    fn term(&self, ground: Ground) -> Sinusoid {
        if ground == Ground::Still { STILL } else { self.term }
    }

    /// What the flight starts with, in numbers long enough for the `u ~ v²` in it, made up of terms of the order of 1.
    fn begin(&self, departure: &Departure) -> Option<Begun> {
        let Departure { ground, time, side, rotation, velocity } = *departure;
        let term = self.term(ground);
        let height = (velocity * velocity).max(rotation);
        let height = if height > 0.0 { height } else { (FROM_REST / term.omega.max(1.0)).powi(4) };
        let bits = BITS + height.log2().abs();
        // Nor is there a flight that starts with what is no number.
        if bits.is_nan() || bits > MOST_BITS {
            return None;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let ar = Arithmetic::new(bits as usize).ok()?;
        let excitation = Excitation::of_term(&ar, &term);
        let state = (&ar.number(side * rotation), &ar.number(side * velocity));
        let flight = Flight::from_state(&ar, &excitation, side, &ar.number(time), state);
        Some(Begun { ar, excitation, flight })
    }

    /// The pull at the start of a flight and its slope, in doubles.
    fn pull(&self, departure: &Departure) -> (f64, f64) {
        let Sinusoid { amplitude, omega, phase } = self.term(departure.ground);
        let (sin, cos) = (omega * departure.time + phase).sin_cos();
        (1.0 + departure.side * amplitude * sin, departure.side * amplitude * omega * cos)
    }

    fn follow(&self, departure: &Departure, horizon: f64) -> Result<Arrival, Loss> {
        let Departure { ground, time, rotation, velocity, .. } = *departure;
        let Sinusoid { amplitude, omega, .. } = self.term(ground);
        let (most, unit) = (1.0 + amplitude.abs(), 1.0 / omega.max(1.0));
        // The pull towards the base is `most` at the most, so the flight lasts as long as under that at least; a little less is surely inside of it.
        let mut step = 0.9 * (velocity + (velocity * velocity + 2.0 * most * rotation).sqrt()) / most;
        if rotation == 0.0 && velocity == 0.0 {
            let (pull, slope) = self.pull(departure);
            // From rest it begins where the pull vanishes, as far as rounding tells, and falls, or where the ground pushes.
            if pull > 8.0 * f64::EPSILON * (most + amplitude.abs() * omega * time) || pull >= 0.0 && slope >= 0.0 {
                return Err(Loss::Stalled);
            }
            step = FROM_REST * unit;
        }
        let Begun { ar, excitation, flight } = self.begin(departure).ok_or(Loss::NotFinite)?;
        let start = ar.number(time);
        let (mut before, mut since) = (start.clone(), 0.0);
        for _ in 0..MOST_STEPS {
            let elapsed = step.min(horizon);
            let now = ar.add(&start, &ar.number(elapsed));
            let rotation = flight.rotation(&ar, &excitation, &now);
            if rotation.is_nan() {
                return Err(Loss::NotFinite);
            }
            if !flight.is_off_base(&rotation) {
                if since == 0.0 && elapsed < horizon {
                    return Err(Loss::FellThrough);
                }
                let Search::Found(end) = root(&ar, &excitation, &flight, before, now) else {
                    return Err(Loss::SolverFailed);
                };
                let interval = double(&ar.sub(&end, &start));
                let speed = -flight.sign * double(&flight.velocity(&ar, &excitation, &end));
                return if speed > 0.0 && interval > 0.0 {
                    Ok(Arrival::Impact { interval, speed })
                } else {
                    Err(Loss::NotFinite)
                };
            }
            let away = [rotation, flight.velocity(&ar, &excitation, &now)].map(|part| flight.sign * double(&part));
            // `(u + u')' = (u + u') - 1 - i f`: from here on it grows under this motion and on still ground, but has to fall for a return.
            if away.iter().sum::<f64>() > most {
                return Ok(Arrival::Overturned { after: elapsed });
            }
            if elapsed >= horizon {
                let [rotation, velocity] = away;
                return Ok(Arrival::Aloft { rotation, velocity });
            }
            (before, since) = (now, elapsed);
            step = (step * GROWTH).min(step + LONGEST * unit);
        }
        Err(Loss::SolverFailed)
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        self.follow(departure, horizon).unwrap_or_else(Arrival::Lost)
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        let Some(Begun { ar, excitation, flight }) = self.begin(departure) else { return (f64::NAN, f64::NAN) };
        let now = ar.add(&ar.number(departure.time), &ar.number(s));
        let of = |part| flight.sign * double(&part);
        (of(flight.rotation(&ar, &excitation, &now)), of(flight.velocity(&ar, &excitation, &now)))
    }

    fn rests(&self, departure: &Departure) -> bool {
        let Departure { ground, time, side, velocity, rotation } = *departure;
        let Sinusoid { amplitude, omega, .. } = self.term(ground);
        let left = if ground == Ground::Still { f64::INFINITY } else { self.until - time };
        let forcing = side * (self.pull(departure).0 - 1.0);
        let steepest = amplitude.abs() * omega;
        rotation == 0.0 && rest::is_certain_under(steepest, self.eta, forcing, side * velocity, left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn departure(time: f64, side: f64, rotation: f64, velocity: f64) -> Departure {
        Departure { ground: Ground::Shaking, time, side, rotation, velocity }
    }

    fn flights(motion: &Motion, eta: f64) -> Flights {
        Flights::new(&Body::new(eta, None).unwrap(), motion).unwrap()
    }

    fn impact(flights: &Flights, from: &Departure) -> (f64, f64) {
        match flights.fly(from, 100.0) {
            Arrival::Impact { interval, speed } => (interval, speed),
            other => panic!("{from:?}: {other:?}"),
        }
    }

    /// On still ground `T = 2 artanh v`, and it lands as it left, however short the flight; from half of alpha after `arcosh 2`.
    #[test]
    fn free_flights_are_the_closed_form_to_the_last_digit() {
        let flights = flights(&Motion::one_sine(1.1, 2.0).unwrap(), 0.9);
        for velocity in [0.9, 0.3, 1e-3, 1e-12, 1e-60] {
            let from = Departure { ground: Ground::Still, ..departure(5.0, -1.0, 0.0, velocity) };
            let (interval, speed) = impact(&flights, &from);
            assert!((interval / (2.0 * velocity.atanh()) - 1.0).abs() < 4e-16, "{velocity}: {interval}");
            assert!((speed / velocity - 1.0).abs() < 4e-16, "{velocity}: {speed}");
        }
        let (interval, speed) = impact(&flights, &Departure { ground: Ground::Still, ..departure(0.0, 1.0, 0.5, 0.0) });
        assert!((interval - 2_f64.acosh()).abs() < 1e-15 && (speed - 0.75_f64.sqrt()).abs() < 1e-15);
        // Over the balance it does not come back.
        let over = Departure { ground: Ground::Still, ..departure(0.0, 1.0, 1.1, 0.0) };
        assert!(matches!(flights.fly(&over, 10.0), Arrival::Overturned { after } if after < 2.0));
    }

    /// A sinusoid from its threshold is that of the case, impact by impact.
    #[test]
    fn a_sinusoid_is_that_of_the_case() {
        let (a, omega, eta) = (1.03, 2.0, 0.92);
        let case = contract::Case::from_amplitude(a, omega, eta).unwrap().with_max_impacts(12).unwrap();
        let own = contract::Oracle::history(&crate::Printed::default(), &case).unwrap();
        let term = Sinusoid { amplitude: a, omega, phase: (1.0_f64 / a).asin() };
        let flights =
            flights(&Motion::sinusoids(vec![Stretch { until: f64::INFINITY, terms: vec![term] }]).unwrap(), eta);
        let mut from = departure(0.0, -1.0, 0.0, 0.0);
        for expected in own.impacts {
            let (interval, speed) = impact(&flights, &from);
            // The phase and the times are rounded here.
            assert!((interval / expected.interval - 1.0).abs() < 1e-12, "{interval} {expected:?}");
            assert!(flights.motion(&from, interval).0.abs() < 1e-15);
            from = departure(expected.time, -from.side, 0.0, eta * speed);
        }
    }

    /// Check values to 24 digits, by another method: the rest of the first rocking of a pulse lies where the impacts lead, and is certain before.
    #[test]
    fn a_sine_pulse_is_followed_into_rest() {
        let flights = flights(&Motion::one_sine(1.02, 2.0).unwrap(), 0.6);
        let mut from = departure((1.0_f64 / 1.02).asin() / 2.0, -1.0, 0.0, 0.0);
        let mut certain = None;
        for n in 0..60 {
            let (interval, speed) = impact(&flights, &from);
            from = departure(from.time + interval, -from.side, 0.0, 0.6 * speed);
            if certain.is_none() && flights.rests(&from) {
                certain = Some(n);
            }
        }
        assert!((from.time - 1.158_296_102_357_346).abs() < 2e-14, "{}", from.time);
        assert!(certain.is_some_and(|n| (3..30).contains(&n)), "{certain:?}");
        // Nothing pushes before the threshold, nor does it rest where the pulse ends before it can.
        assert_eq!(flights.fly(&departure(0.3, -1.0, 0.0, 0.0), 1.0), Arrival::Lost(Loss::Stalled));
        assert!(!flights.rests(&departure(std::f64::consts::PI - 1e-4, 1.0, 0.0, 1e-4)));
    }

    #[test]
    fn other_motions_are_declined() {
        let body = Body::new(0.9, None).unwrap();
        let term = Sinusoid { amplitude: 1.0, omega: 2.0, phase: 0.0 };
        let sum = Motion::sinusoids(vec![Stretch { until: 1.0, terms: vec![term, term] }]).unwrap();
        let record = Motion::record(0.1, 1.0, vec![0.0, 1.0]).unwrap();
        for motion in [sum, record] {
            assert!(matches!(Flights::new(&body, &motion), Err(Decline::Unsupported { .. })));
        }
    }
}
