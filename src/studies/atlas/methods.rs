//! What is asked: the specimens, and the oracles beside them.

use contract::{Case, Ending, Horizon, Oracle};
use ode::Restart;

use crate::{
    measure::asking::{Reply, ask},
    panel,
    studies::specimens::{
        AdHoc, Conclusion, Landing, MoreauJean, OneClock, PrintedInDoubles, Response, Rule, Run, Specimen, Threshold,
        half_period,
    },
};

/// A method of the atlas.
pub enum Contender {
    /// A way that is known to fail.
    Specimen(Box<dyn Specimen>),
    /// A method of the panel.
    Oracle(Box<dyn Oracle>),
}

impl Contender {
    /// What charts and tables call the kind of it.
    pub fn family(&self) -> &str {
        match self {
            Self::Specimen(specimen) => specimen.family(),
            Self::Oracle(_) => "oracle",
        }
    }

    /// What distinguishes it among those of its kind.
    pub fn setting(&self) -> String {
        match self {
            Self::Specimen(specimen) => specimen.setting(),
            Self::Oracle(oracle) => oracle.name().to_owned(),
        }
    }

    /// What it makes of a case.
    pub fn run(&self, case: &Case) -> Option<Run> {
        match self {
            Self::Specimen(specimen) => specimen.run(case),
            Self::Oracle(oracle) => Some(run(oracle.as_ref(), case)),
        }
    }
}

/// The same for an oracle.
fn run(oracle: &dyn Oracle, case: &Case) -> Run {
    let nothing = |why: String| Run {
        impacts: Vec::new(),
        conclusion: Conclusion::GaveUp(why),
        response: None,
        evaluations: None,
    };
    let observed = match ask(oracle, case).reply {
        Reply::Observed(observed) => observed,
        Reply::Declined(_) => return nothing("declines".to_owned()),
        Reply::Broke(how) => return nothing(how.to_string()),
        Reply::Panicked(message) => return nothing(format!("panics: {message}")),
    };
    let impacts: Vec<Landing> = observed.history.impacts.iter().map(Landing::from).collect();
    let (conclusion, response) = match (observed.history.ending, observed.chattering_time) {
        (Ending::AtRest, Some(time)) => {
            (Conclusion::Rests(time.value), Some(Response::of(case, &impacts, Some(time.value))))
        }
        (Ending::Incomplete, _) => (Conclusion::Rocks, response(oracle, case)),
        (ending, _) => (Conclusion::GaveUp(ending.to_string()), None),
    };
    Run { impacts, conclusion, response, evaluations: None }
}

/// Where the block goes that still rocks at `T/2`.
fn response(oracle: &dyn Oracle, case: &Case) -> Option<Response> {
    let followed = case.with_horizon(Horizon::Until(2.0 * half_period(case))).ok()?;
    let history = ask(oracle, &followed).into_observed()?.history;
    let impacts: Vec<Landing> = history.impacts.iter().map(Landing::from).collect();
    let rests = impacts.last().map(|last| last.time).filter(|_| history.ending == Ending::AtRest);
    Some(Response::of(case, &impacts, rests))
}

/// Every method, in the order of the tables.
pub fn methods() -> Vec<Contender> {
    let power = |exponent: i32| 10.0_f64.powi(exponent);
    let mut specimens: Vec<Box<dyn Specimen>> = Vec::new();
    for exponent in 1..=12 {
        specimens.push(Box::new(Threshold { rule: Rule::Velocity, value: power(-exponent) }));
    }
    for rule in [Rule::Interval, Rule::TwoIntervals] {
        for exponent in [1, 2, 3, 4, 6, 8, 10, 12] {
            specimens.push(Box::new(Threshold { rule, value: power(-exponent) }));
        }
    }
    specimens.push(Box::new(AdHoc));
    specimens.push(Box::new(PrintedInDoubles));
    for restart in [Restart::Zero, Restart::Lifted(LIFT), Restart::OldStep] {
        for rtol in [1e-6, 1e-9, 1e-12] {
            specimens.push(Box::new(OneClock { restart, rtol }));
        }
    }
    for exponent in 2..=6 {
        specimens.push(Box::new(MoreauJean { step: power(-exponent) }));
    }
    let mut methods: Vec<Contender> = specimens.into_iter().map(Contender::Specimen).collect();
    for name in ["closed-form", "ode/linear", "asymptotic/paper", "asymptotic/order-16", "asymptotic/resummed"] {
        methods.extend(panel::select(name).unwrap_or_default().into_iter().map(Contender::Oracle));
    }
    methods
}

/// How far a block is lifted off its base where it is.
pub const LIFT: f64 = 1e-12;
