//! When the ground next pushes a resting block off its base, proven to be the first time: where `|f|` passes 1, or jumps past it.

use super::{Acceleration, Kind, Moment, Shaking};
use crate::{directed::Directed, interval::Interval, pull::Side};

/// What comes next for a block at rest.
pub enum Push<F> {
    /// It is pushed off to this side.
    At {
        /// When.
        moment: Moment<F>,
        /// To which side it leaves: against the acceleration of the ground.
        side: Side,
        /// Whether it is pushed at once, where the ground jumps or starts; else the pull vanishes there.
        jumps: bool,
    },
    /// Nothing, until the time given or at any time.
    Never,
    /// Not with these digits.
    Unclear,
}

/// A cell of time is not halved below this share of the time in which the ground changes.
const SHORTEST: f64 = 1e-9;
/// How long a cell is at first, in units of that.
const CELL: f64 = 0.25;
/// How often a bracket is narrowed.
const MOST_NARROWINGS: usize = 100;

/// What is known of the ground in a cell.
enum Found<F> {
    Nothing,
    Crossing(Interval<F>, Side),
    Unclear,
}

impl<F: Directed> Shaking<F> {
    /// The first push from a moment on, at which the block rests.
    pub fn next_push(&self, from: &Moment<F>, until: f64) -> Push<F> {
        let mut moment = from.clone();
        // At the start of a part the ground may jump, or stand at the threshold; a block that has come to rest is held down.
        let mut is_start = from.part == 0 && from.time.width() == 0.0;
        loop {
            if !(moment.time.lower.double_below() < until) || moment.part >= self.parts() {
                return Push::Never;
            }
            if is_start {
                match self.push_at_start(&moment) {
                    Some(Push::Never) => {}
                    Some(push) => return push,
                    None => return Push::Unclear,
                }
            }
            match self.crossing(&moment, until) {
                Found::Crossing(time, side) => {
                    return Push::At { moment: Moment { time, ..moment }, side, jumps: false };
                }
                Found::Unclear => return Push::Unclear,
                Found::Nothing => {}
            }
            let Some(end) = self.end(moment.part) else { return Push::Never };
            moment = Moment { time: end, part: moment.part + 1 };
            is_start = true;
        }
    }

    /// Whether the ground pushes at the start of a part: `Never` if not there, `None` if that is not clear.
    fn push_at_start(&self, moment: &Moment<F>) -> Option<Push<F>> {
        let Acceleration { value, slope } = self.at_start(moment);
        let one = Interval::exactly(1.0);
        let size = value.absolute();
        if one.is_below(&size) {
            return Some(Push::At { moment: moment.clone(), side: against(&value), jumps: true });
        }
        if value.magnitude() < 1.0 {
            return Some(Push::Never);
        }
        // Just at the threshold it depends on where it goes from there.
        let is_one = size.lower == one.lower && size.upper == one.upper;
        let grows = if value.is_positive() { slope } else { -&slope };
        if is_one && grows.is_positive() {
            return Some(Push::At { moment: moment.clone(), side: against(&value), jumps: false });
        }
        (is_one && (grows.is_negative() || grows.magnitude() == 0.0)).then_some(Push::Never)
    }

    /// The first crossing in the rest of a part.
    fn crossing(&self, moment: &Moment<F>, until: f64) -> Found<F> {
        let end = self.end(moment.part);
        if self.most(moment.part).magnitude() <= 1.0 {
            return Found::Nothing;
        }
        if let Kind::Record(record) = &self.kind {
            return self.crossing_of_line(moment, &record.last(moment.part));
        }
        let scale = self.scale();
        let last = end.as_ref().map_or(f64::INFINITY, |end| end.upper.double_above()).min(until);
        let mut from = moment.time.lower.double_below();
        while from < last {
            let to = from + CELL * scale;
            let left = Interval::exactly(from);
            // The last cell ends where the part does.
            let right = match &end {
                Some(end) if to >= last => end.clone(),
                _ => Interval::exactly(to),
            };
            match self.cell(moment.part, &left, &right, SHORTEST * scale) {
                Found::Nothing => {}
                found => return found,
            }
            from = to;
        }
        Found::Nothing
    }

    /// Where a straight line that is within the threshold at a moment crosses it, if it ends beyond.
    fn crossing_of_line(&self, moment: &Moment<F>, last: &Interval<F>) -> Found<F> {
        let one = Interval::exactly(1.0);
        if last.magnitude() <= 1.0 {
            return Found::Nothing;
        }
        let Some(end) = self.end(moment.part).filter(|_| one.is_below(&last.absolute())) else { return Found::Unclear };
        let slope = self.acceleration(moment).slope;
        let threshold = if last.is_positive() { one } else { -&one };
        let root = &end - &(&(last - &threshold) / &slope);
        Found::Crossing(root.and(&moment.time.or(&end)), against(last))
    }

    /// The first crossing in a cell, if `|f|` is not above 1 where it begins.
    fn cell(&self, part: usize, left: &Interval<F>, right: &Interval<F>, shortest: f64) -> Found<F> {
        let (one, half) = (Interval::exactly(1.0), Interval::exactly(0.5));
        let length = right - left;
        let at = |time: &Interval<F>| self.acceleration(&Moment { time: time.clone(), part });
        let (start, end) = (at(left), at(right));
        let longest = Interval::<F>::exactly(length.magnitude());
        let bow = &Interval::exactly(self.bend(part).magnitude()) * &longest;
        // Between its ends `f` leaves the straight line by no more than `|f''| h²/8`.
        let off = &(&bow * &longest) * &Interval::exactly(0.125);
        let range = &start.value.or(&end.value) + &Interval::within(off.magnitude());
        if range.magnitude() < 1.0 {
            return Found::Nothing;
        }
        let slope = &start.slope + &Interval::within(bow.magnitude());
        if slope.is_positive() || slope.is_negative() {
            if end.value.magnitude() <= 1.0 {
                return Found::Nothing;
            }
            if one.is_below(&end.value.absolute()) {
                let threshold = if end.value.is_positive() { one } else { -&one };
                let root = narrow(&left.or(right), &threshold, &slope, at);
                return Found::Crossing(root, against(&end.value));
            }
        }
        if !(length.magnitude() > shortest) {
            return Found::Unclear;
        }
        let middle = (left + &(&length * &half)).centre();
        match self.cell(part, left, &middle, shortest) {
            Found::Nothing => self.cell(part, &middle, right, shortest),
            found => found,
        }
    }
}

/// The side to which a block leaves.
fn against<F: Directed>(acceleration: &Interval<F>) -> Side {
    if acceleration.is_positive() { Side::Minus } else { Side::Plus }
}

/// Where `f` is at the threshold, by Newton's method, in a bracket in which its slope has one sign.
fn narrow<F: Directed>(
    bracket: &Interval<F>,
    threshold: &Interval<F>,
    slope: &Interval<F>,
    at: impl Fn(&Interval<F>) -> Acceleration<F>,
) -> Interval<F> {
    let (mut bracket, mut slope) = (bracket.clone(), slope.clone());
    for _ in 0..MOST_NARROWINGS {
        let centre = bracket.centre();
        let found = &centre - &(&(&at(&centre).value - threshold) / &slope);
        let narrower = found.and(&bracket);
        if !(narrower.width() < 0.5 * bracket.width()) {
            return if narrower.width() <= bracket.width() { narrower } else { bracket };
        }
        bracket = narrower;
        let nearer = at(&bracket).slope;
        slope = slope.and(&nearer);
    }
    bracket
}
