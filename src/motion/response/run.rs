//! The loop of events: rest until the threshold, flights and impacts, rest again.

use std::sync::Arc;

use contract::{Arrival, Departure, Estimate, FlightSolver, Ground, History, Impact, Uncertainty};

use super::{Bout, BoutEnd, Flight, Request, Response, lobes::Lobe, lobes::Lobes, termination::Rule};
use crate::measure::zeno;

/// A sum is closed once its error is at most this, relative to the time since the threshold.
const ACCURACY: f64 = 1e-13;
/// Impacts are resolved until what is left to the accumulation is this share of the time since the threshold: less is not seen in any picture.
const RESOLVED: f64 = 1e-9;
/// Or until so many have followed since it has been certain that the block comes to rest: more do not help.
const MOST_CERTAIN_IMPACTS: usize = 2000;
/// In what steps, and in how many, an overturning block is followed to where it falls.
const FALLING_STEP: f64 = 0.05;
const MOST_FALLING_STEPS: usize = 1000;
/// Impacts that closing a sum can use.
const USEFUL_IMPACTS: usize = 64;
/// What a flight solver leaves of rounding in each interval, relative; only for the error estimate of a closed sum.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Follows the block from rest at `τ = 0`.
pub(super) fn follow(request: &Request, solver: &dyn FlightSolver) -> Response {
    let lobes = Lobes::new(&request.case, request.phase);
    let runner = Runner {
        solver,
        eta: request.case.eta(),
        rule: request.termination.rule(&request.case),
        lasts: request.lasts.unwrap_or(f64::INFINITY),
        until: request.until,
    };
    let mut bouts: Vec<Bout> = Vec::new();
    let mut again: Option<Bout> = None;
    let mut left = request.most_impacts;
    let mut now = 0.0;
    let end = loop {
        let (lobe, start) = lobes.departure(now);
        if start >= runner.lasts || start >= runner.until {
            // Nothing can happen any more; the motion of the ground may still go on, or have ended while the block rocked.
            break runner.lasts.max(now).min(runner.until);
        }
        let bout = match again.as_ref().and_then(|bout| runner.repeated(bout, lobe, start)) {
            Some(same) => same,
            None => {
                let bout = runner.bout(lobe, start, left);
                left = left.saturating_sub(bout.impacts());
                bout
            }
        };
        if again.is_none() && runner.can_be_repeated(&bout) {
            again = Some(bout.clone());
        }
        now = bout.end();
        let rests = bout.outcome.is_rest();
        bouts.push(bout);
        if !rests {
            break now;
        }
    };
    Response { lobes, lasts: request.lasts, bouts, end }
}

struct Runner<'a> {
    solver: &'a dyn FlightSolver,
    eta: f64,
    rule: Rule,
    lasts: f64,
    until: f64,
}

/// A sum of times that are soon far smaller than it (Neumaier).
#[derive(Clone, Copy)]
struct Clock {
    high: f64,
    low: f64,
}

impl Clock {
    fn plus(self, interval: f64) -> Self {
        let high = self.high + interval;
        let part = if self.high >= interval { (self.high - high) + interval } else { (interval - high) + self.high };
        Self { high, low: self.low + part }
    }

    fn time(self) -> f64 {
        self.high + self.low
    }
}

