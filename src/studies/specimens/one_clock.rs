use contract::{Case, Ending, Horizon, Invalid, Limit, Loss};
use ode::{Equation, Flights, Ode, Restart, Solver};

use super::{Conclusion, ENDLESS, Landing, Response, Run, Specimen, half_period};

/// diffsol (Tsit45) on one clock, with the rotation as its event and Eq. 13 at each root, as in the bouncing ball of its own examples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneClock {
    /// What it is given to start a flight.
    pub restart: Restart,
    /// The relative tolerance, which is also the absolute one.
    pub rtol: f64,
}

/// That solver.
///
/// # Errors
/// When the tolerance is not inside [1e-13, 1e-2].
pub fn solver_on_one_clock(restart: Restart, rtol: f64) -> Result<Ode, Invalid> {
    Ok(Ode::new(Equation::Linear, Solver::Tsit45).with_rtol(rtol)?.with_flights(Flights::Naive).with_restart(restart))
}

impl Specimen for OneClock {
    fn family(&self) -> &'static str {
        match self.restart {
            Restart::Zero => "one clock, state zero",
            Restart::Lifted(_) => "one clock, state lifted",
            Restart::OldStep => "one clock, old step kept",
        }
    }

    fn setting(&self) -> String {
        format!("rtol {:e}", self.rtol)
    }

    fn run(&self, case: &Case) -> Option<Run> {
        let half_period = half_period(case);
        let end = 2.0 * half_period;
        let followed = case.with_max_impacts(ENDLESS).ok()?.with_horizon(Horizon::Until(end)).ok()?;
        let counted = solver_on_one_clock(self.restart, self.rtol).ok()?.counted(&followed).ok()?;
        let mut impacts: Vec<Landing> = counted.history.impacts.iter().map(Landing::from).collect();
        let reached_the_end = counted.history.ending == Ending::LimitReached(Limit::Time);
        let response = reached_the_end.then(|| Response::of(case, &impacts, None));
        let is_past = impacts.iter().any(|impact| impact.time >= half_period);
        let conclusion = match counted.history.ending {
            _ if is_past || reached_the_end => Conclusion::Rocks,
            // What the solver does not notice, and a check of the sign after each step does.
            Ending::Lost(Loss::FellThrough) => Conclusion::Astray("falls through the base without an event"),
            Ending::Lost(Loss::NotFinite) => Conclusion::Astray("the velocity at an impact has the wrong sign"),
            Ending::Lost(Loss::Stalled) => Conclusion::Hangs("time stands still"),
            Ending::Lost(Loss::SolverFailed) => Conclusion::GaveUp("the solver gives up".into()),
            Ending::AtRest | Ending::LimitReached(_) => Conclusion::Hangs("impacts without end"),
            Ending::NeverRocks | Ending::Incomplete | Ending::Overturned => return None,
        };
        impacts.retain(|impact| impact.time < half_period);
        Some(Run { impacts, conclusion, response, evaluations: Some(counted.evaluations) })
    }
}
