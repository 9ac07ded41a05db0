//! The infinite sum, closed wrongly by an oracle that closes it itself, with the claim that the right closure has.

use contract::{Case, Ending, Estimate, History};

use super::{Fault, amount, whole};
use crate::{faults::plant::Plant::Answer, measure::zeno};

pub(super) fn all() -> Vec<Fault> {
    vec![
        amount(
            "tail ratio eta",
            "the infinite sum were closed with the ratio eta in place of eta^2",
            "share missing of the exponent 2",
            0.5,
            Answer(|case, size, history| {
                tail(case, history, |pair, eta| {
                    let ratio = |exponent: f64| eta.powf(exponent) / (1.0 - eta.powf(exponent));
                    (ratio(2.0 * (1.0 - size)) - ratio(2.0)) * pair
                });
            }),
        ),
        amount(
            "no tail",
            "the chattering time were the time of the last impact listed, the rest of the infinite sum being left out",
            "share of the tail that is lost",
            1.0,
            Answer(|case, size, history| {
                tail(case, history, |pair, eta| -size * eta * eta / (1.0 - eta * eta) * pair);
            }),
        ),
        amount(
            "tail of the wrong parity",
            "the infinite sum were closed as if both sides flew equally long",
            "share of the difference",
            1.0,
            Answer(|case, size, history| {
                let last = history.impacts.last().map_or(0.0, |last| last.interval);
                tail(case, history, |pair, eta| size * eta * eta / (1.0 - eta * eta) * (2.0 * last - pair));
            }),
        ),
        whole(
            "Eq. 75 with the claim of the higher orders",
            "the infinite sum were closed by one geometric ratio (Eq. 75), which is good to fewer digits",
            Answer(|case, _, history| {
                let right = zeno::close(history, case.eta());
                let first = zeno::eq75(history, case.eta());
                if let (Ending::AtRest, Some(right), Some(value)) = (history.ending, right, first) {
                    history.chattering_time = Some(Estimate { value, ..right });
                }
            }),
        ),
        amount(
            "chattering time off",
            "the chattering time were wrong by itself, all impacts being right",
            "relative error",
            1e-3,
            Answer(|case, size, history| {
                let total = history.impacts.last().map_or(0.0, |last| last.time);
                tail(case, history, |_, _| size * total);
            }),
        ),
    ]
}

/// Gives a complete history a chattering time of its own: the right one plus an error made from the last pair of intervals and `η`.
fn tail(case: &Case, history: &mut History, error: impl Fn(f64, f64) -> f64) {
    let eta = case.eta();
    let pair: f64 = history.impacts.iter().rev().take(2).map(|impact| impact.interval).sum();
    if let (Ending::AtRest, Some(right)) = (history.ending, zeno::close(history, eta)) {
        history.chattering_time = Some(Estimate { value: right.value + error(pair, eta), ..right });
    }
}
