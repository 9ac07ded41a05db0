//! Random questions for whole responses.

use std::f64::consts::{PI, TAU};

use contract::{Case, Normalisation, Slenderness};
use proptest::{prelude::*, strategy::ValueTree};

use super::random::{logarithmic, runner};
use crate::cases::shaking::Shaking;

/// `count` random responses made from `seed`.
pub fn shakings(seed: u64, count: usize) -> Vec<Shaking> {
    let mut runner = runner(seed);
    let strategy = strategy();
    (0..count).filter_map(|_| Some(strategy.new_tree(&mut runner).ok()?.current())).collect()
}

/// Blocks of any restitution under anything from too weak a shaking to one that overturns them, from any phase, for a part of a cycle or several.
fn strategy() -> impl Strategy<Value = Shaking> {
    let a = prop_oneof![
        1 => 0.0..1.0,
        5 => logarithmic(1e-3, 0.5).prop_map(|epsilon| 1.0 + epsilon),
        6 => 1.5..5.0,
    ];
    let omega = logarithmic(0.3, 8.0);
    let eta = prop_oneof![5 => 0.75..0.97, 3 => 0.3..0.75, 1 => 0.05..0.3, 1 => logarithmic(1e-3, 3e-2).prop_map(|loss| 1.0 - loss)];
    let alpha =
        prop_oneof![1 => Just(None), 3 => logarithmic(0.02, 0.4).prop_map(Some), 1 => (0.4..1.2).prop_map(Some)];
    let phase = prop_oneof![1 => Just(None), 2 => (-PI..PI).prop_map(Some)];
    // In cycles: of the shaking, and of the response.
    let lasts = prop_oneof![1 => Just(None), 4 => (0.1..0.8).prop_map(Some), 2 => (1.0..6.0).prop_map(Some)];
    let until = prop_oneof![1 => Just(None), 1 => (0.2..6.0).prop_map(Some)];
    (a, omega, eta, alpha, phase, lasts, until).prop_filter_map(
        "a case that the contract refuses",
        |(a, omega, eta, alpha, phase, lasts, until)| {
            let (alpha, phase): (Option<f64>, Option<f64>) = (alpha, phase);
            let (lasts, until): (Option<f64>, Option<f64>) = (lasts, until);
            let case = Case::from_amplitude(a, omega, eta).ok()?;
            let slenderness = alpha.and_then(|alpha| Slenderness::new(alpha, Normalisation::Threshold).ok());
            let case = slenderness.map_or(case, |slenderness| case.with_slenderness(slenderness));
            let time = |cycles: f64| cycles * TAU / omega;
            let until = match (lasts, until) {
                (None, until) => time(until.unwrap_or(3.0)),
                (Some(_), until) => until.map_or(f64::INFINITY, time),
            };
            Some(Shaking { case, phase, lasts: lasts.map(time), until })
        },
    )
}
