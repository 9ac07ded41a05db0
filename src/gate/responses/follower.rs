//! A whole response by plain means, to hold the others against: in absolute time, on the ground as it is written, one step after the other, each flight
//! until the rotation changes its sign. It shares no code with what it checks, neither that of the flights nor that of the events between them.

use super::{
    knot::Knot,
    landing::{self, Advance},
    problem::Problem,
    whole::{Bout, BoutEnding, Impact},
};

/// Flights are resolved until the sum of those that are left is known to this.
const RESOLVED: f64 = 3e-11;
/// And is this share at the most of the time for which the ground stays as it is.
const SHARE: f64 = 1e-3;
/// Flights shorter than this tell nothing any more on a clock that shows absolute time.
const SHORTEST: f64 = 1e-11;
/// What is followed at the most, in one bout.
const MOST_IMPACTS: usize = 60_000;
/// And in steps, which bounds the work where something is wrong.
const MOST_STEPS: usize = 400_000;

/// A response with the states that it went through.
#[derive(Debug, Clone)]
pub(super) struct Followed {
    pub problem: Problem,
    pub bouts: Vec<Bout>,
    /// Whether a block that still rocks where the response ends would overturn if it were followed.
    pub falls: bool,
    /// Of each bout, the states from which any other is found.
    tracks: Vec<Vec<Knot>>,
}

/// Follows the block from rest, or from where it starts.
pub(super) fn follow(problem: Problem) -> Followed {
    let mut followed = Followed { problem: problem.clone(), bouts: Vec::new(), falls: false, tracks: Vec::new() };
    let mut now = 0.0;
    let from_rest = |now: f64| {
        let (time, side) = problem.next_start(now).filter(|(begin, _)| *begin < problem.until)?;
        Some(Knot { time, side, state: (0.0, 0.0) })
    };
    let mut first = moving(problem.start);
    while let Some(knot) = first.take().or_else(|| from_rest(now)) {
        let (bout, track) = Rocking::new(&problem, knot).follow();
        now = bout.end;
        followed.falls = bout.outcome == BoutEnding::Cut && track.last().is_some_and(|last| falls(&problem, *last));
        let rests = bout.outcome == BoutEnding::Rest;
        followed.bouts.push(bout);
        followed.tracks.push(track);
        if !rests {
            break;
        }
    }
    followed
}

/// The knot of a block that does not start from rest: to the side that it is on, or moves to.
fn moving((rotation, velocity): (f64, f64)) -> Option<Knot> {
    let side = if rotation == 0.0 { velocity } else { rotation }.signum();
    let moves = rotation != 0.0 || velocity != 0.0;
    moves.then_some(Knot { time: 0.0, side, state: (side * rotation, side * velocity) })
}

impl Followed {
    /// The rotation and its velocity at a time; none of a block that rests, or has fallen out of sight.
    pub fn at(&self, time: f64) -> (f64, f64) {
        let bouts = self.bouts.iter().zip(&self.tracks);
        let Some((bout, track)) = bouts.take_while(|(bout, _)| bout.begin <= time).last() else { return (0.0, 0.0) };
        if bout.outcome == BoutEnding::Rest && time >= bout.impacts.last().map_or(bout.end, |last| last.time) {
            return (0.0, 0.0);
        }
        let after = track.partition_point(|knot| knot.time <= time);
        let Some(knot) = after.checked_sub(1).and_then(|last| track.get(last)) else { return (0.0, 0.0) };
        let (mut time_left, mut knot) = (time - knot.time, *knot);
        while time_left > 0.0 && knot.state.0.is_finite() {
            let h = time_left.min(self.problem.longest_step()).min(self.problem.until_change(knot.time));
            knot = knot.advanced(&self.problem, h);
            time_left -= h;
        }
        (knot.side * knot.state.0, knot.side * knot.state.1)
    }
}

/// Whether the flight that goes on from a state ends past the point of no return.
fn falls(problem: &Problem, mut knot: Knot) -> bool {
    for _ in 0..MOST_STEPS {
        if problem.is_lost(knot.time, knot.state.0, knot.state.1) {
            return true;
        }
        match landing::advance(problem, &knot, problem.until_change(knot.time), f64::INFINITY) {
            Advance::Aloft { knot: next, .. } => knot = next,
            Advance::Landed { .. } => return false,
        }
    }
    false
}

