//! When a block that chatters is called at rest: exactly, or by one of the two schemes of Section 5.2 (Fig. 8).

use contract::Invalid;

/// How chattering is ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Termination {
    /// Where the infinite sequence of impacts accumulates: once it is certain to, its sum is closed. No threshold.
    Exact,
    /// At the first impact that the block leaves with at most this speed `|φ'|`, which is `VelTol/(pα)` (Fig. 8b).
    VelocityThreshold(f64),
    /// At the first impact later after the initiation than this time `τ`, which is to be a chattering time (Fig. 8a).
    ChatteringThreshold(f64),
}

impl Termination {
    /// Refuses a threshold that is not a speed, or not a time.
    ///
    /// # Errors
    /// When a threshold is not above 0 and finite.
    pub fn check(self) -> Result<Self, Invalid> {
        match self {
            Self::VelocityThreshold(speed) if !(speed > 0.0 && speed.is_finite()) => {
                Err(Invalid::new("velocity-threshold", format!("{speed:?}"), "above 0 and finite (in pα)"))
            }
            Self::ChatteringThreshold(time) if !(time > 0.0 && time.is_finite()) => {
                Err(Invalid::new("chattering threshold", format!("{time:?}"), "above 0 and finite (in τ)"))
            }
            _ => Ok(self),
        }
    }
}
