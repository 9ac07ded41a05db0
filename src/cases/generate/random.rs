//! Random cases, by proptest strategies.

use contract::Case;
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};

use super::{case, impacts_for};
use crate::measure::critical;

/// The name and case of `count` random cases made from `seed`.
pub(super) fn cases(seed: u64, count: usize) -> Vec<(String, Case)> {
    let mut runner = runner(seed);
    let (usual, wide) = (usual(), wide());
    let mut next = |n: usize| {
        let made = if n.is_multiple_of(WIDE) {
            wide.new_tree(&mut runner).map(|tree| tree.current())
        } else {
            usual.new_tree(&mut runner).map(|tree| tree.current())
        };
        made.ok()
    };
    (1..=count).filter_map(|n| Some((n.to_string(), next(n)?))).collect()
}

/// A source of random numbers that is a function of the seed alone.
pub(super) fn runner(seed: u64) -> TestRunner {
    let mut bytes = [0; 32];
    bytes.iter_mut().zip(seed.to_le_bytes()).for_each(|(byte, of_seed)| *byte = of_seed);
    let config = Config { failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
}

/// One of so many cases is from far outside the range of use, where a fault that only shows there has nowhere else to be seen.
const WIDE: usize = 8;

/// A case of the range of use: restitution, frequency and slenderness over all of it, the amplitude mostly below the critical
/// one and down to a hair above the threshold, the depth mostly what the tail needs and sometimes far beyond.
fn usual() -> impl Strategy<Value = Case> {
    let eta = prop_oneof![4 => 0.75..0.96, 2 => 0.5..0.75, 1 => 0.96..0.985];
    let omega = prop_oneof![6 => logarithmic(0.5, 8.0), 1 => logarithmic(0.1, 20.0)];
    // as a share of a_cr - 1
    let share = prop_oneof![
        6 => 0.02..0.97,
        2 => logarithmic(1e-7, 1e-2),
        1 => logarithmic(1e-5, 1e-1).prop_map(|gap| 1.0 - gap),
        1 => 1.02..1.8,
    ];
    let alpha = logarithmic(0.02, 0.4);
    let depth = prop_oneof![15 => Just(1), 1 => 2..6_usize];
    (eta, omega, share, alpha, depth).prop_filter_map(
        "a case that the contract refuses",
        |(eta, omega, share, alpha, depth)| {
            let epsilon = share * (critical::eq77(eta) - 1.0);
            case(epsilon, omega, eta, alpha)?.with_max_impacts(depth * impacts_for(eta)).ok()
        },
    )
}

/// A case from anywhere: restitution from 0.02 to within 1e-4 of 1, four decades of frequency, eight of amplitude, both sides of the critical one.
fn wide() -> impl Strategy<Value = Case> {
    let eta = prop_oneof![logarithmic(0.02, 0.5), logarithmic(1e-4, 0.5).prop_map(|lost| 1.0 - lost)];
    let omega = prop_oneof![logarithmic(0.01, 200.0), logarithmic(0.01, 0.1), logarithmic(20.0, 200.0)];
    let epsilon = prop_oneof![2 => logarithmic(1e-8, 1e-2), 1 => logarithmic(1e-2, 1.0)];
    let alpha = logarithmic(0.01, 1.2);
    (eta, omega, epsilon, alpha).prop_filter_map("a case that the contract refuses", |(eta, omega, epsilon, alpha)| {
        case(epsilon, omega, eta, alpha)
    })
}

/// Uniform in the logarithm.
pub(super) fn logarithmic(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low.ln()..high.ln()).prop_map(f64::exp)
}
