//! A sinusoid of no amplitude adds nothing, whatever its frequency.

use contract::Sinusoid;

use super::terms::with_terms;
use crate::cases::shaking::AnyMotion;

/// Between the others, or beside them: any will do.
const NOTHING: Sinusoid = Sinusoid { amplitude: 0.0, omega: 1.7, phase: 0.4 };

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    with_terms(asked, |terms| [NOTHING].iter().chain(terms).copied().collect())
}
