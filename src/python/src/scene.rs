//! A block and a motion of the ground, as the commands read them from a scene.

use std::sync::Arc;

use chattercheck::{
    motion::{
        record::Units,
        response::Asked,
        scene::{self, Ground, Shaking},
    },
    panel::{self, Settings},
};
use contract::Model;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::{
    error::{scene_error, value_error},
    wait::{Stop, Stoppable},
};

/// A scene whose values are all allowed.
#[pyclass(frozen)]
pub struct Scene(pub Arc<scene::Scene>);

/// Samples of the ground's acceleration in place of the ground of a scene.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Samples<'py> {
    acc: PyReadonlyArray1<'py, f64>,
    units: String,
    scale: f64,
    /// The step in seconds, or in `τ`.
    dt: Option<f64>,
    dt_tau: Option<f64>,
}

#[pymethods]
impl Scene {
    /// A scene from its text; with samples in place of its ground.
    #[new]
    #[pyo3(signature = (text, samples=None))]
    fn new(text: &str, samples: Option<Samples<'_>>) -> PyResult<Self> {
        let mut scene = scene::Scene::parse(text).map_err(scene_error)?;
        if let Some(Samples { acc, units, scale, dt, dt_tau }) = samples {
            let units = Units::named(&units).map_err(value_error)?;
            let dt = dt.map(|seconds| seconds * scene.block.frequency_parameter()).or(dt_tau).unwrap_or(f64::NAN);
            let samples = acc.as_array().to_vec();
            let shaking = Shaking::of_samples(&scene.block, units, (dt, scale), samples).map_err(value_error)?;
            scene.ground = Ground::Shaking(shaking);
        }
        Ok(Self(Arc::new(scene)))
    }

    /// `p`, 1/s.
    #[getter]
    fn frequency_parameter(&self) -> f64 {
        self.0.block.frequency_parameter()
    }

    /// `α`, radians.
    #[getter]
    fn alpha(&self) -> f64 {
        self.0.block.slenderness
    }

    /// `R`, metres.
    #[getter]
    fn radius(&self) -> f64 {
        self.0.block.radius
    }

    /// `η`.
    #[getter]
    fn restitution(&self) -> f64 {
        self.0.block.restitution
    }

    /// m/s².
    #[getter]
    fn gravity(&self) -> f64 {
        self.0.block.gravity
    }

    /// The acceleration of the ground at which the block begins to rock, in g.
    #[getter]
    fn threshold(&self) -> f64 {
        self.0.threshold()
    }
}

/// By whose flights what is asked is answered: those of the oracle that is named, or the fastest.
///
/// # Errors
/// When the name is not known, or that oracle does not solve the equation.
pub fn oracle_of(asked: &Asked, model: Model, name: Option<&str>, stop: &Stop) -> Result<Stoppable, panel::Refused> {
    let oracle = match (name, asked) {
        (Some(name), _) => {
            panel::one(name, &Settings::default(), if model == Model::Linear { "linear" } else { "nonlinear" })?
        }
        (None, Asked::Sinusoid(_)) => panel::stepper_of(model),
        (None, Asked::Motion(request)) => panel::stepper_on(&request.body, &request.motion),
    };
    if oracle.model() == Model::Linear && model == Model::Nonlinear {
        let solves = |method: &panel::Method| method.models.contains(&model);
        return Err(panel::Refused::unused("model", "nonlinear (of the scene)", oracle.name(), solves));
    }
    Ok(Stoppable { oracle, stop: stop.clone() })
}
