//! One flight in its own units: `tau = tau_n + T xi`, `phi = P chi`, so that every flight is a problem of order one, however short.

use core::cell::Cell;

use contract::{Ending, Loss};
use diffsol::{OdeSolverMethod, OdeSolverStopReason};

use crate::Method;
use crate::equation::{Forcing, Motion};
use crate::piece::{Knot, Piece};
use crate::run::{Equations, Flight, Launch, Outcome};

/// More steps than any flight takes at any tolerance allowed; it bounds the work when something is wrong.
const MOST_STEPS: usize = 100_000;
/// How often a step may be halved because it is in doubt what happened inside.
const MOST_HALVINGS: usize = 60;
/// The first step when the whole flight is one: a little more than the estimated length, to see its end.
const WHOLE_FLIGHT: f64 = 1.05;

/// The equation of motion of one flight, in its own units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scaled {
    motion: Motion,
    forcing: Forcing,
    i: f64,
    /// The unit of time, `T`.
    pub time: f64,
    /// The unit of rotation, `P`.
    pub rotation: f64,
    /// `P/T`.
    velocity: f64,
    /// `T^2/P`.
    per_acceleration: f64,
    /// `chi'(0)`: about `i`, or 0 in the first flight.
    start_velocity: f64,
}

impl Scaled {
    /// Units for the flight that starts as `launch` says.
    ///
    /// With `c_k = i phi^(k)/k!` the coefficients of the rotation away from the base, a coefficient that points back balances one that
    /// points away after the time `(c_j/|c_k|)^(1/(k-j))`. `T` is the first time at which some `c_k < 0` balances all those before it:
    /// `2 |v|/|phi''|` for an ordinary flight, `4 sqrt(eps (2 + eps))/omega` for the first (where only jerk and snap are left), and
    /// otherwise no more than the time in which the excitation or the unstable equilibrium change things.
    pub fn new(motion: &Motion, launch: &Launch) -> Self {
        let Launch { i, tau, velocity } = *launch;
        let forcing = motion.forcing(i, tau);
        let (slope, curvature) = forcing.derivatives();
        // The derivatives of Eq. 4 at phi = 0, with the gain of Eq. 2: the estimate need not be better than that.
        let gain = motion.gain();
        let second = -gain * forcing.excess;
        let third = velocity - gain * slope;
        let fourth = second - gain * curvature;
        let c = [(1, i * velocity), (2, i * second / 2.0), (3, i * third / 6.0), (4, i * fourth / 24.0)];
        let balance = |&(k, ck): &(i32, f64)| {
            let times = c.iter().filter(|&&(j, cj)| j < k && cj > 0.0).map(|&(j, cj)| root(cj / -ck, k - j));
            times.fold(0.0, f64::max)
        };
        let returning = c.iter().filter(|&&(_, ck)| ck < 0.0).map(balance).filter(|&t| t > 0.0);
        let time = returning.fold(1.0 / motion.omega.max(1.0), f64::min);
        let rotation = c.iter().map(|&(k, ck)| ck.abs() * time.powi(k)).fold(0.0, f64::max);
        Self {
            motion: *motion,
            forcing,
            i,
            time,
            rotation,
            velocity: rotation / time,
            per_acceleration: time / rotation * time,
            start_velocity: velocity / rotation * time,
        }
    }

    /// `d^2 chi/d xi^2`.
    #[inline]
    pub fn acceleration(&self, xi: f64, chi: f64) -> f64 {
        let g = self.forcing.at(self.time * xi);
        self.motion.acceleration(self.i, g, self.rotation * chi) * self.per_acceleration
    }

    /// The derivative of [`Self::acceleration`] by `chi`.
    pub fn stiffness(&self, xi: f64, chi: f64) -> f64 {
        let g = self.forcing.at(self.time * xi);
        self.motion.stiffness(self.i, g, self.rotation * chi) * self.time * self.time
    }

    /// The function whose sign the solver watches: the rotation with its known root at `xi = 0` divided out, simple after an impact and
    /// triple in the first flight. So the start of a flight is no event, and a step over the whole flight is one.
    #[inline]
    pub fn event(&self, xi: f64, chi: f64) -> f64 {
        if xi <= 0.0 {
            self.i
        } else if self.start_velocity != 0.0 {
            chi / xi
        } else {
            chi / (xi * xi * xi)
        }
    }

    fn start(&self) -> Knot {
        Knot { t: 0.0, y: 0.0, dy: self.start_velocity, ddy: self.acceleration(0.0, 0.0) }
    }

