//! The closure against sums that are known, and against a fit of its own: a sum of powers of the ratio through the last differences.

use super::*;
use contract::{Ending, Uncertainty};
use proptest::prelude::*;

fn impact(time: f64, interval: f64, claim: f64) -> Impact {
    Impact { time, interval, velocity: 1.0, uncertainty: Uncertainty { time: claim, interval: claim, velocity: claim } }
}

/// The history of these intervals, each with this claim.
fn history(intervals: &[f64], claim: f64) -> History {
    let mut time = 0.0;
    let impacts = intervals.iter().map(|interval| {
        time += interval;
        impact(time, *interval, claim)
    });
    History { impacts: impacts.collect(), ending: Ending::AtRest, chattering_time: None }
}

/// What follows the last of these differences if each `k` back is `Σ c_j r^{-jk}`, `j` from 1 to `columns`: by solving for the `c_j`.
fn rest(differences: &[f64], ratio: f64, columns: usize) -> f64 {
    let mut rows: Vec<Vec<f64>> = (0..columns)
        .map(|back| {
            let powers = (1..=columns).map(|j| ratio.powi(-((j * back) as i32)));
            powers.chain([differences[differences.len() - 1 - back]]).collect()
        })
        .collect();
    for pivot in 0..columns {
        let top = rows[pivot].clone();
        for row in rows.iter_mut().skip(pivot + 1) {
            let factor = row[pivot] / top[pivot];
            row.iter_mut().zip(&top).for_each(|(entry, top)| *entry -= factor * top);
        }
    }
    let mut found = vec![0.0; columns];
    for index in (0..columns).rev() {
        let known: f64 = (index + 1..columns).map(|later| rows[index][later] * found[later]).sum();
        found[index] = (rows[index][columns] - known) / rows[index][index];
    }
    (1..).zip(&found).map(|(j, c)| c * ratio.powi(j) / (1.0 - ratio.powi(j))).sum()
}

fn entries(values: &[f64], biases: &[f64], roundings: &[f64]) -> Vec<Entry> {
    let pairs = values.iter().zip(biases).zip(roundings);
    pairs.map(|((&value, &bias), &rounding)| Entry { value, bias, rounding }).collect()
}

