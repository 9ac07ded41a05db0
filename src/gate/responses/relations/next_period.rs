//! A sinusoid is what it was a period ago.

use std::f64::consts::TAU;

use contract::Sinusoid;

use super::terms::with_terms;
use crate::cases::shaking::AnyMotion;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let further = |term: &Sinusoid| Sinusoid { phase: term.phase + TAU, ..*term };
    with_terms(asked, |terms| terms.iter().map(further).collect())
}
