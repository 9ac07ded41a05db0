//! One flight in its own units: `tau = tau_n + T xi`, `phi = P chi`, so that every flight is a problem of order one, however short.

use core::cell::Cell;

use contract::Loss;
use diffsol::{OdeSolverMethod, OdeSolverStopReason};

use crate::Solver;
use crate::equation::{Motion, Shape};
use crate::forcing::Forcing;
use crate::launch::{Equations, Flight, Launch, Outcome};
use crate::piece::{Knot, Piece};

/// More steps than any flight takes at any tolerance allowed; it bounds the work when something is wrong.
const MOST_STEPS: usize = 100_000;
/// How often a step may be halved because it is in doubt what happened inside.
const MOST_HALVINGS: usize = 60;
/// The first step when the whole flight is one: a little more than the estimated length, to see its end.
const WHOLE_FLIGHT: f64 = 1.05;

/// The equation of motion of one flight, in its own units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scaled<'a> {
    shape: Shape,
    forcing: Forcing<'a>,
    i: f64,
    /// The unit of time, `T`.
    pub time: f64,
    /// The unit of rotation, `P`.
    pub rotation: f64,
    /// `P/T`.
    velocity: f64,
    /// `T^2/P`.
    per_acceleration: f64,
    /// `chi(0)`: 0 from the base.
    start_rotation: f64,
    /// `chi'(0)`: about `i`, or 0 in the first flight.
    start_velocity: f64,
}

impl<'a> Scaled<'a> {
    /// Units for the flight under the motion of a case that starts as `launch` says.
    pub fn of_case(motion: &Motion, launch: &Launch) -> Self {
        Self::new(motion.shape, motion.forcing(launch.i, launch.tau), launch)
    }

    /// Units for the flight that starts as `launch` says.
    ///
    /// With `c_k = i phi^(k)/k!` the coefficients of the rotation away from the base, a coefficient that points back balances one that
    /// points away after the time `(c_j/|c_k|)^(1/(k-j))`. `T` is the first time at which some `c_k < 0` balances all those before it:
    /// `2 |v|/|phi''|` for an ordinary flight, `4 sqrt(eps (2 + eps))/omega` for the first (where only jerk and snap are left), and
    /// otherwise no more than the time in which the excitation or the unstable equilibrium change things.
    pub fn new(shape: Shape, forcing: Forcing<'a>, launch: &Launch) -> Self {
        let Launch { i, rotation, velocity, .. } = *launch;
        let (slope, curvature) = forcing.derivatives();
        // The derivatives of Eq. 4, with the gain of Eq. 2: the estimate need not be better than that.
        let gain = shape.gain();
        let second = rotation - gain * forcing.excess;
        let third = velocity - gain * slope;
        let fourth = second - gain * curvature;
        let c =
            [(0, i * rotation), (1, i * velocity), (2, i * second / 2.0), (3, i * third / 6.0), (4, i * fourth / 24.0)];
        let balance = |&(k, ck): &(i32, f64)| {
            let times = c.iter().filter(|&&(j, cj)| j < k && cj > 0.0).map(|&(j, cj)| root(cj / -ck, k - j));
            times.fold(0.0, f64::max)
        };
        let returning = c.iter().filter(|&&(_, ck)| ck < 0.0).map(balance).filter(|&t| t > 0.0);
        let time = returning.fold(1.0 / forcing.rate().max(1.0), f64::min);
        let unit = c.iter().map(|&(k, ck)| ck.abs() * time.powi(k)).fold(0.0, f64::max);
        Self {
            shape,
            forcing,
            i,
            time,
            rotation: unit,
            velocity: unit / time,
            per_acceleration: time / unit * time,
            start_rotation: rotation / unit,
            start_velocity: velocity / unit * time,
        }
    }

    /// `d^2 chi/d xi^2`.
    #[inline]
    pub fn acceleration(&self, xi: f64, chi: f64) -> f64 {
        let g = self.forcing.at(self.time * xi);
        self.shape.acceleration(self.i, g, self.rotation * chi) * self.per_acceleration
    }

    /// The derivative of [`Self::acceleration`] by `chi`.
    pub fn stiffness(&self, xi: f64, chi: f64) -> f64 {
        let g = self.forcing.at(self.time * xi);
        self.shape.stiffness(self.i, g, self.rotation * chi) * self.time * self.time
    }

