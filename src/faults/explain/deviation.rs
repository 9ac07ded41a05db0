//! How far an answer is from what a hypothesis says that it should be.

use contract::{Case, Ending, History, Impact};

use crate::{gate::samples::Sample, measure::zeno};

/// The largest relative deviation of any interval, velocity or time, or of the chattering time; infinite where the ending, the count or a side differ, or where
/// one of the two declines.
pub(super) fn deviation(sample: &Sample, expected: Option<&History>) -> f64 {
    let (answer, expected) = match (&sample.answer, expected) {
        (Some(answer), Some(expected)) => (answer, expected),
        (None, None) => return 0.0,
        _ => return f64::INFINITY,
    };
    if !is_same(answer.ending, expected.ending) || answer.impacts.len() != expected.impacts.len() {
        return f64::INFINITY;
    }
    let of_impacts = answer.impacts.iter().zip(&expected.impacts).flat_map(|(one, two)| {
        let turned = one.velocity.is_sign_negative() != two.velocity.is_sign_negative();
        of(one, two).map(f64::abs).into_iter().chain(turned.then_some(f64::INFINITY))
    });
    let of_rest = of_rest(&sample.case, answer, expected).map_or(0.0, f64::abs);
    of_impacts.chain([of_rest]).fold(0.0, f64::max)
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
