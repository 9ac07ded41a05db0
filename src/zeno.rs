//! Closing the infinite sum: from a finite list of impacts to the chattering time.
//!
//! The partial sums `τ_n, τ_{n+2}, τ_{n+4}, ...` approach `τ_ch` with errors in `η², η⁴, η⁶, ...`, because the map from one impact to the
//! next but one is analytic in the velocity and multiplies it by `η²` to the lowest order (Eq. 73). Eq. 75 removes the first of these
//! errors; each column of the table below removes one more (Richardson's extrapolation with the ratios `η^{2k}`). The differences of the
//! partial sums are extrapolated and not the sums, so rounding errors stay relative to the last intervals.

use contract::{Estimate, History, Impact};

/// No sequence has gained from more columns than this.
const MOST_COLUMNS: usize = 24;

/// How many flights are left out.
const FIRST_FLIGHTS: usize = 4;

/// What multiple of a change from one column to the next, or of the change before it, is claimed as the error. Few impacts near the
/// critical amplitude need it, where the columns get better slowly and the last change is small by accident.
const SAFETY: f64 = 3.0;

/// The chattering time by the best column of the table, with the error that its last two columns and the claims of the oracle suggest.
/// `None` with fewer than two impacts.
pub fn close(history: &History, eta: f64) -> Option<Estimate> {
    if let Some(own) = history.chattering_time {
        return Some(own);
    }
    let last = history.impacts.last()?;
    let pairs = pair_differences(&history.impacts);
    let best = columns(&pairs, last.time, eta).min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty))?;
    Some(Estimate { value: best.value, uncertainty: best.uncertainty + last.uncertainty.time })
}

/// The chattering time by Eq. 75 with the last two intervals of the history; `None` with fewer than two impacts.
pub fn eq75(history: &History, eta: f64) -> Option<f64> {
    let last = history.impacts.last()?;
    let (difference, _) = pair_differences(&history.impacts).pop()?;
    Some(last.time + eta * eta / (1.0 - eta * eta) * difference)
}

/// `τ_n - τ_{n-2}` for every second impact counted back from the last, in order of time, with the error claimed for it. The first four
/// flights are left out if there are others: the first, from rest, is not of the map whose expansion this is.
fn pair_differences(impacts: &[Impact]) -> Vec<(f64, f64)> {
    let pair = |pair: &[Impact]| {
        let error = |impact: &Impact| impact.interval * impact.uncertainty.interval.max(f64::EPSILON);
        let sum = pair.iter().map(|impact| impact.interval).sum();
        (pair.len() == 2).then(|| (sum, pair.iter().map(error).sum()))
    };
    let regular = impacts.get(FIRST_FLIGHTS..).filter(|rest| rest.len() >= 4).unwrap_or(impacts);
    let mut pairs: Vec<_> = regular.rchunks(2).take(MOST_COLUMNS + 1).filter_map(pair).collect();
    pairs.reverse();
    pairs
}

/// The value in each column at the last impact, and its estimated error: from how much the column and the one before it changed the value,
/// and the claimed errors of the intervals as the extrapolation magnifies them.
fn columns(pairs: &[(f64, f64)], time: f64, eta: f64) -> impl Iterator<Item = Estimate> {
    let mut row = pairs.to_vec();
    let mut value = time;
    let mut power = 1.0;
    let mut last_change = 0.0;
    let mut noise = 0.0;
    std::iter::from_fn(move || {
        let &(difference, error) = row.last()?;
        power *= eta * eta;
        let change = power / (1.0 - power) * difference;
        value += change;
        noise += power / (1.0 - power) * error;
        let uncertainty = SAFETY * change.abs().max(last_change) + noise;
        last_change = change.abs();
        row = row
            .windows(2)
            .filter_map(|two| match two {
                [(early, early_error), (late, late_error)] => {
                    Some(((late - power * early) / (1.0 - power), (late_error + power * early_error) / (1.0 - power)))
                }
                _ => None,
            })
            .collect();
        Some(Estimate { value, uncertainty })
    })
}
