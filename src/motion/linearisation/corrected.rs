//! The linear model with the first-order effect of the slenderness, as an oracle.

use contract::{Case, Decline, Ending, Estimate, History, Horizon, Limit, Model, Oracle};

use super::{LARGEST_RATIO, Linearisation, Shift, threshold::refused};
use crate::measure::excitation::{half_period, horizon};

/// The linear model with the first-order effect of the slenderness: between the two models, with an error that falls as `α⁴`.
///
/// It claims what the linear oracle claims and what the first order leaves out. It declines where that effect is not small, where the claims don't tell
/// how the history ends, and incomplete chattering past half a period.
pub struct Corrected {
    name: String,
    stepper: Box<dyn Oracle>,
}

/// By how much of the horizon the linear impacts are followed past it, for those that the correction moves before it.
const PAST: f64 = 0.05;

impl Corrected {
    /// The correction of a linear oracle that knows how its impacts move.
    pub fn new(stepper: Box<dyn Oracle>) -> Self {
        Self { name: format!("{}/corrected", stepper.name()), stepper }
    }
}

impl Oracle for Corrected {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        Model::Nonlinear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let end = horizon(case);
        let past = case.with_horizon(Horizon::Until(end * (1.0 + PAST))).map_err(refused)?;
        let linearisation = Linearisation::new(self.stepper.as_ref(), &past)?;
        let complete = linearisation.linear.history.ending == Ending::AtRest;
        if !complete && end > half_period(case.omega()) {
            // There a flight may miss the base by a hair in one model and touch it in the other, which no derivative tells.
            return Err(Decline::Unsupported { what: "incomplete chattering past half a period" });
        }
        let mut impacts = linearisation.corrected();
        let unsure = |why: &str| Err(Decline::NotConvergent { why: why.to_owned() });
        let large = |shift: &Shift| !(shift.left < f64::INFINITY && shift.first_order.abs() < LARGEST_RATIO);
        if linearisation.impacts.iter().any(|of| large(&of.interval) || large(&of.velocity)) {
            return unsure("the first-order effect of the slenderness is not small");
        }
        let beside = |time: f64, error: f64| (time - end).abs() <= error;
        if impacts.iter().any(|impact| beside(impact.time, impact.uncertainty.time)) {
            return unsure("undecided: an impact is too near to the end of the time followed");
        }
        let moved = linearisation.impacts.iter().map(|of| of.time.first_order.abs() + of.time.left).fold(0.0, f64::max);
        if moved > 0.5 * PAST * end {
            return unsure("the effect of the slenderness moves impacts across the end of the time followed");
        }
        let listed = impacts.len();
        impacts.retain(|impact| impact.time < end);
        let ending = match linearisation.linear.history.ending {
            Ending::AtRest => match linearisation.corrected_chattering_time() {
                Some(Estimate { value, uncertainty }) if value + uncertainty < end => Ending::AtRest,
                _ => return unsure("undecided: whether the chattering is complete"),
            },
            Ending::Overturned => return unsure("undecided: whether the block overturns"),
            Ending::LimitReached(Limit::Impacts) if impacts.len() == listed => Ending::LimitReached(Limit::Impacts),
            Ending::LimitReached(_) if case.horizon() == Horizon::HalfPeriod => Ending::Incomplete,
            Ending::LimitReached(_) => Ending::LimitReached(Limit::Time),
            other => other,
        };
        Ok(History { impacts, ending, chattering_time: None })
    }
}
