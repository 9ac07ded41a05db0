//! The response that a scene asks for.

use std::sync::Arc;

use contract::{Body, Case, Invalid, Model, Motion, Normalisation, Slenderness};

use super::{Amplitude, Ground, Scene, Shaking, Sine};
use crate::motion::response::{OnMotion, Request, Termination};

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
        // An amplitude in physical units is divided by the threshold: some roundings of a, each of which is a/ε times as much of ε.
        let exact = case.epsilon() == 0.0
            || matches!(sine.amplitude, Amplitude::OverThreshold(_))
            || (matches!(sine.amplitude, Amplitude::OverSlenderThreshold(_)) && self.ask.model == Model::Linear);
        let rounding = if exact { 0.0 } else { 2.0 * f64::EPSILON * case.amplitude() / case.epsilon().abs() };
        Ok(Request { rounding, phase: sine.phase, lies_at, termination: termination.check()?, ..request })
    }

    /// The request for the response to a scene whose ground moves in another way than as a sinusoid, or whose block does not start from rest; `None` of one that is
    /// a sinusoid and starts from rest. A motion without end is followed for 5 cycles of its slowest part unless `until` says otherwise, in `τ`.
    ///
    /// # Errors
    /// When a number is out of its range.
    pub fn on_motion(&self, until: Option<f64>, termination: Termination) -> Result<Option<OnMotion>, Invalid> {
        if matches!(self.ground, Ground::Sinusoid(_)) {
            return Ok(None);
        }
        self.on_any_motion(until, termination).map(Some)
    }

    /// The same of every scene: of a sinusoid too.
    ///
    /// # Errors
    /// As [`Scene::on_motion`].
    pub fn on_any_motion(&self, until: Option<f64>, termination: Termination) -> Result<OnMotion, Invalid> {
        let of_sine;
        let shaking = match &self.ground {
            Ground::Shaking(shaking) => shaking,
            Ground::Sinusoid(sine) => {
                of_sine = self.shaking_of(sine)?;
                &of_sine
            }
        };
        if let Some(until) = until.filter(|until| !(until.is_finite() && *until >= 1e-60)) {
            return Err(Invalid::new("until", format!("{until:?}"), "a finite time above 0 (in τ)"));
        }
        if matches!(termination, Termination::ChatteringThreshold(_)) {
            return Err(Invalid::new("termination", "chattering", "of a sinusoid under a block at rest only"));
        }
        if shaking.over_slender.is_some_and(|model| model != self.ask.model) {
            let allowed = "that of the scene's own model, where an amplitude is over the slender threshold, which each model has for itself";
            let name = if self.ask.model == Model::Linear { "linear" } else { "nonlinear" };
            return Err(Invalid::new("model", name, allowed));
        }
        let alpha = (self.ask.model == Model::Nonlinear).then_some(self.block.slenderness);
        Ok(OnMotion {
            body: Body::new(self.block.restitution, alpha)?,
            motion: Arc::clone(&shaking.motion),
            rounding: shaking.rounding,
            start: self.start,
            until: until.unwrap_or_else(|| endless(&shaking.motion)),
            lies_at: Some(std::f64::consts::FRAC_PI_2 / self.block.slenderness),
            termination: termination.check()?,
            most_impacts: Request::MOST_IMPACTS,
        })
    }

    /// A sinusoid as a motion that starts and may end.
    fn shaking_of(&self, sine: &Sine) -> Result<Shaking, Invalid> {
        let is_slender = matches!(sine.amplitude, Amplitude::OverSlenderThreshold(_));
        let amplitude = match sine.amplitude {
            Amplitude::OverSlenderThreshold(a) if self.ask.model == Model::Linear => a,
            amplitude => self.block.over_threshold(amplitude),
        };
        let omega = self.block.omega(sine.frequency);
        let until = sine.duration.map_or(f64::INFINITY, |seconds| seconds * self.block.frequency_parameter());
        Ok(Shaking {
            name: "a sinusoid",
            motion: Arc::new(Shaking::sine(amplitude, omega, sine.phase, until)?),
            rounding: 2.0 * f64::EPSILON,
            over_slender: is_slender.then_some(self.ask.model),
            notes: Vec::new(),
        })
    }

    /// The case with its amplitude over the threshold of its own model, `g α` or `g tan α`, as responses are counted.
    fn threshold_case(&self, sine: &Sine) -> Result<Case, Invalid> {
        let a = match sine.amplitude {
            Amplitude::OverSlenderThreshold(a) if self.ask.model == Model::Linear => a,
            amplitude => self.block.over_threshold(amplitude),
        };
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
