//! What an engine answered to a case: a reply becomes a history, a refusal, or a breakdown.

use std::time::Duration;

use contract::{Case, Decline, Estimate, History, Impact, Uncertainty};

use crate::{
    launch::Tolerance,
    number::Number,
    reply::{Claim, Column, Columns, Errors, Refusal, Reply},
    verdict::{Breakdown, Verdict},
    words,
};

/// How much of the words of an engine is kept.
const MOST_WORDS: usize = 1_000;

/// How much of a reason is kept: reasons are counted.
const MOST_REASON: usize = 80;

/// What an engine answered to a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The history, the refusal, or how it broke.
    pub outcome: Outcome,
    /// What the engine claimed an error for in this answer; for the rest the user's tolerance stands.
    pub claimed: Claimed,
    /// Whether the intervals are differences of times, and carry the rounding of these.
    pub intervals_from_times: bool,
    /// How long the engine says it took, in nanoseconds.
    pub ns: Option<f64>,
    /// How long it took as seen from outside; in a batch, its share.
    pub elapsed: Duration,
}

/// What an engine claimed an error for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Claimed {
    /// The times.
    pub time: bool,
    /// The intervals.
    pub interval: bool,
    /// The velocities.
    pub velocity: bool,
    /// The chattering time.
    pub tau_ch: bool,
}

/// The history, the refusal, or the breakdown.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A history.
    History(History),
    /// A refusal: of the engine, or of what it is not asked because it does not offer it.
    Declined(Decline),
    /// The engine broke.
    Broke(Breakdown),
}

impl Answer {
    /// An answer without a history.
    pub(crate) fn without(outcome: Outcome) -> Self {
        Self { outcome, claimed: Claimed::default(), intervals_from_times: false, ns: None, elapsed: Duration::ZERO }
    }

    /// The breakdown, as an answer.
    pub(crate) fn broke(verdict: Verdict, happened: impl Into<String>) -> Self {
        Self::without(Outcome::Broke(Breakdown::new(verdict, happened)))
    }

    /// The answer in the words of the contract.
    ///
    /// # Errors
    /// The refusal; a breakdown becomes [`Decline::NoAnswer`].
    pub fn told(&self) -> Result<History, Decline> {
        match &self.outcome {
            Outcome::History(history) => Ok(history.clone()),
            Outcome::Declined(decline) => Err(decline.clone()),
            Outcome::Broke(broke) => Err(broke.clone().into()),
        }
    }

    /// How it broke, if it did.
    pub fn breakdown(&self) -> Option<&Breakdown> {
        match &self.outcome {
            Outcome::Broke(broke) => Some(broke),
            _ => None,
        }
    }

    /// Whether two answers say the same, bit for bit. How long they took is not looked at.
    pub(crate) fn says_the_same(&self, other: &Self) -> bool {
        // Doubles are written with all their digits and their sign, and what is not a number is equal to itself.
        format!("{:?}", self.outcome) == format!("{:?}", other.outcome)
    }

    /// What a reply says of this case.
    pub(crate) fn of(reply: Reply, case: &Case, tolerance: &Tolerance, may_claim: bool) -> Self {
        let ns = reply.ns.map(|ns| ns.0);
        let answer = match (reply.history, reply.decline, reply.error) {
            (Some(columns), None, None) => history(columns, case, tolerance, may_claim),
            (None, Some(refusal), None) => Ok(Self::without(Outcome::Declined(declined(refusal)))),
            (None, None, Some(failure)) => {
                let message = cut(failure.message.unwrap_or_default(), MOST_WORDS);
                Err(Breakdown::new(Verdict::ReportedError, format!("{message:?}")))
            }
            (None, None, None) => Err(missing("one of \"history\", \"decline\" and \"error\"")),
            _ => Err(Breakdown::new(
                Verdict::TwoAnswers,
                "more than one of \"history\", \"decline\" and \"error\" in one answer",
            )),
        };
        let answer = answer.unwrap_or_else(|broke| Self::without(Outcome::Broke(broke)));
        Self { ns, ..answer }
    }
}

fn declined(refusal: Refusal) -> Decline {
    let reason =
        refusal.reason.filter(|reason| !reason.trim().is_empty()).unwrap_or_else(|| "no reason given".to_owned());
    Decline::ByEngine { reason: cut(reason, MOST_REASON), why: cut(refusal.why.unwrap_or_default(), MOST_WORDS) }
}

fn cut(mut words: String, most: usize) -> String {
    words.truncate(words.floor_char_boundary(most));
    words
}

fn missing(what: &str) -> Breakdown {
    Breakdown::new(Verdict::MissingField, format!("the answer has no {what}"))
}

