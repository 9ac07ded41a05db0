//! What the criterion says of a bout, as commands and packages print it.

use serde::Serialize;

use super::{Bout, Criterion};

/// What the criterion says of a bout, in one row; times are `τ` since the start of the motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Told {
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
    /// How it ends.
    pub ending: &'static str,
    /// The impact from which on rest was certain; `null` if it never was.
    pub certain_from_impact: Option<usize>,
    /// When that was.
    pub certain_at: Option<f64>,
    /// The bounds on the time of rest that hold from then on, as those of [`Certain`](super::Certain).
    pub rest_lower: Option<f64>,
    /// See `rest_lower`.
    pub rest_upper: Option<f64>,
    /// The first impact from which alone the local series is trusted; `null` if it never is.
    pub predicted_from_impact: Option<usize>,
    /// When that was.
    pub predicted_at: Option<f64>,
    /// When it says that rest comes, and what it claims that this is off by.
    pub predicted_rest: Option<f64>,
    /// See `predicted_rest`.
    pub predicted_uncertainty: Option<f64>,
    /// The time that is left then, predicted and true.
    pub predicted_left: Option<f64>,
    /// See `predicted_left`.
    pub true_left: Option<f64>,
    /// When the ground pushes the block off again; `null` if it does not.
    pub gap_end: Option<f64>,
    /// What is left of the gap at rest.
    pub margin: Option<f64>,
    /// Whether a gap was missed before: incomplete chattering.
    pub missed_a_gap: bool,
}

impl Criterion {
    /// What it says of `bout`, in one row.
    pub fn told(&self, bout: &Bout) -> Told {
        let Self { certain, gap_end, missed_a_gap, predicted } = *self;
        let between = certain.and_then(|certain| certain.between);
        Told {
            from: bout.begin(),
            to: bout.end(),
            ending: bout.ending(),
            certain_from_impact: certain.map(|certain| certain.impact),
            certain_at: certain.map(|certain| certain.time),
            rest_lower: between.map(|(lower, _)| lower),
            rest_upper: between.map(|(_, upper)| upper),
            predicted_from_impact: predicted.map(|predicted| predicted.impact),
            predicted_at: predicted.map(|predicted| predicted.time),
            predicted_rest: predicted.map(|predicted| predicted.rest.value),
            predicted_uncertainty: predicted.map(|predicted| predicted.rest.uncertainty),
            predicted_left: predicted.map(|predicted| predicted.rest.value - predicted.time),
            true_left: predicted.map(|predicted| bout.end() - predicted.time),
            gap_end,
            margin: gap_end.map(|end| end - bout.end()),
            missed_a_gap,
        }
    }
}
