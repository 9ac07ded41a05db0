//! What is asked of the response, by a sinusoid or by another motion.

use chattercheck::motion::response::{OnMotion, Peak, Request, Response, Sample, Window};
use contract::{Decline, Oracle};

/// What is asked of the response.
pub(super) enum Asked {
    Sinusoid(Request),
    Motion(OnMotion),
}

impl Asked {
    pub fn response(&self, oracle: &dyn Oracle) -> Result<Response, Decline> {
        match self {
            Self::Sinusoid(request) => Response::new(oracle, request),
            Self::Motion(request) => Response::on_motion(oracle, request),
        }
    }

    pub fn samples(&self, response: &Response, oracle: &dyn Oracle, window: &Window) -> Result<Vec<Sample>, Decline> {
        match self {
            Self::Sinusoid(request) => response.samples(oracle, request, window),
            Self::Motion(request) => response.samples_on_motion(oracle, request, window),
        }
    }

    pub fn peak(&self, response: &Response, oracle: &dyn Oracle) -> Result<Option<Peak>, Decline> {
        match self {
            Self::Sinusoid(request) => response.peak(oracle, request),
            Self::Motion(request) => response.peak_on_motion(oracle, request),
        }
    }

    pub fn eta(&self) -> f64 {
        match self {
            Self::Sinusoid(request) => request.case.eta(),
            Self::Motion(request) => request.body.eta(),
        }
    }
}
