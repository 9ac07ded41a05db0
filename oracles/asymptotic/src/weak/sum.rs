//! The time of rest from the terms of its series, and what they leave out.

use contract::Estimate;

use super::flight::{Flights, Push};
use crate::march::{Search, accumulate};

/// By which powers of what is small the terms go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Powers {
    /// About a smooth peak by those of the root of `ε`. Two and two are of one size where the peak is symmetric.
    Roots,
    /// About a kinked one by those of `ε`.
    Whole,
}

/// How many orders beyond the last one that is used tell the error.
const BEYOND: usize = 2;
/// The largest error met in 400 random motions was 1.2 of what the terms beyond say (`tests/motion/weak.rs` of the harness).
const SAFETY: f64 = 2.0;
/// To which the terms together are extrapolated.
const PRECISION: f64 = 1e-15;
/// Of the extrapolation and of the terms, in units of the last place.
const ROUNDING: f64 = 2000.0;
/// Terms that fall by less are near the border, where the next ones fall by still less.
const MOST_RATIO: f64 = 0.6;

impl Powers {
    /// How many terms there are up to the order `ε^(order - 1)`, relative.
    fn terms(self, order: usize) -> usize {
        match self {
            Self::Roots => 2 * order - 1,
            Self::Whole => order,
        }
    }

    /// How many terms have to be known for an answer to an order.
    pub fn needed(self, order: usize) -> usize {
        self.terms(order + BEYOND)
    }

    /// The sizes of the terms of each order.
    fn sizes(self, terms: &[f64]) -> Vec<f64> {
        let size = |terms: &[f64]| terms.iter().map(|term| term.abs()).sum();
        let Some((first, rest)) = terms.split_first() else { return Vec::new() };
        let group = match self {
            Self::Roots => 2,
            Self::Whole => 1,
        };
        std::iter::once(first.abs()).chain(rest.chunks(group).map(size)).collect()
    }
}

/// The terms of the time of rest, in the unit of the push; `None` where a flight does not end, or they do not settle.
pub(super) fn terms(push: Push, eta: f64) -> Option<Vec<f64>> {
    let mut flights = Flights::new(push, eta);
    let (_, limit) = accumulate(|even| flights.fly(even), eta * eta, 0, Search::Together(PRECISION));
    Some(limit?.value.0)
}

/// Their sum up to `order`, with what is left out; `None` where they do not fall.
pub(super) fn sum(terms: &[f64], powers: Powers, order: usize) -> Option<Estimate> {
    let (used, left) = terms.split_at_checked(powers.terms(order))?;
    let sizes = powers.sizes(terms);
    let [.., before, early, late] = *sizes.as_slice() else { return None };
    let ratio = |late: f64, early: f64| if late == 0.0 { 0.0 } else { late / early };
    let ratio = ratio(late, early).max(ratio(early, before));
    let falls = ratio < MOST_RATIO;
    if !falls {
        return None;
    }
    let left: f64 = left.iter().map(|term| term.abs()).sum();
    let beyond = late * ratio / (1.0 - ratio);
    let value: f64 = used.iter().sum();
    let rounding = ROUNDING * f64::EPSILON * sizes.iter().sum::<f64>();
    Some(Estimate { value, uncertainty: SAFETY * (left + beyond) + rounding })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two orders beyond the last one that is used, and a geometric rest.
    #[test]
    fn what_is_left_out_is_claimed_twice() {
        let terms = [1.0, 0.1, 0.01, 0.001];
        let found = sum(&terms, Powers::Whole, 2).unwrap();
        assert!(
            (found.value - 1.1).abs() < 1e-15 && (found.uncertainty / (2.0 * 0.1 / 9.0) - 1.0).abs() < 1e-9,
            "{found:?}"
        );
        // About a symmetric peak every second term is 0.
        let found = sum(&[1.0, 0.0, 0.1, 0.0, 0.01, 0.0, 0.001], Powers::Roots, 2).unwrap();
        assert!(
            (found.value - 1.1).abs() < 1e-15 && (found.uncertainty / (2.0 * 0.1 / 9.0) - 1.0).abs() < 1e-9,
            "{found:?}"
        );
        assert!(
            sum(&[1.0, 0.7, 0.49, 0.343], Powers::Whole, 2).is_none()
                && sum(&[f64::NAN; 4], Powers::Whole, 2).is_none()
        );
        assert_eq!((Powers::Roots.needed(1), Powers::Roots.needed(2), Powers::Whole.needed(2)), (5, 7, 4));
    }
}
