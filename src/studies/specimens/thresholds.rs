use contract::{Case, Ending, Horizon};

use super::{Conclusion, ENDLESS, Landing, Response, Run, Specimen, half_period};
use crate::{measure::excitation::Excitation, panel};

/// When the block is put to rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Once the velocity after an impact is at the threshold or below: the VelTol of Fig. 8b.
    Velocity,
    /// Once one interval is shorter than the threshold.
    Interval,
    /// Once two intervals in a row are: one flight of either sign.
    TwoIntervals,
}

/// Event stepping with exact flights, and a threshold below which the block is put to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold {
    /// What is compared.
    pub rule: Rule,
    /// With what: a velocity `φ'` or an interval in `τ`.
    pub value: f64,
}

impl Threshold {
    /// Whether the block is put to rest at the last of these impacts. It can't be where the excitation exceeds what it resists.
    fn stops(&self, case: &Case, impacts: &[Landing]) -> bool {
        let short = |landing: &Landing| landing.interval < self.value;
        let is_below = match (self.rule, impacts) {
            (Rule::Velocity, [.., last]) => last.velocity.abs() <= self.value,
            (Rule::Interval, [.., last]) => short(last),
            (Rule::TwoIntervals, [.., before, last]) => short(before) && short(last),
            _ => false,
        };
        is_below && impacts.last().is_some_and(|last| can_rest(case, last.time))
    }

    /// The first impact at which it stops, if any.
    fn stop(&self, case: &Case, impacts: &[Landing]) -> Option<usize> {
        (1..=impacts.len()).find(|n| impacts.get(..*n).is_some_and(|list| self.stops(case, list)))
    }
}

/// Whether the excitation at `time` is below the threshold of Eq. 1.
fn can_rest(case: &Case, time: f64) -> bool {
    Excitation::new(case).at(time).abs() < 1.0
}

impl Specimen for Threshold {
    fn family(&self) -> &'static str {
        match self.rule {
            Rule::Velocity => "velocity threshold",
            Rule::Interval => "interval threshold",
            Rule::TwoIntervals => "threshold of two intervals",
        }
    }

    fn setting(&self) -> String {
        format!("{:e}", self.value)
    }

    fn run(&self, case: &Case) -> Option<Run> {
        let half_period = half_period(case);
        let followed = case.with_max_impacts(ENDLESS).ok()?.with_horizon(Horizon::Until(2.0 * half_period)).ok()?;
        let history = panel::stepper().history(&followed).ok()?;
        if history.ending == Ending::NeverRocks {
            return None;
        }
        let mut impacts: Vec<Landing> = history.impacts.iter().map(Landing::from).collect();
        let stop = self.stop(case, &impacts);
        impacts.truncate(stop.unwrap_or(impacts.len()));
        let stopped = stop.and_then(|_| impacts.last()).map(|last| last.time);
        let response = Some(Response::of(case, &impacts, stopped));
        let conclusion = stopped.filter(|time| *time < half_period).map_or(Conclusion::Rocks, Conclusion::Rests);
        impacts.retain(|impact| impact.time < half_period);
        Some(Run { impacts, conclusion, response, evaluations: None })
    }
}
