//! Two histories of one case, impact by impact.

use std::collections::BTreeMap;

use contract::{Case, Ending, Limit, Loss};
use serde::{Deserialize, Serialize};

use crate::{
    gate::tolerance,
    measure::{
        conditioning::Conditioning,
        excitation::horizon,
        model_gap::ModelGap,
        observables::{Observable, Observed},
    },
};

/// What came out of comparing two histories.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The largest share of its allowance that each observable used.
    pub worst: BTreeMap<Observable, Figure>,
    /// How many impacts were compared.
    pub impacts: usize,
    /// Of them, how many in name only: what the oracles claim for one observable is so wide that nearly anything would have passed.
    pub vacuous: usize,
    /// Whether the chattering times were compared, and if so, not in name only.
    pub chattering_time: Option<bool>,
    /// The agreement.
    pub agreement: Agreement,
}

/// The agreement on a pair and a case.
#[derive(Debug, Clone, PartialEq)]
pub enum Agreement {
    /// Everything was within what is allowed.
    Agree,
    /// Something was not. What came after it is poisoned and was not judged.
    Disagree(Disagreement),
    /// The endings differ, but the case is nearer to the critical amplitude than the claims can tell.
    TooClose,
}

/// A difference and what was allowed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// At which impact; 0 if it is of the whole history.
    pub impact: usize,
    /// The difference, in the scale of the observable.
    pub difference: f64,
    /// What was allowed: the claims, and the entry of the tolerance table.
    pub allowed: f64,
}

/// The first thing that two histories disagree on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Disagreement {
    /// What differs.
    pub observable: Observable,
    /// By how much, where, and what was allowed.
    pub figure: Figure,
    /// The two values, printed.
    pub values: [String; 2],
    /// How many later impacts were not judged.
    pub poisoned: usize,
}

impl Figure {
    /// The share of the allowance that was used; above 1 is too much. Anything that is not a number is too much.
    pub fn share(&self) -> f64 {
        match self.difference / self.allowed {
            _ if self.difference == 0.0 => 0.0,
            share if share.is_nan() => f64::INFINITY,
            share => share,
        }
    }

    fn is_allowed(&self) -> bool {
        self.difference <= self.allowed
    }
}

/// What two histories of one case may differ by beyond their claims.
#[derive(Debug, Clone, Copy)]
pub struct Slack<'a> {
    /// What rounding the parameters does; the default is nothing.
    pub conditioning: &'a Conditioning,
    /// The difference allowed between their models, if these differ. It scales the velocities of the second, nonlinear one.
    pub gap: Option<&'a ModelGap>,
}

impl Slack<'_> {
    /// What the tolerance table allows on top of the claims, for an observable at impact `n`.
    fn at(&self, observable: Observable, n: usize) -> f64 {
        const UNIT: f64 = 0.5 * f64::EPSILON;
        let rounding = tolerance::BACKWARD.value * UNIT * self.conditioning.at(observable, n);
        rounding
            + match self.gap {
                None => tolerance::SAME_MODEL.value,
                Some(gap) => tolerance::ACROSS_MODELS.value * gap.at(observable, n),
            }
    }
}

/// Compares two histories of `case`.
pub fn compare(case: &Case, first: &Observed, second: &Observed, slack: Slack) -> Comparison {
    let (mine, theirs) = (&first.history.impacts, &second.history.impacts);
    let common = mine.len().min(theirs.len());
    let mut comparison = Comparison {
        worst: BTreeMap::new(),
        impacts: 0,
        vacuous: 0,
        chattering_time: None,
        agreement: Agreement::Agree,
    };
    for n in 1..=common {
        comparison.impacts += 1;
        let time = first.at(Observable::ImpactTime, n).map_or(0.0, |time| time.value);
        let mut wide = false;
        for observable in Observable::OF_AN_IMPACT {
            let Some((figure, values)) = figure(observable, n, first, second, slack) else { continue };
            wide |= is_wide(figure.allowed, if observable == Observable::ImpactTime { time } else { 1.0 });
            comparison.note(observable, figure);
            if !figure.is_allowed() {
                let poisoned = common - n;
                comparison.agreement = Agreement::Disagree(Disagreement { observable, figure, values, poisoned });
                return comparison;
            }
        }
        comparison.vacuous += usize::from(wide);
    }
    comparison.agreement = endings(case, first, second, slack, common);
    if comparison.agreement != Agreement::Agree {
        return comparison;
    }
    if let (Some(mine), Some(theirs)) = (first.chattering_time, second.chattering_time) {
        let figure = Figure {
            impact: 0,
            difference: (mine.value - theirs.value).abs(),
            allowed: mine.uncertainty + theirs.uncertainty + slack.at(Observable::ChatteringTime, 0),
        };
        comparison.chattering_time = Some(!is_wide(figure.allowed, mine.value));
        comparison.note(Observable::ChatteringTime, figure);
        if !figure.is_allowed() {
            comparison.agreement = Agreement::Disagree(Disagreement {
                observable: Observable::ChatteringTime,
                figure,
                values: [format!("{:?}", mine.value), format!("{:?}", theirs.value)],
                poisoned: 0,
            });
        }
    }
    comparison
}

