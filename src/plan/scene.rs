//! What a scene asks of a plan.

use contract::Invalid;

use super::Question;
use crate::motion::{
    response::{Lobes, Request, Termination},
    scene::Scene,
};

impl Scene {
    /// The question for the chattering time of the first rocking, to the scene's tolerance.
    ///
    /// # Errors
    /// When the numbers leave the range of a case.
    pub fn question(&self) -> Result<Question, Invalid> {
        let request = self.response(None, Termination::Exact)?;
        let Request { case, rounding, .. } = request;
        let lobes = Lobes::new(&case, request.phase);
        let (lobe, start) = lobes.departure(0.0);
        let from_threshold = start == lobe.start;
        let outlasts = request.lasts.is_none_or(|lasts| lasts - start >= lobes.half_period());
        let is_case = case.epsilon() <= 0.0 || (from_threshold && outlasts);
        let (request, afterwards) = if is_case { (None, Some(request)) } else { (Some(request), None) };
        Ok(Question { rounding, request, afterwards, ..Question::new(case, self.ask.tolerance) })
    }
}
