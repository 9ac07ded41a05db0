//! What a motion of the ground was that is no sinusoid under a block at rest, for answers that are collected.

use chattercheck::{
    measure::ground::strongest,
    motion::{
        response::{OnMotion, Termination},
        scene::Scene,
    },
};
use contract::{Invalid, Motion};
use serde::Serialize;

use super::case_facts::CaseFacts;

/// What a scene was, dimensionless.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Facts {
    /// A sinusoid under a block at rest: a case.
    Case(CaseFacts),
    /// Any other motion.
    Motion(MotionFacts),
}

impl Facts {
    pub fn of(scene: &Scene) -> Result<Self, Invalid> {
        Ok(match scene.sine() {
            Ok(_) => Self::Case(CaseFacts::of(&scene.case()?)),
            Err(_) => Self::Motion(MotionFacts::of(scene, &scene.on_motion(None, Termination::Exact)?)),
        })
    }
}

/// The motion and the block, dimensionless.
#[derive(Serialize)]
pub(super) struct MotionFacts {
    pub ground: &'static str,
    pub eta: f64,
    /// Radians; `null` for the slender block.
    pub alpha: Option<f64>,
    /// When the ground comes to rest, `τ`; `null` if it does not.
    pub duration: Option<f64>,
    /// The strongest acceleration, or a bound on that of a sum of sinusoids, over that at which the block begins to rock.
    pub strongest: f64,
    /// Of a record.
    pub samples: Option<usize>,
    /// The time between them, `τ`.
    pub dt: Option<f64>,
}

impl MotionFacts {
    pub fn of(scene: &Scene, request: &OnMotion) -> Self {
        let record = match &*request.motion {
            Motion::Record(record) => Some(record),
            Motion::Sinusoids(_) | Motion::Ricker(_) => None,
        };
        Self {
            ground: scene.ground_name(),
            eta: request.body.eta(),
            alpha: request.body.alpha(),
            duration: Some(request.motion.duration()).filter(|duration| duration.is_finite()),
            strongest: strongest(&request.motion),
            samples: record.map(|record| record.samples.len()),
            dt: record.map(|record| record.dt),
        }
    }
}
