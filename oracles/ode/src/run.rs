//! From flight to flight: the impacts, and why they end.

use core::cell::Cell;

use contract::{Case, Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};
use diffsol::{DiffsolError, NalgebraLU, OdeBuilder, OdeSolverMethod, OdeSolverProblem};

use crate::equation::Motion;
use crate::flight::{Rescaled, Scaled};
use crate::launch::{Equations, Flight, Launch, Matrix, Outcome};
use crate::naive::Naive;
use crate::{Flights, Ode, Solver};

/// Intervals below this have nothing left to resolve: the rotations, of the order of their square, near the smallest double.
const LEAST_INTERVAL: f64 = 1e-140;

/// What the impacts of [`Ode::impacts`](crate::Ode::impacts) claim: nothing.
const NO_CLAIM: Uncertainty = Uncertainty { time: f64::INFINITY, interval: f64::INFINITY, velocity: f64::INFINITY };

/// The first flight of a case.
const FIRST: Launch = Launch { i: -1.0, tau: 0.0, rotation: 0.0, velocity: 0.0 };

type Lu = NalgebraLU<f64>;

/// All impacts of `case`, claiming nothing; `evaluations` counts those of the right-hand side.
pub(crate) fn impacts(ode: &Ode, case: &Case, motion: &Motion, rtol: f64, evaluations: &Cell<u64>) -> History {
    // A solver that cannot even be made has lost the sequence before its first impact.
    let failed = |_: DiffsolError| History {
        impacts: Vec::new(),
        ending: Ending::Lost(Loss::SolverFailed),
        chattering_time: None,
    };
    match ode.flights {
        Flights::Rescaled => {
            let first = Scaled::of_case(motion, &FIRST);
            rescaled(ode.method, first, rtol, evaluations, Follow { case, motion })
        }
        Flights::Naive => naive(ode, case, motion, rtol, evaluations),
    }
    .unwrap_or_else(failed)
}

/// Calls `$then` with the solver that `$method` names; each is a type of its own.
macro_rules! with_solver {
    ($method:expr, $problem:expr, |$solver:ident| $then:expr) => {
        match $method {
            Solver::Tsit45 => $problem.tsit45().map(|$solver| $then),
            Solver::Bdf => $problem.bdf::<Lu>().map(|$solver| $then),
            Solver::TrBdf2 => $problem.tr_bdf2::<Lu>().map(|$solver| $then),
            Solver::Esdirk34 => $problem.esdirk34::<Lu>().map(|$solver| $then),
        }
    };
}

/// What is done with a solver of rescaled flights, whichever type it is of.
pub(crate) trait Task {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>>(self, flight: Rescaled<'_, '_, S>) -> Self::Output;
}

/// A whole history.
struct Follow<'a> {
    case: &'a Case,
    motion: &'a Motion,
}

impl Task for Follow<'_> {
    type Output = History;

    fn run<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>>(self, flight: Rescaled<'_, '_, S>) -> History {
        follow(self.case, self.motion, flight)
    }
}

/// Makes a solver that flies each flight in its own units, the `first` of them in these, and does `task` with it.
pub(crate) fn rescaled<T: Task>(
    method: Solver,
    first: Scaled<'_>,
    rtol: f64,
    evaluations: &Cell<u64>,
    task: T,
) -> Result<T::Output, DiffsolError> {
    let units = &Cell::new(first);
    let mut problem = OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol([rtol])
        .rhs_implicit(
            |y, _, xi, dy| {
                evaluations.set(evaluations.get() + 1);
                if let (&[chi, velocity], [dchi, dvelocity]) = (y, dy) {
                    (*dchi, *dvelocity) = (velocity, units.get().acceleration(xi, chi));
                }
            },
            |y, _, xi, v, jv| {
                if let (&[chi, _], &[v0, v1], [j0, j1]) = (y, v, jv) {
                    (*j0, *j1) = (v1, units.get().stiffness(xi, chi) * v0);
                }
            },
        )
        .root(
            |y, _, xi, g| {
                if let (&[chi, _], [g]) = (y, g) {
                    *g = units.get().event(xi, chi);
                }
            },
            1,
        )
        .init(|_, _, y| y.fill(0.0), 2)
        .build()?;
    tame(&mut problem, method);
    with_solver!(method, problem, |solver| task.run(Rescaled { solver, units, method, rtol }))
}

fn naive(ode: &Ode, case: &Case, motion: &Motion, rtol: f64, evaluations: &Cell<u64>) -> Result<History, DiffsolError> {
    let &Ode { method, restart, .. } = ode;
    let sign = &Cell::new(-1.0);
    let mut problem = OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol([rtol])
        .rhs_implicit(
            |y, _, tau, dy| {
                evaluations.set(evaluations.get() + 1);
                if let (&[phi, velocity], [dphi, dvelocity]) = (y, dy) {
                    let i = sign.get();
                    (*dphi, *dvelocity) = (velocity, motion.shape.acceleration(i, motion.excess(i, tau), phi));
                }
            },
            |y, _, tau, v, jv| {
                if let (&[phi, _], &[v0, v1], [j0, j1]) = (y, v, jv) {
                    let i = sign.get();
                    (*j0, *j1) = (v1, motion.shape.stiffness(i, motion.excess(i, tau), phi) * v0);
                }
            },
        )
        .root(
            |y, _, _, g| {
                if let (&[phi, _], [g]) = (y, g) {
                    *g = phi;
                }
            },
            1,
        )
        .init(|_, _, y| y.fill(0.0), 2)
        .build()?;
    tame(&mut problem, method);
    with_solver!(method, problem, |solver| follow(case, motion, Naive { solver, sign, restart }))
}