/// The history in these columns. Numbers that are wrong are passed on: they are a wrong answer, and the gate's to judge.
fn history(columns: Columns, case: &Case, tolerance: &Tolerance, may_claim: bool) -> Result<Answer, Breakdown> {
    let times = columns.time.ok_or_else(|| missing("\"time\""))?;
    let velocities = columns.velocity.ok_or_else(|| missing("\"velocity\""))?;
    let name = columns.ending.ok_or_else(|| missing("\"ending\""))?;
    let count = times.count;
    let asked = case.max_impacts();
    for (other, column) in [("velocity", Some(&velocities)), ("interval", columns.interval.as_ref())] {
        if let Some(column) = column.filter(|column| column.count != count) {
            let happened = format!("\"time\" has {count} numbers, \"{other}\" has {}", column.count);
            return Err(Breakdown::new(Verdict::UnequalColumns, happened));
        }
    }
    if count > asked {
        return Err(Breakdown::new(Verdict::TooManyImpacts, format!("{asked} were asked for, {count} came")));
    }
    let ending = words::ending(&name, count == asked)
        .ok_or_else(|| Breakdown::new(Verdict::UnknownEnding, format!("{:?}", cut(name, MOST_REASON))))?;
    if columns.claim.is_some() && !may_claim {
        return Err(Breakdown::new(
            Verdict::ClaimNotAnnounced,
            "the answer has a \"claim\", the start said \"claims\": false",
        ));
    }
    let claim = columns.claim.unwrap_or_default();
    check_claim(&claim, count)?;
    let intervals = columns.interval.as_ref();
    let impacts = impacts(&times, &velocities, intervals, &claim, tolerance);
    let chattering_time = columns.tau_ch.map(|Number(value)| Estimate {
        value,
        uncertainty: claim.tau_ch.map_or(tolerance.tau_ch, |claimed| claimed.0),
    });
    Ok(Answer {
        claimed: Claimed {
            time: claim.time.is_some(),
            interval: claim.interval.is_some(),
            velocity: claim.velocity.is_some(),
            tau_ch: claim.tau_ch.is_some(),
        },
        intervals_from_times: intervals.is_none() && count > 0,
        ..Answer::without(Outcome::History(History { impacts, ending, chattering_time }))
    })
}

fn impacts(
    times: &Column,
    velocities: &Column,
    intervals: Option<&Column>,
    claim: &Claim,
    tolerance: &Tolerance,
) -> Vec<Impact> {
    let mut before = 0.0;
    let mut impacts = Vec::with_capacity(times.values.len());
    for (n, (&time, &velocity)) in times.values.iter().zip(&velocities.values).enumerate() {
        let granted = at(claim.interval.as_ref(), n).unwrap_or(tolerance.interval);
        let given = intervals.and_then(|column| column.values.get(n));
        let (interval, cost) = given.map_or_else(|| difference(before, time), |&interval| (interval, 0.0));
        impacts.push(Impact {
            time,
            interval,
            velocity,
            uncertainty: Uncertainty {
                time: at(claim.time.as_ref(), n).unwrap_or(tolerance.time),
                interval: granted + cost,
                velocity: at(claim.velocity.as_ref(), n).unwrap_or(tolerance.velocity),
            },
        });
        before = time;
    }
    impacts
}

/// The interval between two times, and what their rounding costs it, relative: half a unit in the last place of each.
fn difference(before: f64, time: f64) -> (f64, f64) {
    let interval = time - before;
    let cost = 0.5 * f64::EPSILON * (time.abs() + before.abs()) / interval.abs();
    (interval, if cost.is_finite() { cost } else { 0.0 })
}

/// What is claimed of impact `n`.
fn at(claimed: Option<&Errors>, n: usize) -> Option<f64> {
    match claimed? {
        Errors::Same(value) => Some(*value),
        Errors::Each(column) => column.values.get(n).copied(),
    }
}

fn check_claim(claim: &Claim, count: usize) -> Result<(), Breakdown> {
    let bad = |happened| Err(Breakdown::new(Verdict::BadClaim, happened));
    let is_error = |value: &f64| *value >= 0.0;
    for (name, claimed) in [("time", &claim.time), ("interval", &claim.interval), ("velocity", &claim.velocity)] {
        let wrong = match claimed {
            None => None,
            Some(Errors::Same(value)) => Some(value).filter(|value| !is_error(value)),
            Some(Errors::Each(column)) if column.count != count => {
                return bad(format!("the claim of \"{name}\" has {} numbers for {count} impacts", column.count));
            }
            Some(Errors::Each(column)) => column.values.iter().find(|value| !is_error(value)),
        };
        if let Some(value) = wrong {
            return bad(format!("the claim of \"{name}\" has {value:?}"));
        }
    }
    match claim.tau_ch {
        Some(Number(value)) if !is_error(&value) => bad(format!("the claim of \"tau_ch\" is {value:?}")),
        _ => Ok(()),
    }
}
