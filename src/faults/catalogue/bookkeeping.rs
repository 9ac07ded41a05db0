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
            "Times are added up with few digits",
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
            "An interval is what two rounded times differ by",
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
            "All times count from a step later",
            "delay in tau",
            1e-3,
            Answer(|_, size, history| {
                history.impacts.iter_mut().for_each(|impact| impact.time += size);
            }),
        ),
        amount(
            "clock that slips",
            "From impact 30 on the time is off",
            "slip in tau",
            1e-9,
            Answer(|_, size, history| {
                history.impacts.iter_mut().skip(29).for_each(|impact| impact.time += size);
            }),
        ),
        amount(
            "velocities in single precision",
            "The listed velocity has few digits",
            "unit round-off of the velocity",
            SINGLE,
            Answer(|_, size, history| {
                history.impacts.iter_mut().for_each(|impact| impact.velocity *= 1.0 - size);
            }),
        ),
        whole(
            "times in periods",
            "Times are divided by the period of the shaking",
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
