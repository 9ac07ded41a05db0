//! The largest rotation, with how far it may be off: what a response that differs by about a rounding, or is coarser, makes of it.

use contract::{Decline, Oracle};

use super::{Asked, MARGIN, Peak, Response, claims};

/// By how many roundings the largest rotation may be off by itself.
const ROUNDINGS: f64 = 64.0;

impl Asked {
    /// The response, with the largest rotation and how far that may be off; `None` if it never rocks.
    ///
    /// # Errors
    /// When the oracle declines.
    pub fn with_rotation(&self, oracle: &dyn Oracle) -> Result<(Response, Option<(Peak, f64)>), Decline> {
        let response = self.response(oracle)?;
        let Some(peak) = self.peak(&response, oracle)? else { return Ok((response, None)) };
        let ((moved, flights), margin) = match self {
            Self::Sinusoid(request) => (Response::moved(oracle, request)?, MARGIN),
            // The strength alone is moved.
            Self::Motion(request) => (Response::moved_on_motion(oracle, request)?, claims::MARGIN),
        };
        let moved = moved.peak_by(flights.as_ref(), self.alpha());
        let uncertainty = response.uncertainty_of(peak, moved, margin);
        Ok((response, Some((peak, uncertainty))))
    }
}

impl Response {
    /// How far the largest rotation may be off, from that of a response that differs by rounding: by any amount where the two part.
    fn uncertainty_of(&self, peak: Peak, moved: Option<Peak>, margin: f64) -> f64 {
        let size = peak.rotation.abs();
        let parted = self.bouts.iter().any(|bout| bout.conditioning == f64::INFINITY);
        match moved.filter(|_| !parted) {
            Some(moved) => margin * (moved.rotation.abs() - size).abs() + ROUNDINGS * f64::EPSILON * size,
            None => f64::INFINITY,
        }
    }
}
