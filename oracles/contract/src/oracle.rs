use alloc::{boxed::Box, string::String, vec::Vec};
use core::fmt;

use crate::{
    Body, Bout, Case, Closure, FlightSolver, Followed, History, Motion, Sensitivity, SlendernessShift,
    conformance::Times,
};

/// One method that turns a case into an impact history.
///
/// An oracle never depends on another oracle, and a test of the harness enforces it.
pub trait Oracle: Send + Sync {
    /// The name that reports use, unique in a panel: the method, then what distinguishes it, as in `ode/nonlinear/tsit45`.
    fn name(&self) -> &str;

    /// The equation of motion that the oracle solves or approximates.
    fn model(&self) -> Model;

    /// The history of a case.
    ///
    /// # Errors
    /// A [`Decline`] when the oracle cannot do this case. Losing the sequence half-way is not a decline but
    /// [`Ending::Lost`](crate::Ending::Lost).
    fn history(&self, case: &Case) -> Result<History, Decline>;

    /// How it gets its times: whether they are held to be the sums of its intervals, as those of a method of this house are.
    fn times(&self) -> Times {
        Times::AreSums
    }

    /// Told which cases are asked next, before they are. An oracle that answers many at once faster than one by one does that here and remembers
    /// the answers; what it remembered before it may forget. The others have nothing to do.
    fn prepare(&self, _cases: &[Case]) {}

    /// How the impacts of that history answer to small changes of the parameters, impact by impact; `None` from an oracle that does not
    /// know, or declines the case.
    fn sensitivities(&self, _case: &Case) -> Option<Vec<Sensitivity>> {
        None
    }

    /// How the impacts of that history, of the linear model, move when the block is less slender than the model has it, impact by impact;
    /// `None` from an oracle that does not know, or declines the case. The slenderness of the case is not looked at.
    fn slenderness_shifts(&self, _case: &Case) -> Option<Vec<SlendernessShift>> {
        None
    }

    /// The same method with a coarser tolerance: what that changes tells what the tolerance does to its flights. `None` from a method that has none.
    fn coarser(&self) -> Option<Box<dyn Oracle>> {
        None
    }

    /// A solver for single flights of this block under this motion of the ground, from anywhere.
    ///
    /// # Errors
    /// A [`Decline`] from a method that only follows whole histories, or cannot do the case. A case at or below the threshold is declined too: from
    /// rest its block never flies.
    fn flights(&self, _case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        Err(Decline::Unsupported { what: "single flights" })
    }

    /// A solver for single flights of a block on ground that moves in any way. The times of its departures are counted from the start of the motion, and the
    /// ground of them is [`Ground::Shaking`](crate::Ground::Shaking) until the motion ends.
    ///
    /// # Errors
    /// A [`Decline`] from a method that only does the sinusoid of a case, or cannot do this motion.
    fn flights_on(&self, _body: &Body, _motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        Err(Decline::Unsupported { what: "motions of the ground that are no case" })
    }

    /// What closes a sequence of this block on ground that moves so, from any one impact.
    ///
    /// # Errors
    /// A [`Decline`] from a method that follows the impacts instead, or cannot do this motion.
    fn closure_on(&self, _body: &Body, _motion: &Motion) -> Result<Box<dyn Closure>, Decline> {
        Err(Decline::Unsupported { what: "closing a sequence from one impact" })
    }

    /// The bouts of a block on ground that moves in any way, from a method that follows whole responses by itself: one that hands over more from flight to flight
    /// than a departure holds.
    ///
    /// # Errors
    /// A [`Decline`] from a method that only follows flights or cases, or cannot do this motion.
    fn bouts_on(&self, _body: &Body, _motion: &Motion, _asked: &Followed) -> Result<Vec<Bout>, Decline> {
        Err(Decline::Unsupported { what: "whole responses" })
    }
}

/// The equation of motion between impacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Model {
    /// The slender block, Eq. 4. It ignores the slenderness of a case.
    Linear,
    /// The block as it is, Eq. 2. It needs the slenderness of a case.
    Nonlinear,
}

/// Why an oracle refuses a case.
#[derive(Debug, Clone, PartialEq)]
pub enum Decline {
    /// The model needs a slenderness, and the case has none.
    NeedsSlenderness,
    /// A quantity of the case is outside of what the method can do.
    OutOfRange {
        /// The quantity, in the words of the command line.
        field: &'static str,
        /// What it is.
        value: f64,
        /// What the method can do.
        allowed: &'static str,
    },
    /// The method has no answer that it would stand by.
    NotConvergent {
        /// Why not, with the numbers.
        why: String,
    },
    /// The method does not do this kind of question.
    Unsupported {
        /// What it does not do.
        what: &'static str,
    },
    /// An engine that somebody else wrote refuses the case, in its own words.
    ByEngine {
        /// The reason without its numbers, for counting.
        reason: String,
        /// Why, with the numbers; may be empty.
        why: String,
    },
    /// Not a refusal: an engine that somebody else wrote broke, and there is no answer. Whoever counts refusals has to treat it as a failure
    /// ([`Decline::is_breakdown`]), and it says nothing about the physics.
    NoAnswer {
        /// The name of what happened, as in `timed out`.
        breakdown: &'static str,
        /// What happened to this engine, with the numbers.
        happened: String,
        /// What to do about it.
        advice: String,
    },
}

impl Decline {
    /// Whether this is an engine that broke, and not one that refused.
    pub fn is_breakdown(&self) -> bool {
        matches!(self, Self::NoAnswer { .. })
    }

    /// The reason without its numbers, for counting.
    pub fn reason(&self) -> &str {
        match self {
            Self::NeedsSlenderness => "needs a slenderness",
            Self::OutOfRange { .. } => "out of range",
            Self::NotConvergent { .. } => "not convergent",
            Self::Unsupported { .. } => "unsupported",
            Self::ByEngine { reason, .. } => reason,
            Self::NoAnswer { breakdown, .. } => breakdown,
        }
    }
}

impl fmt::Display for Decline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NeedsSlenderness => f.write_str("the model needs a slenderness (alpha)"),
            Self::OutOfRange { field, value, allowed } => {
                write!(f, "{field} = {value:?} is outside what this method can do: {allowed}")
            }
            Self::NotConvergent { why } => f.write_str(why),
            Self::Unsupported { what } => write!(f, "this method does not do {what}"),
            Self::ByEngine { reason, why } if why.is_empty() => f.write_str(reason),
            Self::ByEngine { reason, why } => write!(f, "{reason}: {why}"),
            Self::NoAnswer { breakdown, happened, advice } => write!(f, "{breakdown}: {happened}. {advice}"),
        }
    }
}