    /// The function whose sign the solver watches: the rotation with its known root at `xi = 0` divided out, simple after an impact and
    /// triple in the first flight (double where it starts above the threshold; what is divided by too often keeps its sign). So the start of a flight is no event, and a step over the whole flight is one.
    #[inline]
    pub fn event(&self, xi: f64, chi: f64) -> f64 {
        if xi <= 0.0 {
            self.i
        } else if self.start_rotation != 0.0 {
            chi
        } else if self.start_velocity != 0.0 {
            chi / xi
        } else {
            chi / (xi * xi * xi)
        }
    }

    fn start(&self) -> Knot {
        let y = self.start_rotation;
        Knot { t: 0.0, y, dy: self.start_velocity, ddy: self.acceleration(0.0, y) }
    }

    /// A first step that the error test is likely to accept. The embedded method of order `q` is exact for the parabola that a flight
    /// is but for terms of the relative size `(omega T)^(q-1)`.
    fn first_step(&self, method: Solver, rtol: f64) -> f64 {
        let change = self.forcing.rate().max(1.0) * self.time;
        match method {
            Solver::Tsit45 => WHOLE_FLIGHT.min(6.0 * (rtol / (change * change * change)).powf(0.2)),
            Solver::Esdirk34 => WHOLE_FLIGHT.min(6.0 * (rtol / (change * change)).powf(0.25)),
            Solver::TrBdf2 => WHOLE_FLIGHT.min(6.0 * (rtol / change).cbrt()),
            // It starts at the first order in each flight, for which the parabola itself is the error.
            Solver::Bdf => 2.0 * rtol.sqrt(),
        }
    }

    /// `u = i phi` and `u'` in the units of the problem.
    fn away_from_base(&self, chi: f64, dchi: f64) -> (f64, f64) {
        (self.i * chi * self.rotation, self.i * dchi * self.velocity)
    }
}

/// `x^(1/n)` for n = 1, 2, 3, 4.
fn root(x: f64, n: i32) -> f64 {
    match n {
        1 => x,
        2 => x.sqrt(),
        3 => x.cbrt(),
        _ => x.sqrt().sqrt(),
    }
}

/// What a step tells.
#[derive(Debug, PartialEq)]
enum Told {
    /// There is one impact in it, near this time.
    Impact(f64),
    /// There is none.
    InTheAir,
    /// The solver's event and the values at the ends of the step do not tell the same story, or not a simple one (two roots, a dip below zero):
    /// to be looked at closer.
    Unclear,
}

/// What a step tells that the solver ended for this reason, over which the rotation can change its sign so often, and that ends off the base or not.
fn told(reason: &OdeSolverStopReason<f64>, sign_changes: usize, off_base: bool) -> Told {
    match (reason, sign_changes) {
        (OdeSolverStopReason::RootFound(guess, _), 1) => Told::Impact(*guess),
        (OdeSolverStopReason::InternalTimestep | OdeSolverStopReason::TstopReached, 0) if off_base => Told::InTheAir,
        _ => Told::Unclear,
    }
}

/// How far a flight is followed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leg {
    /// For how long.
    pub lasts: f64,
    /// Whether the ground is another function from then on: a step ends there. Otherwise the last one goes over it.
    pub breaks: bool,
    /// A bound on `|f|` from the start on, by which a block is past the point of no return; none for one that is only watched.
    pub strongest: Option<f64>,
}

/// A solver that flies each flight in the units that it finds in `units`, where the equations of its problem read them too.
pub(crate) struct Rescaled<'c, 'f, S> {
    pub solver: S,
    pub units: &'c Cell<Scaled<'f>>,
    pub method: Solver,
    pub rtol: f64,
}

