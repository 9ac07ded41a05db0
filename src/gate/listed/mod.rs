//! A list of impacts from anywhere, held against what is proven: what is right, to how many digits, and where it goes wrong first.
//!
//! For those who have output and no engine. The list says less than a history does: its numbers have as many digits as were written, there may be no
//! velocities, and it ends where its author stopped.

mod hint;
mod wrong;

use contract::{Case, Ending, Estimate, Horizon, Impact, Invalid, Limit};

use crate::measure::{excitation::half_period, observables::Observed};
pub use hint::Hint;
pub use wrong::{What, Wrong};

/// A number as it was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Written {
    /// Its value.
    pub value: f64,
    /// Half a unit of its last digit.
    pub resolution: f64,
}

impl Written {
    /// The number that `text` says, whose `value` is.
    pub fn new(text: &str, value: f64) -> Self {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let place = exponent.parse::<i32>().unwrap_or(0) - i32::try_from(decimals).unwrap_or(i32::MAX);
        // More digits than a double holds say no more than it does.
        let rounding = 0.5 * f64::EPSILON * value.abs();
        Self { value, resolution: (0.5 * 10.0_f64.powi(place)).max(rounding) }
    }
}

/// An impact of the list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Listed {
    /// The time `τ` since initiation.
    pub time: Written,
    /// The velocity just after the impact, in `φ'`, with or without its sign.
    pub velocity: Option<Written>,
}

/// The fewest significant digits that right impacts have.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Digits {
    /// Of their times.
    pub time: Option<f64>,
    /// Of the intervals before them, as far as their times tell.
    pub interval: Option<f64>,
    /// Of their velocities.
    pub velocity: Option<f64>,
}

/// What is found about a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// How many impacts it has.
    pub impacts: usize,
    /// How many are right, from the first on.
    pub right: usize,
    /// To how many digits those are.
    pub digits: Digits,
    /// What is wrong first.
    pub first_wrong: Option<Wrong>,
    /// What would explain that.
    pub hint: Option<Hint>,
    /// After those that are right: impacts so near to each other that the digits that were written do not tell them apart.
    pub unresolved: usize,
    /// After those: impacts of a later rocking, after the block had come to rest.
    pub later: usize,
    /// After those: impacts that nothing is proven of.
    pub unproven: usize,
    /// How the sequence really ends.
    pub ending: Ending,
    /// When it really comes to rest, if it does.
    pub rest: Option<Estimate>,
}

/// The case that has to be proven for a list: as many impacts, one more, and up to the last time.
///
/// # Errors
/// When the list is longer than a case may be.
pub fn case_for(case: &Case, list: &[Listed]) -> Result<Case, Invalid> {
    let last = list.iter().map(|impact| impact.time.value + impact.time.resolution).fold(0.0, f64::max);
    let case = case.with_max_impacts((list.len() + 1).min(Case::MOST_IMPACTS))?;
    if last > half_period(case.omega()) { case.with_horizon(Horizon::Until(last)) } else { Ok(case) }
}

/// Holds a list against the proven history of [`case_for`] it. An impact is right whose time is off by no more than `tolerance` times the interval before
/// it, and whose velocity by no more than `tolerance` of itself, besides what their last digits leave open.
pub fn judge(case: &Case, proven: &Observed, list: &[Listed], tolerance: f64) -> Judged {
    let rest = proven.chattering_time.filter(|_| proven.history.ending == Ending::AtRest);
    let truth = Truth { case, impacts: &proven.history.impacts, ending: proven.history.ending, rest, tolerance };
    let mut judged = Judged {
        impacts: list.len(),
        right: 0,
        digits: Digits::default(),
        first_wrong: None,
        hint: None,
        unresolved: 0,
        later: 0,
        unproven: 0,
        ending: truth.ending,
        rest,
    };
    for (index, impact) in list.iter().enumerate() {
        let left = list.len() - index;
        match truth.step(list, index) {
            Step::Right => {
                judged.right += 1;
                if let Some(proven) = truth.impacts.get(index) {
                    judged.digits.add(impact, proven);
                }
            }
            Step::Wrong(wrong) => {
                judged.hint = hint::of(&truth, list, index);
                // Times that are all moved may be those of other impacts by chance.
                let off = truth.impacts.first().map(|proven| Wrong { what: What::Off(*proven), ..wrong });
                judged.first_wrong = off.filter(|_| judged.hint.is_some_and(Hint::is_of_times)).or(Some(wrong));
                break;
            }
            Step::Unresolved => judged.unresolved += 1,
            Step::Later => {
                judged.later = left;
                break;
            }
            Step::Unproven => {
                judged.unproven = left;
                break;
            }
        }
    }
    judged
}

/// What is proven, and what is granted.
struct Truth<'a> {
    case: &'a Case,
    impacts: &'a [Impact],
    ending: Ending,
    rest: Option<Estimate>,
    tolerance: f64,
}

/// What one impact of the list is.
enum Step {
    Right,
    Wrong(Wrong),
    Unresolved,
    Later,
    Unproven,
}

/// An interval is told by digits of at most this share of it.
const TOLD: f64 = 0.25;

