//! What is asked of a response, by a sinusoid or by another motion.

use contract::{Decline, Oracle};

use super::{OnMotion, Peak, Request, Response, Sample, Window};

/// What is asked of a response.
#[derive(Debug, Clone, PartialEq)]
pub enum Asked {
    /// To a sinusoid under a block at rest.
    Sinusoid(Request),
    /// To another motion.
    Motion(OnMotion),
}

impl Asked {
    /// The response.
    ///
    /// # Errors
    /// When the oracle declines.
    pub fn response(&self, oracle: &dyn Oracle) -> Result<Response, Decline> {
        match self {
            Self::Sinusoid(request) => Response::new(oracle, request),
            Self::Motion(request) => Response::on_motion(oracle, request),
        }
    }

    /// Its samples.
    ///
    /// # Errors
    /// When the oracle, which the response is of, declines.
    pub fn samples(&self, response: &Response, oracle: &dyn Oracle, window: &Window) -> Result<Vec<Sample>, Decline> {
        match self {
            Self::Sinusoid(request) => response.samples(oracle, request, window),
            Self::Motion(request) => response.samples_on_motion(oracle, request, window),
        }
    }

    /// Its largest rotation; `None` if the block never rocks.
    ///
    /// # Errors
    /// When the oracle, which the response is of, declines.
    pub fn peak(&self, response: &Response, oracle: &dyn Oracle) -> Result<Option<Peak>, Decline> {
        match self {
            Self::Sinusoid(request) => response.peak(oracle, request),
            Self::Motion(request) => response.peak_on_motion(oracle, request),
        }
    }

    /// The slenderness, of a block that has one.
    pub(super) fn alpha(&self) -> Option<f64> {
        match self {
            Self::Sinusoid(request) => request.case.slenderness().map(|slenderness| slenderness.alpha()),
            Self::Motion(request) => request.body.alpha(),
        }
    }

    /// The coefficient of restitution.
    pub fn eta(&self) -> f64 {
        match self {
            Self::Sinusoid(request) => request.case.eta(),
            Self::Motion(request) => request.body.eta(),
        }
    }
}