impl Runner<'_> {
    /// Whether a bout started from rest at the threshold and was over before the ground motion or the response ends: then it is the same each time.
    fn can_be_repeated(&self, bout: &Bout) -> bool {
        bout.start == 0.0 && bout.outcome.is_rest() && self.is_over(bout, bout.lobe)
    }

    fn is_over(&self, bout: &Bout, lobe: Lobe) -> bool {
        lobe.start + bout.duration <= self.lasts.min(self.until)
    }

    /// The same bout again, a whole number of half periods later and mirrored if they are odd, if that is over in time as well.
    fn repeated(&self, earlier: &Bout, lobe: Lobe, start: f64) -> Option<Bout> {
        let same = start == lobe.start && self.is_over(earlier, lobe);
        same.then(|| Bout { lobe, ..earlier.clone() })
    }

    /// From rest at `start`, in a lobe of the excitation, until the block rests or the response ends. Times are counted from the start of the lobe.
    fn bout(&self, lobe: Lobe, start: f64, most: usize) -> Bout {
        let origin = lobe.start;
        let since = start - origin;
        let mut clock = Clock { high: since, low: 0.0 };
        let mut departure =
            Departure { ground: Ground::Shaking, time: since, side: -1.0, rotation: 0.0, velocity: 0.0 };
        let mut flights = Vec::new();
        let mut tail = Tail::default();
        let mut impacts = 0;
        let (outcome, duration) = loop {
            let now = clock.time();
            let shaken = self.lasts - origin;
            if departure.ground == Ground::Shaking && now >= shaken {
                departure.ground = Ground::Still;
                tail = Tail::default();
            }
            let horizon =
                if departure.ground == Ground::Shaking { shaken.min(self.until - origin) } else { self.until - origin };
            if now >= self.until - origin {
                break (BoutEnd::Cut, now);
            }
            let arrival = self.solver.fly(&departure, horizon - now);
            let duration = match arrival {
                Arrival::Impact { interval, .. } => interval,
                Arrival::Aloft { .. } => horizon - now,
                Arrival::Overturned { after } => self.past_the_corner(&departure, after),
                Arrival::Lost(loss) => break (BoutEnd::Lost(loss), now),
            };
            flights.push(Flight { start: now, duration, departure, arrival });
            match arrival {
                Arrival::Impact { interval, speed } => {
                    clock = clock.plus(interval);
                    impacts += 1;
                    let now = clock.time();
                    departure = Departure {
                        time: now,
                        side: -departure.side,
                        rotation: 0.0,
                        velocity: self.eta * speed,
                        ..departure
                    };
                    if let Some(end) = self.rest(&departure, now - since, &mut tail, interval, now)
                        && (departure.ground == Ground::Still || end.1 <= shaken)
                    {
                        break end;
                    }
                    if impacts >= most {
                        break (BoutEnd::TooManyImpacts, now);
                    }
                }
                Arrival::Aloft { rotation, velocity } => {
                    clock = Clock { high: horizon, low: 0.0 };
                    departure = Departure { time: horizon, rotation, velocity, ..departure };
                }
                Arrival::Overturned { .. } => break (BoutEnd::Overturned, now + duration),
                Arrival::Lost(loss) => break (BoutEnd::Lost(loss), now),
            }
        };
        Bout { lobe, start: since, duration, flights: Arc::new(flights), outcome }
    }

    /// How long a flight that is certain to overturn is followed: until its centre of mass is over the corner at least, `|φ| = 1`.
    fn past_the_corner(&self, departure: &Departure, mut after: f64) -> f64 {
        for _ in 0..MOST_FALLING_STEPS {
            if self.solver.motion(departure, after).0 >= 1.0 {
                break;
            }
            after += FALLING_STEP;
        }
        after
    }

    /// Whether the block rests after this impact, and when.
    fn rest(
        &self,
        departure: &Departure,
        since: f64,
        tail: &mut Tail,
        interval: f64,
        now: f64,
    ) -> Option<(BoutEnd, f64)> {
        match self.rule {
            Rule::Speed(threshold) => {
                return (departure.velocity <= threshold).then_some((BoutEnd::VelocityThreshold, now));
            }
            // The scheme is of the shaking alone; and it does not end where the impacts accumulate before its time, so there the sum is closed.
            Rule::Time(time) if departure.ground == Ground::Shaking && since >= time => {
                return Some((BoutEnd::ChatteringThreshold, now));
            }
            Rule::Time(_) | Rule::Exact => {}
        }
        tail.push(departure, interval, now);
        if !self.solver.rests(departure) {
            return None;
        }
        tail.certain += 1;
        let most = tail.certain >= MOST_CERTAIN_IMPACTS;
        if !most && tail.left(self.eta) > RESOLVED * now {
            return None;
        }
        let sum = tail.close(self.eta)?;
        let enough = sum.uncertainty <= ACCURACY * sum.value || most;
        enough.then_some((BoutEnd::Complete { uncertainty: sum.uncertainty }, sum.value))
    }
}

/// The last impacts under one kind of ground motion.
#[derive(Default)]
struct Tail {
    impacts: Vec<Impact>,
    /// How many impacts there were since rest was certain.
    certain: usize,
}

impl Tail {
    fn push(&mut self, departure: &Departure, interval: f64, time: f64) {
        if self.impacts.len() >= 2 * USEFUL_IMPACTS {
            self.impacts.drain(..USEFUL_IMPACTS);
        }
        let uncertainty = Uncertainty { time: f64::EPSILON * time, interval: ROUNDING, velocity: ROUNDING };
        self.impacts.push(Impact { time, interval, velocity: departure.side * departure.velocity, uncertainty });
    }

    /// What is about left, by Eq. 75.
    fn left(&self, eta: f64) -> f64 {
        let last: f64 = self.impacts.iter().rev().take(2).map(|impact| impact.interval).sum();
        last * eta * eta / (1.0 - eta * eta)
    }

    /// When the infinitely many impacts accumulate.
    fn close(&mut self, eta: f64) -> Option<Estimate> {
        let impacts = std::mem::take(&mut self.impacts);
        let history = History { impacts, ending: contract::Ending::AtRest, chattering_time: None };
        let sum = zeno::close(&history, eta);
        self.impacts = history.impacts;
        sum
    }
}
