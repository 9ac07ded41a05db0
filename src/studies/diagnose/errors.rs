use contract::Decline;
use rayon::prelude::*;
use serde::Serialize;

use super::{
    ORDERS, PAPER, spread,
    truth::{critical_epsilon, proven},
};
use crate::measure::excitation::half_period;
use asymptotic::{Alternative, Expansion, Resummed, coefficients};

/// The error of one method at one amplitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ErrorRow {
    /// The restitution.
    pub eta: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// `paper`, `order K`, `resummed`, or one of the ways of resumming that were not taken.
    pub method: String,
    /// The amplitude.
    pub a: f64,
    /// `(a - 1)/(a_cr - 1)`.
    pub share: f64,
    /// What is left of the way, 1 less the share, without the cancellation.
    pub to_go: f64,
    /// `τ_ch/(T/2)` by this method; nothing where it gives none.
    pub half_period_fraction: Option<f64>,
    /// Its relative error, against the enclosure.
    pub error: Option<f64>,
    /// What the method claims as its relative error, if it claims one there.
    pub claim: Option<f64>,
}

/// At even shares of the way to `a_cr`, and at shares ever nearer to it.
pub(super) fn measure(expansions: &[Expansion], done: impl Fn() + Sync) -> Result<Vec<ErrorRow>, Decline> {
    let to_go: Vec<f64> = spread(0.99, 0.02, 48).chain(spread(-2.0, -7.0, 30).map(|log| 10.0_f64.powf(log))).collect();
    let rows = expansions.par_iter().map(|expansion| {
        let rows = of_one(expansion, &to_go);
        done();
        rows
    });
    Ok(rows.collect::<Result<Vec<_>, _>>()?.concat())
}

fn of_one(expansion: &Expansion, to_go: &[f64]) -> Result<Vec<ErrorRow>, Decline> {
    let (omega, eta) = (expansion.omega(), expansion.eta());
    let critical = critical_epsilon(omega, eta)?;
    let places: Vec<(f64, f64, Option<f64>)> = to_go
        .par_iter()
        .map(|&to_go| {
            let epsilon = critical * (1.0 - to_go);
            (to_go, epsilon, proven(epsilon, omega, eta))
        })
        .collect();
    let mut rows = Vec::new();
    for (method, value) in methods(expansion)? {
        for &(to_go, epsilon, truth) in &places {
            let (value, claim) = value(epsilon).unzip();
            let half_period = half_period(omega);
            rows.push(ErrorRow {
                eta,
                omega,
                method: method.clone(),
                a: 1.0 + epsilon,
                share: 1.0 - to_go,
                to_go,
                half_period_fraction: value.map(|value| value / half_period),
                error: value.zip(truth).map(|(value, truth)| (value / truth - 1.0).abs()),
                claim: claim.flatten(),
            });
        }
    }
    Ok(rows)
}

/// A value at an amplitude and the relative error that is claimed for it.
type Approximation<'a> = Box<dyn Fn(f64) -> Option<(f64, Option<f64>)> + 'a>;

/// The methods by name.
fn methods(expansion: &Expansion) -> Result<Vec<(String, Approximation<'_>)>, Decline> {
    let (omega, eta) = (expansion.omega(), expansion.eta());
    let mut methods: Vec<(String, Approximation)> = Vec::new();
    if let Some(paper) = coefficients(eta) {
        let value = move |epsilon: f64| Some((paper.chattering_time(epsilon, omega), None));
        methods.push((PAPER.to_owned(), Box::new(value)));
    }
    for order in ORDERS {
        let value = move |epsilon: f64| {
            let claimed = expansion.chattering_time(order, epsilon);
            let claim = claimed.map(|estimate| estimate.uncertainty / estimate.value);
            Some((expansion.partial_sum(order, epsilon), claim))
        };
        methods.push((format!("order {order}"), Box::new(value)));
    }
    let resummed = Resummed::new(expansion)?;
    let value = move |epsilon: f64| {
        let estimate = resummed.chattering_time(epsilon)?;
        Some((estimate.value, Some(estimate.uncertainty / estimate.value)))
    };
    methods.push(("resummed".to_owned(), Box::new(value)));
    let alternatives = [
        ("reverted series", Some(Alternative::reverted(expansion))),
        ("H cut off", Some(Alternative::truncated(expansion))),
        ("H by Padé", Alternative::pade(expansion)),
    ];
    for (name, alternative) in alternatives {
        if let Some(alternative) = alternative {
            let value = move |epsilon: f64| Some((alternative.chattering_time(epsilon)?, None));
            methods.push((name.to_owned(), Box::new(value)));
        }
    }
    Ok(methods)
}
