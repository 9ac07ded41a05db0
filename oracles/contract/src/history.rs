use alloc::vec::Vec;
use core::fmt;

/// What an oracle found: the impacts in order, and why the list ended.
///
/// Initiation at `τ = 0` is not an impact and is not listed: `impacts[0]` is impact 1, at the end of the first flight.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// The impacts in order of time.
    pub impacts: Vec<Impact>,
    /// Why the list ended.
    pub ending: Ending,
    /// The chattering time, from an oracle that has one of its own which does not come from closing the sum of the listed
    /// intervals. Otherwise the harness closes the sum, in the same way for every oracle.
    pub chattering_time: Option<Estimate>,
}

/// One impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// The dimensionless time `τ_n` since initiation.
    pub time: f64,
    /// The interval `Δτ_{n-1} = τ_n - τ_{n-1}`: how long the flight lasted that this impact ended. Held apart from the time,
    /// because it stays accurate long after the difference of two times has lost every digit.
    pub interval: f64,
    /// The velocity `φ'_n(τ_n)` just after the impact; its sign is that of the flight that follows.
    pub velocity: f64,
    /// What the oracle claims for these three.
    pub uncertainty: Uncertainty,
}

/// The largest error that an oracle claims to have made, in the model that it solves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uncertainty {
    /// Of the time, absolute in `τ`.
    pub time: f64,
    /// Of the interval, relative.
    pub interval: f64,
    /// Of the velocity, relative.
    pub velocity: f64,
}

/// The derivatives of one impact by the amplitude `a` (equally by `ε = a - 1`), the frequency ratio `ω` and the restitution `η`, in this
/// order; each in the unit of the quantity by that of the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivity {
    /// Of [`Impact::time`].
    pub time: [f64; 3],
    /// Of [`Impact::interval`].
    pub interval: [f64; 3],
    /// Of [`Impact::velocity`].
    pub velocity: [f64; 3],
}

/// How an impact of the linear model (Eq. 4) moves when the block is less slender than that model has it: the first three coefficients of the
/// power series in `μ = 2(1/cos α - 1)` of the impact of the nonlinear model (Eq. 2) under
/// [`Normalisation::Threshold`](crate::Normalisation::Threshold). As `μ = α² + O(α⁴)`, the first is the derivative by `α²` at `α = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlendernessShift {
    /// Of [`Impact::time`], in `τ`.
    pub time: [f64; 3],
    /// Of [`Impact::interval`], relative to that of the linear model.
    pub interval: [f64; 3],
    /// Of [`Impact::velocity`] times `α/sin α`, relative to that of the linear model. The factor is that of every rotation of Eq. 2: it
    /// multiplies the acceleration at the base, and moves no impact.
    pub velocity: [f64; 3],
}

/// A value, and the largest error claimed for it, absolute.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// The claimed error, absolute, in the unit of the value.
    pub uncertainty: f64,
}

/// Why a history ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ending {
    /// The excitation never exceeds what the block resists (`a <= 1`): it does not rock, and there are no impacts.
    NeverRocks,
    /// Complete chattering: the oracle has made sure that infinitely many impacts follow the listed ones and that they
    /// accumulate before the excitation turns against the block (before `T/2`, or the next time it does).
    AtRest,
    /// Incomplete chattering: the half period `T/2` was reached while the block was still rocking.
    Incomplete,
    /// The rotation passed the point from which no return is possible.
    Overturned,
    /// A limit of the case was reached before the outcome was clear.
    LimitReached(Limit),
    /// The oracle lost the sequence and knows it. The impacts listed are those before the loss.
    Lost(Loss),
}

/// Which limit of the case ended a history.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Limit {
    /// The number of impacts.
    Impacts,
    /// The time of [`Horizon::Until`](crate::Horizon::Until), reached while still rocking.
    Time,
}

/// How an oracle lost the sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Loss {
    /// The rotation had the sign of the other flight without an impact having been found: the block fell through its base.
    FellThrough,
    /// The impact was found at the very start of its flight, or so near it that time did not advance.
    Stalled,
    /// An interval or velocity came out as zero, negative, or not finite.
    NotFinite,
    /// The solver gave up: its step size, its iteration or its count of steps.
    SolverFailed,
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NeverRocks => f.write_str("never rocks"),
            Self::AtRest => f.write_str("at rest (complete chattering)"),
            Self::Incomplete => f.write_str("incomplete (still rocking at half a period)"),
            Self::Overturned => f.write_str("overturned"),
            Self::LimitReached(Limit::Impacts) => f.write_str("limit of impacts reached"),
            Self::LimitReached(Limit::Time) => f.write_str("limit of time reached"),
            Self::Lost(loss) => write!(f, "lost: {loss}"),
        }
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::FellThrough => "the block fell through its base without an impact",
            Self::Stalled => "time stopped advancing",
            Self::NotFinite => "a value is zero or not finite",
            Self::SolverFailed => "the solver gave up",
        })
    }
}
