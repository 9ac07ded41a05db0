//! From rest to rest: the block waits for the threshold, rocks, and comes to rest again or falls.

use std::sync::Arc;

use contract::{Arrival, Departure, Estimate, FlightSolver, Ground};

use super::{
    Bout, BoutEnd, OnMotion, Request, Response, TOUCH,
    fall::{Fall, Fallen},
    lobes::{Lobe, Lobes},
    shaken::Shaken,
    tail::Tail,
    termination::Termination,
};
use crate::{
    measure::ground::{fastest, strongest},
    motion::walk::Walk,
};

/// Follows the block from rest at `τ = 0`.
pub(super) fn follow(request: &Request, solver: &dyn FlightSolver) -> Response {
    let case = &request.case;
    let runner = Runner {
        solver,
        eta: case.eta(),
        ground: Shaken::Sinusoid(Lobes::new(case, request.phase)),
        termination: request.termination,
        strength: (case.amplitude(), case.omega()),
        alpha: case.slenderness().map(|slenderness| slenderness.alpha()),
        lies_at: request.lies_at,
        lasts: request.lasts.unwrap_or(f64::INFINITY),
        until: request.until,
        passes_touches: false,
    };
    runner.follow(None, request.lasts, request.most_impacts)
}

/// Follows the block on ground that moves in any way, from the start that is asked for.
pub(super) fn follow_motion(request: &OnMotion, solver: &dyn FlightSolver) -> Response {
    follow_any(request, solver, false)
}

/// The same of a motion that is moved by some roundings: where only these make the ground push, so shortly that the solver can't follow it, the block stays at rest.
pub(super) fn follow_moved(request: &OnMotion, solver: &dyn FlightSolver) -> Response {
    follow_any(request, solver, true)
}

fn follow_any(request: &OnMotion, solver: &dyn FlightSolver, passes_touches: bool) -> Response {
    let lasts = request.motion.duration();
    let runner = Runner {
        solver,
        eta: request.body.eta(),
        ground: Shaken::Motion(Arc::clone(&request.motion)),
        termination: request.termination,
        strength: (strongest(&request.motion), fastest(&request.motion)),
        alpha: request.body.alpha(),
        lies_at: request.lies_at,
        lasts,
        until: request.until,
        passes_touches,
    };
    let (rotation, velocity) = request.start;
    let moves = (rotation, velocity) != (0.0, 0.0);
    // From the base it goes the way that its velocity has.
    let side = if rotation == 0.0 { velocity } else { rotation }.signum();
    let start = moves.then_some((side, side * rotation, side * velocity));
    runner.follow(start, lasts.is_finite().then_some(lasts), request.most_impacts)
}

struct Runner<'a> {
    solver: &'a dyn FlightSolver,
    eta: f64,
    ground: Shaken,
    termination: Termination,
    /// Bounds on the ground acceleration, and on how fast it changes.
    strength: (f64, f64),
    alpha: Option<f64>,
    lies_at: Option<f64>,
    lasts: f64,
    until: f64,
    passes_touches: bool,
}

