//! How far apart the linear and the nonlinear model may be on one case.
//!
//! Under threshold normalisation Eq. 2 is, with `φ = (sin α/α) χ` and exactly to second order in `α`,
//!
//! ```text
//! χ'' = χ - i - f - α² [(1/2 + i f) χ - (i + f) χ²/2 + χ³/6]
//! ```
//!
//! so the nonlinear block is a linear one whose gravitational stiffness (the coefficient 1 of `χ`) is off by up to
//! `α² (1/2 + a)`, in one direction or the other, along the way. A linear block with stiffness `κ` is an ordinary linear block in the time
//! `τ sqrt(κ)`. So the effect of `κ = 1 ± δ` on every impact is had from the linear oracle itself, with the conditioning of the case in it,
//! and it falls as `α²` by construction. The true stiffness wanders between the two, so the effect of either may vanish at an impact where that
//! of the true one does not: the bound at an impact is the largest up to it.

use contract::{Case, Horizon, Invalid, Model, Normalisation, Oracle};

use crate::measure::{
    asking::ask,
    observables::{Observable, Observed},
};

/// What `δ` is beyond `α² (1/2 + a)`: room for the terms in `α⁴`.
const ROOM: f64 = 1.1;

/// Bounds on the difference between the models, impact by impact, in the scales of the observables.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelGap {
    /// Time (absolute), interval and velocity (both relative), and the interval ratio (relative).
    impacts: Vec<[f64; 4]>,
    chattering_time: f64,
    /// What a nonlinear velocity has to be divided by to be compared with a linear one: `sin α/α`.
    pub velocity_scale: f64,
}

impl ModelGap {
    /// The gap for a case with slenderness, from the history `base` of the linear oracle `stepper`. `None` where the models are not to be
    /// compared: no slenderness, or the slender normalisation.
    ///
    /// # Errors
    /// When a perturbed case leaves the allowed range.
    pub fn new(stepper: &dyn Oracle, case: &Case, base: &Observed) -> Result<Option<Self>, Invalid> {
        let Some(slenderness) = case.slenderness() else { return Ok(None) };
        if slenderness.normalisation() == Normalisation::Slender || stepper.model() != Model::Linear {
            return Ok(None);
        }
        let alpha = slenderness.alpha();
        let delta = ROOM * alpha * alpha * (0.5 + case.amplitude());
        let softer = stiffened(stepper, case, 1.0 - delta)?;
        let stiffer = stiffened(stepper, case, 1.0 + delta)?;
        let mut gap = Self { impacts: Vec::new(), chattering_time: f64::INFINITY, velocity_scale: alpha.sin() / alpha };
        let (Some(softer), Some(stiffer)) = (softer, stiffer) else { return Ok(Some(gap)) };
        let mut widest = [0.0; 4];
        for n in 1..=base.history.impacts.len() {
            let of = |observable: Observable, other: &Stiffened| {
                let this = base.at(observable, n)?.value;
                let scale = if observable == Observable::ImpactTime { 1.0 } else { this.abs() };
                Some((other.at(observable, n)? - this).abs() / scale)
            };
            for (observable, widest) in Observable::OF_AN_IMPACT.into_iter().zip(&mut widest) {
                let both = of(observable, &softer).zip(of(observable, &stiffer));
                // There is no ratio before the third impact.
                let missing = if observable == Observable::IntervalRatio && n < 3 { 0.0 } else { f64::INFINITY };
                *widest = both.map_or(missing, |(one, two)| one.max(two)).max(*widest);
            }
            gap.impacts.push(widest);
        }
        if let (Some(this), Some(one), Some(two)) =
            (base.chattering_time, softer.chattering_time(), stiffer.chattering_time())
        {
            gap.chattering_time = (one - this.value).abs().max((two - this.value).abs());
        }
        Ok(Some(gap))
    }

    /// The gap in an observable of impact `n`; infinite where the perturbed block does not get so far.
    pub fn at(&self, observable: Observable, n: usize) -> f64 {
        let column = Observable::OF_AN_IMPACT.iter().position(|&of| of == observable);
        let of_impact = || self.impacts.get(n.checked_sub(1)?)?.get(column?).copied();
        match observable {
            Observable::ChatteringTime | Observable::Ending => self.chattering_time,
            _ => of_impact().unwrap_or(f64::INFINITY),
        }
    }
}

/// The history of a linear block of another stiffness, in its own time.
struct Stiffened {
    observed: Observed,
    rate: f64,
}

impl Stiffened {
    fn at(&self, observable: Observable, n: usize) -> Option<f64> {
        let value = self.observed.at(observable, n)?.value;
        Some(if observable == Observable::IntervalRatio { value } else { value / self.rate })
    }

    fn chattering_time(&self) -> Option<f64> {
        Some(self.observed.chattering_time?.value / self.rate)
    }
}

/// The linear block with gravitational stiffness `kappa`: `φ'' = κφ - i - f` is Eq. 4 for `κφ`, in the time `τ sqrt(κ)` and at the
/// frequency `ω/sqrt(κ)`.
fn stiffened(stepper: &dyn Oracle, case: &Case, kappa: f64) -> Result<Option<Stiffened>, Invalid> {
    if kappa <= 0.0 {
        return Ok(None);
    }
    let rate = kappa.sqrt();
    let scaled = Case::from_epsilon(case.epsilon(), case.omega() / rate, case.eta())?;
    let horizon = match case.horizon() {
        Horizon::HalfPeriod => Horizon::HalfPeriod,
        Horizon::Until(time) => Horizon::Until(time * rate),
    };
    let scaled = scaled.with_max_impacts(case.max_impacts())?.with_horizon(horizon)?;
    Ok(ask(stepper, &scaled).into_observed().map(|observed| Stiffened { observed, rate }))
}

#[cfg(test)]
mod tests;
