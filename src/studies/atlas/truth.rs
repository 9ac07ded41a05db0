//! What the methods are measured against.

use contract::{Case, Decline, Ending, History, Horizon, Model};

use crate::{
    measure::critical,
    studies::specimens::{Landing, Response, half_period},
};

/// Everything that is known of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// The case, listing its impacts to [`SHORTEST`].
    pub case: Case,
    /// The impacts before `T/2`, to doubles.
    pub impacts: Vec<Landing>,
    /// `τ_ch`, where the chattering is complete.
    pub chattering_time: Option<f64>,
    /// The rotation in the half period after `T/2`.
    pub response: Response,
}

/// Down to which interval sequences are judged, about.
const SHORTEST: f64 = 1e-30;

impl Truth {
    /// Of the case at `to_go = (a_cr - a)/(a_cr - 1)`.
    ///
    /// # Errors
    /// When the case is out of range or, next to the critical amplitude, undecided.
    pub fn at(omega: f64, eta: f64, to_go: f64) -> Result<Self, Decline> {
        let invalid = |why: contract::Invalid| Decline::NotConvergent { why: why.to_string() };
        let critical = critical::interpolated(omega, eta).map_err(invalid)?;
        let depth = (SHORTEST.ln() / eta.ln()).ceil() as usize;
        let case = Case::from_epsilon((1.0 - to_go) * critical, omega, eta)
            .and_then(|case| case.with_max_impacts(depth))
            .map_err(invalid)?;
        Self::of(case)
    }

    fn of(case: Case) -> Result<Self, Decline> {
        let judge = enclosure::Enclosure::new(Model::Linear);
        let listed = |case: &Case| -> Result<(Vec<Landing>, History), Decline> {
            let history = judge.enclose(case)?.history();
            Ok((history.impacts.iter().map(Landing::from).collect(), history))
        };
        let (impacts, history) = listed(&case)?;
        let chattering_time = history.chattering_time.map(|time| time.value);
        let response = if chattering_time.is_some() {
            Response::of(&case, &impacts, chattering_time)
        } else {
            let invalid = |why: contract::Invalid| Decline::NotConvergent { why: why.to_string() };
            let end = 2.0 * half_period(&case);
            let (all, history) = listed(&case.with_horizon(Horizon::Until(end)).map_err(invalid)?)?;
            // It may come to rest in the second half period; that is as good as its last impact.
            let last = all.last().map(|last| last.time).filter(|_| history.ending == Ending::AtRest);
            Response::of(&case, &all, last)
        };
        Ok(Self { case, impacts, chattering_time, response })
    }

    /// How many of `impacts` are resolved: the intervals of all up to them are within 1 %.
    pub fn resolved(&self, impacts: &[Landing]) -> usize {
        let pairs = impacts.iter().zip(&self.impacts);
        pairs.take_while(|(found, exact)| (found.interval / exact.interval - 1.0).abs() < RESOLVED).count()
    }
}

/// How far off an interval may be that counts as resolved, relative.
const RESOLVED: f64 = 0.01;