proptest! {
    /// Each column is the fit with one more power, to the value and to the claims taken as of one sign; rounding is of alternating sign, the
    /// worst for the fit. The truncation is three times the largest of the last two changes and of that from the last pair but one.
    #[test]
    fn each_column_is_a_fit_with_one_more_power(
        values in prop::array::uniform4(0.5..1.0f64), biases in prop::array::uniform4(0.5..1.0f64),
        roundings in prop::array::uniform4(0.5..1.0f64), eta in 0.4..0.8f64, time in 1.0..2.0f64,
    ) {
        let ratio = eta * eta;
        let found: Vec<Estimate> = columns(entries(&values, &biases, &roundings), time, eta).collect();
        prop_assert_eq!(found.len(), 3);
        let alternating: Vec<f64> = roundings.iter().zip([-1.0, 1.0, -1.0, 1.0]).map(|(rounding, sign)| sign * rounding).collect();
        let value = |columns: usize| if columns == 0 { time } else { time + rest(&values, ratio, columns) };
        let earlier = |columns: usize| time - values[3] + rest(&values[..3], ratio, columns);
        for (columns, found) in (1..).zip(&found) {
            let size = rest(&alternating, ratio, columns).abs() + 10.0;
            prop_assert!((found.value - value(columns)).abs() <= 1e-12 * size, "column {columns}");
            let before = if columns < 2 { 0.0 } else { value(columns - 1) - value(columns - 2) };
            let changes = [value(columns) - value(columns - 1), before, value(columns) - earlier(columns)];
            let truncation = 3.0 * changes.iter().fold(0.0f64, |largest, change| largest.max(change.abs()));
            let expected = truncation + rest(&biases, ratio, columns).abs() + rest(&alternating, ratio, columns);
            prop_assert!((found.uncertainty - expected).abs() <= 1e-11 * (size + expected), "column {columns}: {found:?}, {expected}");
        }
    }

    /// Sequences whose differences are sums of three powers are closed exactly by the third column, and the claim says so.
    #[test]
    fn a_sum_of_powers_is_closed_exactly(eta in 0.4..0.9f64, second in -0.3..0.3f64, third in -0.2..0.2f64, share in 0.3..0.7f64) {
        let ratio = eta * eta;
        let term = |k: i32, j: i32| [1.0, second, third][j as usize - 1] * ratio.powi(j * k);
        let difference = |k: i32| (1..=3).map(|j| term(k, j)).sum::<f64>();
        let intervals: Vec<f64> = (0..14).flat_map(|k| [share * difference(k), (1.0 - share) * difference(k)]).collect();
        let history = history(&intervals, 0.0);
        let rest: f64 = (1..=3).map(|j| term(14, j) / (1.0 - ratio.powi(j))).sum();
        let truth = history.impacts[27].time + rest;
        let found = close(&history, eta);
        prop_assert!(found.is_some_and(|found| (found.value - truth).abs() <= 1e-14 * truth && found.uncertainty < 1e-9), "{found:?} {truth}");
    }

    /// The derivative of the closure in a given column, by differences of the closure.
    #[test]
    fn the_tail_is_differentiated_with_its_ratios(
        intervals in prop::array::uniform6(0.5..1.0f64), by in prop::array::uniform6(-1.0..1.0f64), ratio in 0.2..0.6f64, ratio_by in -1.0..1.0f64,
    ) {
        let moved = |step: f64| {
            let pairs = [0, 1, 2].map(|pair| (0..2).map(|of| intervals[2 * pair + of] + step * by[2 * pair + of]).sum::<f64>());
            [1, 2, 3].map(|columns| rest(&pairs, ratio + step * ratio_by, columns))
        };
        let (above, below) = (moved(1e-5), moved(-1e-5));
        let both: Vec<(f64, f64)> = intervals.into_iter().zip(by).collect();
        for best in 0..3 {
            let expected = (above[best] - below[best]) / 2e-5;
            let found = tail_slope(&both, best, ratio, ratio_by);
            prop_assert!(found.is_some_and(|found| (found - expected).abs() <= 1e-6 * (1.0 + expected.abs())), "{best}: {found:?} {expected}");
        }
        prop_assert!(tail_slope(&both, 3, ratio, ratio_by).is_none());
    }
}

/// The whole derivative: of the time of the last impact, and of the tail, with the ratio for `η` alone.
#[test]
fn the_chattering_time_is_differentiated_by_each_parameter() {
    let by = |parameter: usize, n: usize| 0.1 * (parameter as f64 + 1.0) / (n as f64 + 1.0);
    let (eta, count) = (0.7f64, 12);
    let intervals: Vec<f64> =
        (0..count).map(|n| 0.7f64.powi(n as i32) * (1.0 + 0.01 * 0.5f64.powi(n as i32))).collect();
    let history = history(&intervals, 1e-12);
    let sensitivities: Vec<Sensitivity> = (0..count)
        .map(|n| {
            let interval = [0, 1, 2].map(|parameter| by(parameter, n));
            let time = [0, 1, 2].map(|parameter| (0..=n).map(|n| by(parameter, n)).sum());
            Sensitivity { time, interval, velocity: [0.0; 3] }
        })
        .collect();
    let Some((best, _)) = best_column(&history, eta) else { panic!("no column") };
    let Some(found) = sensitivity(&history, &sensitivities, eta) else { panic!("no derivative") };
    for (parameter, found) in found.into_iter().enumerate() {
        let moved = |step: f64| {
            let intervals: Vec<f64> = intervals.iter().enumerate().map(|(n, i)| i + step * by(parameter, n)).collect();
            let pairs: Vec<f64> = intervals[4..].chunks(2).map(|pair| pair.iter().sum()).collect();
            let eta = if parameter == 2 { eta + step } else { eta };
            intervals.iter().sum::<f64>() + rest(&pairs, eta * eta, best + 1)
        };
        let expected = (moved(1e-6) - moved(-1e-6)) / 2e-6;
        assert!((found - expected).abs() < 1e-7 * expected.abs(), "{parameter}: {found} {expected}");
    }
    let own = History { chattering_time: Some(Estimate { value: 3.0, uncertainty: 0.5 }), ..history };
    assert_eq!(sensitivity(&own, &sensitivities, eta), None);
    assert_eq!(close(&own, eta), Some(Estimate { value: 3.0, uncertainty: 0.5 }));
}

