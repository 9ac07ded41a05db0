//! The exact solution of `u'' = u - 1 - i f` over a stretch of local time `s`, free of cancellation however short it is.
//!
//! Eq. 6 in absolute time subtracts numbers of order 1 to get a rotation of order `v²`. Written in local time with the values
//! at the start of the stretch, the same solution is (`u₀`, `v` rotation and velocity; `b`, `j`, `k` acceleration, jerk and snap
//! of the forcing; `z = s²`)
//!
//! ```text
//! u  = u₀ cosh s + v s S(z) + b s² A(z) + j s³ C(z) + k s⁴ D(z)
//! S = Σ z^m/(2m+1)!   A = Σ z^m/(2m+2)!   C = Σ q_{m+1} z^m/(2m+3)!   D = Σ q_{m+1} z^m/(2m+4)!
//! q_1 = 1,  q_{m+1} = 1 - ω² q_m
//! ```
//!
//! which follows from `(cosh s - cos ωs)/(1 + ω²) = Σ q_m s^{2m}/(2m)!`. With `u₀ = 0`, after an impact, the factor `s` is divided
//! out exactly: `h = u/s` keeps its relative accuracy down to the smallest double. The velocity needs the same care. Eq. 68 says that
//! a flight lands with the speed it left with; what it lands with beyond that has series of its own, from `u' - 2h`,
//!
//! ```text
//! u' = 2h - v + v z P(z) + b s z Q(z) + j s² R(z) + k s³ V(z)
//! P = Σ (2m+1) z^m/(2m+3)!   Q = Σ (2m+2) z^m/(2m+4)!   R = Σ q_{m+1} (2m+1) z^m/(2m+3)!   V = Σ q_{m+1} (2m+2) z^m/(2m+4)!
//! ```
//!
//! so at the impact, `h = 0`, the small part is computed by itself and no rounding error builds up over thousands of flights.

use crate::forcing::Forcing;

/// How many terms of the series are held; enough for `max(1, ω) s` up to [`Flow::REACH`].
const TERMS: usize = 14;

/// `1/n!`.
const INVERSE_FACTORIAL: [f64; 2 * TERMS + 3] = {
    let mut table = [1.0; 2 * TERMS + 3];
    let mut factorial = 1.0;
    let mut n = 1;
    while n < table.len() {
        factorial *= n as f64;
        table[n] = 1.0 / factorial;
        n += 1;
    }
    table
};

/// The series of one `ω`.
#[derive(Debug, Clone)]
pub(crate) struct Flow {
    /// `max(1, ω)`: what a stretch is long or short against.
    rate: f64,
    /// The coefficients of `z^m`, lowest order first: of S, A, P, Q, C, D, R and V.
    rows: [[f64; 8]; TERMS],
}

/// The eight sums at one `s`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sums {
    s: f64,
    row: [f64; 8],
}

/// How a flight stands at one local time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Motion {
    /// `h = u/s`.
    pub deflated: f64,
    /// The size of the terms that `h` is the sum of.
    pub size: f64,
    /// `u'`.
    pub velocity: f64,
    /// `u' - 2h + v`, which at the impact is `u' + v`: how much slower the flight lands than it left.
    pub gain: f64,
    /// `s` times the derivative of `gain`, but for terms smaller by `(max(1, ω) s)²`.
    pub gain_slope: f64,
    /// The size of the terms that `gain` is the sum of.
    pub gain_size: f64,
}

impl Flow {
    /// The series are summed for `max(1, ω) s` up to here; their terms have fallen below 1e-17 by then.
    pub const REACH: f64 = 2.0;

    #[allow(clippy::indexing_slicing)] // all indices are below the constant length of the tables
    pub fn new(omega: f64) -> Self {
        let mut q = 1.0;
        let rows = core::array::from_fn(|m| {
            let inverse = &INVERSE_FACTORIAL[2 * m + 1..2 * m + 5];
            let (odd, even) = ((2 * m + 1) as f64, (2 * m + 2) as f64);
            let (c, d) = (q * inverse[2], q * inverse[3]);
            q = 1.0 - omega * omega * q;
            [inverse[0], inverse[1], odd * inverse[2], even * inverse[3], c, d, odd * c, even * d]
        });
        Self { rate: omega.max(1.0), rows }
    }

    /// The longest stretch that is summed at once.
    pub fn longest(&self) -> f64 {
        Self::REACH / self.rate
    }

    /// Sums the series at `s`, at most [`Flow::longest`], with no more terms than it needs.
    pub fn sums(&self, s: f64) -> Sums {
        let z = s * s;
        // What is left out is of order x^(2 terms)/(2 terms + 1)! relative to 1, below 1e-16 at the right end of each range.
        let terms = match self.rate * s {
            x if x < 1e-8 => 1,
            x if x < 3e-4 => 2,
            x if x < 6e-3 => 3,
            x if x < 0.1 => 5,
            x if x < 0.5 => 8,
            x if x < 1.1 => 10,
            _ => TERMS,
        };
        let mut row = [0.0; 8];
        for coefficients in self.rows.iter().take(terms).rev() {
            for (sum, coefficient) in row.iter_mut().zip(coefficients) {
                *sum = *sum * z + coefficient;
            }
        }
        Sums { s, row }
    }
}