impl<'f, S> Rescaled<'_, 'f, S> {
    /// Starts from here, towards a time to stop at if there is one.
    fn place<'a, E: Equations + 'a>(&mut self, knot: &Knot, h: f64, stop: Option<f64>) -> Result<(), Loss>
    where
        S: OdeSolverMethod<'a, E>,
    {
        let state = self.solver.state_mut();
        (state.y[0], state.y[1]) = (knot.y, knot.dy);
        // Tsit45 takes its first stage from here, and BDF its first difference.
        (state.dy[0], state.dy[1]) = (knot.dy, knot.ddy);
        (*state.t, *state.h) = (knot.t, h);
        let Some(stop) = stop else { return Ok(()) };
        *state.h = h.min(stop - knot.t);
        self.solver.set_stop_time(stop).map_err(|_| Loss::SolverFailed)
    }

    /// Where a flight ends, with the state there: the rotation and the velocity away from the base.
    pub fn follow<'a, E: Equations + 'a>(&mut self, scaled: Scaled<'f>, leg: &Leg) -> (Outcome, (f64, f64))
    where
        S: OdeSolverMethod<'a, E>,
    {
        let start = scaled.start();
        let state = Cell::new(scaled.away_from_base(start.y, start.dy));
        let outcome = self.steps(scaled, start, leg, &state).unwrap_or_else(Outcome::Lost);
        (outcome, state.get())
    }

    /// Step by step; `state` is where it has got to.
    fn steps<'a, E: Equations + 'a>(
        &mut self,
        scaled: Scaled<'f>,
        mut from: Knot,
        leg: &Leg,
        state: &Cell<(f64, f64)>,
    ) -> Result<Outcome, Loss>
    where
        S: OdeSolverMethod<'a, E>,
    {
        self.units.set(scaled);
        let left = leg.lasts / scaled.time;
        let stop = leg.breaks.then_some(left);
        self.place(&from, scaled.first_step(self.method, self.rtol), stop)?;
        let mut halvings = 0;
        for _ in 0..MOST_STEPS {
            let reason = self.solver.step().map_err(|_| Loss::SolverFailed)?;
            let stepped = self.solver.state();
            let (t, y) = (stepped.t, stepped.y[0]);
            let to = Knot { t, y, dy: stepped.y[1], ddy: scaled.acceleration(t, y) };
            if !to.is_finite() {
                return Err(Loss::NotFinite);
            }
            if to.t <= from.t {
                return Err(Loss::Stalled);
            }
            let piece = Piece::between(&from, &to);
            let is_last = matches!(reason, OdeSolverStopReason::TstopReached);
            let end = if is_last { left } else { left.min(to.t) };
            let at_end = |(chi, dchi)| scaled.away_from_base(chi, dchi);
            match told(&reason, piece.sign_changes(), scaled.i * to.y > 0.0) {
                Told::Impact(guess) => {
                    let (xi, slope) = piece.root_near(guess);
                    let (_, du) = scaled.away_from_base(0.0, slope);
                    // Under another ground it does not fly on: what was seen to land before has landed.
                    let (interval, within) = if leg.breaks {
                        ((xi * scaled.time).min(leg.lasts), f64::INFINITY)
                    } else {
                        (xi * scaled.time, leg.lasts)
                    };
                    let outcome = Outcome::landed(interval, -du, within);
                    state.set(if matches!(outcome, Outcome::TimeIsUp) { at_end(piece.at(end)) } else { (0.0, du) });
                    return Ok(outcome);
                }
                Told::InTheAir => {}
                Told::Unclear if halvings < MOST_HALVINGS => {
                    halvings += 1;
                    self.place(&from, 0.5 * (to.t - from.t), stop)?;
                    continue;
                }
                Told::Unclear => return Err(Loss::FellThrough),
            }
            let (u, du) = at_end(piece.at(end));
            state.set((u, du));
            if leg.strongest.is_some_and(|strongest| scaled.shape.is_past_return(strongest, u, du)) {
                return Ok(Outcome::Overturned { after: end * scaled.time });
            }
            if is_last || end < to.t {
                return Ok(Outcome::TimeIsUp);
            }
            from = to;
        }
        Err(Loss::SolverFailed)
    }
}

impl<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>> Flight<'a, E> for Rescaled<'_, '_, S> {
    fn fly(&mut self, motion: &Motion, launch: &Launch, time_left: f64) -> Outcome {
        let leg = Leg { lasts: time_left, breaks: false, strongest: Some(motion.a) };
        self.follow(Scaled::of_case(motion, launch), &leg).0
    }
}

#[cfg(test)]
mod tests {
    use contract::{Case, Normalisation, Slenderness};

    use super::*;
    use crate::Equation;

