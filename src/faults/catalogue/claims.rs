//! Claims that are too small, too large, or no numbers. Planted in an ODE oracle, whose claims are wide enough for that to matter.

use contract::{Estimate, History, Uncertainty};

use super::{Fault, amount, whole, within};
use crate::faults::plant::Plant::Answer;

const ODE: &str = "ode/linear/tsit45";

fn scale(history: &mut History, factor: f64) {
    for impact in &mut history.impacts {
        let Uncertainty { time, interval, velocity } = impact.uncertainty;
        impact.uncertainty =
            Uncertainty { time: factor * time, interval: factor * interval, velocity: factor * velocity };
    }
}

pub(super) fn all() -> Vec<Fault> {
    let all = vec![
        amount(
            "claims too small",
            "errors were claimed to be smaller than they are",
            "what the claims are divided by",
            1e4,
            Answer(|_, size, history| scale(history, 1.0 / size.max(1.0))),
        ),
        amount(
            "claims too wide",
            "errors were claimed to be far larger than they are",
            "what the claims are multiplied by",
            1e12,
            Answer(|_, size, history| scale(history, size.max(1.0))),
        ),
        whole(
            "claims of nothing",
            "every error were claimed to be infinite",
            Answer(|_, _, history| scale(history, f64::INFINITY)),
        ),
        whole(
            "claims that are not numbers",
            "every error were claimed to be NaN",
            Answer(|_, _, history| scale(history, f64::NAN)),
        ),
        whole("negative claims", "the claims had the wrong sign", Answer(|_, _, history| scale(history, -1.0))),
        whole(
            "a velocity that claims nothing",
            "the velocity were wrong, and its claim infinite",
            Answer(|_, _, history| {
                for impact in &mut history.impacts {
                    impact.velocity *= 1.5;
                    impact.uncertainty.velocity = f64::INFINITY;
                }
            }),
        ),
        whole(
            "a chattering time that claims nothing",
            "the chattering time were wrong, and its claim infinite",
            Answer(|_, _, history| {
                history.chattering_time = Some(Estimate { value: 42.0, uncertainty: f64::INFINITY });
            }),
        ),
    ];
    all.into_iter().map(|fault| within(ODE, fault)).collect()
}
