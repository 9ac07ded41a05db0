//! Closing the infinite sum: from a finite list of impacts to the chattering time.
//!
//! The partial sums `τ_n, τ_{n+2}, τ_{n+4}, ...` approach `τ_ch` with errors in `η², η⁴, η⁶, ...`, because the map from one impact to the
//! next but one is analytic in the velocity and multiplies it by `η²` to the lowest order (Eq. 73). Eq. 75 removes the first of these
//! errors; each column of the table below removes one more (Richardson's extrapolation with the ratios `η^{2k}`). The differences of the
//! partial sums are extrapolated and not the sums, so rounding errors stay relative to the last intervals.

use contract::{Estimate, History, Impact, Sensitivity};

/// No sequence has gained from more columns than this.
const MOST_COLUMNS: usize = 24;

/// How many flights are left out.
const FIRST_FLIGHTS: usize = 4;

/// What multiple is claimed as the error of the largest of three changes: from one column to the next, the one before it, and from the
/// last impact but one to the last. Few impacts near the critical amplitude need it, where the columns get better slowly and a change is small by
/// accident.
const SAFETY: f64 = 3.0;

/// The chattering time by the best column of the table, with the error that its last two columns and the claims of the oracle suggest.
/// `None` with fewer than four impacts.
pub fn close(history: &History, eta: f64) -> Option<Estimate> {
    if let Some(own) = history.chattering_time {
        return Some(own);
    }
    let last = history.impacts.last()?;
    let (_, best) = best_column(history, eta)?;
    Some(Estimate { value: best.value, uncertainty: best.uncertainty + last.uncertainty.time })
}

/// The column with the smallest estimated error, and its value.
fn best_column(history: &History, eta: f64) -> Option<(usize, Estimate)> {
    let columns = columns(pair_differences(&history.impacts), history.impacts.last()?.time, eta).enumerate();
    columns.min_by(|(_, a), (_, b)| a.uncertainty.total_cmp(&b.uncertainty))
}

/// The derivatives of that chattering time by `a`, `ω` and `η`, from those of every impact: the closure is differentiated as it stands, its
/// ratios `η^{2k}` included, in the column that [`close`] takes. `None` with fewer than four impacts, and where an oracle has a chattering
/// time of its own.
pub fn sensitivity(history: &History, sensitivities: &[Sensitivity], eta: f64) -> Option<[f64; 3]> {
    if history.chattering_time.is_some() {
        return None;
    }
    let (best, _) = best_column(history, eta)?;
    let mut slope = sensitivities.last()?.time;
    for (parameter, slope) in slope.iter_mut().enumerate() {
        let by = |of: &Sensitivity| of.interval.get(parameter).copied().unwrap_or(0.0);
        let values = history.impacts.iter().zip(sensitivities).map(|(impact, of)| (impact.interval, by(of)));
        let ratio_by = if parameter == 2 { 2.0 * eta } else { 0.0 };
        *slope += tail_slope(&values.collect::<Vec<_>>(), best, eta * eta, ratio_by)?;
    }
    Some(slope)
}

/// The change of that chattering time when the time of the last impact changes by `last` and the intervals by `intervals`, in order, while the ratio
/// stays: the closure in the column that [`close`] takes is linear in them. `None` with fewer than four impacts, and where an oracle has a
/// chattering time of its own.
pub fn shift(history: &History, last: f64, intervals: impl Iterator<Item = f64>, eta: f64) -> Option<f64> {
    if history.chattering_time.is_some() {
        return None;
    }
    let (best, _) = best_column(history, eta)?;
    let values: Vec<_> = history.impacts.iter().map(|impact| impact.interval).zip(intervals).collect();
    Some(last + tail_slope(&values, best, eta * eta, 0.0)?)
}

/// The derivative of what the columns up to `best` add, from the intervals and theirs, and from that of the ratio.
fn tail_slope(intervals: &[(f64, f64)], best: usize, ratio: f64, ratio_by: f64) -> Option<f64> {
    let mut row: Vec<(f64, f64)> = in_pairs(intervals)
        .map(|pair| pair.iter().fold((0.0, 0.0), |(sum, sum_by), (interval, by)| (sum + interval, sum_by + by)))
        .collect();
    row.reverse();
    let mut slope = 0.0;
    let (mut power, mut power_by) = (1.0, 0.0);
    for _ in 0..=best {
        (power, power_by) = (power * ratio, power_by * ratio + power * ratio_by);
        let rest = 1.0 - power;
        let &(difference, by) = row.last()?;
        slope += (power * by + power_by / rest * difference) / rest;
        row = row
            .windows(2)
            .filter_map(|two| match *two {
                [(early, early_by), (late, late_by)] => {
                    let value = (late - power * early) / rest;
                    Some((value, (late_by - power * early_by + power_by * (value - early)) / rest))
                }
                _ => None,
            })
            .collect();
    }
    Some(slope)
}