    fn motions(epsilon: f64, omega: f64) -> [Motion; 2] {
        let block = Slenderness::new(0.4, Normalisation::Threshold).unwrap_or_else(|e| panic!("{e}"));
        let case = Case::from_epsilon(epsilon, omega, 0.9).unwrap_or_else(|e| panic!("{e}")).with_slenderness(block);
        [Equation::Linear, Equation::Nonlinear]
            .map(|equation| Motion::new(&case, equation).unwrap_or(None).unwrap_or_else(|| panic!("it rocks")))
    }

    /// One story from both, and a simple one.
    #[test]
    fn a_step_is_trusted_where_solver_and_values_tell_the_same() {
        let root = OdeSolverStopReason::RootFound(0.5, 0);
        for off_base in [true, false] {
            assert_eq!(told(&root, 1, off_base), Told::Impact(0.5));
            for changes in [0, 2, 3, 5] {
                assert_eq!(told(&root, changes, off_base), Told::Unclear, "{changes}");
            }
            for changes in 1..=5 {
                assert_eq!(told(&OdeSolverStopReason::InternalTimestep, changes, off_base), Told::Unclear, "{changes}");
            }
        }
        for reason in [OdeSolverStopReason::InternalTimestep, OdeSolverStopReason::TstopReached] {
            assert_eq!(told(&reason, 0, true), Told::InTheAir);
            assert_eq!(told(&reason, 0, false), Told::Unclear);
            assert_eq!(told(&reason, 1, true), Told::Unclear);
        }
    }

    fn is_near(a: f64, b: f64) -> bool {
        (a / b - 1.0).abs() < 1e-12
    }

    /// `2 |v|/|phi''|` and half of that times the speed, where nothing changes in so short a time.
    #[test]
    fn a_short_flight_has_the_units_of_its_parabola() {
        for motion in motions(0.03, 2.0) {
            for (i, tau) in [(1.0, 0.5), (-1.0, 0.8)] {
                for speed in [1e-6, 1e-40, 1e-130] {
                    let scaled = Scaled::of_case(&motion, &Launch { i, tau, rotation: 0.0, velocity: i * speed });
                    let acceleration = motion.shape.gain() * motion.excess(i, tau).abs();
                    assert!((scaled.time / (2.0 * speed / acceleration) - 1.0).abs() < 1e-4, "{i} {speed}: {scaled:?}");
                    assert!((scaled.rotation / (speed * scaled.time) - 1.0).abs() < 1e-4, "{i} {speed}: {scaled:?}");
                    assert!((scaled.start_velocity - i).abs() < 1e-4, "{i} {speed}: {scaled:?}");
                }
            }
        }
    }

    /// Jerk and snap alone: `4 sqrt(eps (2 + eps))/omega`; and where that is long, the time in which the excitation or the balance changes things.
    #[test]
    fn the_first_flight_has_the_units_of_its_jerk() {
        let first = Launch { i: -1.0, tau: 0.0, rotation: 0.0, velocity: 0.0 };
        for motions in [motions(1e-4, 0.5), motions(1e-6, 1.0)] {
            let [linear, nonlinear] = motions.map(|motion| Scaled::of_case(&motion, &first));
            let [Motion { a, omega, .. }, _] = motions;
            let epsilon = a - 1.0;
            let expected = 4.0 * (epsilon * (2.0 + epsilon)).sqrt() / omega;
            assert!((linear.time / expected - 1.0).abs() < 1e-9, "{linear:?}");
            assert!(is_near(nonlinear.time, linear.time) && linear.start_velocity == 0.0);
            // c_3 T^3 = c_4 T^4
            let jerk = linear.forcing.derivatives().0;
            assert!((linear.rotation / (jerk / 6.0 * linear.time.powi(3)) - 1.0).abs() < 1e-9, "{linear:?}");
        }
        for (epsilon, omega, longest) in [(0.8, 5.0, 0.2), (0.8, 0.3, 1.0)] {
            let [linear, nonlinear] = motions(epsilon, omega).map(|motion| Scaled::of_case(&motion, &first));
            assert!(is_near(linear.time, longest) && is_near(nonlinear.time, longest));
        }
    }