impl Comparison {
    fn note(&mut self, observable: Observable, figure: Figure) {
        let worst = self.worst.entry(observable).or_insert(figure);
        if figure.share() > worst.share() {
            *worst = figure;
        }
    }
}

/// Whether an allowance is so wide that it compares nothing: half of the value itself.
fn is_wide(allowed: f64, value: f64) -> bool {
    allowed.is_nan() || allowed > 0.5 * value
}

/// The difference of an observable at impact `n`, and the two values.
fn figure(
    observable: Observable,
    n: usize,
    first: &Observed,
    second: &Observed,
    slack: Slack,
) -> Option<(Figure, [String; 2])> {
    let (mine, theirs) = (first.at(observable, n)?, second.at(observable, n)?);
    let their_value = match slack.gap {
        Some(gap) if observable == Observable::Velocity => theirs.value / gap.velocity_scale,
        _ => theirs.value,
    };
    let scale = if observable == Observable::ImpactTime { 1.0 } else { mine.value.abs().max(their_value.abs()) };
    let figure = Figure {
        impact: n,
        difference: (mine.value - their_value).abs() / scale,
        allowed: mine.uncertainty + theirs.uncertainty + slack.at(observable, n),
    };
    Some((figure, [format!("{:?}", mine.value), format!("{their_value:?}")]))
}

/// Whether two endings say the same, and the lists are of the length that they imply.
fn endings(case: &Case, first: &Observed, second: &Observed, slack: Slack, common: usize) -> Agreement {
    let disagree = || {
        let all_alike = kind(first.history.ending) == kind(second.history.ending);
        let describe = |o: &Observed| match (o.history.ending, o.history.impacts.len()) {
            // What differs is where the lists end.
            (ending, listed) if all_alike && listed == case.max_impacts() => {
                format!("{listed} impacts listed, all that were asked for, {ending}")
            }
            (ending, listed) if all_alike => format!("{listed} impacts listed, {ending}"),
            (ending, listed) => format!("{ending} after {listed} impacts"),
        };
        Agreement::Disagree(Disagreement {
            observable: Observable::Ending,
            figure: Figure { impact: common + 1, difference: f64::INFINITY, allowed: 0.0 },
            values: [describe(first), describe(second)],
            poisoned: 0,
        })
    };
    let same = match (kind(first.history.ending), kind(second.history.ending)) {
        (Kind::Unknown, _) | (_, Kind::Unknown) => true,
        (Kind::Complete, Kind::Rocking) | (Kind::Rocking, Kind::Complete) => false,
        (one, two) if one == two => true,
        _ => return disagree(),
    };
    let (shorter, longer) = if first.history.impacts.len() == common { (first, second) } else { (second, first) };
    let time_left_is_within =
        |unsure: f64, time: f64| (horizon(case) - time).abs() <= unsure + slack.at(Observable::ImpactTime, common + 1);
    // One that comes to rest and one that does not part at an impact that the first has and the second has not.
    let Some(extra) = longer.history.impacts.get(common) else {
        let last = |observed: &Observed| observed.history.impacts.last().map(|last| (last.uncertainty.time, last.time));
        let too_close = last(first)
            .zip(last(second))
            .is_some_and(|((mine, time), (theirs, _))| time_left_is_within(mine + theirs, time));
        return match (same, too_close) {
            (true, _) => Agreement::Agree,
            (false, true) => Agreement::TooClose,
            (false, false) => disagree(),
        };
    };
    let claimed = common.checked_sub(1).and_then(|last| shorter.history.impacts.get(last));
    let explained = match shorter.history.ending {
        Ending::AtRest => claimed.is_some_and(|last| last.interval < tolerance::RESOLUTION.value),
        // An impact so near to the end of the time that one list has it and the other has not; across models, an impact that a block of
        // slightly other stiffness does not have.
        Ending::Incomplete | Ending::LimitReached(Limit::Time) | Ending::Overturned => {
            let unsure = extra.uncertainty.time + claimed.map_or(0.0, |last| last.uncertainty.time);
            time_left_is_within(unsure, extra.time)
        }
        // What is listed before a loss or an overturning was compared; the loss itself is judged by the laws.
        Ending::Lost(_) => true,
        Ending::NeverRocks | Ending::LimitReached(Limit::Impacts) => false,
    };
    match (explained, same) {
        (true, true) => Agreement::Agree,
        (true, false) => Agreement::TooClose,
        (false, _) => disagree(),
    }
}

/// Endings that can't both be true of one case are of different kinds.
#[derive(PartialEq, Eq)]
enum Kind {
    Still,
    Complete,
    /// Still rocking at the end: whether it is seen to be overturning already depends on how early a method can prove it.
    Rocking,
    Unknown,
}

fn kind(ending: Ending) -> Kind {
    match ending {
        Ending::NeverRocks => Kind::Still,
        Ending::AtRest => Kind::Complete,
        Ending::Incomplete | Ending::Overturned | Ending::LimitReached(Limit::Time) => Kind::Rocking,
        Ending::LimitReached(Limit::Impacts) => Kind::Unknown,
        Ending::Lost(Loss::FellThrough | Loss::Stalled | Loss::NotFinite | Loss::SolverFailed) => Kind::Unknown,
    }
}

#[cfg(test)]
mod tests;
