//! The smallest size at which a fault turns the gate red.

use contract::Invalid;
use rayon::prelude::*;
use serde::Serialize;

use super::{
    Fault, Size,
    trial::{Evidence, Trial},
};

/// How far below its natural size a fault is followed, in powers of ten. A fault that is still seen there is seen at any size.
const DECADES: i32 = 60;

/// The bisection ends when red and green are this close, as a ratio.
const PRECISION: f64 = 1.1;

/// What was found out about a fault: a row of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The fault's name.
    pub fault: &'static str,
    /// The mistake that a simulator with it makes, in words that go on after "as if".
    pub as_if: &'static str,
    /// The oracle that it was planted in.
    pub oracle: String,
    /// What its size measures.
    pub size: &'static str,
    /// Its size when it is really made; for faults at one impact, the deepest that was tried.
    pub natural: Option<f64>,
    /// The smallest size at which the gate is red.
    pub smallest: Smallest,
    /// What made the gate red there.
    pub caught_by: Option<String>,
}

/// The smallest size at which a fault is seen.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Smallest {
    /// Coming down from the natural size, the gate is red to this size and green at the next that was tried, a tenth smaller. It may be red again
    /// further down: nothing was looked for there.
    Amount(f64),
    /// It was red all the way down to this size.
    Any(f64),
    /// It is red at every impact.
    EveryDepth,
    /// It is there, and it is seen.
    Seen,
    /// The gate stays green at the natural size: the fault escapes.
    Escapes,
    /// The gate stays green when it is made at these impacts.
    EscapesAt(Vec<usize>),
}

impl Row {
    /// Whether the gate is blind to the fault where it is really made.
    pub fn escapes(&self) -> bool {
        matches!(self.smallest, Smallest::Escapes | Smallest::EscapesAt(_))
    }
}

/// Looks for the floor of every fault, on all threads.
///
/// # Errors
/// When a fault is planted in an oracle that the gate lacks.
pub fn table(trial: &Trial, faults: &[Fault], done: impl Fn() + Sync) -> Result<Vec<Row>, Invalid> {
    faults
        .par_iter()
        .map(|fault| {
            let row = row(trial, fault);
            done();
            row
        })
        .collect()
}

fn row(trial: &Trial, fault: &Fault) -> Result<Row, Invalid> {
    let (size, natural, (smallest, evidence)) = match fault.size {
        Size::Amount { meaning, natural } => (meaning, Some(natural), amount(trial, fault, natural)?),
        Size::Depth(followers) => {
            let deepest = trial.depth(&fault.oracle).saturating_sub(followers);
            ("impact", Some(deepest as f64), depths(trial, fault, deepest)?)
        }
        Size::Whole => (
            "",
            None,
            match trial.detects(fault, 1.0, None)? {
                Some(found) => (Smallest::Seen, Some(found)),
                None => (Smallest::Escapes, None),
            },
        ),
    };
    let Fault { name, as_if, oracle, .. } = fault.clone();
    Ok(Row { fault: name, as_if, oracle, size, natural, smallest, caught_by: evidence.map(|evidence| evidence.by) })
}

/// Down from the natural size by powers of ten until the gate is green, and then between the last two.
fn amount(trial: &Trial, fault: &Fault, natural: f64) -> Result<(Smallest, Option<Evidence>), Invalid> {
    let Some(mut evidence) = trial.detects(fault, natural, None)? else {
        return Ok((Smallest::Escapes, None));
    };
    let mut red = natural;
    let mut green = None;
    for _ in 0..DECADES {
        let smaller = 0.1 * red;
        match trial.detects(fault, smaller, Some(&evidence))? {
            Some(found) => (red, evidence) = (smaller, found),
            None => {
                green = Some(smaller);
                break;
            }
        }
    }
    let Some(mut green) = green else {
        return Ok((Smallest::Any(red), trial.detects(fault, red, None)?));
    };
    while red > PRECISION * green {
        let middle = (red * green).sqrt();
        match trial.detects(fault, middle, Some(&evidence))? {
            Some(found) => (red, evidence) = (middle, found),
            None => green = middle,
        }
    }
    // Once more without a hint, so that the evidence does not depend on the threads.
    Ok((Smallest::Amount(red), trial.detects(fault, red, None)?))
}

/// Every depth.
fn depths(trial: &Trial, fault: &Fault, deepest: usize) -> Result<(Smallest, Option<Evidence>), Invalid> {
    let mut last = None;
    let mut missed = Vec::new();
    for depth in 1..=deepest {
        match trial.detects(fault, depth as f64, last.as_ref())? {
            Some(found) => last = Some(found),
            None => missed.push(depth),
        }
    }
    let shown = trial.detects(fault, 1.0, None)?;
    Ok((if missed.is_empty() { Smallest::EveryDepth } else { Smallest::EscapesAt(missed) }, shown))
}
