//! Impacts that are missed, invented, repeated, swapped, or turned.

use contract::{Case, History};

use super::{Fault, amount, at_depth, between, whole, within};
use crate::faults::plant::Plant::Answer;

/// What has to be seen in every oracle.
pub(super) fn everywhere(oracle: &str) -> Vec<Fault> {
    let all = [
        at_depth(
            "missed impact",
            "one impact were missed, the block falling through its base and landing at the next",
            Answer(missed),
        ),
        at_depth(
            "missed impact, hidden",
            "one impact were missed, and the velocities after it had the signs that they should have all the same",
            Answer(missed_hidden),
        ),
        at_depth(
            "missed pair of impacts",
            "two impacts in a row were missed, a later root being found in place of the first",
            Answer(missed_pair),
        ),
    ];
    all.into_iter().map(|fault| within(oracle, fault)).collect()
}

pub(super) fn all() -> Vec<Fault> {
    vec![
        between("extra impact", "the start of a flight were found as an impact once more", Answer(extra)),
        between(
            "grazing impact counted",
            "one flight were cut in two by an impact that does not happen",
            Answer(grazing),
        ),
        between("impact repeated", "one impact were listed twice", Answer(repeated)),
        between("impacts out of order", "two impacts were listed the wrong way round", Answer(swapped)),
        at_depth("sign not turned", "the velocity kept its sign at one impact", Answer(turned)),
        at_depth(
            "not a number",
            "one interval were not a number",
            Answer(|_, size, history| {
                if let Some(impact) = at(history, size) {
                    impact.interval = f64::NAN;
                }
            }),
        ),
        whole(
            "side never turned",
            "the side were never turned, all velocities having one sign",
            Answer(|_, _, history| {
                history.impacts.iter_mut().for_each(|impact| impact.velocity = impact.velocity.abs());
            }),
        ),
        whole(
            "initiation as an impact",
            "the start from rest were listed as impact 1",
            Answer(|case, _, history| {
                if let Some(first) = history.impacts.first().copied() {
                    history.impacts.insert(
                        0,
                        contract::Impact {
                            time: f64::MIN_POSITIVE,
                            interval: f64::MIN_POSITIVE,
                            velocity: first.velocity * 1e-300,
                            ..first
                        },
                    );
                    history.impacts.iter_mut().skip(1).for_each(|impact| impact.velocity = -impact.velocity);
                    history.impacts.truncate(case.max_impacts());
                }
            }),
        ),
        amount(
            "velocity before restitution",
            "the velocities listed were those just before the impacts, without eta",
            "share missing of the exponent of eta",
            1.0,
            Answer(|case, size, history| {
                let factor = case.eta().powf(-size);
                history.impacts.iter_mut().for_each(|impact| impact.velocity *= factor);
            }),
        ),
    ]
}

/// Impact `size` (1 is the first).
fn at(history: &mut History, size: f64) -> Option<&mut contract::Impact> {
    history.impacts.get_mut((size as usize).checked_sub(1)?)
}

/// Takes out `count` impacts from impact `size` on, if others follow; the next interval is longer by theirs.
fn skip(history: &mut History, size: f64, count: usize) {
    let from = (size as usize).saturating_sub(1);
    let to = (from + count).min(history.impacts.len());
    if from >= to {
        return;
    }
    let missed: f64 = history.impacts.drain(from..to).map(|impact| impact.interval).sum();
    if let Some(next) = history.impacts.get_mut(from) {
        next.interval += missed;
    }
}

fn missed(_: &Case, size: f64, history: &mut History) {
    skip(history, size, 1);
}

fn missed_hidden(_: &Case, size: f64, history: &mut History) {
    skip(history, size, 1);
    let from = (size as usize).saturating_sub(1);
    history.impacts.iter_mut().skip(from).for_each(|impact| impact.velocity = -impact.velocity);
}

fn missed_pair(_: &Case, size: f64, history: &mut History) {
    skip(history, size, 2);
}

/// An impact more after impact `size`, a share of the flight later, with the velocities that hide it.
fn insert(case: &Case, size: f64, history: &mut History, share: f64) {
    let n = size as usize;
    let (Some(before), Some(after)) = (at(history, size).copied(), at(history, size + 1.0).copied()) else { return };
    let first = share * after.interval;
    let extra = contract::Impact { time: before.time + first, interval: first, velocity: -before.velocity, ..after };
    if let Some(after) = at(history, size + 1.0) {
        after.interval -= first;
    }
    history.impacts.insert(n, extra);
    history.impacts.iter_mut().skip(n + 1).for_each(|impact| impact.velocity = -impact.velocity);
    history.impacts.truncate(case.max_impacts());
}

fn extra(case: &Case, size: f64, history: &mut History) {
    insert(case, size, history, 1e-12);
}

fn grazing(case: &Case, size: f64, history: &mut History) {
    insert(case, size, history, 0.5);
}

fn repeated(case: &Case, size: f64, history: &mut History) {
    if let Some(impact) = at(history, size).copied() {
        history.impacts.insert(size as usize, impact);
        history.impacts.truncate(case.max_impacts());
    }
}

fn swapped(_: &Case, size: f64, history: &mut History) {
    let n = size as usize;
    if n >= 1 && n < history.impacts.len() {
        history.impacts.swap(n - 1, n);
    }
}

fn turned(_: &Case, size: f64, history: &mut History) {
    if let Some(impact) = at(history, size) {
        impact.velocity = -impact.velocity;
    }
}
