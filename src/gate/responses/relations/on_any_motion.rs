//! A steady sinusoid is a motion of one stretch with one term. Only from a phase that is given: the threshold is a phase that is rounded.

use std::sync::Arc;

use contract::{Body, Motion, Sinusoid, Stretch};

use crate::cases::shaking::{AnyMotion, Shaking};

pub(super) fn change(shaking: &Shaking) -> Option<AnyMotion> {
    let Shaking { case, phase, lasts, until } = shaking;
    let term = Sinusoid { amplitude: case.amplitude(), omega: case.omega(), phase: (*phase)? };
    let stretch = Stretch { until: lasts.unwrap_or(f64::INFINITY), terms: vec![term] };
    let body = Body::new(case.eta(), case.slenderness().map(|slenderness| slenderness.alpha())).ok()?;
    let motion = Arc::new(Motion::sinusoids(vec![stretch]).ok()?);
    Some(AnyMotion { body, motion, start: (0.0, 0.0), until: *until })
}
