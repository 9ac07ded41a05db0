//! The whole response of a block to a sinusoid that may start at any phase and end at any time: rest until the threshold, rocking, chattering into
//! rest, rocking again in the next lobe, free rocking after the end, and overturning.
//!
//! The response is made of flights, which a [`FlightSolver`] follows one at a time: `closed-form` for Eq. 4, `taylor` for
//! Eq. 2. Chattering is closed as an infinite sum unless one of the schemes of Section 5.2 is asked for.

mod asked;
mod claims;
mod fall;
mod lobes;
mod peak;
mod rotation;
mod rounding;
mod run;
mod sample;
mod shaken;
mod tail;
mod termination;

use std::sync::Arc;

use contract::{Arrival, Body, Case, Decline, FlightSolver, Invalid, Loss, Motion, Oracle, Slenderness};

pub use super::walk::Flight;
pub use asked::Asked;
pub use lobes::{Lobe, Lobes};
pub use peak::Peak;
use rounding::Way;
pub use sample::{Sample, State, Window};
pub use shaken::Shaken;
pub use termination::Termination;

/// A motion of the ground, and how far the block is followed. All times are `τ`, from the start of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Amplitude, frequency and restitution, and the slenderness for the nonlinear model; the amplitude in multiples of the acceleration at which the
    /// block begins to rock (threshold normalisation).
    pub case: Case,
    /// By how much `ε` may be off by the rounding of what it was computed from, relative; 0 if it is given as it is.
    pub rounding: f64,
    /// The phase of the motion at `τ = 0` in radians; `None` for the threshold, growing.
    pub phase: Option<f64>,
    /// When the motion ends, `τ_ex`; `None` for never.
    pub lasts: Option<f64>,
    /// When the response ends at the latest; infinite for once nothing can happen any more.
    pub until: f64,
    /// The rotation `φ` at which the block lies on its side, `π/(2α)`, and the response ends; `None` where the slenderness is not known. There the
    /// response of a block that overturns ends where it passes its corner for good, `|φ| = 1`.
    pub lies_at: Option<f64>,
    /// How chattering is ended.
    pub termination: Termination,
    /// How many impacts are followed at the most.
    pub most_impacts: usize,
}

/// A block on ground that moves in any way, and how far it is followed. All times are `τ`, from the start of the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct OnMotion {
    /// The block.
    pub body: Body,
    /// The motion; the amplitude in multiples of the acceleration at which the block begins to rock.
    pub motion: Arc<Motion>,
    /// By how much the motion may be off by the rounding of what it was computed from, relative.
    pub rounding: f64,
    /// The rotation and the velocity at `τ = 0`, `φ` and `φ'`; from rest if both are 0.
    pub start: (f64, f64),
    /// As [`Request::until`].
    pub until: f64,
    /// As [`Request::lies_at`].
    pub lies_at: Option<f64>,
    /// How chattering is ended: exactly, or by a velocity threshold.
    pub termination: Termination,
    /// How many impacts are followed at the most.
    pub most_impacts: usize,
}

