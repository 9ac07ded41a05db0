//! The ground moves to the other side, and so does the block.

use super::terms::on;
use crate::cases::shaking::AnyMotion;

pub(super) fn change(asked: &AnyMotion) -> Option<AnyMotion> {
    let (rotation, velocity) = asked.start;
    let mirrored = on(asked, asked.motion.scaled(-1.0))?;
    Some(AnyMotion { start: (-rotation, -velocity), ..mirrored })
}
