//! What one chattering time costs: to a tolerance, by the cheapest setting of each oracle that meets it; and to 1e-6 at each distance from the
//! critical amplitude.
//!
//! Every setting is first asked, and its answer compared with the proven one. Of those that are good enough the one that took least time is timed.
//! An oracle without any is a line that says so.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

mod verified;

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use asymptotic::{Asymptotic, Order};
use closed_form::ClosedForm;
use contract::{Case, Model, Oracle};
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main, measurement::WallTime};
use enclosure::Enclosure;
use ode::{Equation, Ode, Solver};
use printed::Printed;

use verified::{Proven, chattering_time, proven};

/// One way to ask an oracle.
struct Setting {
    oracle: Box<dyn Oracle>,
    impacts: usize,
    name: String,
}

/// An oracle by all its settings.
struct Candidate {
    name: &'static str,
    settings: Vec<Setting>,
}

const DEPTHS: [usize; 11] = [8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 400];

fn setting(oracle: impl Oracle + 'static, impacts: usize, name: impl Into<String>) -> Setting {
    Setting { oracle: Box::new(oracle), impacts, name: name.into() }
}

fn methods() -> Vec<Candidate> {
    let by_depth = |name, oracle: fn(usize) -> Setting| Candidate { name, settings: DEPTHS.map(oracle).into() };
    let mut methods = vec![by_depth("closed-form", |n| setting(ClosedForm, n, format!("{n} impacts")))];
    for (name, method) in [("ode/tsit45", Solver::Tsit45), ("ode/bdf", Solver::Bdf), ("ode/esdirk34", Solver::Esdirk34)]
    {
        let mut settings = Vec::new();
        for rtol in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let ode = Ode::new(Equation::Linear, method).with_rtol(rtol).expect("in range");
            settings.extend([16, 32, 64, 128].map(|n| setting(ode.clone(), n, format!("rtol {rtol:e}, {n} impacts"))));
        }
        methods.push(Candidate { name, settings });
    }
    let order = |order, name| setting(Asymptotic::new().with_order(order).expect("in range"), 60, name);
    let mut settings = vec![order(Order::Paper, "paper".to_owned()), order(Order::Resummed, "resummed".to_owned())];
    settings.extend([2, 4, 8, 16, 32].map(|terms| order(Order::Terms(terms), format!("{terms} terms"))));
    methods.push(Candidate { name: "asymptotic", settings });
    let enclosure = |digits: u32| {
        let enclosure = Enclosure::new(Model::Linear).with_digits(digits).expect("in range");
        setting(enclosure, 60, format!("{digits} digits"))
    };
    methods.push(Candidate { name: "enclosure", settings: [4, 8, 12, 16].map(enclosure).into() });
    methods.push(Candidate { name: "printed", settings: vec![setting(Printed::default(), 200, "60 digits")] });
    methods
}

/// What a setting is asked, if it has an answer within `tolerance`, relative; and how long that takes.
fn tried(setting: &Setting, proven: &Proven, tolerance: f64) -> Option<(Case, Duration)> {
    let case = proven.case.with_max_impacts(setting.impacts).expect("in range");
    let mut shortest = Duration::MAX;
    for _ in 0..3 {
        let start = Instant::now();
        let time = chattering_time(setting.oracle.as_ref(), &case)?;
        shortest = shortest.min(start.elapsed());
        if (time / proven.time - 1.0).abs() > tolerance {
            return None;
        }
    }
    Some((case, shortest))
}

fn time_the_cheapest(
    group: &mut BenchmarkGroup<WallTime>,
    method: &Candidate,
    proven: &Proven,
    tolerance: f64,
    at: &str,
) {
    let good = method.settings.iter().filter_map(|setting| Some((setting, tried(setting, proven, tolerance)?)));
    let Some((setting, (case, _))) = good.min_by_key(|(_, (_, took))| *took) else {
        eprintln!("chattering time/{}/{at}: no setting meets {tolerance:e}", method.name);
        return;
    };
    let name = format!("{}/{at} ({})", method.name, setting.name);
    group.bench_function(name, |bencher| bencher.iter(|| chattering_time(setting.oracle.as_ref(), black_box(&case))));
}

fn to_a_tolerance(criterion: &mut Criterion) {
    let cases = proven();
    let middle =
        cases.iter().min_by(|a, b| (a.distance - 0.6).abs().total_cmp(&(b.distance - 0.6).abs())).expect("cases");
    let mut group = criterion.benchmark_group("chattering time");
    group.sample_size(10).measurement_time(Duration::from_millis(300)).warm_up_time(Duration::from_millis(100));
    for method in &methods() {
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
            time_the_cheapest(&mut group, method, middle, tolerance, &format!("{tolerance:e}"));
        }
    }
    group.finish();
}

fn near_the_critical_amplitude(criterion: &mut Criterion) {
    let cases = proven();
    let mut group = criterion.benchmark_group("distance");
    group.sample_size(10).measurement_time(Duration::from_millis(300)).warm_up_time(Duration::from_millis(100));
    for method in methods().iter().filter(|method| ["closed-form", "ode/tsit45", "asymptotic"].contains(&method.name)) {
        for proven in &cases {
            time_the_cheapest(&mut group, method, proven, 1e-6, &format!("{:.2}", proven.distance));
        }
    }
    group.finish();
}

criterion_group!(benches, to_a_tolerance, near_the_critical_amplitude);
criterion_main!(benches);