    #[test]
    fn the_equation_in_units_of_the_flight_is_that_of_the_block() {
        for motion in motions(0.2, 3.0) {
            for (i, tau, velocity) in [(-1.0, 0.0, 0.0), (1.0, 0.4, 0.05), (-1.0, 0.6, -0.3)] {
                let scaled = Scaled::of_case(&motion, &Launch { i, tau, rotation: 0.0, velocity });
                for (xi, chi) in [(0.2, 0.1), (0.7, -0.3), (1.0, 0.4)] {
                    let g = motion.forcing(i, tau).at(xi * scaled.time);
                    let unscaled = motion.shape.acceleration(i, g, chi * scaled.rotation);
                    let found = scaled.acceleration(xi, chi) * scaled.rotation / scaled.time.powi(2);
                    assert!((found - unscaled).abs() < 1e-14, "{found} {unscaled}");
                    let h = 1e-5;
                    let slope = (scaled.acceleration(xi, chi + h) - scaled.acceleration(xi, chi - h)) / (2.0 * h);
                    assert!((scaled.stiffness(xi, chi) - slope).abs() < 1e-8, "{slope}");
                    let (u, du) = scaled.away_from_base(chi, 2.0);
                    assert!((u - i * chi * scaled.rotation).abs() < 1e-15);
                    assert!((du - i * 2.0 * scaled.rotation / scaled.time).abs() < 1e-15);
                }
                let start = scaled.start();
                assert_eq!(
                    (start.t, start.y, start.dy, start.ddy),
                    (0.0, 0.0, scaled.start_velocity, scaled.acceleration(0.0, 0.0))
                );
                assert!((scaled.start_velocity * scaled.rotation / scaled.time - velocity).abs() < 1e-15);
            }
        }
    }

    /// The known root is divided out, so that a parabola and a cubic leave a straight line.
    #[test]
    fn the_event_has_the_sign_of_the_flight_until_its_end() {
        let [motion, _] = motions(0.03, 2.0);
        let later = Scaled::of_case(&motion, &Launch { i: 1.0, tau: 0.5, rotation: 0.0, velocity: 0.01 });
        let first = Scaled::of_case(&motion, &Launch { i: -1.0, tau: 0.0, rotation: 0.0, velocity: 0.0 });
        assert_eq!((later.event(0.0, 0.0), first.event(0.0, 0.0), first.event(-0.1, 5.0)), (1.0, -1.0, -1.0));
        for xi in [0.25, 0.5, 2.0] {
            assert_eq!(later.event(xi, xi * (1.0 - xi)), 1.0 - xi);
            assert_eq!(first.event(xi, -xi * xi * xi * (1.0 - xi)), xi - 1.0);
        }
    }

    /// Errors of a step of order `q` grow as its power `q + 1`; under one that is always accepted the whole flight is one step.
    #[test]
    fn the_first_step_follows_the_tolerance_and_the_change_in_a_flight() {
        let [motion, _] = motions(0.03, 2.0);
        let flight =
            |speed: f64| Scaled::of_case(&motion, &Launch { i: 1.0, tau: 0.5, rotation: 0.0, velocity: speed });
        for (method, order, change) in
            [(Solver::Tsit45, 5.0, 3.0), (Solver::Esdirk34, 4.0, 2.0), (Solver::TrBdf2, 3.0, 1.0)]
        {
            let (long, short) = (flight(1e-2), flight(1e-3));
            let step = |scaled: &Scaled, rtol: f64| scaled.first_step(method, rtol);
            let base = step(&long, 1e-13);
            let growth = step(&long, 1e-12) / base;
            assert!(is_near(growth, 10_f64.powf(1.0 / order)), "{method}: {growth}");
            let growth = step(&short, 1e-13) / base;
            assert!(is_near(growth, (long.time / short.time).powf(change / order)), "{method}: {growth}");
            // Of the order of the tolerance, and what is short enough is one step.
            let level = base / (1e-13 / (2.0 * long.time).powf(change)).powf(1.0 / order);
            assert!((3.0..12.0).contains(&level), "{method}: {level}");
            assert_eq!(step(&flight(1e-30), 1e-8), WHOLE_FLIGHT);
        }
        assert!(is_near(flight(1e-2).first_step(Solver::Bdf, 1e-8), 2e-4));
        assert_eq!((root(8.0, 1), root(9.0, 2), root(8.0, 3)), (8.0, 3.0, 2.0));
    }
}
