//! How far an answer is from what a hypothesis says that it should be.

use contract::{Case, Ending, History, Impact, Limit};

use crate::{gate::samples::Sample, measure::zeno};

/// An answer that is held against what hypotheses say.
pub(super) struct Held<'a> {
    pub sample: &'a Sample,
    /// Whether the ending has to be the very same: where what is wrong is the ending, or it is that of the truth. Else it only must not contradict: who does not
    /// say what follows the last impact that was asked for says nothing wrong.
    is_strict: bool,
    /// Its deviation from the truth.
    pub before: Deviation,
}

/// How far an answer is off.
#[derive(Clone, Copy)]
pub(super) struct Deviation {
    /// The largest relative deviation of any interval, velocity or time, or of the chattering time; infinite where the ending, the count or a side differ, or
    /// where one of the two declines.
    pub whole: f64,
    /// That of the intervals, the speeds and the times which both list.
    pub numbers: f64,
}

impl<'a> Held<'a> {
    /// With the truth of its case.
    pub fn new(sample: &'a Sample, truth: Option<&History>) -> Self {
        let endings = sample.answer.as_ref().zip(truth).map(|(answer, truth)| (answer.ending, truth.ending));
        let is_strict = sample.is_ending_wrong || endings.is_none_or(|(one, two)| is_same(one, two));
        let none = Deviation { whole: 0.0, numbers: 0.0 };
        let held = Self { sample, is_strict, before: none };
        Self { before: held.off(truth), ..held }
    }

    /// How far the answer is from this.
    pub fn off(&self, expected: Option<&History>) -> Deviation {
        let (answer, expected) = match (&self.sample.answer, expected) {
            (Some(answer), Some(expected)) => (answer, expected),
            (None, None) => return Deviation { whole: 0.0, numbers: 0.0 },
            _ => return Deviation { whole: f64::INFINITY, numbers: f64::INFINITY },
        };
        let pairs = || answer.impacts.iter().zip(&expected.impacts);
        let numbers = pairs().flat_map(|(one, two)| of(one, two)).map(f64::abs).fold(0.0, f64::max);
        let is_turned = pairs().any(|(one, two)| one.velocity.is_sign_negative() != two.velocity.is_sign_negative());
        let is_like = if self.is_strict { is_same } else { is_compatible };
        let differs = !is_like(answer.ending, expected.ending) || answer.impacts.len() != expected.impacts.len();
        let whole = if is_turned || differs {
            f64::INFINITY
        } else {
            of_rest(&self.sample.case, answer, expected).map_or(0.0, f64::abs).max(numbers)
        };
        Deviation { whole, numbers }
    }

    /// Whether with a hypothesis that leaves this deviation the answer is explained: the deviation falls to a thousandth. Where the ending, the count or a side did
    /// not match, they have to, and what was wrong with the numbers must have gone with that.
    pub fn is_explained(&self, after: Deviation) -> bool {
        /// Lists that are like each other, and what is left of a deviation that has gone.
        const ALIKE: f64 = 0.1;
        const NOTHING: f64 = 1e-9;
        let before = self.before;
        if before.whole.is_infinite() {
            let gone = after.numbers <= (ALIKE * before.numbers).max(NOTHING);
            after.whole <= ALIKE && (self.sample.is_ending_wrong || gone)
        } else {
            before.whole > 0.0 && after.whole <= 1e-3 * before.whole
        }
    }

    /// Whether a hypothesis that leaves this deviation spoils a right answer.
    pub fn is_spoiled(&self, after: Deviation) -> bool {
        after.whole > 1e3 * self.before.whole.max(1e-12)
    }
}

/// The relative deviation of the chattering time, with its sign, where the engine has one of its own.
pub(super) fn of_rest(case: &Case, answer: &History, expected: &History) -> Option<f64> {
    let is_at_rest = answer.ending == Ending::AtRest && expected.ending == Ending::AtRest;
    let own = answer.chattering_time.filter(|_| is_at_rest)?;
    Some(ratio(own.value, expected.chattering_time.or_else(|| zeno::close(expected, case.eta()))?.value))
}

/// Whether two endings are the same, in the words of an engine: how a sequence was lost, and which limit was reached, they don't say.
fn is_same(one: Ending, two: Ending) -> bool {
    use Ending::{LimitReached, Lost};
    one == two || matches!((one, two), (Lost(_), Lost(_)) | (LimitReached(_), LimitReached(_)))
}

/// Whether two endings can both be true: whether more impacts than were asked for would follow is said or it is not, and so is that the block overturns.
fn is_compatible(one: Ending, two: Ending) -> bool {
    let says_nothing = |ending| ending == Ending::LimitReached(Limit::Impacts);
    let rocks = |ending| matches!(ending, Ending::Incomplete | Ending::Overturned);
    is_same(one, two) || says_nothing(one) || says_nothing(two) || rocks(one) && rocks(two)
}

/// The relative deviations of an impact, with their signs: of its interval, its speed and its time. Not-a-number differs infinitely from a number, and not from itself.
pub(super) fn of(one: &Impact, two: &Impact) -> [f64; 3] {
    [ratio(one.interval, two.interval), ratio(one.velocity.abs(), two.velocity.abs()), ratio(one.time, two.time)]
}

fn ratio(one: f64, two: f64) -> f64 {
    if one == two || one.is_nan() && two.is_nan() {
        return 0.0;
    }
    let off = (one - two) / two;
    if off.is_nan() { f64::INFINITY } else { off }
}
