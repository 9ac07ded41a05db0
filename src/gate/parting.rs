//! Where an answer that is wrong parts from one that is proven, or is not wrong: their impacts side by side.

use contract::Impact;
use serde::{Deserialize, Serialize};

use crate::{
    gate::{examine::Examination, finding::Finding},
    measure::{
        asking::Answer,
        observables::{Observable, Observed},
    },
};

/// The impacts of two answers to one case around the first that differs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parting {
    /// Whose answer is shown: what is wrong, or the first of two that differ.
    pub answered: Whole,
    /// What it is held against.
    pub against: Whole,
    /// Whether that is proven.
    pub is_proven: bool,
    /// The first impact that is wrong; 0 where it is the history as a whole.
    pub impact: usize,
    /// The impacts around it.
    pub rows: Vec<Row>,
}

/// What is shown of a history as a whole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Whole {
    /// Whose it is.
    pub oracle: String,
    /// How it ends.
    pub ending: String,
    /// How many impacts it has.
    pub impacts: usize,
    /// Its chattering time, as it has it or as the sum of the intervals closes to.
    pub tau_ch: Option<f64>,
}

/// One impact of both.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Which.
    pub impact: usize,
    /// As it was answered, if it was.
    pub answered: Option<Seen>,
    /// As it is proven, or answered by the other.
    pub against: Option<Seen>,
    /// In what they part: further than what the two claim together.
    pub parts_in: Vec<Observable>,
}

/// An impact in numbers; what is not finite is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Seen {
    /// `τ`
    pub time: Option<f64>,
    /// `Δτ`
    pub interval: Option<f64>,
    /// `φ'`
    pub velocity: Option<f64>,
}

/// How many are kept of one case.
const MOST: usize = 3;
/// How many impacts are kept before the first that is wrong, and from it on.
const BEFORE: usize = 3;
const AFTER: usize = 7;

/// A history, and whose it is.
type Named<'a> = (&'a str, &'a Observed);

/// Where the answers that these findings are about part from others: one parting for an oracle.
pub fn partings(examination: &Examination, findings: &[Finding], sound: &[String]) -> Vec<Parting> {
    let mut partings: Vec<Parting> = Vec::new();
    for finding in findings {
        let Some((answered, against, is_proven)) = sides(examination, finding, sound) else { continue };
        if partings.len() < MOST && partings.iter().all(|known| known.answered.oracle != answered.0) {
            partings.push(parting(answered, against, is_proven, first_wrong(findings, answered.0)));
        }
    }
    partings
}

/// The first impact of this oracle at which anything is wrong; 0 where it is the history as a whole.
fn first_wrong(findings: &[Finding], oracle: &str) -> usize {
    let about_it = findings.iter().filter(|finding| finding.oracles().contains(&oracle));
    about_it.map(Finding::impact).filter(|impact| *impact > 0).min().unwrap_or(0)
}

/// The answer that is wrong, or the first of two, and what it is held against: what is proven if anything is, else what is sound, else the other of the two.
fn sides<'a>(
    examination: &'a Examination,
    finding: &Finding,
    sound: &[String],
) -> Option<(Named<'a>, Named<'a>, bool)> {
    let place = |name: &str| examination.answers.iter().position(|answer| answer.oracle == name);
    let wrong = match finding {
        Finding::Law { oracle, .. } | Finding::Refuted { oracle, .. } => place(oracle)?,
        Finding::Pair { oracles: [one, two], .. } if sound.contains(one) && !sound.contains(two) => place(two)?,
        Finding::Pair { oracles: [one, _], .. } => place(one)?,
        Finding::Broke { .. } => return None,
    };
    let named = |answer: &'a Answer| Some((answer.oracle.as_str(), answer.observed()?));
    let answer = examination.answers.get(wrong)?;
    let answered = named(answer)?;
    if let Some(judged) = examination.judgements.iter().find(|judgement| judgement.place == wrong) {
        return Some((answered, (judged.judge.as_str(), judged.proven.as_ref()), true));
    }
    let others =
        || examination.answers.iter().filter(|other| other.oracle != answer.oracle && other.model == answer.model);
    let sound = others().filter(|other| sound.contains(&other.oracle)).find_map(named);
    let of_pair = || others().filter(|other| finding.oracles().contains(&other.oracle.as_str())).find_map(named);
    Some((answered, sound.or_else(of_pair)?, false))
}

fn parting(answered: Named, against: Named, is_proven: bool, impact: usize) -> Parting {
    let whole = |(oracle, observed): Named| Whole {
        oracle: oracle.to_owned(),
        ending: observed.history.ending.to_string(),
        impacts: observed.history.impacts.len(),
        tau_ch: observed.chattering_time.map(|time| time.value).filter(|value| value.is_finite()),
    };
    let (mine, theirs) = (&answered.1.history.impacts, &against.1.history.impacts);
    let first = impact.max(1).saturating_sub(BEFORE).max(1);
    let last = (impact.max(1) + AFTER).min(mine.len().max(theirs.len()));
    let rows = (first..=last).map(|n| {
        let at = |impacts: &[Impact]| impacts.get(n - 1).copied();
        let (one, two) = (at(mine), at(theirs));
        Row {
            impact: n,
            answered: one.map(Seen::from),
            against: two.map(Seen::from),
            parts_in: one.zip(two).map(|(one, two)| parts_in(one, two)).unwrap_or_default(),
        }
    });
    Parting { answered: whole(answered), against: whole(against), is_proven, impact, rows: rows.collect() }
}

/// In what two impacts differ by more than both claim.
fn parts_in(one: Impact, two: Impact) -> Vec<Observable> {
    let relative = |one: f64, two: f64| (one - two).abs() / two.abs();
    let (mine, theirs) = (one.uncertainty, two.uncertainty);
    let differences = [
        (Observable::ImpactTime, (one.time - two.time).abs(), mine.time + theirs.time),
        (Observable::Interval, relative(one.interval, two.interval), mine.interval + theirs.interval),
        (Observable::Velocity, relative(one.velocity, two.velocity), mine.velocity + theirs.velocity),
    ];
    // What is no number is within nothing.
    let parts = |(_, difference, allowed): &(Observable, f64, f64)| difference > allowed || difference.is_nan();
    differences.into_iter().filter(parts).map(|(observable, ..)| observable).collect()
}

impl From<Impact> for Seen {
    fn from(impact: Impact) -> Self {
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        Self { time: finite(impact.time), interval: finite(impact.interval), velocity: finite(impact.velocity) }
    }
}
