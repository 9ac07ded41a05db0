use std::f64::consts::SQRT_2;

use super::even_flight;
use crate::compensated::Compensated;

/// The iterative procedure of the paper's section 3.3 (Steps 1-3), flight after flight, in variables that are free of `ω` and `ε`:
/// time `τ_n = (x ε^(1/2) + u ε^(3/2))/ω`, velocity `φ'_n = v ε^(3/2)/ω`.
#[derive(Debug, Clone)]
pub(crate) struct Flights {
    eta: f64,
    even_next: bool,
    x: Compensated,
    u: Compensated,
    v: f64,
}

/// One flight `n` of the procedure, and the impact `n + 1` that ended it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flight {
    /// What the flight added to `τ`.
    pub(crate) interval: Interval,
    /// `x = ω σ_{n+1;1}` of Eq. 48, at the impact.
    pub(crate) x: f64,
    /// `u = ω σ_{n+1;3}` of Eq. 48, at the impact.
    pub(crate) u: f64,
    /// `v = ω Φ_{n+1;3}^{(1)}` of Eq. 57, just after the impact.
    pub(crate) v: f64,
}

/// The one term that Eq. 65 keeps of a flight's duration.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Interval {
    /// `ω T_{n;1}` of an even flight, which goes with `ε^(1/2)`.
    Even(f64),
    /// `ω T_{n;3}` of an odd flight, which goes with `ε^(3/2)`.
    Odd(f64),
}

impl Flights {
    pub(crate) fn new(eta: f64) -> Self {
        Self { eta, even_next: true, x: Compensated::default(), u: Compensated::default(), v: 0.0 }
    }

    /// Steps 1 and 3. Step 1, Eq. 31, is the cubic of Eq. 62 at `x = v = 0`: `y = 4√2`.
    fn even(&mut self) -> Interval {
        let x = self.x.value();
        let y = if x > 0.0 { even_flight::duration(x, self.v) } else { 4.0 * SQRT_2 };
        self.v = self.eta * even_flight::velocity_at_end(x, y);
        self.x.add(y);
        Interval::Even(y)
    }

    /// Step 2, Eqs 64 and 57: `Φ_{n;0}^{(2)} = -1` for `i_n = 1`, and `T_{n;1} = 0`.
    fn odd(&mut self) -> Interval {
        let duration = self.v;
        self.v *= -self.eta;
        self.u.add(duration);
        Interval::Odd(duration)
    }
}

impl Iterator for Flights {
    type Item = Flight;

    /// Never `None`: the sequence is infinite. (The paper ends it when the cubic returns a negative root; it has a positive one always.)
    fn next(&mut self) -> Option<Flight> {
        let interval = if self.even_next { self.even() } else { self.odd() };
        self.even_next = !self.even_next;
        Some(Flight { interval, x: self.x.value(), u: self.u.value(), v: self.v })
    }
}
