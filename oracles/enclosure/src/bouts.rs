//! Whole responses on ground that moves in any way: from rest to rest, and on.

use contract::{Body, Followed, Motion as GroundMotion};

use crate::{
    directed::Directed,
    flight::{From, Outcome, Takeoff},
    ground::Ground,
    interval::Interval,
    piece::Motion,
    pull::Side,
    rest,
    sequence::{Impact, slowest},
    shaking::{Moment, Push, Shaking},
};

/// A bout.
pub struct Bout<F> {
    pub begin: Interval<F>,
    pub side: Side,
    pub impacts: Vec<Impact<F>>,
    pub end: BoutEnd<F>,
}

/// How a bout ends.
pub enum BoutEnd<F> {
    /// With rest.
    Rest(Interval<F>),
    /// No return is possible.
    Overturned,
    /// The block is in the air when the response ends.
    Aloft,
    /// It was followed no further, because it is long.
    Exhausted,
    /// Not with these digits.
    Unclear,
}

/// What is asked.
pub struct Asked<'a> {
    pub body: &'a Body,
    pub motion: &'a GroundMotion,
    pub followed: &'a Followed,
    /// How wide the time of a rest may be, relative to itself.
    pub width: f64,
    /// How many times the usual effort is spent.
    pub patience: usize,
}

/// Later than any response ends.
const FOREVER: f64 = 1e9;
/// How many impacts of a bout are followed.
const MOST_IMPACTS: usize = 50_000;

/// Follows the block; `None` where it is not clear whether it ever rocks. Where it is not clear whether it rocks again, the last bout has no clear end: whoever reads a
/// last rest takes it that the block rests from there on.
pub fn follow<F: Directed>(asked: &Asked<'_>) -> Option<Vec<Bout<F>>> {
    let ground = Shaking::<F>::new(asked.motion);
    let alpha = asked.body.alpha();
    let motion = Motion::new(ground.amplitude(), ground.rate, alpha).patient(asked.patience);
    let run = Run { asked, ground, motion };
    let mut bouts: Vec<Bout<F>> = Vec::new();
    let mut departure = run.first();
    loop {
        let (moment, side, from) = match departure {
            Departure::At(moment, side, from) => (moment, side, from),
            Departure::Never => return Some(bouts),
            Departure::Unclear => {
                bouts.last_mut()?.end = BoutEnd::Unclear;
                return Some(bouts);
            }
        };
        let (bout, last) = run.bout(moment, side, from);
        let rests = matches!(bout.end, BoutEnd::Rest(_));
        bouts.push(bout);
        match last.filter(|_| rests) {
            Some(last) => departure = run.next(&last),
            None => return Some(bouts),
        }
    }
}

/// How a bout starts.
enum Departure<F> {
    At(Moment<F>, Side, From<F>),
    Never,
    Unclear,
}

struct Run<'a, F> {
    asked: &'a Asked<'a>,
    ground: Shaking<F>,
    motion: Motion<F>,
}

impl<F: Directed> Run<'_, F> {
    fn first(&self) -> Departure<F> {
        let (rotation, velocity) = self.asked.followed.start;
        let start = self.ground.start();
        if rotation == 0.0 && velocity == 0.0 {
            return self.next(&start);
        }
        let side = if rotation > 0.0 || rotation == 0.0 && velocity > 0.0 { Side::Plus } else { Side::Minus };
        let (distance, velocity) = (side.of(&Interval::exactly(rotation)), side.of(&Interval::exactly(velocity)));
        let from = if rotation == 0.0 { From::Impact(velocity) } else { From::Air(distance, velocity) };
        Departure::At(start, side, from)
    }

    /// From rest.
    fn next(&self, rests: &Moment<F>) -> Departure<F> {
        match self.ground.next_push(rests, self.asked.followed.until) {
            Push::At { moment, .. } if !(moment.time.lower.double_below() < self.asked.followed.until) => {
                Departure::Never
            }
            Push::At { moment, side, jumps } => {
                Departure::At(moment, side, if jumps { From::Jump } else { From::Threshold })
            }
            Push::Never => Departure::Never,
            Push::Unclear => Departure::Unclear,
        }
    }

    /// One bout, and its last impact.
    fn bout(&self, start: Moment<F>, side: Side, from: From<F>) -> (Bout<F>, Option<Moment<F>>) {
        let eta = self.asked.body.eta();
        // A number that every format has, and far enough for all that a block does.
        let until = Interval::exactly(self.asked.followed.until.min(FOREVER));
        let mut bout = Bout { begin: start.time.clone(), side, impacts: Vec::new(), end: BoutEnd::Unclear };
        let (mut moment, mut side, mut from) = (start, side, from);
        let mut rest: Option<Interval<F>> = None;
        for _ in 0..MOST_IMPACTS {
            let takeoff = Takeoff { horizon: &until - &moment.time, moment: moment.clone(), side, from };
            let (interval, landing) = match self.motion.fly(&self.ground, takeoff) {
                Outcome::Landing { interval, speed, moment: at } => {
                    moment = at;
                    (interval, speed)
                }
                Outcome::Aloft => return (Bout { end: BoutEnd::Aloft, ..bout }, None),
                Outcome::Overturned => return (Bout { end: BoutEnd::Overturned, ..bout }, None),
                Outcome::Unclear => break,
            };
            side = side.other();
            let speed = &Interval::exactly(eta) * &landing;
            if bout.impacts.len() < self.asked.followed.most_impacts {
                let impact = Impact { time: moment.time.clone(), interval, speed: speed.clone(), side };
                bout.impacts.push(impact);
            }
            if let Some(left) = rest::time_left(&self.motion, &self.ground, &moment, side, &speed, eta) {
                let closed = &moment.time + &left;
                let known = rest.map_or_else(|| closed.clone(), |before| before.and(&closed));
                let enough = left.width() <= self.asked.width * moment.time.middle().max(f64::MIN_POSITIVE)
                    || left.width() <= moment.time.width();
                let listed = bout.impacts.len() >= self.asked.followed.most_impacts
                    || speed.upper.double_above() < slowest::<F>();
                // Where the response ends before, it is followed to there.
                let in_time = known.is_below(&until);
                if enough && listed && in_time {
                    return (Bout { end: BoutEnd::Rest(known), ..bout }, Some(moment));
                }
                rest = Some(known);
            }
            from = From::Impact(speed);
        }
        let end = match rest {
            // What is proven is true, if it is wider than was asked.
            Some(rest) if rest.is_below(&until) => BoutEnd::Rest(rest),
            _ if self.motion.exhausted() => BoutEnd::Exhausted,
            _ => BoutEnd::Unclear,
        };
        (Bout { end, ..bout }, Some(moment))
    }
}
