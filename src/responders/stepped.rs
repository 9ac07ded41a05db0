//! Whole responses by the flights of one oracle each: [`motion::response`](crate::motion::response).

use std::sync::Arc;

use contract::{Arrival, Body, Case, Decline, FlightSolver, Model, Motion, Normalisation, Oracle, Slenderness};

use crate::{
    cases::shaking::{AnyMotion, Question, Shaking},
    gate::responses::{Bout, BoutEnding, Impact, Responder, Row, State, Whole},
    motion::response::{self, BoutEnd, OnMotion, Request, Response, Termination, Window},
    panel::{self, Follows, Settings},
};

/// So slender a block obeys Eq. 4 to twelve digits: this is how a method for Eq. 2 is held against those for Eq. 4.
const SLENDER: f64 = 1e-6;

/// Whole responses by the flights of one oracle.
pub struct Stepped {
    /// The oracle.
    pub oracle: Box<dyn Oracle>,
    /// The name in reports.
    pub name: String,
    /// The equation of motion that it is held against.
    pub model: Model,
    /// See [`Responder::accuracy`].
    pub accuracy: f64,
    /// Whether its table is looked at as well, and how high it rocks.
    pub table: bool,
    /// Whether it is asked for wavelets.
    pub wavelets: bool,
}

/// Every method that follows whole responses flight by flight, as the panel says.
pub fn all() -> Vec<Stepped> {
    let of = |follows: &Follows| {
        let Follows { oracle: name, model, accuracy, table, wavelets } = *follows;
        let oracle = panel::one(name, &Settings::default(), "linear").ok()?;
        let slender = model != oracle.model();
        let name = if slender { format!("{name}/slender") } else { name.to_owned() };
        Some(Stepped { oracle, name, model, accuracy, table, wavelets })
    };
    panel::methods().flat_map(|method| method.responses).filter_map(of).collect()
}

impl Stepped {
    /// Whether a method for Eq. 2 is held against those for Eq. 4.
    fn is_slender(&self) -> bool {
        self.model == Model::Linear && self.oracle.model() == Model::Nonlinear
    }

    /// The case as the oracle is asked it.
    fn case(&self, shaking: &Shaking) -> Option<Case> {
        if !self.is_slender() {
            return Some(shaking.case);
        }
        Some(shaking.case.with_slenderness(Slenderness::new(SLENDER, Normalisation::Threshold).ok()?))
    }

    fn whole(&self, request: &Request, rows: usize) -> Result<Whole, Decline> {
        let oracle = self.oracle.as_ref();
        let response = Response::new(oracle, request)?;
        let solver = if response.bouts.is_empty() { None } else { Some(oracle.flights(&request.case)?) };
        let bouts = response.bouts.iter().map(|of| bout(of, solver.as_deref().filter(|_| self.table))).collect();
        let rows = if self.table && response.end > 0.0 {
            let window = Window { from: 0.0, to: response.end, steps: rows };
            response.samples(oracle, request, &window)?.iter().map(row).collect()
        } else {
            Vec::new()
        };
        Ok(Whole { bouts, rests: response.rests(), end: response.end, told_until: None, rows })
    }

    fn whole_on_motion(&self, asked: &AnyMotion, rows: usize) -> Result<Whole, Decline> {
        let oracle = self.oracle.as_ref();
        // Without a slenderness a method for Eq. 2 follows Eq. 4.
        let alpha = asked.body.alpha().filter(|_| self.model == Model::Nonlinear);
        let body = Body::new(asked.body.eta(), alpha).unwrap_or(asked.body);
        let request = OnMotion {
            body,
            motion: Arc::clone(&asked.motion),
            rounding: 0.0,
            start: asked.start,
            until: asked.until,
            lies_at: asked.body.alpha().map(|alpha| std::f64::consts::FRAC_PI_2 / alpha),
            termination: Termination::Exact,
            most_impacts: Request::MOST_IMPACTS,
        };
        let response = Response::on_motion(oracle, &request)?;
        let bouts = response.bouts.iter().map(|of| bout(of, None)).collect();
        let rows = if self.table && response.end > 0.0 {
            let window = Window { from: 0.0, to: response.end, steps: rows };
            response.samples_on_motion(oracle, &request, &window)?.iter().map(row).collect()
        } else {
            Vec::new()
        };
        Ok(Whole { bouts, rests: response.rests(), end: response.end, told_until: None, rows })
    }
}

