//! What would explain a list that is wrong: that it is in other units, or counted from elsewhere.

use std::fmt;

use contract::Impact;

use super::{Listed, Truth};
use crate::measure::excitation::Excitation;

/// What would explain what is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hint {
    /// The times are all later by this much.
    Shifted(f64),
    /// The times are all later by this much, which is how long the sinusoid takes from zero to the threshold.
    FromZero(f64),
    /// The times are all multiples by this.
    Scaled(f64),
    /// The velocities are those just before the impacts.
    BeforeImpact,
}

impl Hint {
    /// Whether it is about all times.
    pub(super) fn is_of_times(self) -> bool {
        !matches!(self, Self::BeforeImpact)
    }
}

/// As many impacts have to fit.
const ENOUGH: usize = 3;
const MOST: usize = 8;

/// What would explain the list that goes wrong at `index`.
pub(super) fn of(truth: &Truth, list: &[Listed], index: usize) -> Option<Hint> {
    let both = || list.iter().zip(truth.impacts).take(MOST);
    let (first, proven) = both().next()?;
    if both().count() < ENOUGH {
        return None;
    }
    let fits = |moved: &dyn Fn(f64) -> f64| {
        both().all(|(given, proven)| {
            let written = super::Written { value: moved(given.time.value), resolution: 2.0 * given.time.resolution };
            truth.is_at(proven, &written)
        })
    };
    if index == 0 && !truth.is_at(proven, &first.time) {
        let by = first.time.value - proven.time;
        if fits(&|time| time - by) {
            let threshold = Excitation::new(truth.case).phase() / truth.case.omega();
            let is_from_zero = (by - threshold).abs() <= 2.0 * truth.allowed(proven, &first.time);
            return Some(if is_from_zero { Hint::FromZero(by) } else { Hint::Shifted(by) });
        }
        let by = first.time.value / proven.time;
        if by > 0.0 && fits(&|time| time / by) {
            return Some(Hint::Scaled(by));
        }
    }
    let is_before = |(given, proven): (&Listed, &Impact)| {
        let speed = proven.velocity.abs() / truth.case.eta();
        let off = |given: super::Written| (given.value.abs() - speed).abs() - given.resolution;
        given.velocity.is_some_and(|given| off(given) <= truth.tolerance * speed)
    };
    both().all(is_before).then_some(Hint::BeforeImpact)
}

impl fmt::Display for Hint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FromZero(by) => write!(
                f,
                "all times are {by:.9} later: they are counted from where the sinusoid is zero, and should be from initiation, where it reaches the threshold"
            ),
            Self::Shifted(by) => {
                write!(f, "all times are {by:.9} later than they should be: they are to be counted from initiation")
            }
            Self::Scaled(by) => write!(
                f,
                "all times are {by:.9} of what they should be: they are to be in tau = p t; seconds of a block with p = {:.9} would be so",
                1.0 / by
            ),
            Self::BeforeImpact => {
                f.write_str("the velocities are 1/eta of what they should be: those just before the impacts, and asked are those just after")
            }
        }
    }
}
