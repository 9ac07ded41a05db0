//! Errors, counted by their powers of ten.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::gate::counting::add_counts;

/// Relative errors, counted.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// How many.
    pub count: usize,
    /// The largest. What is no number counts as 1e300.
    pub worst: f64,
    /// How many are at most ten to this power, and above the power before: from -17, all that is at most 1e-17, to 1, all that is above 1.
    pub decades: BTreeMap<i32, usize>,
}

/// The decades at the ends, which hold all that is beyond.
const ENDS: (i32, i32) = (-17, 1);

/// What an error that is no number counts as.
const LARGEST: f64 = 1e300;

impl Errors {
    /// Counts an error.
    pub(super) fn note(&mut self, error: f64) {
        let error = if error <= LARGEST { error.abs() } else { LARGEST };
        self.count += 1;
        self.worst = self.worst.max(error);
        let decade = if error > 0.0 { (error.log10().ceil() as i32).clamp(ENDS.0, ENDS.1) } else { ENDS.0 };
        *self.decades.entry(decade).or_default() += 1;
    }

    /// Adds those of other cases.
    pub(super) fn add(&mut self, other: Self) {
        self.count += other.count;
        self.worst = self.worst.max(other.worst);
        add_counts(&mut self.decades, other.decades);
    }

    /// All of them together.
    pub fn sum<'a>(all: impl Iterator<Item = &'a Self>) -> Self {
        let mut sum = Self::default();
        all.for_each(|errors| sum.add(errors.clone()));
        sum
    }

    /// A power of ten that half of the errors do not exceed; `None` if there are none.
    pub fn median(&self) -> Option<f64> {
        let mut below = 0;
        let middle = self.decades.iter().find(|(_, count)| {
            below += **count;
            2 * below >= self.count
        });
        middle.map(|(&decade, _)| 10.0_f64.powi(decade))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each power of ten holds what is at most itself; what is no number is an error beyond all others.
    #[test]
    fn errors_are_counted_by_powers_of_ten() {
        let mut errors = Errors::default();
        assert_eq!(errors.median(), None);
        for error in [0.0, 1e-30, 1e-3, 1.1e-3, -5e-3, 2.0] {
            errors.note(error);
        }
        assert_eq!(errors.decades, BTreeMap::from([(-17, 2), (-3, 1), (-2, 2), (1, 1)]));
        assert_eq!((errors.count, errors.worst, errors.median()), (6, 2.0, Some(1e-3)));
        let mut other = Errors::default();
        other.note(f64::NAN);
        other.note(f64::INFINITY);
        errors.add(other);
        assert_eq!((errors.count, errors.worst, errors.decades[&1]), (8, 1e300, 3));
    }
}