impl Responder for Stepped {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        self.model
    }

    fn accuracy(&self) -> f64 {
        self.accuracy
    }

    fn is_asked(&self, question: &Question) -> bool {
        match question {
            Question::Sinusoid(_) => true,
            Question::Motion(asked) => self.wavelets || !matches!(*asked.motion, Motion::Ricker(_)),
        }
    }

    fn respond(&self, question: &Question, rows: usize) -> Option<Whole> {
        match question {
            Question::Sinusoid(shaking) => {
                let Shaking { phase, lasts, until, .. } = *shaking;
                let asked = Request::new(shaking.case, lasts, until).ok()?;
                self.whole(&Request { phase, case: self.case(shaking)?, ..asked }, rows).ok()
            }
            Question::Motion(asked) => self.whole_on_motion(asked, rows).ok(),
        }
    }
}

fn bout(bout: &response::Bout, solver: Option<&dyn FlightSolver>) -> Bout {
    let flights = bout.flights.iter();
    let after = |n: usize| bout.flights.get(n + 1).map(|flight| flight.departure.velocity);
    let impacts = flights.enumerate().filter_map(|(n, flight)| match flight.arrival {
        Arrival::Impact { speed, .. } => {
            Some(Impact { time: bout.lobe.start + flight.end, before: speed, after: after(n) })
        }
        _ => None,
    });
    let (outcome, uncertainty) = match bout.outcome {
        BoutEnd::Complete { uncertainty } => (BoutEnding::Rest, uncertainty),
        BoutEnd::VelocityThreshold | BoutEnd::ChatteringThreshold => (BoutEnding::Rest, 0.0),
        BoutEnd::Overturned => (BoutEnding::Overturned, 0.0),
        BoutEnd::Cut => (BoutEnding::Cut, 0.0),
        BoutEnd::TooManyImpacts | BoutEnd::Lost(_) => (BoutEnding::GivenUp, 0.0),
    };
    Bout {
        begin: bout.begin(),
        side: bout.lobe.mirror * bout.flights.first().map_or(-1.0, |flight| flight.departure.side),
        impacts: impacts.collect(),
        outcome,
        end: bout.end(),
        uncertainty,
        peak: solver.map(|solver| peak(&bout.flights, solver)),
    }
}

/// Into how many parts a flight is divided to see where about it is highest.
const PARTS: u32 = 16;
/// By how much the estimated height of a flight may be below the largest estimate for it to be looked at.
const LOWER: f64 = 0.03;

/// The largest rotation of all flights that end with an impact, those that go on from another in the air with it.
fn peak(flights: &[response::Flight], solver: &dyn FlightSolver) -> f64 {
    let last = flights.iter().rposition(|flight| matches!(flight.arrival, Arrival::Impact { .. }));
    let landed = flights.get(..last.map_or(0, |last| last + 1)).unwrap_or_default();
    let highest_estimate = landed.iter().map(estimate).fold(0.0, f64::max);
    let (mut highest, mut of_flight) = (0.0_f64, 0.0_f64);
    for flight in landed {
        let in_pieces = matches!(flight.arrival, Arrival::Aloft { .. });
        if in_pieces || estimate(flight) >= LOWER * highest_estimate {
            of_flight = of_flight.max(peak_of(flight, solver));
        }
        if matches!(flight.arrival, Arrival::Impact { .. }) {
            highest = highest.max(of_flight);
            of_flight = 0.0;
        }
    }
    highest
}

/// The height of a flight if it were a parabola with the larger speed of its ends, on top of what it starts from.
fn estimate(flight: &response::Flight) -> f64 {
    let speed = match flight.arrival {
        Arrival::Impact { speed, .. } => speed,
        Arrival::Aloft { .. } | Arrival::Overturned { .. } | Arrival::Lost(_) => 0.0,
    };
    flight.departure.rotation + 0.25 * flight.duration * speed.max(flight.departure.velocity.abs())
}

fn peak_of(flight: &response::Flight, solver: &dyn FlightSolver) -> f64 {
    let at = |s: f64| solver.motion(&flight.departure, s);
    let part = flight.duration / f64::from(PARTS);
    let heights = (0..=PARTS).map(|k| (f64::from(k) * part, at(f64::from(k) * part).0));
    let (place, height) = heights.fold((0.0, 0.0), |best, new| if new.1 > best.1 { new } else { best });
    let (mut rising, mut falling) = ((place - part).max(0.0), (place + part).min(flight.duration));
    for _ in 0..24 {
        let middle = 0.5 * (rising + falling);
        if at(middle).1 > 0.0 { rising = middle } else { falling = middle }
    }
    height.max(at(rising).0)
}

fn row(sample: &response::Sample) -> Row {
    Row {
        time: sample.tau,
        rotation: sample.phi,
        velocity: sample.phi_velocity,
        ground: sample.ground_acceleration,
        state: match sample.state {
            response::State::Rest => State::Rest,
            response::State::Rocking => State::Rocking,
            response::State::Overturned => State::Overturned,
            response::State::Lying => State::Lying,
        },
    }
}
