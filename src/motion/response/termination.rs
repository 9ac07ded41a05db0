//! When a block that chatters is called at rest: exactly, or by one of the two schemes of Section 5.2 (Fig. 8).

use contract::{Case, Invalid};

use crate::{measure::critical, panel};

/// How chattering is ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Termination {
    /// Where the infinite sequence of impacts accumulates: once it is certain to, its sum is closed. No threshold.
    Exact,
    /// At the first impact that the block leaves with at most this speed `|φ'|`, which is `VelTol/(pα)` (Fig. 8b).
    VelocityThreshold(f64),
    /// At the first impact later after the initiation than the chattering time of Eq. 65, if the amplitude is below the critical one by a fit
    /// (Fig. 8a).
    ChatteringThreshold(Condition),
}

/// The fit of the critical amplitude that decides whether complete chattering is expected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// Eq. 76, by `ω` and `η`.
    Eq76,
    /// Eq. 77, by `η` alone.
    Eq77,
}

/// The rule for one case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    Exact,
    Speed(f64),
    /// The chattering time by Eq. 65.
    Time(f64),
}

impl Termination {
    /// Refuses a threshold that is not a speed.
    ///
    /// # Errors
    /// When a velocity threshold is not above 0 and finite.
    pub fn check(self) -> Result<Self, Invalid> {
        match self {
            Self::VelocityThreshold(speed) if !(speed > 0.0 && speed.is_finite()) => {
                Err(Invalid::new("velocity-threshold", format!("{speed:?}"), "above 0 and finite (in pα)"))
            }
            _ => Ok(self),
        }
    }

    /// What it comes to for this case. Where the chattering threshold does not apply, chattering ends exactly.
    pub(super) fn rule(self, case: &Case) -> Rule {
        match self {
            Self::Exact => Rule::Exact,
            Self::VelocityThreshold(speed) => Rule::Speed(speed),
            Self::ChatteringThreshold(condition) => {
                let critical = match condition {
                    Condition::Eq76 => critical::eq76(case.omega(), case.eta()),
                    Condition::Eq77 => critical::eq77(case.eta()),
                };
                let expected = case.amplitude() < critical;
                expected.then(|| chattering_time(case)).flatten().map_or(Rule::Exact, Rule::Time)
            }
        }
    }
}

/// The chattering time by Eq. 65, whatever its error; `None` for a restitution that its sums do not reach.
fn chattering_time(case: &Case) -> Option<f64> {
    Some(panel::coefficients(case.eta())?.chattering_time(case.epsilon(), case.omega()))
}
