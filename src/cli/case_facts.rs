//! What a case was, for answers that are collected: an answer in JSON says what it answers.

use chattercheck::cases::case_file::name_of;
use contract::Case;
use serde::Serialize;

/// The parameters of a case, dimensionless.
#[derive(Serialize)]
pub(super) struct CaseFacts {
    pub a: f64,
    /// `a - 1`, without the rounding of `a`.
    pub epsilon: f64,
    pub omega: f64,
    pub eta: f64,
    /// Radians; `null` for the slender block.
    pub alpha: Option<f64>,
    /// What `a` is a multiple of: `threshold`, g tan(alpha), or `slender`, g alpha; `null` for the slender block, where they are the same.
    pub normalisation: Option<&'static str>,
}

impl CaseFacts {
    pub fn of(case: &Case) -> Self {
        let slenderness = case.slenderness();
        Self {
            a: case.amplitude(),
            epsilon: case.epsilon(),
            omega: case.omega(),
            eta: case.eta(),
            alpha: slenderness.map(|of| of.alpha()),
            normalisation: slenderness.map(|of| name_of(of.normalisation())),
        }
    }
}
