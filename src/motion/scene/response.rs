//! The response that a scene asks for.

use contract::{Case, Invalid, Model, Normalisation, Slenderness};

use super::{Amplitude, Scene};
use crate::motion::response::{Request, Termination};

/// How many cycles of a motion without end are followed unless told otherwise.
const CYCLES: f64 = 5.0;

impl Scene {
    /// The request for the response to this scene: from the start of the ground motion, to its end and until the block rests after it, or for 5 cycles
    /// of a motion without end; `until` limits both, in `τ`.
    ///
    /// # Errors
    /// When the numbers leave the range of a case, or a threshold or `until` is not above 0.
    pub fn response(&self, until: Option<f64>, termination: Termination) -> Result<Request, Invalid> {
        let case = self.threshold_case()?;
        let p = self.block.frequency_parameter();
        let lasts = self.ground.duration.map(|seconds| seconds * p);
        let limit = if lasts.is_some() { f64::INFINITY } else { CYCLES * std::f64::consts::TAU / case.omega() };
        if let Some(until) = until.filter(|until| !until.is_finite()) {
            return Err(Invalid::new("until", format!("{until:?}"), "a finite time above 0 (in τ)"));
        }
        let request = Request::new(case, lasts, until.unwrap_or(limit))?;
        let lies_at = Some(std::f64::consts::FRAC_PI_2 / self.block.slenderness);
        // An amplitude in physical units is divided by the threshold: some roundings of a, each of which is a/ε times as much of ε.
        let exact = case.epsilon() == 0.0
            || matches!(self.ground.amplitude, Amplitude::OverThreshold(_))
            || (matches!(self.ground.amplitude, Amplitude::OverSlenderThreshold(_)) && self.ask.model == Model::Linear);
        let rounding = if exact { 0.0 } else { 2.0 * f64::EPSILON * case.amplitude() / case.epsilon().abs() };
        Ok(Request { rounding, phase: self.ground.phase, lies_at, termination: termination.check()?, ..request })
    }

    /// The case with its amplitude over the threshold of its own model, `g α` or `g tan α`, as responses are counted.
    fn threshold_case(&self) -> Result<Case, Invalid> {
        let a = match self.ground.amplitude {
            Amplitude::OverSlenderThreshold(a) if self.ask.model == Model::Linear => a,
            _ => self.over_threshold(),
        };
        let case = Case::from_amplitude(a, self.omega(), self.block.restitution)?;
        Ok(match self.ask.model {
            Model::Linear => case,
            Model::Nonlinear => {
                case.with_slenderness(Slenderness::new(self.block.slenderness, Normalisation::Threshold)?)
            }
        })
    }
}