    /// A first step that the error test is likely to accept. The embedded method of order `q` is exact for the parabola that a flight
    /// is but for terms of the relative size `(omega T)^(q-1)`.
    fn first_step(&self, method: Method, rtol: f64) -> f64 {
        let change = self.motion.omega.max(1.0) * self.time;
        match method {
            Method::Tsit45 => WHOLE_FLIGHT.min(6.0 * (rtol / (change * change * change)).powf(0.2)),
            Method::Esdirk34 => WHOLE_FLIGHT.min(6.0 * (rtol / (change * change)).powf(0.25)),
            Method::TrBdf2 => WHOLE_FLIGHT.min(6.0 * (rtol / change).cbrt()),
            // It starts at the first order in each flight, for which the parabola itself is the error.
            Method::Bdf => 2.0 * rtol.sqrt(),
        }
    }

    /// `u = i phi` and `u'` in the units of the problem.
    fn away_from_base(&self, chi: f64, dchi: f64) -> (f64, f64) {
        (self.i * chi * self.rotation, self.i * dchi * self.velocity)
    }
}

/// `x^(1/n)` for n = 1, 2, 3.
fn root(x: f64, n: i32) -> f64 {
    match n {
        1 => x,
        2 => x.sqrt(),
        _ => x.cbrt(),
    }
}

/// A solver that flies each flight in the units that it finds in `units`, where the equations of its problem read them too.
pub(crate) struct Rescaled<'c, S> {
    pub solver: S,
    pub units: &'c Cell<Scaled>,
    pub motion: Motion,
    pub method: Method,
    pub rtol: f64,
}

impl<S> Rescaled<'_, S> {
    fn place<'a, E: Equations + 'a>(&mut self, knot: &Knot, h: f64)
    where
        S: OdeSolverMethod<'a, E>,
    {
        let state = self.solver.state_mut();
        (state.y[0], state.y[1]) = (knot.y, knot.dy);
        // Tsit45 takes its first stage from here, and BDF its first difference.
        (state.dy[0], state.dy[1]) = (knot.dy, knot.ddy);
        (*state.t, *state.h) = (knot.t, h);
    }
}

impl<'a, E: Equations + 'a, S: OdeSolverMethod<'a, E>> Flight<'a, E> for Rescaled<'_, S> {
    fn fly(&mut self, launch: &Launch, time_left: f64) -> Outcome {
        let scaled = Scaled::new(&self.motion, launch);
        self.units.set(scaled);
        let mut from = scaled.start();
        self.place(&from, scaled.first_step(self.method, self.rtol));
        let mut halvings = 0;
        for _ in 0..MOST_STEPS {
            let Ok(reason) = self.solver.step() else {
                return Outcome::Ended(Ending::Lost(Loss::SolverFailed));
            };
            let state = self.solver.state();
            let (t, y) = (state.t, state.y[0]);
            let to = Knot { t, y, dy: state.y[1], ddy: scaled.acceleration(t, y) };
            if !to.is_finite() {
                return Outcome::Ended(Ending::Lost(Loss::NotFinite));
            }
            if to.t <= from.t {
                return Outcome::Ended(Ending::Lost(Loss::Stalled));
            }
            let piece = Piece::between(&from, &to);
            match (reason, piece.sign_changes()) {
                (OdeSolverStopReason::RootFound(guess, _), 1) => {
                    let (xi, slope) = piece.root_near(guess);
                    let (_, du) = scaled.away_from_base(0.0, slope);
                    return Outcome::landed(xi * scaled.time, -du, time_left);
                }
                (OdeSolverStopReason::InternalTimestep, 0) if scaled.i * to.y > 0.0 => {}
                // The solver's event and the values at the ends of the step do not tell the same story, or not a simple one
                // (two roots, a dip below zero): go back and look closer.
                _ if halvings < MOST_HALVINGS => {
                    halvings += 1;
                    self.place(&from, 0.5 * (to.t - from.t));
                    continue;
                }
                _ => return Outcome::Ended(Ending::Lost(Loss::FellThrough)),
            }
            let end = (time_left / scaled.time).min(to.t);
            let (chi, dchi) = piece.at(end);
            let (u, du) = scaled.away_from_base(chi, dchi);
            if self.motion.is_past_return(u, du) {
                return Outcome::Ended(Ending::Overturned);
            }
            if end < to.t {
                return Outcome::TimeIsUp;
            }
            from = to;
        }
        Outcome::Ended(Ending::Lost(Loss::SolverFailed))
    }
}
