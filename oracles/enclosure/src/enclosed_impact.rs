//! What is proven of one impact.

use contract::{Estimate, Impact, Uncertainty};

use crate::{bounds::Bounds, directed::Directed, sequence};

/// Bounds for one impact.
#[derive(Debug, Clone, PartialEq)]
pub struct EnclosedImpact {
    /// The time `τ_n`.
    pub time: Bounds,
    /// The interval `Δτ_(n-1)`.
    pub interval: Bounds,
    /// The velocity `φ'` just after the impact.
    pub velocity: Bounds,
}

/// What is proven of one impact; `None` if a bound is not a number.
pub(crate) fn enclosed_impact<F: Directed>(impact: sequence::Impact<F>) -> Option<EnclosedImpact> {
    Some(EnclosedImpact {
        time: Bounds::new(&impact.time)?,
        interval: Bounds::new(&impact.interval)?,
        velocity: Bounds::new(&impact.side.of(&impact.speed))?,
    })
}

/// The middle of an interval, and half its width.
pub(crate) fn estimate(bounds: &Bounds) -> Estimate {
    let (value, uncertainty) = bounds.middle();
    Estimate { value, uncertainty }
}

impl EnclosedImpact {
    pub(crate) fn impact(&self) -> Impact {
        let relative = |bounds: &Bounds| {
            let (value, uncertainty) = bounds.middle();
            (value, (uncertainty / bounds.lower().abs().min(bounds.upper().abs())).next_up())
        };
        let (time, time_claim) = self.time.middle();
        let (interval, interval_claim) = relative(&self.interval);
        let (velocity, velocity_claim) = relative(&self.velocity);
        let uncertainty = Uncertainty { time: time_claim, interval: interval_claim, velocity: velocity_claim };
        Impact { time, interval, velocity, uncertainty }
    }
}
