//! The cheapest method that a scene needs.

use chattercheck::{
    motion::scene,
    plan::{Conclusion, MotionPlan, Plan, Question},
};
use contract::{Invalid, Model};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::{
    error::value_error,
    scene::Scene,
    wait::{Stop, interruptible},
};

/// The plan of a scene to this relative tolerance. JSON.
#[pyfunction]
pub fn plan(py: Python<'_>, scene: &Scene, tolerance: f64) -> PyResult<String> {
    if !(1e-15..=0.5).contains(&tolerance) {
        return Err(value_error(Invalid::new("tolerance", format!("{tolerance:?}"), "1e-15 to 0.5 (relative)")));
    }
    let scene = scene.0.clone();
    let work = move || if scene.sine().is_ok() { of_case(&scene, tolerance) } else { of_motion(&scene, tolerance) };
    Ok(interruptible(py, &Stop::default(), work)?.map_err(value_error)?.to_string())
}

/// A chattering time: what is predicted of each method, and the answer of the one that is chosen.
fn of_case(scene: &scene::Scene, tolerance: f64) -> Result<Value, String> {
    let question = scene.question().map_err(|invalid| invalid.to_string())?;
    let plan = Plan::new(Question { tolerance, ..question });
    let answer = plan.answer();
    if let (None, Some(decline)) = (answer.conclusion(), answer.declined()) {
        return Err(format!("every method declines, first because {decline}"));
    }
    let chosen = plan.chosen().map(|candidate| candidate.method.to_string());
    let candidates: Vec<Value> = plan
        .candidates
        .iter()
        .map(|candidate| {
            let errors = candidate.errors.as_ref().ok().copied().filter(|_| plan.question.is_predicted());
            json!({
                "method": candidate.method.to_string(),
                "error": errors.map(|errors| errors.total()),
                "model_error": errors.map(|errors| errors.model),
                "cost_microseconds": candidate.cost,
                "refused": candidate.errors.as_ref().err().map(ToString::to_string),
            })
        })
        .collect();
    let time = answer.chattering_time();
    let p = scene.block.frequency_parameter();
    Ok(json!({
        "chosen": chosen,
        "candidates": candidates,
        "complete": answer.conclusion().map(|found| matches!(found, Conclusion::Complete(_))),
        "tau_ch": time.map(|time| time.value),
        "seconds": time.map(|time| time.value / p),
        "uncertainty": time.map(|time| time.uncertainty),
        "meets_tolerance": answer.meets,
    }))
}

/// A whole response by both models: what linearisation costs.
fn of_motion(scene: &scene::Scene, tolerance: f64) -> Result<Value, String> {
    let plan = MotionPlan::new(scene).map_err(|error| error.to_string())?;
    let candidate = |model: Model| {
        let (by, of_model) = (plan.by(model), plan.error_of(model));
        json!({
            "method": by.oracle,
            "error": of_model.map(|error| error + by.uncertainty()),
            "model_error": of_model,
            "cost_microseconds": null,
            "refused": null,
        })
    };
    let asked = scene.ask.model;
    Ok(json!({
        "chosen": plan.by(plan.chosen(asked, tolerance)).oracle,
        "candidates": [candidate(Model::Linear), candidate(Model::Nonlinear)],
        "complete": null,
        "tau_ch": null,
        "seconds": null,
        "uncertainty": null,
        "meets_tolerance": plan.meets(asked, tolerance),
    }))
}
