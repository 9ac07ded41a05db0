//! The time that is left of chattering after one impact, as a power series in the speed: the local Zeno series.
//!
//! Nothing is followed. From the speed, the time and the side of one impact, and the derivatives of the ground motion at that time, the series sums up all
//! impacts that follow; see [`series`]. Written to be independent of every method that steps: its own evaluation of the ground ([`ground`]), its own flights as series
//! in two variables ([`flight`]), its own bounds ([`bounds`]). It says by how much it may be wrong, and declines where it must not be trusted: next to
//! the initiation, where its terms do not fall, and where the motion of the ground changes before the impacts have accumulated.
#![cfg_attr(test, allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used))]

pub mod bounds;
mod closure;
pub mod equation;
mod extended;
pub mod flight;
pub mod ground;
pub mod heights;
mod pair;
mod polynomial;
pub mod series;

pub use closure::{MOST_ORDER, Series, Terms};
use contract::{Body, Case, Closure, Decline, History, Invalid, Model, Motion, Oracle};

/// The closing of sequences by the series to some order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Accumulation {
    order: usize,
}

impl Default for Accumulation {
    /// To order 8.
    fn default() -> Self {
        Self { order: 8 }
    }
}

impl Accumulation {
    /// To another order.
    ///
    /// # Errors
    /// When `order` is not 1 to 16.
    pub fn with_order(self, order: usize) -> Result<Self, Invalid> {
        if (1..=MOST_ORDER).contains(&order) {
            Ok(Self { order })
        } else {
            Err(Invalid::new("order", order, "1 to 16"))
        }
    }

    /// The series of a block under a motion of the ground.
    pub fn series(&self, body: &Body, motion: &Motion) -> Series {
        Series::new(body, motion, self.order)
    }
}

impl Oracle for Accumulation {
    fn name(&self) -> &str {
        "accumulation"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, _case: &Case) -> Result<History, Decline> {
        Err(Decline::Unsupported { what: "impacts: it closes the sum of those that follow one" })
    }

    /// Of Eq. 2 for a block with a slenderness, of Eq. 4 for one without.
    fn closure_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn Closure>, Decline> {
        Ok(Box::new(self.series(body, motion)))
    }
}
