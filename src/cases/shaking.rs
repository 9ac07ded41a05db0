//! A dimensionless question for a whole response.

use contract::Case;

/// A block at rest on ground that begins to shake at `τ = 0` as a sinusoid, at any phase and for any time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaking {
    /// Amplitude, frequency and restitution, and the slenderness for the nonlinear model (threshold normalisation).
    pub case: Case,
    /// The phase at `τ = 0`, in radians; `None` for the threshold, growing.
    pub phase: Option<f64>,
    /// When the shaking ends, `τ`; `None` for never.
    pub lasts: Option<f64>,
    /// When the response ends at the latest, `τ`; infinite only where the shaking ends.
    pub until: f64,
}
