//! Times and intervals that are kept badly.

use contract::History;

use super::{Fault, amount, whole};
use crate::faults::plant::Plant::Answer;

/// Half the spacing of single precision numbers at 1, and of doubles.
const SINGLE: f64 = f32::EPSILON as f64 / 2.0;
const DOUBLE: f64 = f64::EPSILON / 2.0;

pub(super) fn all() -> Vec<Fault> {
    const ROUNDING: &str = "unit round-off of the clock";
    vec![
        amount(
            "clock in single precision",
            "times were added up in single precision",
            ROUNDING,
            SINGLE,
            Answer(|_, size, history| {
                let mut lost = 0.0;
                for impact in &mut history.impacts {
                    lost += size * impact.time;
                    impact.time -= lost;
                }
            }),
        ),
        amount(
            "intervals as differences of times",
            "intervals were the differences of rounded times",
            ROUNDING,
            DOUBLE,
            Answer(|_, size, history| {
                for (n, impact) in history.impacts.iter_mut().enumerate() {
                    // Roundings up and down in turn.
                    impact.interval += if n % 2 == 0 { size } else { -size } * impact.time;
                }
            }),
        ),
        amount(
            "late clock",
            "all times were counted from a step too early or too late",
            "delay in tau",
            1e-3,
            Answer(|_, size, history| {
                history.impacts.iter_mut().for_each(|impact| impact.time += size);
            }),
        ),
        amount(
            "clock that slips",
            "the clock slipped at impact 30",
            "slip in tau",
            1e-9,
            Answer(|_, size, history| {
                history.impacts.iter_mut().skip(29).for_each(|impact| impact.time += size);
            }),
        ),
        amount(
            "velocities in single precision",
            "velocities were listed in single precision",
            "unit round-off of the velocity",
            SINGLE,
            Answer(|_, size, history| {
                history.impacts.iter_mut().for_each(|impact| impact.velocity *= 1.0 - size);
            }),
        ),
        whole(
            "times in periods",
            "times were counted in periods of the shaking",
            Answer(|case, _, history| {
                let period = std::f64::consts::TAU / case.omega();
                rescale(history, 1.0 / period);
            }),
        ),
    ]
}

/// Times and intervals in another unit.
fn rescale(history: &mut History, factor: f64) {
    for impact in &mut history.impacts {
        impact.time *= factor;
        impact.interval *= factor;
    }
}
