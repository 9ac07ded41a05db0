//! Random motions of the ground that are no steady sinusoids: pulses, sums of sinusoids, and records.

use std::{f64::consts::TAU, sync::Arc};

use contract::{Body, Invalid, Motion, Ricker, Sinusoid, Stretch};
use proptest::{collection::vec, prelude::*, strategy::ValueTree};

use super::random::{logarithmic, runner};
use crate::cases::shaking::AnyMotion;

/// Apart from the seeds of the other generators.
const OWN_SEED: u64 = 0x6d6f_7469_6f6e;

/// `count` random motions made from `seed`.
pub fn motions(seed: u64, count: usize) -> Vec<AnyMotion> {
    let mut runner = runner(seed ^ OWN_SEED);
    let strategy = strategy();
    (0..count).filter_map(|_| Some(strategy.new_tree(&mut runner).ok()?.current())).collect()
}

/// Blocks under anything from too weak a motion to one that overturns them; from rest, or from a tilt; for a part of the motion or until all is over.
fn strategy() -> impl Strategy<Value = AnyMotion> {
    let eta = prop_oneof![5 => 0.6..0.95, 2 => 0.2..0.6, 1 => logarithmic(1e-2, 4e-2).prop_map(|loss| 1.0 - loss)];
    let alpha = prop_oneof![1 => Just(None), 3 => logarithmic(0.02, 0.6).prop_map(Some)];
    let start = prop_oneof![
        8 => Just((0.0, 0.0)),
        1 => (-0.9..0.9).prop_map(|rotation| (rotation, 0.0)),
        1 => (-0.6..0.6, -0.5..0.5),
    ];
    let share = prop_oneof![2 => Just(None), 1 => (0.2..1.5).prop_map(Some)];
    let motion = prop_oneof![pulse(), wavelet(), sum(), sum(), record(), record()];
    (motion, eta, alpha, start, share).prop_filter_map(
        "a motion or a block that the contract refuses",
        |(motion, eta, alpha, start, share): (_, f64, Option<f64>, (f64, f64), Option<f64>)| {
            let motion: Motion = Result::ok(motion)?;
            let until = share.map_or(f64::INFINITY, |share| share * motion.duration());
            Some(AnyMotion { body: Body::new(eta, alpha).ok()?, motion: Arc::new(motion), start, until })
        },
    )
}

type Made = Result<Motion, Invalid>;

/// Peaks from below the threshold to far above it, most of them just above.
fn strength() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => 0.5..1.0,
        4 => logarithmic(1e-3, 0.3).prop_map(|epsilon| 1.0 + epsilon),
        4 => 1.2..4.0,
    ]
}

fn signed() -> impl Strategy<Value = f64> {
    (strength(), any::<bool>()).prop_map(|(size, mirrored)| if mirrored { -size } else { size })
}

/// Single pulses; the cosine starts and ends with a jump.
fn pulse() -> BoxedStrategy<Made> {
    let of = (signed(), logarithmic(0.4, 8.0), 0..3_u8, 1.0..3.0, -3.0..3.0);
    of.prop_map(|(a, omega, kind, gamma, nu)| match kind {
        0 => Motion::one_sine(a, omega),
        1 => Motion::one_cosine(a, omega),
        _ => Motion::mavroeidis_papageorgiou(1.5 * a, omega, gamma, nu),
    })
    .boxed()
}

/// Of the first kind with the middle anywhere, so that some begin above the threshold.
fn wavelet() -> BoxedStrategy<Made> {
    let of = (signed(), logarithmic(0.6, 8.0), 0.3..8.0, any::<bool>());
    of.prop_map(|(amplitude, omega, middle, antisymmetric)| {
        Motion::ricker(Ricker { amplitude, omega, center: middle / omega, antisymmetric })
    })
    .boxed()
}

/// Two or three sinusoids, which begin and end as they are, mostly with jumps.
fn sum() -> BoxedStrategy<Made> {
    let term = (0.2..1.0, logarithmic(0.4, 8.0), -3.0..3.0);
    let of = (strength(), vec(term, 2..4), 1.0..5.0);
    of.prop_map(|(peak, terms, cycles): (f64, Vec<(f64, f64, f64)>, f64)| {
        let all: f64 = terms.iter().map(|(size, ..)| size).sum();
        let slowest = terms.iter().map(|(_, omega, _)| *omega).fold(f64::INFINITY, f64::min);
        let term =
            |(size, omega, phase): (f64, f64, f64)| Sinusoid { amplitude: 1.2 * peak * size / all, omega, phase };
        let terms = terms.into_iter().map(term).collect();
        Motion::sinusoids(vec![Stretch { until: (cycles * TAU / slowest).min(30.0), terms }])
    })
    .boxed()
}

/// Samples that wander: a random walk towards 0, with a step from far below the time of the block to about it.
fn record() -> BoxedStrategy<Made> {
    let of = (strength(), logarithmic(0.01, 0.4), vec(-1.0..1.0, 10..120), 0.3..0.95);
    of.prop_map(|(peak, dt, steps, memory): (f64, f64, Vec<f64>, f64)| {
        let mut last = 0.0;
        let samples: Vec<f64> = steps
            .iter()
            .map(|step| {
                last = memory * last + step;
                last
            })
            .collect();
        let most = samples.iter().fold(f64::MIN_POSITIVE, |most: f64, sample| most.max(sample.abs()));
        Motion::record(dt, peak / most, samples)
    })
    .boxed()
}
