//! From rest to rest: the block waits for the threshold, rocks, and comes to rest again or falls.

use std::sync::Arc;

use contract::{Arrival, Departure, Estimate, FlightSolver, Ground};

use super::{
    Bout, BoutEnd, Request, Response,
    fall::{Fall, Fallen},
    lobes::{Lobe, Lobes},
    tail::Tail,
    termination::Termination,
};
use crate::motion::walk::Walk;

/// Follows the block from rest at `τ = 0`.
pub(super) fn follow(request: &Request, solver: &dyn FlightSolver) -> Response {
    let lobes = Lobes::new(&request.case, request.phase);
    let runner = Runner {
        solver,
        eta: request.case.eta(),
        half_period: lobes.half_period(),
        termination: request.termination,
        fall: Fall::new(solver, &request.case, request.lies_at),
        lasts: request.lasts.unwrap_or(f64::INFINITY),
        until: request.until,
    };
    let mut bouts: Vec<Bout> = Vec::new();
    let mut again: Option<Bout> = None;
    let mut left = request.most_impacts;
    let mut now = 0.0;
    let mut lying = None;
    let end = loop {
        let (lobe, start) = lobes.departure(now);
        if start >= runner.lasts || start >= runner.until {
            // Nothing can happen any more; the motion of the ground may still go on, or have ended while the block rocked.
            break runner.lasts.max(now).min(runner.until);
        }
        let bout = match again.as_ref().and_then(|bout| runner.repeated(bout, lobe, start)) {
            Some(same) => same,
            None => {
                let (bout, lies) = runner.bout(lobe, start, left);
                lying = lies.map(|rotation| lobe.mirror * rotation);
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
    Response { lobes, lasts: request.lasts, bouts, lying, end }
}

struct Runner<'a> {
    solver: &'a dyn FlightSolver,
    eta: f64,
    half_period: f64,
    termination: Termination,
    fall: Fall<'a>,
    lasts: f64,
    until: f64,
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

    /// From rest at `start`, in a lobe of the excitation, until the block rests, falls or the response ends; and the rotation at which it lies, if it does.
    /// Times are counted from the start of the lobe.
    fn bout(&self, lobe: Lobe, start: f64, most: usize) -> (Bout, Option<f64>) {
        let since = lobe.since(start);
        let shaken = self.lasts - lobe.start;
        let mut walk = Walk::from_rest(self.solver, self.eta, since, shaken, self.until - lobe.start);
        let mut flights = Vec::new();
        let mut tail = Tail::default();
        let (mut impacts, mut ground) = (0, Ground::Shaking);
        let mut lying = None;
        let (outcome, duration) = loop {
            let Some(flight) = walk.fly() else { break (BoutEnd::Cut, walk.now()) };
            if let Arrival::Lost(loss) = flight.arrival {
                break (BoutEnd::Lost(loss), flight.start);
            }
            if let Some(Fallen { end, lies }) = self.fall.follow(&mut walk, &flight, &mut flights) {
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
            if let Some(end) = self.rest(&departure, now - since, &mut tail, interval, now)
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
            Ground::Shaking => ((now / self.half_period).floor() + 1.0) * self.half_period,
            Ground::Still => f64::INFINITY,
        };
        let Estimate { value, uncertainty } = tail.rest(self.solver, (departure, interval, now), self.eta, latest)?;
        Some((BoutEnd::Complete { uncertainty }, value))
    }
}