/// A whole response. Between its bouts the block rests.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// The motion of the ground.
    pub ground: Shaken,
    /// When it ends.
    pub lasts: Option<f64>,
    /// The times of rocking, in order.
    pub bouts: Vec<Bout>,
    /// The rotation at which the block lies on its side in the end, if it does.
    pub lying: Option<f64>,
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
    /// What rounding may have done to when it ends, absolute in `τ`: what a change of the parameters by a few roundings does. Infinite where it then ends in
    /// another way, or with another number of impacts: all that is said of it and of what follows is as good as a guess.
    pub conditioning: f64,
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
    /// With overturning: the block lies on its side, or where its slenderness is not known, has passed its corner for good; or it is certain to, and the
    /// response ends before.
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
        hits.map(|flight| self.lobe.start + flight.end)
    }

    /// The impacts as far as they are resolved, each with its time since the start of the motion, the interval since the last one or since the bout began, and the
    /// velocity just after it, which is `eta` times that before.
    pub fn impact_list(&self, eta: f64) -> impl Iterator<Item = (f64, f64, f64)> {
        let mut interval = 0.0;
        self.flights.iter().filter_map(move |flight| {
            interval += flight.duration;
            let Arrival::Impact { speed, .. } = flight.arrival else { return None };
            let side = -self.lobe.mirror * flight.departure.side;
            Some((self.lobe.start + flight.end, std::mem::take(&mut interval), side * eta * speed))
        })
    }

    /// How far off the time of its end may be, absolute in `τ`.
    pub fn uncertainty(&self) -> f64 {
        match self.outcome {
            BoutEnd::Complete { uncertainty } => uncertainty,
            _ => self.conditioning,
        }
    }

    /// Its end may be off by so much more.
    fn widen(&mut self, by: f64) {
        self.conditioning += by;
        if let BoutEnd::Complete { uncertainty } = &mut self.outcome {
            *uncertainty += by;
        }
    }

    /// Whether so little is known of its end that its time is not to be relied on.
    pub fn is_unsure(&self) -> bool {
        let uncertainty = self.uncertainty();
        uncertainty.is_nan() || uncertainty > f64::max(SURE * self.length(), KNOWN * self.end())
    }

    /// How long it lasts.
    fn length(&self) -> f64 {
        self.duration - self.start
    }

    /// Whether the ground did no more than touch the threshold: the block has come to rest again before anything could be seen.
    fn is_touch(&self) -> bool {
        self.outcome.is_rest() && self.length() <= TOUCH * self.end()
    }

    /// Whether it begins where another one does, as far as touches are told apart.
    fn is_beside(&self, other: &Self) -> bool {
        (self.begin() - other.begin()).abs() <= TOUCH * other.end()
    }

    /// The name of its end in reports: `unsure` where it is not known well enough to be called by its name.
    pub fn ending(&self) -> &'static str {
        if self.is_unsure() { "unsure" } else { self.outcome.name() }
    }

    /// Whether another bout goes the same way: it ends as this one does, with as many impacts; where it ends with an accumulation, about as many are resolved.
    fn is_like(&self, other: &Self) -> bool {
        let apart = self.impacts().abs_diff(other.impacts());
        let most = if self.outcome.is_rest() { ALIKE } else { 0 };
        self.outcome.name() == other.outcome.name() && apart <= most
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
        Self::and_moved(oracle, request).map(|(response, _)| response)
    }

    /// The response, and that to the request moved by some roundings, which its claims come from.
    ///
    /// # Errors
    /// As [`Response::new`].
    pub fn and_moved(oracle: &dyn Oracle, request: &Request) -> Result<(Self, Self), Decline> {
        if request.case.epsilon() <= 0.0 {
            // Below the threshold nothing ever happens.
            let end = request.lasts.unwrap_or(f64::INFINITY).min(request.until);
            let ground = Shaken::Sinusoid(Lobes::new(&request.case, request.phase));
            let response = Self { ground, lasts: request.lasts, bouts: Vec::new(), lying: None, end };
            return Ok((response.clone(), response));
        }
        let response = run::follow(request, oracle.flights(&request.case)?.as_ref());
        let (moved, _) = Self::moved(oracle, request)?;
        Ok((response.with_conditioning(&moved), moved))
    }

    /// What rounding does in all flights before a rest is what moving the parameters by about a rounding does; and what a tolerance does is what a coarser one does, and
    /// less: the response that is moved so, and its flights.
    fn moved(oracle: &dyn Oracle, request: &Request) -> Result<(Self, Box<dyn FlightSolver>), Decline> {
        let case = nudged(&request.case, request.rounding)
            .map_err(|_| Decline::Unsupported { what: "cases at the border of what is allowed" })?;
        let coarser = oracle.coarser();
        let flights = coarser.as_deref().unwrap_or(oracle).flights(&case)?;
        Ok((run::follow(&Request { case, ..*request }, flights.as_ref()), flights))
    }

    /// The response to another motion than a sinusoid, by the flights of `oracle`.
    ///
    /// # Errors
    /// When the oracle declines, because it has no flights on such a motion or can't do it.
    pub fn on_motion(oracle: &dyn Oracle, request: &OnMotion) -> Result<Self, Decline> {
        Self::and_moved_on_motion(oracle, request).map(|(response, _)| response)
    }

    /// As [`Response::and_moved`], to another motion than a sinusoid.
    ///
    /// # Errors
    /// As [`Response::on_motion`].
    pub fn and_moved_on_motion(oracle: &dyn Oracle, request: &OnMotion) -> Result<(Self, Self), Decline> {
        let response = Self::once_on_motion(oracle, request)?;
        let (moved, _) = Self::moved_on_motion(oracle, request)?;
        Ok((response.with_conditioning(&moved).with_rounding(Way::of(oracle, request)), moved))
    }

    /// The response to a motion that is stronger by some roundings, or of a coarser solver, and its flights. It is the strength alone that is moved: what two changes do may
    /// cancel.
    fn moved_on_motion(oracle: &dyn Oracle, request: &OnMotion) -> Result<(Self, Box<dyn FlightSolver>), Decline> {
        let border = |_| Decline::Unsupported { what: "motions at the border of what is allowed" };
        // A record has been divided by the threshold: some roundings of each sample.
        let motion = request.motion.scaled(1.0 + 4.0 * f64::EPSILON + request.rounding).map_err(border)?;
        let request = OnMotion { motion: Arc::new(motion), ..request.clone() };
        let coarser = oracle.coarser();
        let flights = coarser.as_deref().unwrap_or(oracle).flights_on(&request.body, &request.motion)?;
        Ok((run::follow_moved(&request, flights.as_ref()), flights))
    }

    /// The same, of which it is not said what rounding does to it.
    ///
    /// # Errors
    /// As [`Response::on_motion`].
    pub fn once_on_motion(oracle: &dyn Oracle, request: &OnMotion) -> Result<Self, Decline> {
        Ok(run::follow_motion(request, oracle.flights_on(&request.body, &request.motion)?.as_ref()))
    }

    /// Adds how far `other` is from it, which differs by rounding; once the two have parted, nothing that follows is known.
    fn with_conditioning(mut self, other: &Self) -> Self {
        let mut parted = false;
        let mut others = other.bouts.iter().peekable();
        for bout in &mut self.bouts {
            // Where the ground just touches the threshold, rounding decides whether the block moves at all: what follows is the same after such a moment of rocking
            // as without it.
            let is_touch = bout.is_touch();
            let is_between = |other: &&Bout| other.is_touch() && other.begin() < bout.begin() && !other.is_beside(bout);
            while others.next_if(is_between).is_some() {}
            let same = others.next_if(|other| !is_touch || other.is_beside(bout));
            let same = same.filter(|other| other.is_like(bout) || is_touch && other.outcome.is_rest());
            // The time itself is a double, and so is that of the lobe that it is counted from.
            let rounding = f64::EPSILON * bout.end();
            if is_touch && same.is_none() && !parted {
                bout.conditioning = bout.length() + rounding;
                continue;
            }
            parted |= same.is_none();
            let moved = same.map_or(f64::INFINITY, |other| MARGIN * (bout.duration - other.duration).abs() + rounding);
            bout.widen(if parted { f64::INFINITY } else { moved });
        }
        self
    }

    /// Adds what rounding in each flight does to when the block rests.
    fn with_rounding(mut self, way: Way) -> Self {
        for bout in &mut self.bouts {
            if matches!(bout.outcome, BoutEnd::Complete { .. }) {
                bout.widen(rounding::of_rest(bout, &self.ground, way));
            }
        }
        self
    }

    /// The largest rotation while the block rocks; `None` if it never does.
    ///
    /// # Errors
    /// When `oracle`, which the response is of, declines the case.
    pub fn peak(&self, oracle: &dyn Oracle, request: &Request) -> Result<Option<Peak>, Decline> {
        if self.bouts.is_empty() {
            return Ok(None);
        }
        let alpha = request.case.slenderness().map(|slenderness| slenderness.alpha());
        Ok(self.peak_by(oracle.flights(&request.case)?.as_ref(), alpha))
    }

    /// The largest rotation in a response to another motion than a sinusoid.
    ///
    /// # Errors
    /// When `oracle`, which the response is of, declines it.
    pub fn peak_on_motion(&self, oracle: &dyn Oracle, request: &OnMotion) -> Result<Option<Peak>, Decline> {
        Ok(self.peak_by(oracle.flights_on(&request.body, &request.motion)?.as_ref(), request.body.alpha()))
    }

    /// The acceleration of the ground at `tau`, in multiples of that at which the block begins to rock; 0 once the motion is over.
    pub fn acceleration(&self, tau: f64) -> f64 {
        if self.lasts.is_some_and(|lasts| tau > lasts) { 0.0 } else { self.ground.acceleration(tau) }
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
/// The end of a bout is known if its time is, to this share of how long it lasts.
const SURE: f64 = 1e-3;
/// Or to this share of itself: a bout may be shorter than what its end is known to.
const KNOWN: f64 = 1e-12;
/// A bout that lasts no longer than this share of the time is one of a ground that touches the threshold.
const TOUCH: f64 = 1e-6;
/// By how many impacts two bouts may differ that end with infinitely many, or with a speed.
const ALIKE: usize = 4;
/// What multiple of the change is claimed: rounding of every flight may add up to more than one change of the parameters shows.
const MARGIN: f64 = 4.0;

/// The case with its parameters moved by a few roundings each, and `ε` by its own `rounding` too.
fn nudged(case: &Case, rounding: f64) -> Result<Case, Invalid> {
    let moved = |value: f64, roundings: f64| value * (1.0 + roundings * f64::EPSILON);
    let nudged = Case::from_epsilon(
        moved(case.epsilon(), 4.0) + rounding * case.epsilon(),
        moved(case.omega(), 1.0),
        case.eta() * (1.0 - 0.5 * f64::EPSILON),
    )?;
    let Some(of) = case.slenderness() else { return Ok(nudged) };
    Ok(nudged.with_slenderness(Slenderness::new(moved(of.alpha(), -0.5), of.normalisation())?))
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
            // Flights that are shorter by far have speeds that are no numbers.
            if value.is_nan() || value < 1e-60 {
                return Err(Invalid::new(field, format!("{value:?}"), "1e-60 or more (in τ)"));
            }
        }
        let most = MOST_CYCLES * std::f64::consts::TAU / case.omega();
        if lasts.unwrap_or(until).min(until) > most {
            let (field, value) = lasts.map_or(("until", until), |lasts| ("duration", lasts));
            return Err(Invalid::new(field, format!("{value:?}"), "up to 10000 cycles of the ground motion (in τ)"));
        }
        let lies_at = case.slenderness().map(|slenderness| std::f64::consts::FRAC_PI_2 / slenderness.alpha());
        let most_impacts = Self::MOST_IMPACTS;
        Ok(Self {
            case,
            rounding: 0.0,
            phase: None,
            lasts,
            until,
            lies_at,
            termination: Termination::Exact,
            most_impacts,
        })
    }
}
