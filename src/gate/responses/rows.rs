//! The first row of the table of a response that is not what it has to be.

use super::{
    difference::{Difference, ROUNDING, ROUNDING_OF_STATES, What, plain, unless_near},
    follower::Followed,
    reference::Reference,
    whole::{BoutEnding, Row, State},
};

/// Beyond this rotation a fall is not followed.
const OUT_OF_SIGHT: f64 = 5.0;

pub(super) fn first_difference(rows: &[Row], reference: &Reference, scale: f64) -> Option<Difference> {
    let comparison = Comparison { reference, scale };
    rows.iter().find_map(|row| comparison.row(row))
}

struct Comparison<'a> {
    reference: &'a Reference,
    scale: f64,
}

impl Comparison<'_> {
    /// Whether the bout at this time ends with the block on its side, if it is followed long enough.
    fn overturns(&self, time: f64) -> bool {
        let Followed { bouts, falls, .. } = &self.reference.nominal;
        let bout = bouts.iter().take_while(|bout| bout.begin <= time).last();
        bout.is_some_and(|bout| match bout.outcome {
            BoutEnding::Overturned => true,
            BoutEnding::Cut => *falls,
            BoutEnding::Rest | BoutEnding::GivenUp => false,
        })
    }

    fn row(&self, row: &Row) -> Option<Difference> {
        if row.time >= self.reference.until {
            return None;
        }
        let ((rotation, velocity), spread) = self.reference.at(row.time);
        if rotation.abs() > OUT_OF_SIGHT.min(self.reference.nominal.problem.lies_at) {
            return None;
        }
        if matches!(row.state, State::Overturned | State::Lying) && !self.overturns(row.time) {
            return Some(Difference { expected: rotation, ..plain(What::State, row.time) });
        }
        let floor = ROUNDING_OF_STATES * (1.0 + rotation.abs());
        let allowed = self.scale * spread.0 + floor;
        let differs = unless_near(What::Rotation, row.time, row.rotation, rotation, allowed);
        if differs.is_some() || row.state == State::Lying || self.is_at_an_impact(row.time) {
            return differs;
        }
        let allowed = self.scale * spread.1 + ROUNDING_OF_STATES * (1.0 + velocity.abs());
        unless_near(What::Velocity, row.time, row.velocity, velocity, allowed)
    }

    /// Whether the velocity jumps at this time, as far as that is known, or so often that it is not resolved.
    fn is_at_an_impact(&self, time: f64) -> bool {
        let bouts = self.reference.nominal.bouts.iter().zip(&self.reference.known);
        let Some((bout, known)) = bouts.take_while(|(bout, _)| bout.begin <= time + ROUNDING).last() else {
            return false;
        };
        let near = ROUNDING_OF_STATES + self.scale * known.impacts.last().map_or(0.0, |(time, _)| *time);
        let unresolved = bout.impacts.last().is_some_and(|last| time >= last.time - near && time <= bout.end + near);
        let next = bout.impacts.partition_point(|impact| impact.time < time - near);
        unresolved || bout.impacts.get(next).is_some_and(|impact| impact.time <= time + near)
    }
}
