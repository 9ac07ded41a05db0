//! What must be true of every history by itself.

use contract::{
    Case, Ending, History, Horizon, Impact, Model, Normalisation,
    conformance::{self, Rule, Times},
};
use serde::{Deserialize, Serialize};

use crate::{
    gate::{compare::Figure, tolerance},
    measure::{
        excitation::{Excitation, horizon},
        observables::{Observable, Observed},
    },
};

/// A law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// The oracle did not panic.
    Answers,
    /// The sequence was not lost.
    NotLost,
    /// Intervals are positive and finite, claims are numbers, the list is as long as the ending says.
    Form,
    /// The velocity has the sign of the flight that follows: `i_n = (-1)^{n+1}` (Eq. 70).
    SignAlternates,
    /// The times are the sums of the intervals (Eq. 42).
    TimeIsSum,
    /// No impact comes after the time up to which the case was to be followed, by more than is claimed.
    InTime,
    /// Interval ratios tend to `η²` (Eq. 73), at the rate that follows from Eq. 4.
    IntervalRatio,
    /// What an oracle calls rest is still rest when it is asked for more impacts. Tried where the oracles' endings differ.
    RestStays,
    /// What an oracle calls overturned does not land again for another that follows it further. Tried where the oracles' endings differ.
    OverturnedStays,
    /// What is left after any one impact is what its local series says.
    TimeLeft,
}

impl Law {
    /// Every law, in the order in which they are tried.
    pub const ALL: [Self; 10] = [
        Self::Answers,
        Self::NotLost,
        Self::Form,
        Self::SignAlternates,
        Self::TimeIsSum,
        Self::InTime,
        Self::IntervalRatio,
        Self::RestStays,
        Self::OverturnedStays,
        Self::TimeLeft,
    ];

    /// What it says, for reports.
    pub fn says(self) -> &'static str {
        match self {
            Self::Answers => "the oracle answers",
            Self::NotLost => "the sequence is not lost",
            Self::Form => "the history is well formed",
            Self::SignAlternates => "the sign of the velocity alternates (Eq. 70)",
            Self::TimeIsSum => "times are sums of intervals (Eq. 42)",
            Self::InTime => "no impact comes after the time that was asked for",
            Self::IntervalRatio => "interval ratios tend to eta^2 at the known rate (Eq. 73)",
            Self::RestStays => "rest stays rest when more impacts are asked for",
            Self::OverturnedStays => "what is overturned does not land again",
            Self::TimeLeft => "what is left after an impact is what the local series says",
        }
    }

    /// Whether it is about how a history ends, or how many impacts it has, and not about their numbers.
    pub fn is_of_ending(self) -> bool {
        match self {
            Self::NotLost | Self::InTime | Self::RestStays | Self::OverturnedStays => true,
            Self::Answers
            | Self::Form
            | Self::SignAlternates
            | Self::TimeIsSum
            | Self::IntervalRatio
            | Self::TimeLeft => false,
        }
    }
}

/// A law that a history breaks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Breach {
    /// Which.
    pub law: Law,
    /// At which impact; 0 if the whole history does.
    pub impact: usize,
    /// How, with the numbers.
    pub how: String,
}

/// What came out of checking one history against the laws.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Checked {
    /// The first breach, if there is one.
    pub breach: Option<Breach>,
    /// The interval ratio that used most of its allowance.
    pub ratio: Option<Figure>,
    /// The chattering time from one impact alone that used most of its allowance.
    pub left: Option<Figure>,
}

/// Checks the history of an oracle that solves `model`. One whose times need not be sums is allowed what it claims for them, too.
pub fn check(case: &Case, model: Model, observed: &Observed, times: Times) -> Checked {
    let history = &observed.history;
    let breach = form(case, history, times).or_else(|| in_time(case, history));
    let mut checked = Checked { breach, ..Checked::default() };
    if checked.breach.is_none() && forcing_is_known(case, model, history) {
        for n in 3..=history.impacts.len() {
            let Some(figure) = interval_ratio(case, observed, n) else { continue };
            if checked.ratio.is_none_or(|worst| figure.share() > worst.share()) {
                checked.ratio = Some(figure);
            }
            if figure.share() > 1.0 {
                let how = format!(
                    "ratio to the interval before last is off the first-order law by {:.3e}, allowed {:.3e}",
                    figure.difference, figure.allowed
                );
                checked.breach = Some(Breach { law: Law::IntervalRatio, impact: n, how });
                break;
            }
        }
    }
    checked
}

