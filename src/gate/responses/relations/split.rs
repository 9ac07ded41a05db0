//! The motion changes its formula where it goes on as before: stretches are divided into several, and a record has a sample more between any two.

use contract::{Motion, Record, Stretch};

use super::terms::on;
use crate::cases::shaking::AnyMotion;

/// Into how many parts a stretch is divided.
const PARTS: u32 = 3;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    match asked.motion.as_ref() {
        Motion::Sinusoids(stretches) => on(asked, Motion::sinusoids(divided(stretches)?)),
        Motion::Record(of) => on(asked, with_middles(of)),
        Motion::Ricker(_) => None,
    }
}

fn divided(stretches: &[Stretch]) -> Option<Vec<Stretch>> {
    let mut parts = Vec::new();
    let mut from = 0.0;
    for Stretch { until, terms } in stretches {
        if until.is_infinite() {
            return None;
        }
        let inner = (1..PARTS).map(|part| from + (until - from) * f64::from(part) / f64::from(PARTS));
        parts.extend(inner.chain([*until]).map(|until| Stretch { until, terms: terms.clone() }));
        from = *until;
    }
    Some(parts)
}

fn with_middles(Record { dt, scale, samples }: &Record) -> Result<Motion, contract::Invalid> {
    let pairs = samples.windows(2).flat_map(|pair| match pair {
        [one, two] => vec![*one, 0.5 * (one + two)],
        _ => Vec::new(),
    });
    Motion::record(0.5 * dt, *scale, pairs.chain(samples.last().copied()).collect())
}
