//! Impact events per second of each oracle, and of batches on each instruction set, on one thread.
//!
//! Every answer is verified before it is timed: an oracle that disagrees with the tables of reference is not worth timing.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing)]

mod verified;

use std::{hint::black_box, time::Duration};

use asymptotic::{Asymptotic, Expansion, Resummed};
use closed_form::{ClosedForm, batch::InstructionSet};
use contract::{Case, History, Model, Oracle};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ode::{Equation, Ode, Solver};
use taylor::Taylor;

use verified::{Batched, IMPACTS, one_thread, verify_impacts, workload};

/// Whether an oracle solves the nonlinear equation, by its name.
fn nonlinear_model(name: &str) -> bool {
    name.starts_with("taylor") || name.starts_with("ode/nonlinear")
}

fn throughput(criterion: &mut Criterion) {
    let cases = workload(200);
    let linear = |method: Solver, rtol: f64| {
        let ode = Ode::new(Equation::Linear, method).with_rtol(rtol).expect("in range");
        move |case: &Case| ode.impacts(case).ok()
    };
    let nonlinear = Ode::new(Equation::Nonlinear, Solver::Tsit45).with_rtol(1e-10).expect("in range");
    let paper = Asymptotic::new();
    type Run = Box<dyn Fn(&Case) -> Option<History>>;
    // The tolerance that the answer has to meet before it is timed: generous for methods of low order, and for the other model.
    let oracles: Vec<(&str, f64, Run)> = vec![
        ("closed-form", 1e-12, Box::new(|case| ClosedForm.history(case).ok())),
        ("taylor", 1e-6, Box::new(|case| Taylor.history(case).ok())),
        ("ode/linear/tsit45 rtol=1e-10", 1e-5, Box::new(linear(Solver::Tsit45, 1e-10))),
        ("ode/linear/bdf rtol=1e-9", 1e-3, Box::new(linear(Solver::Bdf, 1e-9))),
        ("ode/linear/tr-bdf2 rtol=1e-8", 5e-2, Box::new(linear(Solver::TrBdf2, 1e-8))),
        ("ode/linear/esdirk34 rtol=1e-10", 1e-3, Box::new(linear(Solver::Esdirk34, 1e-10))),
        ("ode/nonlinear/tsit45 rtol=1e-10", 1e-5, Box::new(move |case| nonlinear.impacts(case).ok())),
        // The series is off by a multiple of epsilon: it is timed for what it is.
        ("asymptotic/paper", 10.0, Box::new(move |case| paper.history(case).ok())),
    ];
    let mut group = criterion.benchmark_group("impacts");
    group.sample_size(10).measurement_time(Duration::from_secs(2)).warm_up_time(Duration::from_millis(300));
    for (name, tolerance, run) in &oracles {
        let model = if nonlinear_model(name) { Model::Nonlinear } else { Model::Linear };
        verify_impacts(name, model, run.as_ref(), *tolerance);
        let impacts: usize = cases.iter().filter_map(run).map(|history| history.impacts.len()).sum();
        group.throughput(Throughput::Elements(impacts as u64));
        group.bench_function(*name, |bencher| {
            bencher.iter(|| cases.iter().map(|case| run(black_box(case))).for_each(|h| drop(black_box(h))))
        });
    }
    let cases = workload(100_000);
    let mut batched = Batched::new(&cases, IMPACTS);
    let thread = one_thread();
    for set in InstructionSet::available() {
        Batched::verify(set, 1e-12);
        let tally = batched.run(set);
        group.throughput(Throughput::Elements(tally.impacts));
        let name = format!("batch/{set:?}");
        group.bench_function(name, |bencher| bencher.iter(|| thread.install(|| batched.run(set))));
    }
    group.finish();
}

/// The cost of one sequence against its depth: how many impacts are followed.
fn depth(criterion: &mut Criterion) {
    let case = Case::from_amplitude(1.03, 2.0, 0.92).expect("a case");
    let tsit45 = Ode::new(Equation::Linear, Solver::Tsit45).with_rtol(1e-10).expect("in range");
    verify_impacts("closed-form", Model::Linear, &|case| ClosedForm.history(case).ok(), 1e-12);
    verify_impacts("ode", Model::Linear, &|case| tsit45.impacts(case).ok(), 1e-6);
    Batched::verify(InstructionSet::fastest(), 1e-12);
    let thread = one_thread();
    let mut group = criterion.benchmark_group("depth");
    group.sample_size(10).measurement_time(Duration::from_millis(500)).warm_up_time(Duration::from_millis(200));
    for impacts in [10, 40, 160, 640] {
        let case = case.with_max_impacts(impacts).expect("in range");
        group.throughput(Throughput::Elements(impacts as u64));
        group.bench_function(format!("closed-form/{impacts}"), |bencher| {
            bencher.iter(|| ClosedForm.history(black_box(&case)))
        });
        group.bench_function(format!("ode/{impacts}"), |bencher| bencher.iter(|| tsit45.impacts(black_box(&case))));
        let cases = vec![case; 1024];
        let mut batched = Batched::new(&cases, impacts);
        group.throughput(Throughput::Elements((cases.len() * impacts) as u64));
        let set = InstructionSet::fastest();
        group.bench_function(format!("batch of 1024/{impacts}"), |bencher| {
            bencher.iter(|| thread.install(|| batched.run(set)))
        });
    }
    group.finish();
}

/// The series to any order: its coefficients once for each frequency and restitution, and then a value at each amplitude.
fn series(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("series");
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(300));
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

criterion_group!(benches, throughput, depth, series);
criterion_main!(benches);
