//! The largest rotation, with how far it may be off: what a response that differs by about a rounding, or is coarser, makes of it.

use std::sync::Arc;

use contract::{Body, Decline, Oracle};

use super::{MARGIN, OnMotion, Peak, Request, Response, nudged, run};

/// By how many roundings the largest rotation may be off by itself.
const ROUNDINGS: f64 = 64.0;

impl Response {
    /// The response, with the largest rotation and how far that may be off; `None` if it never rocks.
    ///
    /// # Errors
    /// As [`Response::new`].
    pub fn with_rotation(oracle: &dyn Oracle, request: &Request) -> Result<(Self, Option<(Peak, f64)>), Decline> {
        let response = Self::new(oracle, request)?;
        let Some(peak) = response.peak(oracle, request)? else { return Ok((response, None)) };
        let case = nudged(&request.case, request.rounding)
            .map_err(|_| Decline::Unsupported { what: "cases at the border of what is allowed" })?;
        let coarser = oracle.coarser();
        let flights = coarser.as_deref().unwrap_or(oracle).flights(&case)?;
        let other = run::follow(&Request { case, ..*request }, flights.as_ref()).peak_by(flights.as_ref());
        let uncertainty = response.uncertainty_of(peak, other);
        Ok((response, Some((peak, uncertainty))))
    }

    /// The response to another motion than a sinusoid, with the largest rotation and how far that may be off; `None` if it never rocks.
    ///
    /// # Errors
    /// As [`Response::on_motion`].
    pub fn with_rotation_on_motion(
        oracle: &dyn Oracle,
        request: &OnMotion,
    ) -> Result<(Self, Option<(Peak, f64)>), Decline> {
        let response = Self::on_motion(oracle, request)?;
        let Some(peak) = response.peak_on_motion(oracle, request)? else { return Ok((response, None)) };
        let border = |_| Decline::Unsupported { what: "motions at the border of what is allowed" };
        let motion = request.motion.scaled(1.0 + 4.0 * f64::EPSILON + request.rounding).map_err(border)?;
        let body = Body::new(request.body.eta() * (1.0 - 0.5 * f64::EPSILON), request.body.alpha()).map_err(border)?;
        let nearby = OnMotion { body, motion: Arc::new(motion), ..request.clone() };
        let coarser = oracle.coarser();
        let flights = coarser.as_deref().unwrap_or(oracle).flights_on(&nearby.body, &nearby.motion)?;
        let other = run::follow_motion(&nearby, flights.as_ref()).peak_by(flights.as_ref());
        let uncertainty = response.uncertainty_of(peak, other);
        Ok((response, Some((peak, uncertainty))))
    }

    /// How far the largest rotation may be off, from that of a response that differs by rounding: by any amount where the two part.
    fn uncertainty_of(&self, peak: Peak, other: Option<Peak>) -> f64 {
        let size = peak.rotation.abs();
        let parted = self.bouts.iter().any(|bout| bout.conditioning == f64::INFINITY);
        match other.filter(|_| !parted) {
            Some(other) => MARGIN * (other.rotation.abs() - size).abs() + ROUNDINGS * f64::EPSILON * size,
            None => f64::INFINITY,
        }
    }
}
