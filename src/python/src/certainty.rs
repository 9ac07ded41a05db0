//! When rest was certain, and at which scale of the motion a block overturns.

use chattercheck::{
    motion::{
        certainty::Changes,
        criterion::{Crossings, criteria, critical_scale, crossings},
        response::{Asked, OnMotion, Response, Termination},
        scene,
    },
    panel,
};
use contract::{Invalid, Oracle};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::{
    error::value_error,
    scene::{Scene, oracle_of},
    wait::{Stop, Stoppable, interruptible},
};

/// The request of a scene by any motion, and who follows it.
fn asked(
    scene: &scene::Scene,
    until: Option<f64>,
    oracle: Option<&str>,
    stop: &Stop,
) -> Result<(OnMotion, Stoppable), String> {
    let request = scene.on_motion(until, Termination::Exact).map_err(|invalid| invalid.to_string())?;
    let by = oracle_of(&Asked::Motion(request.clone()), scene.ask.model, oracle, stop);
    Ok((request, by.map_err(|refused| refused.to_string())?))
}

/// For each bout of a scene when rest was certain; and the scale at which some chattering turns incomplete. JSON.
#[pyfunction]
#[pyo3(signature = (scene, until=None, to_scale=2.0, oracle=None))]
pub fn criterion(
    py: Python<'_>,
    scene: &Scene,
    until: Option<f64>,
    to_scale: f64,
    oracle: Option<String>,
) -> PyResult<String> {
    if !(to_scale > 1.0 && to_scale <= 1e6) {
        return Err(value_error(Invalid::new("to-scale", format!("{to_scale:?}"), "above 1, up to 1e6")));
    }
    let (stop, scene) = (Stop::default(), scene.0.clone());
    let work = {
        let stop = stop.clone();
        move || -> Result<Value, String> {
            let (request, oracle) = asked(&scene, until, oracle.as_deref(), &stop)?;
            let declined = |decline| format!("{} declines: {decline}", oracle.name());
            let response = Response::on_motion(&oracle, &request).map_err(declined)?;
            let closing = panel::closing();
            let found = criteria((&oracle, closing.as_ref()), &request, &response).map_err(declined)?;
            let fastest = Stoppable { oracle: panel::stepper_on(&request.body, &request.motion), stop };
            let critical = critical_scale(&fastest, &request, to_scale);
            let critical = critical.map_err(|why| format!("{}: {why}", fastest.name()))?;
            let bouts: Vec<_> = response.bouts.iter().zip(&found).map(|(bout, found)| found.told(bout)).collect();
            let (lower, upper) = (critical.map(|found| found.lower), critical.map(|found| found.upper));
            let incomplete = json!({ "lower": lower, "upper": upper, "searched_to": to_scale, "certified": false });
            Ok(json!({ "bouts": bouts, "incomplete": incomplete, "oracle": oracle.name() }))
        }
    };
    Ok(interruptible(py, &stop, work)?.map_err(value_error)?.to_string())
}

/// The scales of the motion of a scene at which the block overturns, and at which some chattering turns incomplete. JSON.
#[pyfunction]
#[pyo3(signature = (scene, scales=(0.1, 10.0), oracle=None))]
pub fn overturning(py: Python<'_>, scene: &Scene, scales: (f64, f64), oracle: Option<String>) -> PyResult<String> {
    let (from, to) = scales;
    if !(1e-6..=1e6).contains(&from) {
        return Err(value_error(Invalid::new("from", format!("{from:?}"), "1e-6 to 1e6")));
    }
    if !(to > from && to <= 1e6) {
        return Err(value_error(Invalid::new("to", format!("{to:?}"), "above --from, up to 1e6")));
    }
    let (stop, scene) = (Stop::default(), scene.0.clone());
    let work = {
        let stop = stop.clone();
        move || -> Result<Value, String> {
            let (request, oracle) = asked(&scene, None, oracle.as_deref(), &stop)?;
            let found = crossings(&oracle, &request, scales).map_err(|why| format!("{}: {why}", oracle.name()))?;
            let Crossings { at_first, incomplete, overturned } = found;
            let judge = panel::judge_of(scene.ask.model).map(|oracle| Stoppable { oracle, stop });
            let judged = judge.as_ref().map(|judge| (judge as &dyn Oracle, &request));
            Ok(json!({
                "overturning": Changes::of(at_first.overturned, overturned, judged, |fate| fate.overturned),
                "incomplete": Changes::of(at_first.incomplete, incomplete, judged, |fate| fate.incomplete),
                "oracle": oracle.name(),
            }))
        }
    };
    Ok(interruptible(py, &stop, work)?.map_err(value_error)?.to_string())
}