/// Lifts the limits that are counted over the life of a solver, which here is a whole history; a flight has a limit of its own.
fn tame<E: Equations>(problem: &mut OdeSolverProblem<E>, method: Solver) {
    problem.ode_options.max_nonlinear_solver_failures = usize::MAX;
    problem.ode_options.min_timestep = 1e-18;
    if method == Solver::Bdf {
        // By default a step only grows when it can double. The steps of a flight are then the first one times powers of two, and the
        // error jumps by a factor of up to 30 with the place of the tolerance between them, which no comparison of two runs survives.
        problem.ode_options.min_timestep_growth = Some(1.2);
    }
}

/// Follows the block from impact to impact.
fn follow<'a, E: Equations + 'a>(case: &Case, motion: &Motion, mut flight: impl Flight<'a, E>) -> History {
    let (horizon, out_of_time) = match case.horizon() {
        Horizon::HalfPeriod => (motion.half_period(), Ending::Incomplete),
        Horizon::Until(tau) => (tau, Ending::LimitReached(Limit::Time)),
    };
    let mut impacts = Vec::with_capacity(case.max_impacts().min(1024));
    let mut clock = Clock::default();
    let mut launch = FIRST;
    let mut certain = false;
    let ending = loop {
        let (interval, speed) = match flight.fly(motion, &launch, clock.left_until(horizon)) {
            Outcome::Impact { interval, speed } => (interval, speed),
            Outcome::TimeIsUp => break out_of_time,
            Outcome::Overturned { .. } => break Ending::Overturned,
            Outcome::Lost(loss) => break Ending::Lost(loss),
        };
        clock.advance(interval);
        // Eq. 13: the velocity keeps its sign, and so is that of the flight that follows.
        let i = -launch.i;
        launch = Launch { i, tau: clock.now, rotation: 0.0, velocity: i * case.eta() * speed };
        impacts.push(Impact { time: clock.now, interval, velocity: launch.velocity, uncertainty: NO_CLAIM });
        certain = certain || motion.comes_to_rest(case.eta(), clock.now, launch.velocity.abs());
        let too_short = interval < LEAST_INTERVAL;
        if too_short || impacts.len() >= case.max_impacts() {
            break match (certain, too_short) {
                (true, _) => Ending::AtRest,
                (false, true) => Ending::Lost(Loss::Stalled),
                (false, false) => Ending::LimitReached(Limit::Impacts),
            };
        }
    };
    History { impacts, ending, chattering_time: None }
}

/// The time since initiation as a compensated sum (Knuth's two-sum): the late intervals are far below its last digit.
#[derive(Debug, Default)]
struct Clock {
    now: f64,
    rest: f64,
}

impl Clock {
    fn advance(&mut self, interval: f64) {
        let add = interval + self.rest;
        let sum = self.now + add;
        let virtual_add = sum - self.now;
        self.rest = (self.now - (sum - virtual_add)) + (add - virtual_add);
        self.now = sum;
    }

    fn left_until(&self, horizon: f64) -> f64 {
        (horizon - self.now) - self.rest
    }
}

#[cfg(test)]
mod tests {
    use contract::Case;

    use super::*;
    use crate::Equation;

    /// One flight, wherever it starts.
    struct Fly<'a>(&'a Motion, Launch);

    impl Task for Fly<'_> {
        type Output = Outcome;

        fn run<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>>(self, mut flight: Rescaled<'_, '_, S>) -> Outcome {
            flight.fly(self.0, &self.1, 10.0)
        }
    }

    /// A block that is below its base already has no impact to come; whatever the solver makes of its root, it is told as lost.
    #[test]
    fn a_flight_that_is_below_the_base_has_fallen_through() {
        let case = Case::from_epsilon(0.1, 2.0, 0.9).unwrap_or_else(|e| panic!("{e}"));
        let motion = Motion::new(&case, Equation::Linear).unwrap_or(None).unwrap_or_else(|| panic!("it rocks"));
        for method in Solver::ALL {
            for (i, rotation, velocity) in [(1.0, -1e-3, -0.1), (-1.0, 1e-3, 0.1), (1.0, -0.5, 0.0), (-1.0, 1e-9, 1e-3)]
            {
                let launch = Launch { i, tau: 0.3, rotation, velocity };
                let evaluations = Cell::new(0);
                let outcome = rescaled(
                    method,
                    Scaled::of_case(&motion, &FIRST),
                    method.default_rtol(),
                    &evaluations,
                    Fly(&motion, launch),
                );
                // An implicit method may find no step at all that is short enough.
                let lost = match outcome {
                    Ok(Outcome::Lost(loss)) => Some(loss),
                    _ => None,
                };
                let implicit = method != Solver::Tsit45 && lost == Some(Loss::SolverFailed);
                assert!(implicit || lost == Some(Loss::FellThrough), "{method} {launch:?}: {lost:?}");
            }
        }
    }

    /// Intervals far below the last digit of the clock add up, and what is left until a time sees them.
    #[test]
    fn the_clock_does_not_lose_what_it_cannot_show() {
        let mut clock = Clock::default();
        clock.advance(1.0);
        let tick = 2_f64.powi(-60);
        for _ in 0..128 {
            clock.advance(tick);
        }
        // 2^-53 is half of the last digit of 1.
        assert_eq!((clock.now, clock.left_until(1.0)), (1.0, -128.0 * tick));
        clock.advance(2_f64.powi(-53));
        assert_eq!((clock.now, clock.left_until(1.0 + f64::EPSILON)), (1.0 + f64::EPSILON, 0.0));
        // Also where what is added is larger than what is there.
        let mut clock = Clock::default();
        clock.advance(tick);
        clock.advance(4.0);
        assert_eq!((clock.now, clock.left_until(5.0)), (4.0, 1.0));
        assert_eq!(clock.left_until(4.0), -tick);
    }
}
