//! What a response has to be, and how well that is known: the plain follower's, beside two of the same problem with every number moved a little. How far
//! they part says what an error in a flight comes to later on; where they part altogether the problem does not say what happens, and nothing is compared
//! from there on.

use contract::Model;

use super::{
    follower::{Followed, follow},
    problem::Problem,
    whole::{Bout, BoutEnding},
};
use crate::cases::shaking::Question;

/// By how much the numbers of a problem are moved, relative.
const MOVED: f64 = 1e-8;
/// What the plain follower's own flights are worth, as [`Responder::accuracy`](super::Responder::accuracy).
const OWN: f64 = 2e-12;
/// By how much the numbers of a question are rounded in another form.
const ROUNDED: f64 = 4.0 * f64::EPSILON;
/// Speeds that differ by this share are of flights that are not the same any more.
const PARTED: f64 = 0.02;

/// The response that others are held against.
pub(super) struct Reference {
    pub nominal: Followed,
    moved: [Followed; 2],
    /// Of the bouts that are known, how well.
    pub known: Vec<Known>,
    /// From when on it is too close to call what happens; infinite where it is known to the end.
    pub until: f64,
}

/// What the bouts of a response have to be, and how well that is known.
pub(super) struct Expected<'a> {
    pub bouts: &'a [Bout],
    /// Of the first of them.
    pub known: &'a [Known],
    /// From when on it is too close to call what happens.
    pub until: f64,
    /// Whether a block that still rocks where the response ends would overturn, so that it may be said to.
    pub falls: bool,
}

/// By how much a bout moves with the problem.
#[derive(Debug, Clone, Default)]
pub(super) struct Known {
    pub begin: f64,
    /// Of the impacts that are known: the time, and the speed relative.
    pub impacts: Vec<(f64, f64)>,
    /// Of when it ends and of its peak; `None` where it is too close to call how it ends.
    pub ending: Option<(f64, f64)>,
}

impl Reference {
    /// The reference for `question` under the equation of `model`; `None` where that lacks a slenderness.
    pub fn new(question: &Question, model: Model) -> Option<Self> {
        let problem = Problem::new(question, model)?;
        let moved = [MOVED, -MOVED].map(|by| follow(problem.moved(by)));
        let nominal = follow(problem);
        let mut reference = Self { nominal, moved, known: Vec::new(), until: f64::INFINITY };
        let mut spread = Spread::default();
        for (k, bout) in reference.nominal.bouts.iter().enumerate() {
            let [one, two] = [0, 1].map(|place| reference.moved.get(place).and_then(|moved| moved.bouts.get(k)));
            let Some(known) = one.zip(two).and_then(|(one, two)| spread.bout(bout, [one, two])) else {
                reference.until = bout.begin;
                return Some(reference);
            };
            let ends = known.ending.is_some();
            if !ends {
                let last = known.impacts.len().checked_sub(1).and_then(|last| bout.impacts.get(last));
                reference.until = last.map_or(bout.begin, |last| last.time);
            }
            reference.known.push(known);
            if !ends {
                return Some(reference);
            }
        }
        let unlike = reference.moved.iter().any(|moved| moved.falls != reference.nominal.falls);
        if let (true, Some(last), Some(bout)) = (unlike, reference.known.last_mut(), reference.nominal.bouts.last()) {
            last.ending = None;
            reference.until = bout.end;
        }
        let bouts = reference.nominal.bouts.len();
        if let Some(more) = reference.moved.iter().find_map(|moved| moved.bouts.get(bouts)) {
            reference.until = more.begin;
        }
        Some(reference)
    }

    /// What another response has to be.
    pub fn expected(&self) -> Expected<'_> {
        Expected { bouts: &self.nominal.bouts, known: &self.known, until: self.until, falls: self.nominal.falls }
    }

    /// By what an error of the follower and of a method of this accuracy is larger than what moving the problem shows.
    pub fn scale(accuracy: f64) -> f64 {
        (accuracy + OWN) / MOVED
    }

    /// The same of the errors of one method of this accuracy in two answers; the numbers of a question in another form are rounded.
    pub fn scale_of_two(accuracy: f64) -> f64 {
        (2.0 * accuracy + ROUNDED) / MOVED
    }

    /// The rotation and its velocity at a time, and how far they move with the problem.
    pub fn at(&self, time: f64) -> ((f64, f64), (f64, f64)) {
        let (rotation, velocity) = self.nominal.at(time);
        let spread = self.moved.iter().map(|moved| moved.at(time)).fold((0.0_f64, 0.0_f64), |spread, moved| {
            (spread.0.max((moved.0 - rotation).abs()), spread.1.max((moved.1 - velocity).abs()))
        });
        ((rotation, velocity), spread)
    }
}

/// The largest so far: differences change their sign on the way.
#[derive(Debug, Clone, Copy, Default)]
struct Spread {
    time: f64,
    speed: f64,
}

impl Spread {
    /// How well a bout is known; `None` where it is not known that it begins.
    fn bout(&mut self, bout: &Bout, moved: [&Bout; 2]) -> Option<Known> {
        let largest =
            |of: &dyn Fn(&Bout) -> f64| moved.iter().map(|moved| (of(moved) - of(bout)).abs()).fold(0.0, f64::max);
        let begin = largest(&|bout| bout.begin);
        if moved.iter().any(|moved| moved.side != bout.side) || begin > PARTED {
            return None;
        }
        // Where it began from rest at the threshold, what was before is forgotten.
        *self = Self { time: begin, speed: 0.0 };
        let mut known = Known { begin, ..Known::default() };
        let counts = moved.map(|moved| moved.impacts.len());
        let same = moved.iter().all(|moved| moved.outcome == bout.outcome) && bout.outcome != BoutEnding::GivenUp;
        let rests = same && bout.outcome == BoutEnding::Rest;
        for (n, impact) in bout.impacts.iter().enumerate() {
            for other in moved.iter().filter_map(|moved| moved.impacts.get(n)) {
                self.time = self.time.max((other.time - impact.time).abs());
                self.speed = self.speed.max((other.before / impact.before - 1.0).abs());
            }
            let enough = counts.iter().all(|count| *count > n);
            if !enough && rests && n + 3 > bout.impacts.len() {
                // One more or less is resolved of infinitely many.
                break;
            }
            if !enough || self.speed.is_nan() || self.speed > PARTED {
                return Some(known);
            }
            known.impacts.push((self.time, self.speed));
        }
        let complete = rests || counts.iter().all(|count| *count == bout.impacts.len());
        if same && complete {
            let end = largest(&|bout| bout.end).max(self.time);
            known.ending = Some((end, largest(&|bout| bout.peak.unwrap_or_default())));
        }
        Some(known)
    }
}
