//! The oracle that integrates the equation of motion with a general ODE solver ([diffsol](https://docs.rs/diffsol)) and finds the impacts
//! as roots of the rotation. It knows nothing of the problem but the equation of motion itself: Eq. 4 for the slender block, Eq. 2 for
//! the block as it is.
//!
//! Each flight is integrated in units of its own, in which it is a problem of order one, so flights as short as `1e-140` come out with
//! the accuracy of the first. [`Flights::Naive`] keeps the clock and the units of the problem instead, the way one would first write it,
//! to show where that ends.
//!
//! What the solver reports is never taken on trust: after each step the quintic through the values at its ends must agree with the
//! solver on whether there was a root, and there must be no more than one; otherwise the step is halved, and in the end the sequence is
//! reported as [lost](contract::Ending::Lost).
#![forbid(unsafe_code)]

mod claim;
mod ending;
mod equation;
mod flight;
mod flights;
mod forcing;
mod ground;
mod launch;
mod naive;
mod on_motion;
mod piece;
mod run;

use core::cell::Cell;
use core::fmt;
use core::str::FromStr;

use contract::{Body, Case, Decline, Ending, FlightSolver, History, Invalid, Model, Oracle};

use crate::equation::Motion;
use crate::flights::{OnCase, Single};
use crate::on_motion::OnMotion;

/// The equation of motion between impacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Equation {
    /// Eq. 4.
    Linear,
    /// Eq. 2.
    Nonlinear,
}

/// The method of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Solver {
    /// Explicit Runge-Kutta 5(4) of Tsitouras.
    Tsit45,
    /// Backward differentiation of variable order, 1 to 5.
    Bdf,
    /// TR-BDF2, singly diagonally implicit, second order.
    TrBdf2,
    /// ESDIRK34, singly diagonally implicit, third order.
    Esdirk34,
}

/// How the flights are put to the solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Flights {
    /// Each in its own units, with a clock that starts at its start.
    Rescaled,
    /// All on one clock and in the units of the problem. Kept to be studied: it loses the sequence once the tolerances or the spacing of
    /// the clock are coarser than a flight.
    Naive,
}

/// What a solver on one clock is given to start the flight after an impact. Each is what someone would write, and each fails in its own way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Restart {
    /// The rotation exactly zero, and a first step of a quarter of the flight.
    Zero,
    /// The rotation lifted off the base by this much, so that the start of a flight is no root; and the same first step.
    Lifted(f64),
    /// The rotation exactly zero, and the step that the solver was taking before the impact.
    OldStep,
}

/// The oracle: an equation, a method, a tolerance.
#[derive(Debug, Clone)]
pub struct Ode {
    equation: Equation,
    method: Solver,
    flights: Flights,
    restart: Restart,
    rtol: f64,
    name: String,
}

/// The impacts from a single run, and what they cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Counted {
    /// As from [`Ode::impacts`].
    pub history: History,
    /// How often the right-hand side was evaluated.
    pub evaluations: u64,
}

impl Equation {
    /// As in the oracle's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Nonlinear => "nonlinear",
        }
    }
}

