//! The whole response of a block to a sinusoid that may start at any phase and end at any time: rest until the threshold, rocking, chattering into
//! rest, rocking again in the next lobe, free rocking after the end, and overturning.
//!
//! The response is made of flights, which a [`FlightSolver`](contract::FlightSolver) follows one at a time: `closed-form` for Eq. 4, `taylor` for
//! Eq. 2. Chattering is closed as an infinite sum unless one of the schemes of Section 5.2 is asked for.

mod lobes;
mod run;
mod sample;
mod termination;

use std::sync::Arc;

use contract::{Arrival, Case, Decline, Departure, Invalid, Loss, Oracle};

pub use lobes::{Lobe, Lobes};
pub use sample::{Sample, State, Window};
pub use termination::{Condition, Termination};

/// A motion of the ground, and how far the block is followed. All times are `τ`, from the start of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Amplitude, frequency and restitution, and the slenderness for the nonlinear model; the amplitude in multiples of the acceleration at which the
    /// block begins to rock (threshold normalisation).
    pub case: Case,
    /// The phase of the motion at `τ = 0` in radians; `None` for the threshold, growing.
    pub phase: Option<f64>,
    /// When the motion ends, `τ_ex`; `None` for never.
    pub lasts: Option<f64>,
    /// When the response ends at the latest; infinite for once nothing can happen any more.
    pub until: f64,
    /// How chattering is ended.
    pub termination: Termination,
    /// How many impacts are followed at the most.
    pub most_impacts: usize,
}

/// A whole response. Between its bouts the block rests.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// The excitation.
    pub lobes: Lobes,
    /// When it ends.
    pub lasts: Option<f64>,
    /// The times of rocking, in order.
    pub bouts: Vec<Bout>,
    /// When the response ends.
    pub end: f64,
}

/// Rocking from rest to rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Bout {
    /// The lobe of the excitation that set it off. Times in a bout are counted from the start of the lobe, and signs are those of a lobe to the positive
    /// side.
    pub lobe: Lobe,
    /// When it starts: 0 unless the ground acceleration was above the threshold already.
    pub start: f64,
    /// When it ends.
    pub duration: f64,
    /// The flights in order.
    pub flights: Arc<Vec<Flight>>,
    /// Why it ends.
    pub outcome: BoutEnd,
}

/// One flight of a bout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// When it starts.
    pub start: f64,
    /// How long it lasts.
    pub duration: f64,
    /// How it starts.
    pub departure: Departure,
    /// How it ends; in the air where the ground comes to rest, or the response ends.
    pub arrival: Arrival,
}

/// Why a bout ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BoutEnd {
    /// With rest, where infinitely many impacts accumulate; with the error that is expected of when.
    Complete {
        /// Absolute, in `τ`.
        uncertainty: f64,
    },
    /// With rest, by the velocity threshold.
    VelocityThreshold,
    /// With rest, by the chattering threshold.
    ChatteringThreshold,
    /// With overturning.
    Overturned,
    /// With the end of the response, while it rocks.
    Cut,
    /// With the limit of impacts.
    TooManyImpacts,
    /// With the loss of the sequence.
    Lost(Loss),
}

impl BoutEnd {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Complete { .. } => "complete",
            Self::VelocityThreshold => "velocity-threshold",
            Self::ChatteringThreshold => "chattering-threshold",
            Self::Overturned => "overturned",
            Self::Cut => "rocking",
            Self::TooManyImpacts => "too-many-impacts",
            Self::Lost(_) => "lost",
        }
    }

    /// Whether the block then rests.
    pub fn is_rest(self) -> bool {
        matches!(self, Self::Complete { .. } | Self::VelocityThreshold | Self::ChatteringThreshold)
    }
}

impl Bout {
    /// When it begins, since the start of the motion.
    pub fn begin(&self) -> f64 {
        self.lobe.start + self.start
    }

    /// When it ends, since the start of the motion.
    pub fn end(&self) -> f64 {
        self.lobe.start + self.duration
    }

    /// When the block hits its base, as far as the impacts are resolved, since the start of the motion.
    pub fn impact_times(&self) -> impl Iterator<Item = f64> {
        let hits = self.flights.iter().filter(|flight| matches!(flight.arrival, Arrival::Impact { .. }));
        hits.map(|flight| self.lobe.start + (flight.start + flight.duration))
    }

