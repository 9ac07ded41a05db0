//! The first difference of a response from what it has to be.

use std::cell::Cell;

use super::{
    difference::{Difference, ROUNDING, ROUNDING_OF_STATES, What, plain, unless_near},
    reference::{Expected, Reference},
    rows,
    whole::{Bout, BoutEnding, Whole},
};

/// A claim on when a block comes to rest that is wider than this share of the bout, where that is known, claims nothing.
const WIDE: f64 = 1e-3;

/// The first difference of a response of a method of this accuracy, as far as it is known what has to happen; and the largest share of what is allowed
/// that any impact and any rest used.
pub(super) fn first_difference(whole: &Whole, reference: &Reference, accuracy: f64) -> (Option<Difference>, Used) {
    let scale = Reference::scale(accuracy);
    let (difference, used) = of_bouts(whole, &reference.expected(), scale);
    (difference.or_else(|| rows::first_difference(&whole.rows, reference, scale)), used)
}

/// The same of bouts alone, with `scale` by what an error is larger than what is known.
pub(super) fn of_bouts(whole: &Whole, expected: &Expected<'_>, scale: f64) -> (Option<Difference>, Used) {
    let comparison = Comparison { expected, scale, used: Cell::default() };
    let difference = comparison.bouts(&whole.bouts, whole.told_until.unwrap_or(f64::INFINITY));
    (difference, comparison.used.get())
}

/// The largest shares of what is allowed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Used {
    /// That an impact used.
    pub by_impacts: f64,
    /// That a rest used.
    pub by_rests: f64,
}

struct Comparison<'a> {
    expected: &'a Expected<'a>,
    scale: f64,
    used: Cell<Used>,
}

impl Comparison<'_> {
    fn bouts(&self, bouts: &[Bout], told_until: f64) -> Option<Difference> {
        let Expected { bouts: expected, known, until, .. } = *self.expected;
        for (k, (bout, known)) in expected.iter().zip(known).enumerate() {
            let Some(own) = bouts.get(k) else {
                return (bout.begin < told_until).then(|| plain(What::NoBout, bout.begin));
            };
            let late = ROUNDING * (1.0 + bout.begin);
            let begins = unless_near(What::Begin, bout.begin, own.begin, bout.begin, self.scale * known.begin + late);
            let difference = begins
                .or_else(|| unless_near(What::Side, bout.begin, own.side, bout.side, 0.0))
                .or_else(|| self.impacts(own, bout, &known.impacts))
                .or_else(|| known.ending.and_then(|moves| self.ending(own, bout, moves)));
            if difference.is_some() {
                return difference;
            }
        }
        let more = bouts.get(expected.len()).filter(|bout| bout.begin < until);
        more.map(|bout| plain(What::ExtraBout, bout.begin))
    }

    fn impacts(&self, own: &Bout, bout: &Bout, known: &[(f64, f64)]) -> Option<Difference> {
        for (n, (impact, (time, speed))) in bout.impacts.iter().zip(known).enumerate() {
            let Some(found) = own.impacts.get(n) else {
                // A method may close the sum of infinitely many earlier.
                let closed = own.outcome == BoutEnding::Rest && bout.outcome == BoutEnding::Rest;
                return (!closed).then(|| plain(What::NoImpact, impact.time));
            };
            let late = ROUNDING * (1.0 + impact.time);
            let late = self.scale * time + late;
            let faster = (self.scale * speed + 1e-11) * impact.before + 1e-16;
            let shares = [(found.time - impact.time).abs() / late, (found.before - impact.before).abs() / faster];
            let used = self.used.get();
            self.used.set(Used { by_impacts: shares.into_iter().fold(used.by_impacts, f64::max), ..used });
            let difference = unless_near(What::ImpactTime, impact.time, found.time, impact.time, late)
                .or_else(|| unless_near(What::ImpactSpeed, impact.time, found.before, impact.before, faster));
            if difference.is_some() {
                return difference;
            }
        }
        None
    }

    fn ending(&self, own: &Bout, bout: &Bout, (end, peak): (f64, f64)) -> Option<Difference> {
        let rests = bout.outcome == BoutEnding::Rest;
        if let Some(extra) = own.impacts.get(bout.impacts.len()).filter(|_| !rests) {
            return Some(plain(What::ExtraImpact, extra.time));
        }
        if !self.may_end(own.outcome, bout.outcome) {
            let what = What::Ending(own.outcome, bout.outcome);
            return Some(Difference { found: own.end, ..plain(what, bout.end) });
        }
        if rests {
            let allowed = self.scale * end + bout.uncertainty + ROUNDING * (1.0 + bout.end);
            let most = WIDE * (bout.end - bout.begin) + allowed;
            let unsure = unless_near(What::Unsure, bout.end, own.uncertainty, 0.0, most);
            let used = self.used.get();
            let share = (own.end - bout.end).abs() / (allowed + own.uncertainty);
            self.used.set(Used { by_rests: used.by_rests.max(share), ..used });
            let at = unless_near(What::RestTime, bout.end, own.end, bout.end, allowed + own.uncertainty);
            if let Some(difference) = unsure.or(at) {
                return Some(difference);
            }
        }
        let (found, expected) = own.peak.zip(bout.peak)?;
        let allowed = self.scale * peak + ROUNDING_OF_STATES * (1.0 + expected);
        unless_near(What::Peak, bout.end, found, expected, allowed)
    }

    /// One method is certain earlier than another that a block overturns: then the one has it, and the other still follows it where the response ends.
    fn may_end(&self, own: BoutEnding, right: BoutEnding) -> bool {
        match (own, right) {
            (BoutEnding::Overturned, BoutEnding::Cut) => self.expected.falls,
            (BoutEnding::Cut, BoutEnding::Overturned) => true,
            _ => own == right,
        }
    }
}
