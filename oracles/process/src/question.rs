//! What is said to an engine.

use contract::{Case, Horizon, Model, Normalisation};
use serde::Serialize;

use crate::words;

/// The versions of the protocol that are spoken here.
pub const VERSIONS: [u64; 1] = [1];

/// What has to come back bit for bit: a double without a short decimal, the smallest, the largest, and the zero with a sign.
pub const ECHO: [f64; 4] = [0.1, 5e-324, f64::MAX, -0.0];

/// A message to the engine.
#[derive(Debug, Serialize)]
#[serde(tag = "cmd", rename_all = "lowercase")]
pub enum Question<'a> {
    /// The first: which versions are spoken, and what to echo.
    Start {
        /// The versions.
        versions: [u64; 1],
        /// The doubles.
        echo: [f64; 4],
    },
    /// One case.
    Case(&'a Asked),
    /// Many cases.
    Cases {
        /// The cases.
        cases: &'a [Asked],
    },
    /// The last.
    Stop,
}

/// A case in the words of the protocol.
#[derive(Debug, Serialize)]
pub struct Asked {
    /// The number that the answer has to carry.
    pub seq: u64,
    model: &'static str,
    epsilon: f64,
    omega: f64,
    eta: f64,
    alpha: Option<f64>,
    normalisation: &'static str,
    ground: Ground,
    impacts: usize,
    until: Until,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
enum Ground {
    Sine { start: &'static str },
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Until {
    Named(&'static str),
    Time(f64),
}

impl Asked {
    /// The question number `seq`: this case, in this model. The normalisation is the case's own, and `otherwise` where the model has no slenderness.
    pub fn new(seq: u64, case: &Case, model: Model, otherwise: Normalisation) -> Self {
        let slenderness = case.slenderness().filter(|_| model == Model::Nonlinear);
        Self {
            seq,
            model: words::model(model),
            epsilon: case.epsilon(),
            omega: case.omega(),
            eta: case.eta(),
            alpha: slenderness.map(|block| block.alpha()),
            normalisation: words::normalisation(slenderness.map_or(otherwise, |block| block.normalisation())),
            ground: Ground::Sine { start: "threshold" },
            impacts: case.max_impacts(),
            until: match case.horizon() {
                Horizon::HalfPeriod => Until::Named("half-period"),
                Horizon::Until(time) => Until::Time(time),
            },
        }
    }
}

impl Question<'_> {
    /// The message as a line, with its end.
    ///
    /// # Errors
    /// None that is known: every message can be written as JSON.
    pub fn line(&self) -> serde_json::Result<String> {
        serde_json::to_string(self).map(|text| text + "\n")
    }
}
