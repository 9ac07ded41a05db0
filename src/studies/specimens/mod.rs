//! **Specimens: ways of handling the accumulation point that are known to fail, kept to measure how.** None of them is an oracle, none makes a
//! claim, none is on the panel, and no conclusion of the gate rests on one. Only the [`atlas`](crate::studies::atlas) and the
//! [`work_precision`](crate::studies::work_precision) charts ask them. Do not copy them into a simulator.
//!
//! | file | what it is | where it comes from |
//! | --- | --- | --- |
//! | `thresholds` | at rest once a velocity, or an interval, falls below a threshold | Fig. 8b; Cusumano and Bai; Wagg and Bishop |
//! | `ad_hoc` | at rest at the time of Eq. 65 if Eq. 76 says that the chattering is complete | Fig. 8a |
//! | `as_printed` | Eqs 6-13 in doubles and in absolute time | the paper as it stands |
//! | `one_clock` | diffsol on one clock, restarted after each impact in three ways | what one would write first |
//! | `time_stepping` | the scheme of Moreau and Jean, with a fixed step | nonsmooth mechanics |
//!
//! Each is given a case and says what became of the block by half a period, `T/2`, and where its rotation went in the half period after that.
//! The thresholds and the ad hoc scheme are given exact flights (the closed form), so what they do wrong is theirs alone.

mod ad_hoc;
mod as_printed;
mod one_clock;
mod response;
mod thresholds;
mod time_stepping;

use contract::{Case, Impact};

use crate::measure::excitation;

pub use ad_hoc::AdHoc;
pub use as_printed::PrintedInDoubles;
pub use one_clock::{OneClock, solver_on_one_clock};
pub use response::{Response, SAMPLES, sample_times};
pub use thresholds::{Rule, Threshold};
pub use time_stepping::MoreauJean;

/// A way of handling the accumulation point.
pub trait Specimen: Send + Sync {
    /// What kind of way it is, as charts and tables call it.
    fn family(&self) -> &'static str;

    /// Its setting: a threshold, a tolerance, a step.
    fn setting(&self) -> String;

    /// What it makes of a case of the linear model, followed to the end of the first period; `None` when it can't be asked such a case.
    fn run(&self, case: &Case) -> Option<Run>;
}

/// What became of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The impacts before `T/2`, as far as it got.
    pub impacts: Vec<Landing>,
    /// What it says of the chattering.
    pub conclusion: Conclusion,
    /// The rotation in the half period after `T/2`, where it got that far.
    pub response: Option<Response>,
    /// How often it evaluated the right-hand side, if it is a method that does.
    pub evaluations: Option<u64>,
}

/// One impact. It claims nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landing {
    /// The time `τ_n`.
    pub time: f64,
    /// The interval `Δτ_(n-1)`.
    pub interval: f64,
    /// The velocity just after.
    pub velocity: f64,
}

/// What a way of handling the accumulation point says of the chattering.
#[derive(Debug, Clone, PartialEq)]
pub enum Conclusion {
    /// Complete: at rest from this time on, which is its chattering time.
    Rests(f64),
    /// Incomplete: still rocking at `T/2`.
    Rocks,
    /// None: it fell through the base, or took a wrong turn, and has not noticed.
    Astray(&'static str),
    /// None, and it says so.
    GaveUp(String),
    /// None: it would go on for ever without getting on.
    Hangs(&'static str),
}

impl From<&Impact> for Landing {
    fn from(impact: &Impact) -> Self {
        Self { time: impact.time, interval: impact.interval, velocity: impact.velocity }
    }
}

/// More impacts than this is taken as going on for ever: so many lie above intervals of 1e-300 at `η = 0.98`.
pub const ENDLESS: usize = 40_000;

/// `T/2 = π/ω`, the time at which the excitation is the mirror image of its start.
pub fn half_period(case: &Case) -> f64 {
    excitation::half_period(case.omega())
}
