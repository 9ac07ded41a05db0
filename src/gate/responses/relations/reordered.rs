//! A sum does not depend on the order of what is added.

use super::terms::with_terms;
use crate::cases::shaking::AnyMotion;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let reordered = with_terms(asked, |terms| terms.iter().rev().copied().collect())?;
    (reordered.motion != asked.motion).then_some(reordered)
}