/// The column with the smallest error is taken, with the claim for the last impact on top.
#[test]
fn the_best_column_is_taken_and_the_time_of_the_last_impact_is_claimed_for() {
    let history = history(&[1.0, 0.9, 0.64, 0.57, 0.41, 0.36, 0.26, 0.23, 0.166, 0.149, 0.105, 0.094], 1e-3);
    let pairs = pair_differences(&history.impacts);
    let all: Vec<Estimate> = columns(pairs, history.impacts[11].time, 0.8).collect();
    let least = all.iter().map(|column| column.uncertainty).fold(f64::INFINITY, f64::min);
    let found = close(&history, 0.8);
    assert!(found.is_some_and(|found| found.uncertainty == least + 1e-3));
    assert!(all.iter().any(|column| Some(column.value) == found.map(|found| found.value)));
    assert!(all.iter().any(|column| column.uncertainty > 1.01 * least));
    // Two pairs are needed for a column.
    for (count, closed) in [(0, false), (1, false), (2, false), (3, false), (4, true)] {
        let mut short = history.clone();
        short.impacts.truncate(count);
        assert_eq!(close(&short, 0.8).is_some(), closed, "{count} impacts");
    }
}

/// `r/(1 - r)` times the last two intervals: for `η² = 1/2` these themselves.
#[test]
fn eq_75_closes_with_the_last_two_intervals() {
    let found = eq75(&history(&[1.0, 0.5, 0.25], 0.0), 0.5f64.sqrt());
    assert!(found.is_some_and(|found| (found - 2.5).abs() < 1e-15), "{found:?}");
    let found = eq75(&history(&[1.0, 0.5], 0.0), 0.5);
    assert!(found.is_some_and(|found| (found - 2.0).abs() < 1e-15), "{found:?}");
    assert_eq!(eq75(&history(&[1.0], 0.0), 0.5), None);
}

/// Pairs are counted from the last impact; the first four flights are left out where four others are left, and more than 25 pairs are not used.
#[test]
fn which_flights_are_paired() {
    let pairs = |count: usize| in_pairs(&(0..count).collect::<Vec<_>>()).map(<[usize]>::to_vec).collect::<Vec<_>>();
    assert_eq!(pairs(3), [[1, 2]]);
    assert_eq!(pairs(7), [[5, 6], [3, 4], [1, 2]]);
    assert_eq!(pairs(8), [[6, 7], [4, 5]]);
    assert_eq!(pairs(9), [[7, 8], [5, 6]]);
    assert_eq!((pairs(53).len(), pairs(54).len(), pairs(100).len()), (24, 25, 25));
    assert_eq!(pairs(100)[24], [50, 51]);
}

/// What an oracle claims is taken as a bias, and as rounding no less than one and no more than eight units.
#[test]
fn what_an_entry_is_made_of() {
    let unit = f64::EPSILON;
    let entry = Entry::of(&[impact(1.0, 0.5, 0.25), impact(1.25, 0.25, 0.0)]);
    assert_eq!((entry.value, entry.bias, entry.rounding), (0.75, 0.125, 0.5 * 8.0 * unit + 0.25 * unit));
    let entry = Entry::of(&[impact(1.0, 0.5, 2.0 * unit), impact(1.25, 0.25, 4.0 * unit)]);
    assert_eq!((entry.bias, entry.rounding), (2.0 * unit, 2.0 * unit));
}