/// A bout in the making.
struct Rocking<'a> {
    problem: &'a Problem,
    begin: f64,
    side: f64,
    knot: Knot,
    track: Vec<Knot>,
    impacts: Vec<Impact>,
    /// The last two intervals, where both passed with the ground as it is.
    intervals: [Option<f64>; 2],
    /// When the flight began.
    since: f64,
    peak: f64,
    /// The peak of the flight so far.
    peak_of_flight: f64,
}

impl<'a> Rocking<'a> {
    fn new(problem: &'a Problem, knot: Knot) -> Self {
        Self {
            problem,
            begin: knot.time,
            side: knot.side,
            knot,
            track: Vec::new(),
            impacts: Vec::new(),
            intervals: [None; 2],
            since: knot.time,
            peak: 0.0,
            peak_of_flight: 0.0,
        }
    }

    fn follow(mut self) -> (Bout, Vec<Knot>) {
        for _ in 0..MOST_STEPS {
            if self.knot.time >= self.problem.until {
                let until = self.problem.until;
                return self.ended(BoutEnding::Cut, until, 0.0);
            }
            self.track.push(self.knot);
            let (u, w) = self.knot.state;
            if self.problem.is_lost(self.knot.time, u, w) || u >= self.problem.lies_at {
                let now = self.knot.time;
                return self.ended(BoutEnding::Overturned, now, 0.0);
            }
            let limit = (self.problem.until - self.knot.time).min(self.problem.until_change(self.knot.time));
            let advance = landing::advance(self.problem, &self.knot, limit, self.peak.max(self.peak_of_flight));
            if let Some(peak) = advance.peak() {
                self.peak_of_flight = self.peak_of_flight.max(peak);
            }
            match advance {
                Advance::Aloft { knot, .. } => {
                    if knot.time >= self.problem.change(self.knot.time) {
                        self.intervals = [None; 2];
                        self.since = f64::NAN;
                    }
                    self.knot = knot;
                }
                Advance::Landed { after, speed, .. } => {
                    if let Some((outcome, end, uncertainty)) = self.land(after, speed) {
                        return self.ended(outcome, end, uncertainty);
                    }
                }
            }
        }
        let now = self.knot.time;
        self.ended(BoutEnding::GivenUp, now, 0.0)
    }

    /// Takes an impact, and says how the bout ends if it does.
    fn land(&mut self, after: f64, speed: f64) -> Option<(BoutEnding, f64, f64)> {
        let problem = self.problem;
        let time = self.knot.time + after;
        // The interval apart from the clock, where the flight was one step; it is short then.
        let interval = if self.since == self.knot.time { after } else { time - self.since };
        let interval = Some(interval).filter(|interval| interval.is_finite());
        self.intervals = [self.intervals[1], interval];
        self.impacts.push(Impact { time, before: speed, after: Some(problem.eta * speed) });
        self.peak = self.peak.max(self.peak_of_flight);
        self.peak_of_flight = 0.0;
        self.knot = Knot { time, side: -self.knot.side, state: (0.0, problem.eta * speed) };
        self.since = time;
        if let [Some(one), Some(two)] = self.intervals {
            let squared = problem.eta * problem.eta;
            let left = (one + two) * squared / (1.0 - squared);
            let held = 1.0 - problem.ground(time).abs();
            // How the flights change, relative: on still ground by the square of their length; while it shakes by the time that they take beside that
            // in which what holds the block down does.
            let change = if time < problem.lasts {
                (one + two + left) * (1.0 + problem.slope(time)) / held
            } else {
                (one + two) * (one + two)
            };
            if held > 0.0 && left * change < RESOLVED && left < SHARE * problem.stays(time) {
                return Some((BoutEnding::Rest, time + left, left * change + 1e-15 * time));
            }
        }
        let given_up = interval.is_some_and(|interval| interval < SHORTEST) || self.impacts.len() >= MOST_IMPACTS;
        given_up.then_some((BoutEnding::GivenUp, time, 0.0))
    }

    fn ended(self, outcome: BoutEnding, end: f64, uncertainty: f64) -> (Bout, Vec<Knot>) {
        // Of a flight that does not land the peak is not that of a whole flight.
        let Self { begin, side, impacts, peak, track, .. } = self;
        (Bout { begin, side, impacts, outcome, end, uncertainty, peak: Some(peak) }, track)
    }
}