    /// How many impacts are resolved.
    pub fn impacts(&self) -> usize {
        self.impact_times().count()
    }
}

impl Response {
    /// The response, by the flights of `oracle`.
    ///
    /// # Errors
    /// When the oracle declines, because it has no flights or can't do the case.
    pub fn new(oracle: &dyn Oracle, request: &Request) -> Result<Self, Decline> {
        if request.case.epsilon() <= 0.0 {
            // Below the threshold nothing ever happens.
            let end = if request.until.is_finite() { request.until } else { request.lasts.unwrap_or(0.0) };
            let lobes = Lobes::new(&request.case, request.phase);
            return Ok(Self { lobes, lasts: request.lasts, bouts: Vec::new(), end });
        }
        let response = run::follow(request, oracle.flights(&request.case)?.as_ref());
        // What rounding does in all flights before a rest is what moving the parameters by about a rounding does.
        let case = nudged(&request.case)
            .map_err(|_| Decline::Unsupported { what: "cases at the border of what is allowed" })?;
        let other = run::follow(&Request { case, ..*request }, oracle.flights(&case)?.as_ref());
        Ok(response.with_conditioning(&other))
    }

    /// Adds to the uncertainty of each rest how far `other`, which differs by rounding, is from it.
    fn with_conditioning(mut self, other: &Self) -> Self {
        for (k, bout) in self.bouts.iter_mut().enumerate() {
            if let BoutEnd::Complete { uncertainty } = &mut bout.outcome {
                let same = other.bouts.get(k).filter(|other| matches!(other.outcome, BoutEnd::Complete { .. }));
                *uncertainty += same.map_or(f64::INFINITY, |other| MARGIN * (bout.duration - other.duration).abs());
            }
        }
        self
    }

    /// The times of rest, each from and to.
    pub fn rests(&self) -> Vec<(f64, f64)> {
        let begins = self.bouts.iter().map(Bout::begin).chain([self.end]);
        let ends = [0.0]
            .into_iter()
            .chain(self.bouts.iter().map(|bout| if bout.outcome.is_rest() { bout.end() } else { self.end }));
        ends.zip(begins).filter(|(from, to)| to > from).collect()
    }
}

/// No motion is followed for longer.
const MOST_CYCLES: f64 = 1e4;
/// What multiple of the change is claimed: rounding of every flight may add up to more than one change of the parameters shows.
const MARGIN: f64 = 4.0;

/// The case with its parameters moved by a few roundings each.
fn nudged(case: &Case) -> Result<Case, Invalid> {
    let moved = |value: f64, roundings: f64| value * (1.0 + roundings * f64::EPSILON);
    let nudged = Case::from_epsilon(
        moved(case.epsilon(), 4.0),
        moved(case.omega(), 1.0),
        case.eta() * (1.0 - 0.5 * f64::EPSILON),
    )?;
    Ok(case.slenderness().map_or(nudged, |slenderness| nudged.with_slenderness(slenderness)))
}

impl Request {
    /// How many impacts are followed unless told otherwise; repetitions of a half period are not counted.
    pub const MOST_IMPACTS: usize = 1_000_000;

    /// The response to a case as it stands: a motion that starts at the threshold and lasts `lasts`.
    ///
    /// # Errors
    /// When a time is not above 0.
    pub fn new(case: Case, lasts: Option<f64>, until: f64) -> Result<Self, Invalid> {
        for (field, value) in [("duration", lasts.unwrap_or(1.0)), ("until", until)] {
            if value.is_nan() || value <= 0.0 {
                return Err(Invalid::new(field, format!("{value:?}"), "above 0 (in τ)"));
            }
        }
        let most = MOST_CYCLES * std::f64::consts::TAU / case.omega();
        if lasts.unwrap_or(until).min(until) > most {
            let (field, value) = lasts.map_or(("until", until), |lasts| ("duration", lasts));
            return Err(Invalid::new(field, format!("{value:?}"), "up to 10000 cycles of the ground motion (in τ)"));
        }
        Ok(Self { case, phase: None, lasts, until, termination: Termination::Exact, most_impacts: Self::MOST_IMPACTS })
    }
}
