//! A response that disagrees, as a scene that can be run by itself.

use std::{f64::consts::TAU, path::Path};

use contract::{Model, Motion, Record, Ricker};

use super::{examine::Finding, failure::Failure};
use crate::cases::shaking::{AnyMotion, Question, Shaking};

/// The slenderness of a block that is slender anyway; any will do.
const SLENDER: f64 = 0.1;

/// The text of a scene file for `question`, with what disagreed and how to run it as comments; `path` is where it will be.
pub fn scene_text(failure: &Failure, seed: u64, question: &Question, finding: &Finding, path: &Path) -> String {
    let model = match finding.model {
        Model::Linear => "linear",
        Model::Nonlinear => "nonlinear",
    };
    let until = question.until();
    let until = if until.is_finite() { format!(" --until {until:?}") } else { String::new() };
    let alpha = question.alpha().unwrap_or(SLENDER);
    let ground = match question {
        Question::Sinusoid(shaking) => of_sinusoid(shaking),
        Question::Motion(asked) => of_motion(asked, path),
    };
    format!(
        "# {finding}\n# Shrunk from {} of seed {seed}. Run: chattercheck response {} --model {model}{until}\n\n\
         [block]\nradius = 1.0\nslenderness = {alpha:?}\nrestitution = {:?}\n\n[ground]\n{ground}",
        failure.name,
        path.display(),
        question.eta(),
    )
}

/// The samples that the scene at a path reads from [`samples_path`], if it reads any: one in a line, in multiples of the threshold.
pub fn samples_text(question: &Question) -> Option<String> {
    let Question::Motion(asked) = question else { return None };
    let Motion::Record(record) = asked.motion.as_ref() else { return None };
    Some(record.samples.iter().map(|sample| format!("{sample:?}\n")).collect())
}

/// Where the samples of the scene at `path` are.
pub fn samples_path(path: &Path) -> std::path::PathBuf {
    path.with_extension("csv")
}

fn of_sinusoid(Shaking { case, phase, lasts, .. }: &Shaking) -> String {
    let phase = phase.map_or(String::new(), |phase| format!("phase = {phase:?}\n"));
    let cycles = |lasts: f64| format!("duration = {{ cycles = {:?} }}\n", lasts * case.omega() / TAU);
    format!(
        "amplitude = {{ over-threshold = {:?} }}\nfrequency = {{ omega = {:?} }}\n{phase}{}",
        case.amplitude(),
        case.omega(),
        lasts.map_or(String::new(), cycles),
    )
}

fn of_motion(asked: &AnyMotion, path: &Path) -> String {
    let strong = |amplitude: f64, omega: f64| {
        format!("amplitude = {{ over-threshold = {amplitude:?} }}, frequency = {{ omega = {omega:?} }}")
    };
    let ground = match asked.motion.as_ref() {
        Motion::Sinusoids(stretches) => {
            // A scene has one stretch.
            let terms = stretches.iter().flat_map(|stretch| &stretch.terms);
            let term = |term: &contract::Sinusoid| {
                format!("    {{ {}, phase = {:?} }},\n", strong(term.amplitude, term.omega), term.phase)
            };
            let terms: String = terms.map(term).collect();
            format!("sinusoids = [\n{terms}]\nduration = {{ tau = {:?} }}\n", asked.motion.duration())
        }
        Motion::Ricker(Ricker { amplitude, omega, center, antisymmetric }) => {
            let name = if *antisymmetric { "ricker-antisymmetric" } else { "ricker" };
            format!(
                "pulse = \"{name}\"\n{}\ncenter = {{ tau = {center:?} }}\n",
                strong(*amplitude, *omega).replace(", ", "\n")
            )
        }
        Motion::Record(Record { dt, scale, .. }) => {
            let samples = samples_path(path);
            let file = samples.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            format!(
                "record = {{ file = \"{file}\", units = \"threshold\", dt = {{ tau = {dt:?} }}, scale = {scale:?} }}\n"
            )
        }
    };
    let (rotation, velocity) = asked.start;
    let start = if asked.start == (0.0, 0.0) {
        String::new()
    } else {
        format!("\n[start]\nrotation = {rotation:?}\nvelocity = {velocity:?}\n")
    };
    ground + &start
}
