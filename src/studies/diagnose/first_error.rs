use contract::Decline;
use rayon::prelude::*;
use serde::Serialize;

use super::{
    ORDERS, PAPER, map, spread,
    truth::{critical_epsilon, stepped},
};
use asymptotic::{Expansion, coefficients};

/// The smallest amplitude at which an order errs by 1 %.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FirstErrorRow {
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// `paper (Eq. 65)`, or the number of terms.
    pub order: String,
    /// The amplitude; nothing if the order does not err by so much at all below `a_cr`.
    pub a: Option<f64>,
    /// The same as `(a - 1)/(a_cr - 1)`.
    pub share: Option<f64>,
}

/// What counts as an error.
const ERROR: f64 = 0.01;

pub(super) fn measure(grid: usize, done: impl Fn() + Sync) -> Result<Vec<FirstErrorRow>, Decline> {
    let rows = map(grid).into_par_iter().map(|(omega, eta)| {
        let rows = of_one(omega, eta);
        done();
        rows
    });
    Ok(rows.collect::<Result<Vec<_>, _>>()?.concat())
}

fn of_one(omega: f64, eta: f64) -> Result<Vec<FirstErrorRow>, Decline> {
    let critical = critical_epsilon(omega, eta)?;
    let most = ORDERS.into_iter().max().unwrap_or(1);
    let expansion = Expansion::new(omega, eta, most, 0)?;
    // First coarsely, every truth once for all orders.
    let shares: Vec<f64> = spread(0.0, 0.99, 99).skip(1).chain([0.995, 0.998, 0.999]).collect();
    let truths: Vec<Option<f64>> = shares.iter().map(|share| stepped(share * critical, omega, eta)).collect();
    let mut rows = Vec::new();
    let mut add = |order: String, value: &dyn Fn(f64) -> f64| {
        let is_off = |share: f64, truth: f64| (value(share * critical) / truth - 1.0).abs() >= ERROR;
        let first =
            shares.iter().zip(&truths).position(|(&share, truth)| truth.is_some_and(|truth| is_off(share, truth)));
        let share = first.and_then(|first| {
            let mut low = first.checked_sub(1).and_then(|before| shares.get(before).copied()).unwrap_or(0.0);
            let mut high = *shares.get(first)?;
            for _ in 0..20 {
                let middle = 0.5 * (low + high);
                if is_off(middle, stepped(middle * critical, omega, eta)?) { high = middle } else { low = middle }
            }
            Some(high)
        });
        rows.push(FirstErrorRow { omega, eta, order, a: share.map(|share| 1.0 + share * critical), share });
    };
    if let Some(paper) = coefficients(eta) {
        add(PAPER.to_owned(), &|epsilon| paper.chattering_time(epsilon, omega));
    }
    for order in ORDERS {
        add(order.to_string(), &|epsilon| expansion.partial_sum(order, epsilon));
    }
    Ok(rows)
}