impl Truth<'_> {
    /// By how much a time may be off.
    fn allowed(&self, proven: &Impact, written: &Written) -> f64 {
        self.tolerance * proven.interval + proven.uncertainty.time + written.resolution
    }

    fn is_at(&self, proven: &Impact, written: &Written) -> bool {
        (written.value - proven.time).abs() <= self.allowed(proven, written)
    }

    /// What the impact at `index` of the list is, if all before it were right or not told apart.
    fn step(&self, list: &[Listed], index: usize) -> Step {
        let Some(impact) = list.get(index) else { return Step::Unproven };
        let time = impact.time;
        let wrong = |what: What| Step::Wrong(Wrong { n: index + 1, given: time.value, what });
        let before = index.checked_sub(1).and_then(|before| list.get(before));
        if let Some(before) = before.filter(|before| time.value < before.time.value) {
            return wrong(What::Falls(before.time.value));
        }
        if self.ending == Ending::NeverRocks {
            return wrong(What::NeverRocks);
        }
        if let Some(rest) = self.rest {
            if time.value + time.resolution >= half_period(self.case.omega()) {
                return Step::Later;
            }
            let last = self.impacts.get(index).map_or(0.0, |proven| self.tolerance * proven.interval);
            if time.value > rest.value + rest.uncertainty + time.resolution + last {
                return wrong(What::AfterRest(rest.value));
            }
        }
        let Some(proven) = self.impacts.get(index) else {
            return self.beyond().map_or(Step::Unproven, wrong);
        };
        if time.resolution > TOLD * proven.interval {
            return Step::Unresolved;
        }
        if !self.is_at(proven, &time) {
            return wrong(self.misplaced(list, index, proven));
        }
        match self.velocity(list, index, proven) {
            Some(wrong) => Step::Wrong(wrong),
            None => Step::Right,
        }
    }

    /// What is wrong with an impact after the last that is proven, if that was the last.
    fn beyond(&self) -> Option<What> {
        match self.ending {
            Ending::Overturned => Some(What::AfterOverturning),
            Ending::Incomplete | Ending::LimitReached(Limit::Time) => Some(What::TooMany),
            Ending::AtRest | Ending::NeverRocks | Ending::LimitReached(Limit::Impacts) | Ending::Lost(_) => None,
        }
    }

    /// What is wrong with an impact that is not where it should be.
    fn misplaced(&self, list: &[Listed], index: usize, proven: &Impact) -> What {
        let is_there = |other: &Impact| list.get(index).is_some_and(|impact| self.is_at(other, &impact.time));
        let elsewhere = self.impacts.iter().enumerate().filter(|(other, _)| *other != index);
        match elsewhere.map(|(other, proven)| (other, is_there(proven))).find(|(_, is_there)| *is_there) {
            Some((other, _)) if other > index => What::Missed(other - index),
            Some((other, _)) => What::Repeated(other + 1),
            None if list.get(index + 1).is_some_and(|next| self.is_at(proven, &next.time)) => What::Extra,
            None => What::Off(*proven),
        }
    }

    /// What is wrong with the velocity, if it is given and anything is.
    fn velocity(&self, list: &[Listed], index: usize, proven: &Impact) -> Option<Wrong> {
        let given = list.get(index)?.velocity?;
        let wrong = |what: What| Some(Wrong { n: index + 1, given: given.value, what });
        let speed = proven.velocity.abs();
        if given.resolution > TOLD * speed {
            return None;
        }
        let allowed = (self.tolerance + proven.uncertainty.velocity) * speed + given.resolution;
        if (given.value.abs() - speed).abs() > allowed {
            return wrong(What::Velocity(proven.velocity));
        }
        // Speeds have no signs; velocities alternate, from either side.
        let has_signs = list.iter().filter_map(|impact| impact.velocity).any(|velocity| velocity.value < 0.0);
        let first = list.first().and_then(|first| first.velocity).zip(self.impacts.first());
        let mirrored = first.is_some_and(|(given, proven)| given.value.signum() != proven.velocity.signum());
        let is_turned = (given.value.signum() != proven.velocity.signum()) != mirrored;
        if has_signs && is_turned { wrong(What::Side) } else { None }
    }
}

impl Digits {
    /// Adds a right impact.
    fn add(&mut self, given: &Listed, proven: &Impact) {
        let off = ((given.time.value - proven.time).abs() - proven.uncertainty.time).max(0.0);
        fewer(&mut self.time, off / proven.time);
        fewer(&mut self.interval, off / proven.interval);
        if let Some(velocity) = given.velocity {
            let speed = proven.velocity.abs();
            let off = ((velocity.value.abs() - speed).abs() / speed - proven.uncertainty.velocity).max(0.0);
            fewer(&mut self.velocity, off);
        }
    }
}

/// What a double can hold.
const MOST_DIGITS: f64 = 16.0;

fn fewer(digits: &mut Option<f64>, error: f64) {
    let of_this = (-error.log10()).clamp(0.0, MOST_DIGITS);
    *digits = Some(digits.map_or(of_this, |digits| digits.min(of_this)));
}

#[cfg(test)]
mod tests;
