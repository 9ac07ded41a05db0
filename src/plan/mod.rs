//! No more model than a scene needs: the cheapest method that meets what is asked, and why.
//!
//! Each candidate's error is predicted from the numbers of the case alone ([`estimate`]), in four parts: the model, the truncation, the discretisation and the
//! conditioning. The cheapest whose parts add up to no more than the tolerance is run; its answer carries an error estimate made after the fact, and
//! where that is worse than asked the next one runs.

pub mod estimate;
pub mod evidence;
mod on_motion;
mod refusal;
mod run;
mod scene;
mod stepping;
mod way;

use contract::Case;

use crate::motion::response::Request;

pub use estimate::{Errors, Place};
pub use on_motion::{Compared, Followed, MotionPlan, Parted};
pub use refusal::Refusal;
pub use run::{Answer, Attempt, Conclusion};
pub use stepping::{Found, step};
pub use way::Way;

/// A question about the chattering time of one case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// The case, its amplitude over the threshold of its own model; with the slenderness if the answer is to be that of Eq. 2.
    pub case: Case,
    /// How accurately, relative.
    pub tolerance: f64,
    /// By how much `ε` is off by the rounding of what it was computed from, relative; 0 if it is given as it is.
    pub rounding: f64,
    /// The motion, unless it is that of a case: one that starts at the threshold and lasts for half a period at least.
    pub request: Option<Request>,
    /// The same motion where it is that of a case: what happens after half a period if the chattering is incomplete. A question about a case alone has none.
    pub afterwards: Option<Request>,
    /// How near it is to the critical amplitude; `None` outside of the range in which errors are predicted.
    pub place: Option<Place>,
}

impl Question {
    /// A question about a case as it stands.
    pub fn new(case: Case, tolerance: f64) -> Self {
        Self { case, tolerance, rounding: 0.0, request: None, afterwards: None, place: Place::of(&case) }
    }

    /// The tolerance of a question that names none.
    pub const DEFAULT_TOLERANCE: f64 = 1e-6;

    /// Whether errors of a chattering time are predicted: not outside of the range in which they were measured, and not where there is none. What is asked
    /// there has to say itself how far it is off.
    pub fn is_predicted(&self) -> bool {
        self.place.is_some_and(|place| place.share <= 1.0)
    }

    /// The slenderness, 0 for the linear model.
    pub fn alpha(&self) -> f64 {
        self.case.slenderness().map_or(0.0, |slenderness| slenderness.alpha())
    }
}

/// A candidate, and what becomes of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The method.
    pub method: Way,
    /// The predicted error, or why there is none.
    pub errors: Result<Errors, Refusal>,
    /// The predicted cost in microseconds; only ratios mean anything.
    pub cost: f64,
}

impl Candidate {
    /// Whether the predicted error is no more than the tolerance.
    pub fn meets(&self, tolerance: f64) -> bool {
        self.errors.as_ref().is_ok_and(|errors| errors.total() <= tolerance)
    }
}

/// Every candidate, the cheapest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What is asked.
    pub question: Question,
    /// The candidates.
    pub candidates: Vec<Candidate>,
}

impl Plan {
    /// The plan for a question.
    pub fn new(question: Question) -> Self {
        let mut candidates: Vec<Candidate> = way::ALL
            .into_iter()
            .map(|method| Candidate { method, errors: method.predict(&question), cost: method.cost(&question) })
            .collect();
        candidates.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        Self { question, candidates }
    }

    /// The candidate that is chosen: the cheapest that is predicted to meet the tolerance, or if none is, the one with the smallest error.
    pub fn chosen(&self) -> Option<&Candidate> {
        let able = || self.candidates.iter().filter(|candidate| candidate.errors.is_ok());
        let total = |candidate: &Candidate| candidate.errors.as_ref().map_or(f64::INFINITY, Errors::total);
        let meets = able().find(|candidate| candidate.meets(self.question.tolerance));
        meets.or_else(|| able().min_by(|one, other| total(one).total_cmp(&total(other))))
    }

    /// Runs the chosen candidate, and the ones after it as long as the answer is worse than asked.
    pub fn answer(&self) -> Answer {
        run::answer(self)
    }
}
