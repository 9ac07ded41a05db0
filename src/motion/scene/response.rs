//! The response that a scene asks for.

use std::sync::Arc;

use contract::{Body, Case, Invalid, Model, Motion, Normalisation, Sinusoid, Slenderness, Stretch};

use super::{Ground, ROUNDING, Scene, Shaking, Sine};
use crate::{
    measure::ground::fastest,
    motion::response::{Asked, OnMotion, Request, Termination},
};

/// How many cycles of a motion without end are followed unless told otherwise.
const CYCLES: f64 = 5.0;

impl Scene {
    /// The request for the response to this scene: from the start of the ground motion, to its end and until the block rests after it, or for 5 cycles
    /// of a motion without end; `until` limits both, in `τ`.
    ///
    /// # Errors
    /// When the numbers leave the range of a case, or a threshold or `until` is not above 0.
    pub fn response(&self, until: Option<f64>, termination: Termination) -> Result<Request, Invalid> {
        let sine = self.sine()?;
        let case = self.threshold_case(sine)?;
        let p = self.block.frequency_parameter();
        let lasts = sine.duration.map(|seconds| seconds * p);
        let limit = if lasts.is_some() { f64::INFINITY } else { CYCLES * std::f64::consts::TAU / case.omega() };
        if let Some(until) = until.filter(|until| !until.is_finite()) {
            return Err(Invalid::new("until", format!("{until:?}"), "a finite time above 0 (in τ)"));
        }
        let request = Request::new(case, lasts, until.unwrap_or(limit))?;
        let lies_at = Some(std::f64::consts::FRAC_PI_2 / self.block.slenderness);
        // Some roundings of a, each of which is a/ε times as much of ε.
        let exact = case.epsilon() == 0.0 || self.block.over_own_threshold(sine.amplitude, self.ask.model).1 == 0.0;
        let rounding = if exact { 0.0 } else { ROUNDING * case.amplitude() / case.epsilon().abs() };
        Ok(Request { rounding, phase: sine.phase, lies_at, termination: termination.check()?, ..request })
    }

    /// What a scene asks, by a sinusoid under a block at rest or by another motion.
    ///
    /// # Errors
    /// As [`Scene::response`] and [`Scene::on_motion`].
    pub fn asked(&self, until: Option<f64>, termination: Termination) -> Result<Asked, Invalid> {
        Ok(match self.sine() {
            Ok(_) => Asked::Sinusoid(self.response(until, termination)?),
            Err(_) => Asked::Motion(self.on_motion(until, termination)?),
        })
    }

    /// The request for the response to a scene of any motion of the ground, and of a block at rest or not; a sinusoid is a motion too. One without end is followed
    /// for 5 cycles of its slowest part unless `until` says otherwise, in `τ`.
    ///
    /// # Errors
    /// When a number is out of its range.
    pub fn on_motion(&self, until: Option<f64>, termination: Termination) -> Result<OnMotion, Invalid> {
        let (motion, rounding) = self.motion()?;
        if let Some(until) = until.filter(|until| !(until.is_finite() && *until >= 1e-60)) {
            return Err(Invalid::new("until", format!("{until:?}"), "a finite time above 0 (in τ)"));
        }
        if let Some(until) =
            until.filter(|until| until * fastest(&motion) > std::f64::consts::TAU * Motion::MOST_CYCLES)
        {
            let allowed = "up to 10000 cycles of the fastest part of the motion (in τ)";
            // A record ends by itself, and what comes then is still ground.
            if motion.duration().is_infinite() {
                return Err(Invalid::new("until", format!("{until:?}"), allowed));
            }
        }
        if matches!(termination, Termination::ChatteringThreshold(_)) {
            return Err(Invalid::new("termination", "chattering", "of a sinusoid under a block at rest only"));
        }
        let alpha = (self.ask.model == Model::Nonlinear).then_some(self.block.slenderness);
        Ok(OnMotion {
            body: Body::new(self.block.restitution, alpha)?,
            rounding,
            start: self.start,
            until: until.unwrap_or_else(|| endless(&motion)),
            motion,
            lies_at: Some(std::f64::consts::FRAC_PI_2 / self.block.slenderness),
            termination: termination.check()?,
            most_impacts: Request::MOST_IMPACTS,
        })
    }

    /// The motion of the ground, and by how much rounding may have moved it, relative.
    pub(super) fn motion(&self) -> Result<(Arc<Motion>, f64), Invalid> {
        let sine = match &self.ground {
            Ground::Sinusoid(sine) => sine,
            Ground::Shaking(Shaking { over_slender: Some(model), .. }) if *model != self.ask.model => {
                let allowed = "that of the scene's own model, where an amplitude is over the slender threshold, which each model has for itself";
                let name = if self.ask.model == Model::Linear { "linear" } else { "nonlinear" };
                return Err(Invalid::new("model", name, allowed));
            }
            Ground::Shaking(shaking) => return Ok((Arc::clone(&shaking.motion), shaking.rounding)),
        };
        let (amplitude, rounding) = self.block.over_own_threshold(sine.amplitude, self.ask.model);
        let omega = self.block.omega(sine.frequency);
        // Without a phase it starts at the threshold, growing, and one that stays below it at its peak.
        let phase = sine.phase.unwrap_or_else(|| (1.0 / amplitude.max(1.0)).asin());
        let until = sine.duration.map_or(f64::INFINITY, |seconds| seconds * self.block.frequency_parameter());
        let terms = if amplitude > 0.0 { vec![Sinusoid { amplitude, omega, phase }] } else { Vec::new() };
        Ok((Arc::new(Motion::sinusoids(vec![Stretch { until, terms }])?), rounding))
    }

    /// The case with its amplitude over the threshold of its own model, `g α` or `g tan α`, as responses are counted.
    fn threshold_case(&self, sine: &Sine) -> Result<Case, Invalid> {
        let (a, _) = self.block.over_own_threshold(sine.amplitude, self.ask.model);
        let case = Case::from_amplitude(a, self.block.omega(sine.frequency), self.block.restitution)?;
        Ok(match self.ask.model {
            Model::Linear => case,
            Model::Nonlinear => {
                case.with_slenderness(Slenderness::new(self.block.slenderness, Normalisation::Threshold)?)
            }
        })
    }
}

/// How long a motion is followed unless told otherwise: to its end and on, or for 5 cycles of its slowest part if it has none; still ground for as long as it takes.
fn endless(motion: &Motion) -> f64 {
    let Motion::Sinusoids(stretches) = motion else { return f64::INFINITY };
    let last = stretches.last().filter(|last| last.until.is_infinite());
    let slowest = last.into_iter().flat_map(|last| &last.terms).map(|term| term.omega).fold(f64::INFINITY, f64::min);
    if slowest > 0.0 && slowest.is_finite() { CYCLES * std::f64::consts::TAU / slowest } else { f64::INFINITY }
}
