use contract::{Case, Ending, Horizon};

use super::{Conclusion, ENDLESS, Landing, Response, Run, Specimen, half_period};
use crate::{measure::critical, panel};

/// The scheme of Fig. 8a: below the critical amplitude of Eq. 76 the block is put to rest at the first impact after the chattering time of Eq. 65;
/// above it, never.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AdHoc;

impl Specimen for AdHoc {
    fn family(&self) -> &'static str {
        "ad hoc (Eqs 65 and 76)"
    }

    fn setting(&self) -> String {
        String::new()
    }

    fn run(&self, case: &Case) -> Option<Run> {
        let half_period = half_period(case);
        let followed = case.with_max_impacts(ENDLESS).ok()?.with_horizon(Horizon::Until(2.0 * half_period)).ok()?;
        let history = panel::stepper().history(&followed).ok()?;
        let mut impacts: Vec<Landing> = history.impacts.iter().map(Landing::from).collect();
        let is_complete = case.amplitude() < critical::eq76(case.omega(), case.eta());
        let at = asymptotic::coefficients(case.eta())?.chattering_time(case.epsilon(), case.omega());
        let stop = impacts.iter().position(|impact| is_complete && impact.time >= at);
        impacts.truncate(stop.map_or(impacts.len(), |stop| stop + 1));
        let stopped = stop.and_then(|_| impacts.last()).map(|last| last.time);
        let conclusion = match stopped.filter(|time| *time < half_period) {
            Some(time) => Conclusion::Rests(time),
            None if history.ending == Ending::AtRest && impacts.iter().all(|impact| impact.time < half_period) => {
                Conclusion::Hangs("the impacts accumulate before the time at which it would stop")
            }
            None => Conclusion::Rocks,
        };
        let response = match conclusion {
            Conclusion::Hangs(_) => None,
            _ => Some(Response::of(case, &impacts, stopped)),
        };
        impacts.retain(|impact| impact.time < half_period);
        Some(Run { impacts, conclusion, response, evaluations: None })
    }
}
