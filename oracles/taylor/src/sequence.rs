//! The history: flight after flight, and what is claimed of it.

use contract::{Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};

use crate::equation::Block;
use crate::flight::{Landing, fly};

/// Below this speed a history ends: the next quantities would come near to the smallest double.
const SLOWEST: f64 = 1e-280;
/// So many steps of a flight round by no more than the perturbation stands for.
const FEW_STEPS: u32 = 40;

/// The history of `block`, with claims from the differences to those of `perturbed`: runs whose parameters are changed by about what rounding
/// does to them in all flights, each in another way, because the effect of one may vanish where that of another does not. Claimed are 0.6 times
/// (of the time 0.3 times) the sum of the largest relative differences so far and `4e-15 + 1e-16 n`, which no true error reaches in the default
/// run of `chattercheck verify --judge all`; nothing where a perturbed run has no such impact.
pub fn history(block: &Block, perturbed: &[Block], horizon: Horizon, most: usize) -> History {
    let (mut impacts, ending) = run(block, horizon, most);
    let margins: Vec<Uncertainty> = impacts.iter().map(|impact| impact.uncertainty).collect();
    for (n, impact) in (1_u32..).zip(&mut impacts) {
        let floor = 4e-15 + 1e-16 * f64::from(n);
        impact.uncertainty = Uncertainty { time: floor, interval: floor, velocity: floor };
    }
    for perturbed in perturbed {
        let (others, _) = run(perturbed, horizon, impacts.len());
        let mut worst = (0.0, 0.0, 0.0);
        let mut others = others.iter();
        for impact in &mut impacts {
            worst = others.next().map_or((f64::INFINITY, f64::INFINITY, f64::INFINITY), |other| {
                (
                    difference(impact.time, other.time).max(worst.0),
                    difference(impact.interval, other.interval).max(worst.1),
                    difference(impact.velocity, other.velocity).max(worst.2),
                )
            });
            impact.uncertainty.time += worst.0;
            impact.uncertainty.interval += worst.1;
            impact.uncertainty.velocity += worst.2;
        }
    }
    for (impact, margin) in impacts.iter_mut().zip(margins) {
        impact.uncertainty.time *= 0.3 * impact.time * margin.time;
        impact.uncertainty.interval *= 0.6 * margin.interval;
        impact.uncertainty.velocity *= 0.6 * margin.velocity;
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

#[cfg(test)]
mod tests;
