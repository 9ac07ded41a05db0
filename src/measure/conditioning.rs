//! How much of each observable one unit of relative change in a parameter makes.
//!
//! A method that works in doubles rounds the parameters that it is given: it solves a case next to the one that was asked, and nobody may
//! hold that against it. What it does to an observable `x` is `κ = |ε ∂x/∂ε| + |ω ∂x/∂ω| + |η ∂x/∂η|` times the rounding, with the
//! derivatives of an oracle that knows them. Towards the critical amplitude `κ` of the chattering time grows as `(a_cr - a)^(β-1)`.

use std::panic::{AssertUnwindSafe, catch_unwind};

use contract::{Case, History, Impact, Model, Oracle, Sensitivity, Uncertainty};

use crate::measure::{
    asking::Answer,
    observables::{Observable, Observed},
    zeno,
};

/// The condition of every observable of one case, in its own scale: of times absolute, of intervals, velocities and ratios relative.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Conditioning {
    /// In the order of [`Observable::OF_AN_IMPACT`].
    impacts: Vec<[f64; 4]>,
    chattering_time: f64,
}

impl Conditioning {
    /// The conditioning of `case` by the first linear oracle of the panel that has derivatives to its answer; zero where none has.
    pub fn of(panel: &[&dyn Oracle], answers: &[Answer], case: &Case) -> Self {
        let by = |(oracle, answer): (&&dyn Oracle, &Answer)| Self::by(*oracle, case, answer.observed()?);
        let linear = |(_, answer): &(_, &Answer)| answer.model == Model::Linear;
        panel.iter().zip(answers).filter(linear).find_map(by).unwrap_or_default()
    }

    /// The conditioning by the derivatives of one oracle, whose history is `observed`; `None` without them.
    pub fn by(oracle: &dyn Oracle, case: &Case, observed: &Observed) -> Option<Self> {
        // A panic inside a method must not take the run with it.
        let sensitivities = catch_unwind(AssertUnwindSafe(|| oracle.sensitivities(case))).ok()??;
        if sensitivities.len() != observed.history.impacts.len() {
            return None;
        }
        Some(Self::new(case, observed, &sensitivities))
    }

    /// The conditioning from the derivatives of every impact.
    pub fn new(case: &Case, observed: &Observed, sensitivities: &[Sensitivity]) -> Self {
        let relative: Vec<[f64; 3]> = observed
            .history
            .impacts
            .iter()
            .zip(sensitivities)
            .map(|(impact, of)| of.interval.map(|by| by / impact.interval))
            .collect();
        let impacts = observed
            .history
            .impacts
            .iter()
            .zip(sensitivities)
            .zip(&relative)
            .enumerate()
            .map(|(n, ((impact, of), interval))| {
                // Of the ratio to the interval before last; there is none before the third impact.
                let before = n.checked_sub(2).and_then(|before| relative.get(before));
                let ratio = before.map_or([0.0; 3], |before| difference(interval, before));
                [*interval, of.velocity.map(|by| by / impact.velocity), of.time, ratio].map(|by| condition(case, by))
            })
            .collect();
        let chattering_time = observed
            .chattering_time
            .and_then(|_| zeno::sensitivity(&observed.history, sensitivities, case.eta()))
            .map_or(0.0, |by| condition(case, by));
        Self { impacts, chattering_time }
    }

    /// The condition of an observable at impact `n`, or of the chattering time. Past the impacts that are known, that of the last.
    pub fn at(&self, observable: Observable, n: usize) -> f64 {
        let Some(column) = Observable::OF_AN_IMPACT.iter().position(|&of| of == observable) else {
            return self.chattering_time;
        };
        let impact = n.checked_sub(1).and_then(|index| self.impacts.get(index)).or(self.impacts.last());
        impact.and_then(|impact| impact.get(column)).copied().unwrap_or(0.0)
    }

    /// The conditioning of what an oracle answers to a case, by another one that has derivatives; zero where it has none there.
    pub fn by_other(sensitive: &dyn Oracle, case: &Case) -> Self {
        let history = sensitive.history(case).ok();
        let by = |history| Self::by(sensitive, case, &Observed::new(case, history));
        history.and_then(by).unwrap_or_default()
    }

    /// Widens what a history claims by these errors, of its impacts and of the chattering time, times `at_least + κ`.
    pub fn widen(&self, history: &mut History, at_least: f64, errors: Uncertainty, of_chattering_time: f64) {
        let more = |error: f64, observable, n| {
            // Of no error there is no multiple, however large.
            if error > 0.0 { error * (at_least + self.at(observable, n)) } else { 0.0 }
        };
        for (n, Impact { uncertainty, .. }) in (1..).zip(&mut history.impacts) {
            uncertainty.time += more(errors.time, Observable::ImpactTime, n);
            uncertainty.interval += more(errors.interval, Observable::Interval, n);
            uncertainty.velocity += more(errors.velocity, Observable::Velocity, n);
        }
        if let Some(of) = &mut history.chattering_time {
            of.uncertainty += more(of_chattering_time, Observable::ChatteringTime, 0);
        }
    }
}

fn difference(one: &[f64; 3], other: &[f64; 3]) -> [f64; 3] {
    let ([a, b, c], [x, y, z]) = (one, other);
    [a - x, b - y, c - z]
}

/// `κ` from the derivatives by `a`, `ω` and `η`. Derivatives that are lost bound nothing.
fn condition(case: &Case, [by_a, by_omega, by_eta]: [f64; 3]) -> f64 {
    let kappa = (case.epsilon() * by_a).abs() + (case.omega() * by_omega).abs() + (case.eta() * by_eta).abs();
    if kappa.is_nan() { f64::INFINITY } else { kappa }
}

#[cfg(test)]
mod tests;