/// The chattering time by Eq. 75 with the last two intervals of the history; `None` with fewer than two impacts.
pub fn eq75(history: &History, eta: f64) -> Option<f64> {
    let last = history.impacts.last()?;
    let difference = pair_differences(&history.impacts).pop()?.value;
    Some(last.time + eta * eta / (1.0 - eta * eta) * difference)
}

/// Every second flight counted back from the last, with the one before it, the last pair first. The first four flights are left out if there
/// are others: the first, from rest, is not of the map whose expansion this is.
fn in_pairs<T>(flights: &[T]) -> impl Iterator<Item = &[T]> {
    let regular = flights.get(FIRST_FLIGHTS..).filter(|rest| rest.len() >= 4).unwrap_or(flights);
    regular.rchunks(2).take(MOST_COLUMNS + 1).filter(|pair| pair.len() == 2)
}

/// An entry of the table and what its error is made of.
#[derive(Clone, Copy)]
struct Entry {
    value: f64,
    /// What the oracle claims, taken as of one sign: what a method does wrong it does alike in neighbouring flights.
    bias: f64,
    /// What can be of any sign from one flight to the next: rounding.
    rounding: f64,
}

/// Of what an oracle claims no more than this, relative, can be rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl Entry {
    /// `τ_n - τ_{n-2}`.
    fn of(pair: &[Impact]) -> Self {
        let sum = |of: fn(&Impact) -> f64| pair.iter().map(|impact| impact.interval * of(impact)).sum();
        Self {
            value: sum(|_| 1.0),
            bias: sum(|impact| impact.uncertainty.interval),
            rounding: sum(|impact| impact.uncertainty.interval.clamp(f64::EPSILON, ROUNDING)),
        }
    }

    /// The entry of the next column: what is left when the errors that fall by `power` are removed.
    fn extrapolated(early: Self, late: Self, power: f64) -> Self {
        Self {
            value: (late.value - power * early.value) / (1.0 - power),
            bias: (late.bias - power * early.bias) / (1.0 - power),
            rounding: (late.rounding + power * early.rounding) / (1.0 - power),
        }
    }
}

/// The entries of the first column, in order of time.
fn pair_differences(impacts: &[Impact]) -> Vec<Entry> {
    let mut pairs = Vec::with_capacity(MOST_COLUMNS + 1);
    pairs.extend(in_pairs(impacts).map(Entry::of));
    pairs.reverse();
    pairs
}

/// The value in each column at the last impact, and its estimated error: from how much the column and the one before it changed the value, how
/// much the last two impacts changed the column, and the claimed errors of the intervals as the extrapolation magnifies them.
fn columns(mut row: Vec<Entry>, time: f64, eta: f64) -> impl Iterator<Item = Estimate> {
    let mut value = time;
    let mut power = 1.0;
    let mut last_change = 0.0;
    let (mut bias, mut rounding) = (0.0, 0.0);
    let mut drift = row.last().map_or(0.0, |last| last.value);
    std::iter::from_fn(move || {
        let late = *row.last()?;
        let early = *row.get(row.len().checked_sub(2)?)?;
        power *= eta * eta;
        let weight = power / (1.0 - power);
        let change = weight * late.value;
        value += change;
        drift += weight * (late.value - early.value);
        bias += weight * late.bias;
        rounding += weight * late.rounding;
        let truncation = SAFETY * change.abs().max(last_change).max(drift.abs());
        last_change = change.abs();
        // The next column in the place of this one, which is one entry longer.
        let mut entries = row.iter_mut().rev();
        let mut late = entries.next().copied();
        for entry in entries {
            let early = *entry;
            *entry = late.map_or(early, |late| Entry::extrapolated(early, late, power));
            late = Some(early);
        }
        row.pop();
        Some(Estimate { value, uncertainty: truncation + bias.abs() + rounding })
    })
}

#[cfg(test)]
mod tests;
