//! What the time that is left costs, by the order of the series. Each answer is verified before it is timed.
//!
//! ```text
//! cargo bench -p accumulation
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

use std::hint::black_box;

use accumulation::Accumulation;
use contract::{Body, Closure, Departure, Ground, Motion, Sinusoid, Stretch};
use criterion::{Criterion, criterion_group, criterion_main};

/// What stepping with 50 digits takes, linear and nonlinear (alpha = 0.3).
const LEFT: [(Option<f64>, f64); 2] = [(None, 0.004_426_335_689_387_336), (Some(0.3), 0.004_492_908_471_650_057)];

fn orders(criterion: &mut Criterion) {
    let term = Sinusoid { amplitude: 1.03, omega: 2.0, phase: 0.5 };
    let motion = Motion::sinusoids(vec![Stretch { until: f64::INFINITY, terms: vec![term] }]).unwrap();
    let departure = Departure { ground: Ground::Shaking, time: 0.9, side: 1.0, rotation: 0.0, velocity: 2e-4 };
    for (alpha, left) in LEFT {
        for order in [4, 8, 12] {
            let body = Body::new(0.8, alpha).unwrap();
            let closure = Accumulation::default().with_order(order).unwrap().series(&body, &motion);
            let found = closure.time_left(&departure).unwrap();
            assert!((found.value - left).abs() <= found.uncertainty && found.uncertainty < 1e-3 * left, "{found:?}");
            let name = format!("{} order {order}", if alpha.is_none() { "linear" } else { "nonlinear" });
            criterion.bench_function(&name, |bencher| bencher.iter(|| closure.time_left(black_box(&departure))));
        }
    }
}

criterion_group!(benches, orders);
criterion_main!(benches);
