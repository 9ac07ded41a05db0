//! A sequence followed by one method and closed by another, from one of its impacts.

use std::sync::Arc;

use contract::{
    Arrival, Body, Case, Closure, Decline, Departure, Ending, Estimate, FlightSolver, Ground, History, Model, Motion,
    Oracle,
};

use crate::measure::closing::{chattering_time, of_case};

/// The impacts of a stepper, and the chattering time that the closing of another method gives from one of them.
pub struct Closed {
    name: String,
    stepper: Box<dyn Oracle>,
    closing: Arc<dyn Oracle>,
}

impl Closed {
    /// The impacts of `stepper`, closed by `closing`, under a name.
    pub fn new(name: String, stepper: Box<dyn Oracle>, closing: Box<dyn Oracle>) -> Self {
        Self { name, stepper, closing: closing.into() }
    }

    /// The chattering time from the impact that tells it best, of those from the first that it is closed from.
    fn chattering_time(&self, case: &Case, history: &History) -> Result<Estimate, Decline> {
        let closure = of_case(self.closing.as_ref(), case, self.model())?;
        let mut best: Option<Estimate> = None;
        let mut why = Decline::NotConvergent { why: "no impact is listed that it could be closed from".to_owned() };
        for impact in &history.impacts {
            match chattering_time(closure.as_ref(), impact, case.eta()) {
                Err(declined) if best.is_none() => why = declined,
                Err(_) => {}
                Ok(found) if best.is_some_and(|best| found.uncertainty >= BETTER * best.uncertainty) => break,
                Ok(found) => best = Some(found),
            }
        }
        best.ok_or(why)
    }
}

/// A sum from a later impact is waited for while it is better by this factor from one to the next.
const BETTER: f64 = 0.9;

impl Oracle for Closed {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        self.stepper.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let history = self.stepper.history(case)?;
        if history.ending != Ending::AtRest {
            return Ok(history);
        }
        let chattering_time = Some(self.chattering_time(case, &history)?);
        Ok(History { chattering_time, ..history })
    }

    fn coarser(&self) -> Option<Box<dyn Oracle>> {
        let stepper = self.stepper.coarser()?;
        Some(Box::new(Self { name: self.name.clone(), stepper, closing: Arc::clone(&self.closing) }))
    }

    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        let closure = of_case(self.closing.as_ref(), case, self.model())?;
        Ok(Box::new(Flights { solver: self.stepper.flights(case)?, closure }))
    }

    fn flights_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        let closure = self.closing.closure_on(body, motion)?;
        Ok(Box::new(Flights { solver: self.stepper.flights_on(body, motion)?, closure }))
    }
}

/// The flights of one method, and what is left of them by another.
struct Flights {
    solver: Box<dyn FlightSolver>,
    closure: Box<dyn Closure>,
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        self.solver.fly(departure, horizon)
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        self.solver.motion(departure, s)
    }

    fn rests(&self, departure: &Departure) -> bool {
        match departure.ground {
            Ground::Shaking => self.closure.time_left(departure).is_ok(),
            Ground::Still => self.solver.rests(departure),
        }
    }

    fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
        // Free rocking that is too fast for the series is summed impact by impact.
        self.closure.time_left(departure).ok().or_else(|| self.solver.time_to_rest(departure))
    }
}