impl Solver {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Tsit45, Self::Bdf, Self::TrBdf2, Self::Esdirk34];

    /// As in the oracle's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tsit45 => "tsit45",
            Self::Bdf => "bdf",
            Self::TrBdf2 => "tr-bdf2",
            Self::Esdirk34 => "esdirk34",
        }
    }

    /// The tolerance unless told otherwise: about where the method is still fast and a smaller one no longer pays.
    pub fn default_rtol(self) -> f64 {
        match self {
            // With 1e-12 the claims hid a relative error of 1e-12 in ω from the gate.
            Self::Tsit45 => 4e-13,
            Self::Bdf => 1e-9,
            Self::TrBdf2 => 1e-8,
            Self::Esdirk34 => 1e-11,
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Solver {
    type Err = Invalid;

    fn from_str(name: &str) -> Result<Self, Invalid> {
        let found = Self::ALL.into_iter().find(|method| method.name() == name);
        found.ok_or_else(|| Invalid::new("method", name, "tsit45, bdf, tr-bdf2 or esdirk34"))
    }
}

impl Ode {
    /// The oracle for `equation` by `method`, with the method's default tolerance and rescaled flights.
    pub fn new(equation: Equation, method: Solver) -> Self {
        let (flights, restart, rtol) = (Flights::Rescaled, Restart::Zero, method.default_rtol());
        Self { equation, method, flights, restart, rtol, name: String::new() }.named()
    }

    /// The same with the relative tolerance `rtol`, which is also the absolute one in the units of the flight (or, in naive mode, of
    /// the problem).
    ///
    /// # Errors
    /// When `rtol` is not inside [1e-13, 1e-2]: below, it asks for more than doubles have; above, the error estimates mean nothing.
    pub fn with_rtol(self, rtol: f64) -> Result<Self, Invalid> {
        if (1e-13..=1e-2).contains(&rtol) {
            Ok(Self { rtol, ..self })
        } else {
            Err(Invalid::new("rtol", format!("{rtol:?}"), "1e-13 <= rtol <= 1e-2"))
        }
    }

    /// The same with the flights put to the solver as named.
    #[must_use]
    pub fn with_flights(self, flights: Flights) -> Self {
        Self { flights, ..self }.named()
    }

    /// The same with the flights of [`Flights::Naive`] started as named; the default is [`Restart::Zero`].
    #[must_use]
    pub fn with_restart(self, restart: Restart) -> Self {
        Self { restart, ..self }
    }

    /// The equation of motion.
    pub fn equation(&self) -> Equation {
        self.equation
    }

    /// The method of integration.
    pub fn method(&self) -> Solver {
        self.method
    }

    /// How the flights are put to the solver.
    pub fn flights(&self) -> Flights {
        self.flights
    }

    /// The relative tolerance.
    pub fn rtol(&self) -> f64 {
        self.rtol
    }

    /// The impacts from a single run, which is twice as fast as [`Oracle::history`] and claims nothing: every uncertainty is infinite.
    ///
    /// # Errors
    /// As [`Oracle::history`].
    pub fn impacts(&self, case: &Case) -> Result<History, Decline> {
        self.run(case, self.rtol)
    }

    /// As [`Ode::impacts`], with a count of what they cost.
    ///
    /// # Errors
    /// As [`Oracle::history`].
    pub fn counted(&self, case: &Case) -> Result<Counted, Decline> {
        let evaluations = Cell::new(0);
        let history = self.run_counting(case, self.rtol, &evaluations)?;
        Ok(Counted { history, evaluations: evaluations.get() })
    }

    fn run(&self, case: &Case, rtol: f64) -> Result<History, Decline> {
        self.run_counting(case, rtol, &Cell::new(0))
    }

    fn run_counting(&self, case: &Case, rtol: f64, evaluations: &Cell<u64>) -> Result<History, Decline> {
        Ok(match Motion::new(case, self.equation)? {
            Some(motion) => run::impacts(self, case, &motion, rtol, evaluations),
            None => History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None },
        })
    }

    /// How single flights are flown: each by itself, and so in its own units.
    fn single(&self) -> Result<Single, Decline> {
        match self.flights {
            Flights::Rescaled => Ok(Single { method: self.method, rtol: self.rtol }),
            Flights::Naive => Err(Decline::Unsupported { what: "single flights: it has one clock for all of them" }),
        }
    }

    fn named(self) -> Self {
        let suffix = match self.flights {
            Flights::Rescaled => "",
            Flights::Naive => "/naive",
        };
        Self { name: format!("ode/{}/{}{suffix}", self.equation.name(), self.method), ..self }
    }
}

impl Oracle for Ode {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        match self.equation {
            Equation::Linear => Model::Linear,
            Equation::Nonlinear => Model::Nonlinear,
        }
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let mut history = self.run(case, self.rtol)?;
        let [coarse, coarser] = claim::tolerances(self.rtol).map(|rtol| self.run(case, rtol));
        claim::claim(self, &mut history, &coarse?, &coarser?);
        if let (Equation::Nonlinear, Some(slenderness)) = (self.equation, case.slenderness()) {
            claim::widen(&mut history, equation::threshold_excess(case.epsilon(), slenderness).1);
        }
        Ok(history)
    }

    /// From a single run each, in its own units at the tolerance of this oracle: as accurate as its impacts.
    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        let single = self.single()?;
        let motion = Motion::new(case, self.equation)?;
        let motion = motion.ok_or(Decline::Unsupported { what: "flights of a block that never rocks" })?;
        Ok(Box::new(OnCase { single, eta: case.eta(), motion }))
    }

    fn coarser(&self) -> Option<Box<dyn Oracle>> {
        let [_, rtol] = claim::tolerances(self.rtol);
        Some(Box::new(Self { rtol, ..self.clone() }))
    }

    fn flights_on(&self, body: &Body, motion: &contract::Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        Ok(Box::new(OnMotion::new(self.single()?, self.equation, body, motion)?))
    }
}
