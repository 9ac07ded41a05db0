//! The scheme of Fig. 8a: where complete chattering is expected by a fit of the critical amplitude, the block is called at rest once the chattering time
//! of Eq. 65 has passed.

use asymptotic::coefficients;
use contract::Case;

use crate::{measure::critical, motion::response::Termination};

/// The fit of the critical amplitude that decides whether complete chattering is expected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// Eq. 76, by `ω` and `η`.
    Eq76,
    /// Eq. 77, by `η` alone.
    Eq77,
}

/// The termination by this scheme. Where it does not apply, above the fit or for a restitution that the sums of Eq. 65 do not reach, chattering ends exactly.
pub fn chattering_threshold(case: &Case, condition: Condition) -> Termination {
    let critical = match condition {
        Condition::Eq76 => critical::eq76(case.omega(), case.eta()),
        Condition::Eq77 => critical::eq77(case.eta()),
    };
    let series = coefficients(case.eta()).filter(|_| case.amplitude() < critical);
    let time = series.map(|series| series.chattering_time(case.epsilon(), case.omega()));
    // A block that does not rock has none.
    time.filter(|time| *time > 0.0).map_or(Termination::Exact, Termination::ChatteringThreshold)
}