impl Runner<'_> {
    /// From rest to rest, and on; from a side, rotation and velocity at first, or from rest.
    fn follow(self, mut moving: Option<(f64, f64, f64)>, lasts: Option<f64>, most_impacts: usize) -> Response {
        let mut bouts: Vec<Bout> = Vec::new();
        let mut again: Option<Bout> = None;
        let mut left = most_impacts;
        let mut now = 0.0;
        let mut lying = None;
        let end = loop {
            let state = moving.take();
            let departure = match state {
                Some(_) => Some((Lobe { start: 0.0, mirror: 1.0 }, 0.0)),
                None => self.ground.departure(now).filter(|(_, start)| *start < self.lasts && *start < self.until),
            };
            let Some((lobe, start)) = departure else {
                // Nothing can happen any more; the motion of the ground may still go on, or have ended while the block rocked.
                let end = self.lasts.max(now).min(self.until);
                break if end.is_finite() { end } else { now };
            };
            let bout = match again.as_ref().and_then(|bout| self.repeated(bout, lobe, start)) {
                Some(same) => same,
                None => {
                    let (bout, lies) = self.bout(lobe, start, state, left);
                    lying = lies.map(|rotation| lobe.mirror * rotation);
                    left = left.saturating_sub(bout.impacts());
                    bout
                }
            };
            if again.is_none() && self.can_be_repeated(&bout) {
                again = Some(bout.clone());
            }
            if self.passes_touches
                && let Some(after) = self.after_touch(&bout)
            {
                now = after;
                continue;
            }
            now = bout.end();
            let rests = bout.outcome.is_rest();
            bouts.push(bout);
            if !rests {
                break now;
            }
        };
        Response { ground: self.ground, lasts, bouts, lying, end }
    }

    /// When a bout is over in which the solver lost the block at once, or never came to an end of it, if the ground no more than touches the threshold there.
    fn after_touch(&self, bout: &Bout) -> Option<f64> {
        let after = bout.begin() * (1.0 + TOUCH);
        let is_lost = matches!(bout.outcome, BoutEnd::Lost(_) | BoutEnd::TooManyImpacts) && bout.end() <= after;
        (is_lost && self.ground.acceleration(after).abs() <= 1.0).then_some(after)
    }

    /// Whether a bout started from rest at the threshold and was over before the ground motion or the response ends: then it is the same each time.
    fn can_be_repeated(&self, bout: &Bout) -> bool {
        let is_same = matches!(self.ground, Shaken::Sinusoid(_));
        is_same && bout.start == 0.0 && bout.outcome.is_rest() && self.is_over(bout, bout.lobe)
    }

    fn is_over(&self, bout: &Bout, lobe: Lobe) -> bool {
        lobe.start + bout.duration <= self.lasts.min(self.until)
    }

    /// The same bout again, a whole number of half periods later and mirrored if they are odd, if that is over in time as well.
    fn repeated(&self, earlier: &Bout, lobe: Lobe, start: f64) -> Option<Bout> {
        let same = start == lobe.start && self.is_over(earlier, lobe);
        same.then(|| Bout { lobe, ..earlier.clone() })
    }

    /// From rest at `start`, in a lobe of the excitation, until the block rests, falls or the response ends; and the rotation at which it lies, if it does.
    /// Times are counted from the start of the lobe.
    fn bout(&self, lobe: Lobe, start: f64, moving: Option<(f64, f64, f64)>, most: usize) -> (Bout, Option<f64>) {
        let since = lobe.since(start);
        let (shaken, until) = (self.lasts - lobe.start, self.until - lobe.start);
        let solver = &self.ground.seen(self.solver, lobe);
        let fall = Fall::new(solver, self.strength, self.alpha, self.lies_at);
        let mut walk = match moving {
            None => Walk::from_rest(solver, self.eta, since, shaken, until),
            Some((side, rotation, velocity)) => {
                let departure = Departure { ground: Ground::Shaking, time: since, side, rotation, velocity };
                Walk::from(solver, self.eta, departure, shaken, until)
            }
        };
        let mut flights = Vec::new();
        let mut tail = Tail::default();
        let (mut impacts, mut ground) = (0, Ground::Shaking);
        let mut lying = None;
        let (outcome, duration) = loop {
            let Some(flight) = walk.fly() else { break (BoutEnd::Cut, walk.now()) };
            if let Arrival::Lost(loss) = flight.arrival {
                break (BoutEnd::Lost(loss), flight.start);
            }
            if let Some(Fallen { end, lies }) = fall.follow(&mut walk, &flight, &mut flights) {
                lying = lies;
                break (BoutEnd::Overturned, end);
            }
            flights.push(flight);
            let Arrival::Impact { interval, .. } = flight.arrival else { continue };
            impacts += 1;
            let (now, departure) = (walk.now(), walk.departure());
            if departure.ground != ground {
                (tail, ground) = (Tail::default(), departure.ground);
            }
            if let Some(end) = self.rest((solver, lobe), &departure, now - since, &mut tail, interval, now)
                && (departure.ground == Ground::Still || end.1 <= shaken)
            {
                break end;
            }
            if impacts >= most {
                break (BoutEnd::TooManyImpacts, now);
            }
        };
        (Bout { lobe, start: since, duration, flights: Arc::new(flights), outcome, conditioning: 0.0 }, lying)
    }

    /// Whether the block rests after this impact, and when.
    fn rest(
        &self,
        (solver, lobe): (&dyn FlightSolver, Lobe),
        departure: &Departure,
        since: f64,
        tail: &mut Tail,
        interval: f64,
        now: f64,
    ) -> Option<(BoutEnd, f64)> {
        match self.termination {
            Termination::VelocityThreshold(threshold) => {
                return (departure.velocity <= threshold).then_some((BoutEnd::VelocityThreshold, now));
            }
            // The scheme is of the shaking alone; and it does not end where the impacts accumulate before its time, so there the sum is closed.
            Termination::ChatteringThreshold(time) if departure.ground == Ground::Shaking && since >= time => {
                return Some((BoutEnd::ChatteringThreshold, now));
            }
            Termination::ChatteringThreshold(_) | Termination::Exact => {}
        }
        // On shaking ground it rests before the ground pushes it away again.
        let latest = match departure.ground {
            Ground::Shaking => self.ground.latest(lobe, now),
            Ground::Still => f64::INFINITY,
        };
        let Estimate { value, uncertainty } = tail.rest(solver, (departure, interval, now), self.eta, latest)?;
        Some((BoutEnd::Complete { uncertainty }, value))
    }
}
