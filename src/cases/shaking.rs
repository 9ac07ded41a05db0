//! Dimensionless questions for whole responses.

use std::sync::Arc;

use contract::{Body, Case, Motion};

/// A question for a whole response.
#[derive(Debug, Clone, PartialEq)]
pub enum Question {
    /// On ground that shakes as a sinusoid.
    Sinusoid(Shaking),
    /// On ground that moves in any way.
    Motion(AnyMotion),
}

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

/// A block on ground that moves in any way.
#[derive(Debug, Clone, PartialEq)]
pub struct AnyMotion {
    /// The block; without a slenderness it is only asked of the linear model.
    pub body: Body,
    /// The motion, in multiples of the threshold.
    pub motion: Arc<Motion>,
    /// The rotation and the velocity at `τ = 0`, `φ` and `φ'`; from rest if both are 0.
    pub start: (f64, f64),
    /// When the response ends at the latest, `τ`; infinite only where the motion ends.
    pub until: f64,
}

impl Question {
    /// The restitution.
    pub fn eta(&self) -> f64 {
        match self {
            Self::Sinusoid(shaking) => shaking.case.eta(),
            Self::Motion(asked) => asked.body.eta(),
        }
    }

    /// The slenderness angle, where it is known.
    pub fn alpha(&self) -> Option<f64> {
        match self {
            Self::Sinusoid(shaking) => shaking.case.slenderness().map(|slenderness| slenderness.alpha()),
            Self::Motion(asked) => asked.body.alpha(),
        }
    }

    /// When the ground comes to rest; infinite for never.
    pub fn lasts(&self) -> f64 {
        match self {
            Self::Sinusoid(shaking) => shaking.lasts.unwrap_or(f64::INFINITY),
            Self::Motion(asked) => asked.motion.duration(),
        }
    }

    /// When the response ends at the latest.
    pub fn until(&self) -> f64 {
        match self {
            Self::Sinusoid(shaking) => shaking.until,
            Self::Motion(asked) => asked.until,
        }
    }

    /// The same, with the response ending earlier.
    pub fn ending(&self, until: f64) -> Self {
        match self {
            Self::Sinusoid(shaking) => Self::Sinusoid(Shaking { until, ..*shaking }),
            Self::Motion(asked) => Self::Motion(AnyMotion { until, ..asked.clone() }),
        }
    }
}
