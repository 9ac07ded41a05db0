//! Eq. 6 as it is printed, apart from the oracle: fine in doubles for flights of length O(1), and used for those only.

use contract::Case;

/// The motion between two impacts, Eq. 6 and its derivative.
pub struct Flight {
    /// `i`, the sign of the rotation.
    pub sign: f64,
    start: f64,
    /// The coefficients of `cosh` and `sinh` of the local time.
    hyperbolic: (f64, f64),
    amplitude: f64,
    omega: f64,
    psi: f64,
}

impl Flight {
    /// The flight that leaves the base with `velocity` at the time `start`.
    pub fn new(case: &Case, sign: f64, start: f64, velocity: f64) -> Self {
        let (amplitude, omega) = (case.amplitude(), case.omega());
        let psi = (1.0 / amplitude).asin(); // Eq. 12
        let mut flight = Self { sign, start, hyperbolic: (0.0, 0.0), amplitude, omega, psi };
        let (particular, rate) = flight.particular(0.0);
        flight.hyperbolic = (-sign - particular, velocity - rate);
        flight
    }

    /// The first flight of a case, from rest at initiation, `i = -1`.
    pub fn first(case: &Case) -> Self {
        Self::new(case, -1.0, 0.0, 0.0)
    }

    /// `u = i φ` and `u'` a local time `s` after the start.
    pub fn motion(&self, s: f64) -> (f64, f64) {
        let (particular, rate) = self.particular(s);
        let (a, b) = self.hyperbolic;
        let rotation = a * s.cosh() + b * s.sinh() + self.sign + particular;
        let velocity = a * s.sinh() + b * s.cosh() + rate;
        (self.sign * rotation, self.sign * velocity)
    }

    /// The motion `a sin(ωτ + ψ)/(1 + ω²)` forced by the excitation, and its derivative.
    fn particular(&self, s: f64) -> (f64, f64) {
        let (sin, cos) = (self.omega * (self.start + s) + self.psi).sin_cos();
        let size = self.amplitude / (1.0 + self.omega * self.omega);
        (size * sin, size * self.omega * cos)
    }
}

/// `n` equally spaced points inside of (0, `end`).
pub fn inside(end: f64, n: u32) -> impl Iterator<Item = f64> {
    (1..n).map(move |k| end * f64::from(k) / f64::from(n))
}
