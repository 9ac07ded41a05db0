//! Impact events per second of each oracle, on one thread.
//!
//! The workload: 200 seeded cases with `a` in [1.005, 1.035], `ω` in [0.5, 8], `η` in [0.80, 0.95], 60 impacts each. Every answer is verified
//! before it is timed: an oracle that disagrees with the closed form, or with a value from many digits, is not worth timing.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

use std::{hint::black_box, time::Duration};

use asymptotic::{Asymptotic, Expansion, Resummed};
use chattercheck::observables::Observed;
use closed_form::ClosedForm;
use contract::{Case, History, Normalisation, Oracle, Slenderness};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ode::{Equation, Method, Ode};
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};

/// The chattering time of (1.03, 2, 0.92), from `printed` with 60 digits.
const TAU_CH: f64 = 1.125_947_676_933_812_1;

fn workload() -> Vec<Case> {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[6; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let strategy = (1.005..1.035, 0.5..8.0, 0.80..0.95).prop_map(|(a, omega, eta)| {
        let slenderness = Slenderness::new(0.1, Normalisation::Threshold).expect("in range");
        Case::from_amplitude(a, omega, eta).expect("in range").with_slenderness(slenderness)
    });
    (0..200).map(|_| strategy.new_tree(&mut runner).expect("a case").current()).collect()
}

/// The impacts that the workload makes, after making sure that they are right to within `tolerance`, relative in the interval.
fn verified(name: &str, run: &dyn Fn(&Case) -> Option<History>, cases: &[Case], tolerance: f64) -> u64 {
    let reference = Case::from_amplitude(1.03, 2.0, 0.92).expect("in range").with_max_impacts(80).expect("in range");
    let closed = Observed::new(&reference, ClosedForm.history(&reference).expect("a history"));
    let time = closed.chattering_time.expect("complete").value;
    assert!((time - TAU_CH).abs() < 1e-13, "the closed form itself is off by {:e}", time - TAU_CH);
    let mut impacts = 0;
    for case in cases {
        let (exact, Some(found)) = (ClosedForm.history(case).expect("a history"), run(case)) else { continue };
        assert_eq!(found.impacts.len(), exact.impacts.len(), "{name} has another number of impacts in {case:?}");
        for (one, two) in exact.impacts.iter().zip(&found.impacts) {
            let error = (two.interval / one.interval - 1.0).abs();
            // An ill-conditioned case, for which the closed form itself claims less, is allowed as much more.
            let allowed = tolerance * f64::max(1.0, one.uncertainty.interval / 1e-14);
            assert!(error <= allowed, "{name} is off by {error:e} in {case:?}");
        }
        impacts += found.impacts.len() as u64;
    }
    assert!(impacts > 5_000, "{name} made {impacts} impacts only");
    impacts
}

fn throughput(criterion: &mut Criterion) {
    let cases = workload();
    let linear = |method: Method, rtol: f64| {
        let ode = Ode::new(Equation::Linear, method).with_rtol(rtol).expect("in range");
        move |case: &Case| ode.impacts(case).ok()
    };
    let nonlinear = Ode::new(Equation::Nonlinear, Method::Tsit45).with_rtol(1e-10).expect("in range");
    let paper = Asymptotic::new();
    type Run = Box<dyn Fn(&Case) -> Option<History>>;
    // The tolerance that the answer has to meet before it is timed: generous for methods of low order, and for the other model.
    let oracles: Vec<(&str, f64, Run)> = vec![
        ("closed-form", 1e-13, Box::new(|case| ClosedForm.history(case).ok())),
        ("ode/linear/tsit45 rtol=1e-10", 1e-6, Box::new(linear(Method::Tsit45, 1e-10))),
        ("ode/linear/bdf rtol=1e-9", 1e-4, Box::new(linear(Method::Bdf, 1e-9))),
        ("ode/linear/tr-bdf2 rtol=1e-8", 1e-2, Box::new(linear(Method::TrBdf2, 1e-8))),
        ("ode/linear/esdirk34 rtol=1e-10", 1e-4, Box::new(linear(Method::Esdirk34, 1e-10))),
        ("ode/nonlinear/tsit45 rtol=1e-10", 1e-2, Box::new(move |case| nonlinear.impacts(case).ok())),
        // The series is off by a multiple of epsilon: it is timed for what it is.
        ("asymptotic/paper", 1.0, Box::new(move |case| paper.history(case).ok())),
    ];
    let mut group = criterion.benchmark_group("impacts");
    group.sample_size(10).measurement_time(Duration::from_secs(3)).warm_up_time(Duration::from_millis(500));
    for (name, tolerance, run) in &oracles {
        let impacts = verified(name, run.as_ref(), &cases, *tolerance);
        group.throughput(Throughput::Elements(impacts));
        group.bench_function(*name, |bencher| {
            bencher.iter(|| cases.iter().map(|case| run(black_box(case))).for_each(|h| drop(black_box(h))))
        });
    }
    group.finish();
}

/// The series to any order: its coefficients once for each frequency and restitution, and then a value at each amplitude.
fn series(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("series");
    for terms in [16, 40, 96] {
        let expansion = || Expansion::new(2.0, 0.92, terms, 0).expect("in range");
        let value = expansion().partial_sum(terms, 1.001 - 1.0);
        // Proven by the enclosure.
        assert!((value / 0.171_838_004_435_673_67 - 1.0).abs() < 1e-14, "{terms} terms: {value}");
        group.bench_function(format!("coefficients/{terms}"), |bencher| bencher.iter(|| black_box(expansion())));
        let known = expansion();
        group.bench_function(format!("value/{terms}"), |bencher| {
            bencher.iter(|| black_box(&known).partial_sum(terms, black_box(0.02)))
        });
        if let Ok(resummed) = Resummed::new(&known) {
            group.bench_function(format!("resummed value/{terms}"), |bencher| {
                bencher.iter(|| black_box(&resummed).chattering_time(black_box(0.02)))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, throughput, series);
criterion_main!(benches);
