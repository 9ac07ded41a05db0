//! A question on another motion of the ground.

use std::sync::Arc;

use contract::{Invalid, Motion, Sinusoid, Stretch};

use crate::cases::shaking::AnyMotion;

/// The same block, and start, on another motion; `None` where there is no such motion.
pub(super) fn on(asked: &AnyMotion, motion: Result<Motion, Invalid>) -> Option<AnyMotion> {
    Some(AnyMotion { motion: Arc::new(motion.ok()?), ..asked.clone() })
}

/// The same on a sum of sinusoids that is written in another way, a stretch at a time; `None` of other motions.
pub(super) fn with_terms(asked: &AnyMotion, rewrite: impl Fn(&[Sinusoid]) -> Vec<Sinusoid>) -> Option<AnyMotion> {
    let Motion::Sinusoids(stretches) = asked.motion.as_ref() else { return None };
    let stretch = |of: &Stretch| Stretch { until: of.until, terms: rewrite(&of.terms) };
    on(asked, Motion::sinusoids(stretches.iter().map(stretch).collect()))
}
