//! A sinusoid is the sum of its halves.

use contract::Sinusoid;

use super::terms::with_terms;
use crate::cases::shaking::AnyMotion;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let half = |term: &Sinusoid| Sinusoid { amplitude: 0.5 * term.amplitude, ..*term };
    with_terms(asked, |terms| terms.iter().chain(terms).map(half).collect())
}
