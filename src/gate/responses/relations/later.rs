//! Still ground comes first. Only of a block that starts from rest, and of sums of sinusoids: of records a straight line to the first sample would come with it.

use contract::{Motion, Sinusoid, Stretch};

use super::terms::on;
use crate::cases::shaking::AnyMotion;

/// How much later, `τ`; few digits, so that times lose none.
pub(super) const BY: f64 = 1.375;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let Motion::Sinusoids(stretches) = asked.motion.as_ref() else { return None };
    if asked.start != (0.0, 0.0) {
        return None;
    }
    // Phases count from the start of the motion.
    let term = |term: &Sinusoid| Sinusoid { phase: term.phase - term.omega * BY, ..*term };
    let stretch = |of: &Stretch| Stretch { until: of.until + BY, terms: of.terms.iter().map(term).collect() };
    let still = Stretch { until: BY, terms: Vec::new() };
    let moved = on(asked, Motion::sinusoids([still].into_iter().chain(stretches.iter().map(stretch)).collect()))?;
    Some(AnyMotion { until: asked.until + BY, ..moved })
}
