//! The samples of a record are in a unit a quarter as large, which its scale takes back: no digit changes.

use contract::{Motion, Record};

use super::terms::on;
use crate::cases::shaking::AnyMotion;

/// A power of two.
const UNIT: f64 = 0.25;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let Motion::Record(Record { dt, scale, samples }) = asked.motion.as_ref() else { return None };
    on(asked, Motion::record(*dt, scale * UNIT, samples.iter().map(|sample| sample / UNIT).collect()))
}
