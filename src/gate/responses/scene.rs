//! A response that disagrees, as a scene that can be run by itself.

use std::f64::consts::TAU;

use contract::Model;

use super::{examine::Finding, failure::Failure};
use crate::cases::shaking::Shaking;

/// The slenderness of a block that is slender anyway; any will do.
const SLENDER: f64 = 0.1;

/// The text of a scene file for `shaking`, with what disagreed and how to run it as comments; `path` is where it will be.
pub fn scene_text(failure: &Failure, seed: u64, shaking: &Shaking, finding: &Finding, path: &str) -> String {
    let Shaking { case, phase, lasts, until } = shaking;
    let model = match finding.model {
        Model::Linear => "linear",
        Model::Nonlinear => "nonlinear",
    };
    let until = if until.is_finite() { format!(" --until {until:?}") } else { String::new() };
    let alpha = case.slenderness().map_or(SLENDER, |slenderness| slenderness.alpha());
    let line = |key: &str, value: Option<String>| value.map_or(String::new(), |value| format!("{key} = {value}\n"));
    let phase = line("phase", phase.map(|phase| format!("{phase:?}")));
    let cycles = lasts.map(|lasts| format!("{{ cycles = {:?} }}", lasts * case.omega() / TAU));
    format!(
        "# {finding}\n# Shrunk from {} of seed {seed}. Run: chattercheck response {path} --model {model}{until}\n\n\
         [block]\nradius = 1.0\nslenderness = {alpha:?}\nrestitution = {:?}\n\n\
         [ground]\namplitude = {{ over-threshold = {:?} }}\nfrequency = {{ omega = {:?} }}\n{phase}{}",
        failure.name,
        case.eta(),
        case.amplitude(),
        case.omega(),
        line("duration", cycles),
    )
}