impl Sums {
    /// The motion of a flight that left the base with `velocity`, at this local time.
    pub fn after_impact(&self, velocity: f64, forcing: &Forcing) -> Motion {
        let [s1, s2, p, q, c, d, r, v] = self.row;
        let Self { s, .. } = *self;
        let Forcing { acceleration, jerk, snap, .. } = *forcing;
        let free = (velocity * s1, s * acceleration * s2);
        let forced = (jerk * c, s * snap * d);
        let deflated = free.0 + (free.1 + s * s * (forced.0 + forced.1));
        let gains = (velocity * p, s * acceleration * q, jerk * r, s * snap * v);
        let (square, cube) = (gains.0 + gains.2, gains.1 + gains.3);
        let gain = s * s * (square + cube);
        Motion {
            deflated,
            size: free.0.abs() + free.1.abs() + s * s * (forced.0.abs() + forced.1.abs()),
            velocity: (2.0 * deflated - velocity) + gain,
            gain,
            gain_slope: s * s * (2.0 * square + 3.0 * cube),
            gain_size: s * s * (gains.0.abs() + gains.1.abs() + (gains.2.abs() + gains.3.abs())),
        }
    }

    /// The rotation and velocity a stretch later, from those at its start.
    pub fn advance(&self, (rotation, velocity): (f64, f64), forcing: &Forcing) -> (f64, f64) {
        let [s1, s2, _, _, c, d, _, _] = self.row;
        let Self { s, .. } = *self;
        let Forcing { acceleration, jerk, snap, .. } = *forcing;
        let (sinh, cosh) = (s * s1, self.cosh());
        let tilt = self.tilt(forcing);
        let driven = s * s * (acceleration * s2 + s * (jerk * c + s * snap * d));
        (rotation * cosh + velocity * sinh + driven, rotation * sinh + velocity * cosh + acceleration * sinh + tilt)
    }

    /// `cosh s = 2S - 1 + zP`.
    pub fn cosh(&self) -> f64 {
        let [s1, _, p, ..] = self.row;
        2.0 * s1 - 1.0 + self.s * self.s * p
    }

    /// `sinh s`.
    pub fn sinh(&self) -> f64 {
        let [s1, ..] = self.row;
        self.s * s1
    }

    /// `j s² E + k s³ C`, with `E = Σ q_{m+1} z^m/(2m+2)! = 2C + R`: what the change of the forcing adds to the velocity, and
    /// how far the rotation moves when the start moves in time.
    pub fn tilt(&self, forcing: &Forcing) -> f64 {
        let [_, _, _, _, c, _, r, _] = self.row;
        self.s * self.s * (forcing.jerk * (2.0 * c + r) + self.s * forcing.snap * c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Eq. 6 and its derivative as printed, in local time: fine when `s` is of order 1.
    fn eq_6(omega: f64, s: f64, (u0, v): (f64, f64), forcing: &Forcing) -> (f64, f64) {
        let Forcing { acceleration, jerk, snap, .. } = *forcing;
        // the forcing -1 - i f(s) = m + c cos(ωs) + d sin(ωs)
        let (c, d) = (-snap / (omega * omega), jerk / omega);
        let (mean, scale) = (acceleration - c, 1.0 / (1.0 + omega * omega));
        let (sin, cos) = (omega * s).sin_cos();
        let particular = (-mean - scale * (c * cos + d * sin), scale * omega * (c * sin - d * cos));
        let at_start = (u0 + mean + scale * c, v + scale * omega * d);
        (
            particular.0 + at_start.0 * s.cosh() + at_start.1 * s.sinh(),
            particular.1 + at_start.0 * s.sinh() + at_start.1 * s.cosh(),
        )
    }

    #[test]
    fn the_series_are_eq_6() {
        let forcing = Forcing { acceleration: -0.7, jerk: 0.4, snap: -1.3, rounding: (0.0, 0.0) };
        for omega in [0.3f64, 1.0, 2.0, 8.0] {
            let flow = Flow::new(omega);
            for x in [0.3, 0.7, 1.5, 2.0] {
                let s = x / omega.max(1.0);
                let sums = flow.sums(s);
                let expected = eq_6(omega, s, (0.2, 0.5), &forcing);
                let found = sums.advance((0.2, 0.5), &forcing);
                assert_relative_eq!(found.0, expected.0, max_relative = 1e-13);
                assert_relative_eq!(found.1, expected.1, max_relative = 1e-13);
                let expected = eq_6(omega, s, (0.0, 0.5), &forcing);
                let motion = sums.after_impact(0.5, &forcing);
                assert_relative_eq!(motion.deflated * s, expected.0, max_relative = 1e-13);
                assert_relative_eq!(motion.velocity, expected.1, max_relative = 1e-13);
            }
        }
    }

    #[test]
    fn fewer_terms_for_a_short_stretch_change_nothing() {
        for omega in [0.5f64, 3.0, 20.0] {
            let flow = Flow::new(omega);
            for x in [0.9e-8, 2.9e-4, 5.9e-3, 0.099, 0.499, 1.09] {
                let s = x / omega.max(1.0);
                let short = flow.sums(s).row;
                for (column, found) in short.into_iter().enumerate() {
                    let full = flow.rows.iter().rev().fold(0.0, |sum, row| sum * s * s + row[column]);
                    assert_relative_eq!(found, full, max_relative = 4e-16);
                }
            }
        }
    }
}
