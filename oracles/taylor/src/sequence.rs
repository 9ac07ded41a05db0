//! The history: flight after flight, and what is claimed of it.

use contract::{Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};

use crate::equation::Block;
use crate::flight::{Landing, fly};

/// Below this speed a history ends: the next quantities would come near to the smallest double.
const SLOWEST: f64 = 1e-280;
/// So many steps of a flight round by no more than the perturbation stands for.
const FEW_STEPS: u32 = 40;

/// The history of `block`, with claims from the differences to that of `perturbed`: a run whose parameters are changed by
/// more than what rounding does to them in all flights. The claim is the largest relative difference so far, and
/// `8e-15 + 2e-16 n`, and for the time a quarter of the difference and 0.7 of these; it is infinite where the perturbed run has no such impact.
pub fn history(block: &Block, perturbed: &Block, horizon: Horizon, most: usize) -> History {
    let (mut impacts, ending) = run(block, horizon, most);
    let (others, _) = run(perturbed, horizon, impacts.len());
    let mut worst = (0.0, 0.0, 0.0);
    let mut others = others.iter();
    let mut floor = 8e-15;
    for impact in &mut impacts {
        worst = others.next().map_or((f64::INFINITY, f64::INFINITY, f64::INFINITY), |other| {
            (
                difference(impact.time, other.time).max(worst.0),
                difference(impact.interval, other.interval).max(worst.1),
                difference(impact.velocity, other.velocity).max(worst.2),
            )
        });
        floor += 2e-16;
        impact.uncertainty = Uncertainty {
            time: impact.time * impact.uncertainty.time * (0.25 * worst.0 + 0.7 * floor),
            interval: impact.uncertainty.interval * (worst.1 + floor),
            velocity: impact.uncertainty.velocity * (worst.2 + floor),
        };
    }
    History { impacts, ending, chattering_time: None }
}

/// `|b/a - 1|`.
fn difference(a: f64, b: f64) -> f64 {
    ((b - a) / a).abs()
}

/// The impacts of `block`, and why they end. Instead of a claim each holds a margin, the factor by which the rounding of
/// flights of uncommonly many steps widens it.
fn run(block: &Block, horizon: Horizon, most: usize) -> (Vec<Impact>, Ending) {
    let (end, beyond) = match horizon {
        Horizon::HalfPeriod => (core::f64::consts::PI / block.omega, Ending::Incomplete),
        Horizon::Until(time) => (time, Ending::LimitReached(Limit::Time)),
    };
    let mut impacts = Vec::with_capacity(most.min(1024));
    let (mut high, mut low) = (0.0_f64, 0.0_f64);
    let (mut side, mut speed) = (-1.0, 0.0);
    let mut excess = 0.0;
    while impacts.len() < most {
        let (interval, arrival) = match fly(block, side, high + low, speed, (end - high) - low) {
            Landing::Impact { interval, speed, steps } => {
                excess += f64::from(steps.saturating_sub(FEW_STEPS));
                (interval, speed)
            }
            Landing::Flying => return (impacts, beyond),
            Landing::Overturned => return (impacts, Ending::Overturned),
            Landing::Lost(loss) => return (impacts, Ending::Lost(loss)),
        };
        // Neumaier's sum: the intervals soon fall below the rounding of the time.
        let sum = high + interval;
        low += if high >= interval { (high - sum) + interval } else { (interval - sum) + high };
        high = sum;
        if high + low >= end {
            return (impacts, beyond);
        }
        side = -side;
        speed = block.eta * arrival;
        if !(interval > 0.0 && speed > 0.0 && speed.is_finite()) {
            return (impacts, Ending::Lost(Loss::NotFinite));
        }
        let margin = 1.0 + 0.05 * excess;
        let uncertainty = Uncertainty { time: margin, interval: margin, velocity: margin };
        impacts.push(Impact { time: high + low, interval, velocity: side * speed, uncertainty });
        if speed < SLOWEST {
            let certain = block.certainly_rests(high + low, speed);
            return (impacts, if certain { Ending::AtRest } else { Ending::Lost(Loss::Stalled) });
        }
    }
    let certain = block.certainly_rests(high + low, speed);
    (impacts, if certain { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) })
}