/// The laws that need no formula of the motion: those of the contract.
fn form(case: &Case, history: &History, times: Times) -> Option<Breach> {
    if let Ending::Lost(loss) = history.ending {
        return Some(Breach { law: Law::NotLost, impact: history.impacts.len() + 1, how: loss.to_string() });
    }
    let conformance::Breach { rule, impact, how } = conformance::check_told(case, history, times).err()?;
    let law = match rule {
        Rule::SignAlternates => Law::SignAlternates,
        Rule::TimeIsSum => Law::TimeIsSum,
        _ => Law::Form,
    };
    Some(Breach { law, impact, how })
}

/// Impacts after the end of the time that was asked for.
fn in_time(case: &Case, history: &History) -> Option<Breach> {
    let end = horizon(case);
    let latest = end * (1.0 + conformance::TIME_IS_SUM * f64::EPSILON);
    let is_late = |impact: &Impact| impact.time - impact.uncertainty.time > latest;
    let (index, late) = history.impacts.iter().enumerate().find(|(_, impact)| is_late(impact))?;
    let how = format!("time {:?}, to be followed until {end:?} and no further", late.time);
    Some(Breach { law: Law::InTime, impact: index + 1, how })
}

/// Whether the forcing at the base is that of the case's own amplitude, and the chattering runs into rest in the first half period.
fn forcing_is_known(case: &Case, model: Model, history: &History) -> bool {
    let threshold = case.slenderness().is_none_or(|s| s.normalisation() == Normalisation::Threshold);
    history.ending == Ending::AtRest && case.horizon() == Horizon::HalfPeriod && (model == Model::Linear || threshold)
}

/// How far the ratio of interval `n` to interval `n - 2` is from `η²` and its first-order correction; `None` outside the regime.
///
/// With `b = 1 + i f` and `c = i f'` the pull towards the base and its rate on the side `i`, a flight of duration `T` that leaves with speed
/// `v` obeys, to first order in `T` and for both models, `T = (2v/b)(1 - cT/3b)` and lands with `v (1 + cT/3b)`.
fn interval_ratio(case: &Case, observed: &Observed, n: usize) -> Option<Figure> {
    let impacts = &observed.history.impacts;
    let ratio = observed.at(Observable::IntervalRatio, n)?;
    let first = impacts.get(n.checked_sub(3)?)?.interval;
    let second = impacts.get(n.checked_sub(2)?)?.interval;
    // The first of the three flights starts at impact n - 3, where initiation is impact 0.
    let start = n.checked_sub(4).map_or(Some(0.0), |index| Some(impacts.get(index)?.time))?;
    let eta = case.eta();
    let [plus, minus] = Excitation::new(case).pull_rates(start);
    // c/b on the side of the first and third flight, and on the other
    let (same, other) = if n % 2 == 1 { (minus, plus) } else { (plus, minus) };
    let change = same.abs().max(other.abs()) * (first + second);
    if change.is_nan() || change > tolerance::RATIO_REGIME.value {
        return None;
    }
    let landing = (same * first + other * second) / 3.0;
    let weaker_pull = -same * (first + second);
    let shorter_flight = (1.0 - eta * eta) * same * first / 3.0;
    let expected = eta * eta * (1.0 + landing + weaker_pull + shorter_flight);
    Some(Figure {
        impact: n,
        difference: (ratio.value / expected - 1.0).abs(),
        // However well the intervals are known, they are doubles, and so is their ratio.
        allowed: tolerance::RATIO_LAW.value * change * change + ratio.uncertainty + 2.0 * f64::EPSILON,
    })
}

#[cfg(test)]
mod tests;
