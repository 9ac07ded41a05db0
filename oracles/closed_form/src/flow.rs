//! The exact solution of `u'' = u - 1 - i f` over a stretch of local time `s`, free of cancellation however short it is.
//!
//! Eq. 6 in absolute time subtracts numbers of order 1 to get a rotation of order `v²`. In local time the same solution is its
//! Taylor series. The equation itself gives every derivative at the start from the first few (`v` velocity, `c` acceleration; `j`,
//! `k` jerk and snap of the forcing; the next derivatives of the forcing are `-ω² j`, `-ω² k`, `ω⁴ j`, ...):
//!
//! ```text
//! u^(2m+1) = v + q_m j   u^(2m+2) = c + q_m k   q_0 = 0,  q_{m+1} = 1 - ω² q_m
//! u = u₀ + v s + c s²/2 + s³ (O(z) + s E(z))   z = s²
//! O = Σ u^(2m+1)/(2m+1)! z^(m-1)   E = Σ u^(2m+2)/(2m+2)! z^(m-1)   from m = 1
//! ```
//!
//! After an impact `u₀ = 0`, and the factor `s` is divided out exactly: `h = u/s` keeps its relative accuracy down to the smallest
//! double. The velocity needs the same care. Eq. 68 says that a flight lands with the speed it left with; what it lands with beyond
//! that is small, and is summed by itself:
//!
//! ```text
//! loss = u' - 2h + v = z (O + 2z O' + s (2E + 2z E'))
//! s h' = loss - v + h
//! s² h'' = s loss' = z (2O + 10z O' + 4z² O'' + s (6E + 14z E' + 4z² E''))
//! ```
//!
//! so at the impact, `h = 0`, no rounding error builds up over thousands of flights.

use crate::{dual::Scalar, forcing::Forcing};

/// How many terms of `O` and `E` are held.
const TERMS: usize = 11;

/// How many terms are enough up to which `max(1, ω) s`; beyond, all are summed. The first term left out of `loss` is of order
/// `6 (2n+1)/(2n+3)! x^(2n)` relative to what is kept, and below 1e-16. Few ranges, as each is a branch that may be mispredicted.
const FEW: (usize, f64) = (3, 9e-3);
const SOME: (usize, f64) = (6, 0.32);

/// The coefficients of `z^(m-1)`, each for `O` and for `E`.
#[derive(Debug, Clone, Copy)]
struct Row<T> {
    /// `1/(2m+1)!` and `1/(2m+2)!`, of `v` and of `c`.
    free: [f64; 2],
    /// The same times `q_m`, of `j` and of `k`.
    forced: [T; 2],
}

/// The series of one `ω`.
#[derive(Debug, Clone)]
pub(crate) struct Flow<T> {
    /// `max(1, ω)`: what a stretch is long or short against.
    rate: f64,
    /// The coefficients, lowest order first.
    rows: [Row<T>; TERMS],
}

/// `O` and `E` at one `s`, with their derivatives.
#[derive(Debug, Clone, Copy)]
struct Sums<T> {
    value: [T; 2],
    slope: [T; 2],
    /// Half the second derivative.
    bend: [T; 2],
}

/// How a flight stands at one local time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Motion<T> {
    /// `h = u/s`.
    pub deflated: T,
    /// `s h'`.
    pub slope: T,
    /// `s² h''`, which is `s` times the derivative of the loss.
    pub bend: T,
    /// `u' - 2h + v`, which at the impact is `u' + v`: how much slower the flight lands than it left.
    pub loss: T,
}

/// The series are summed for `max(1, ω) s` up to here.
const REACH: f64 = 2.0;

impl<T: Scalar> Flow<T> {
    pub fn new(omega: T) -> Self {
        let (mut q, mut inverse_factorial) = (T::from(1.0), 0.5); // q_1, 1/2!
        let rows = core::array::from_fn(|index| {
            let n = (2 * index + 3) as f64;
            let free = [inverse_factorial / n, inverse_factorial / (n * (n + 1.0))];
            let forced = free.map(|coefficient| q.scaled(coefficient));
            q = T::from(1.0) - omega * omega * q;
            [_, inverse_factorial] = free;
            Row { free, forced }
        });
        Self { rate: omega.value().max(1.0), rows }
    }

    /// The longest stretch that is summed at once.
    pub fn longest(&self) -> f64 {
        REACH / self.rate
    }

    /// The motion `s` after leaving the base with `velocity`. Inlined, with what it calls: that nothing passes through memory is
    /// worth a tenth of the time of a flight.
    #[inline(always)]
    pub fn after_impact(&self, s: T, velocity: T, forcing: &Forcing<T>) -> Motion<T> {
        Motion::after_impact(s, velocity, forcing, self.sums(s, [velocity, forcing.acceleration], forcing))
    }

    /// The rotation and velocity a stretch later, from those at its start.
    pub fn advance(&self, s: T, (rotation, velocity): (T, T), forcing: &Forcing<T>) -> (T, T) {
        let acceleration = rotation + forcing.acceleration;
        let Sums { value: [o, e], slope: [o1, e1], .. } = self.sums(s, [velocity, acceleration], forcing);
        let z = s * s;
        (
            rotation + s * (velocity + (s.scaled(0.5) * acceleration + z * (o + s * e))),
            velocity
                + (s * acceleration
                    + z * ((o.scaled(3.0) + z.scaled(2.0) * o1) + s * (e.scaled(4.0) + z.scaled(2.0) * e1))),
        )
    }

    /// `O`, `E` and their derivatives, from `[v, c]` and the forcing.
    #[inline(always)]
    fn sums(&self, s: T, start: [T; 2], forcing: &Forcing<T>) -> Sums<T> {
        match self.rate * s.value() {
            x if x < FEW.1 => self.first_terms::<{ FEW.0 }>(s, start, forcing),
            x if x < SOME.1 => self.first_terms::<{ SOME.0 }>(s, start, forcing),
            _ => self.first_terms::<TERMS>(s, start, forcing),
        }
    }

    /// The sums of the first `N` terms, by Horner's rule.
    #[inline(always)]
    fn first_terms<const N: usize>(&self, s: T, [v, c]: [T; 2], forcing: &Forcing<T>) -> Sums<T> {
        let Forcing { jerk, snap, .. } = *forcing;
        let z = s * s;
        let zero = [T::from(0.0); 2];
        let (mut value, mut slope, mut bend) = (zero, zero, zero);
        for Row { free, forced } in self.rows.iter().take(N).rev() {
            let [odd, even] = [v.scaled(free[0]) + forced[0] * jerk, c.scaled(free[1]) + forced[1] * snap];
            bend = [bend[0] * z + slope[0], bend[1] * z + slope[1]];
            slope = [slope[0] * z + value[0], slope[1] * z + value[1]];
            value = [value[0] * z + odd, value[1] * z + even];
        }
        Sums { value, slope, bend }
    }
}

impl<T: Scalar> Motion<T> {
    #[inline]
    fn after_impact(s: T, velocity: T, forcing: &Forcing<T>, sums: Sums<T>) -> Self {
        let Sums { value: [o, e], slope: [o1, e1], bend: [o2, e2] } = sums;
        let z = s * s;
        let deflated = velocity + (s.scaled(0.5) * forcing.acceleration + z * (o + s * e));
        let loss = z * ((o + z.scaled(2.0) * o1) + s.scaled(2.0) * (e + z * e1));
        let bend = z
            * ((o.scaled(2.0) + z * (o1.scaled(10.0) + z.scaled(8.0) * o2))
                + s * (e.scaled(6.0) + z * (e1.scaled(14.0) + z.scaled(8.0) * e2)));
        Self { deflated, slope: (deflated - velocity) + loss, bend, loss }
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
                let expected = eq_6(omega, s, (0.2, 0.5), &forcing);
                let found = flow.advance(s, (0.2, 0.5), &forcing);
                assert_relative_eq!(found.0, expected.0, max_relative = 1e-13);
                assert_relative_eq!(found.1, expected.1, max_relative = 1e-13);
                let expected = eq_6(omega, s, (0.0, 0.5), &forcing);
                let motion = flow.after_impact(s, 0.5, &forcing);
                assert_relative_eq!(motion.deflated * s, expected.0, max_relative = 1e-13);
                assert_relative_eq!(motion.slope + motion.deflated, expected.1, max_relative = 1e-13);
            }
        }
    }

    /// `h`, `s h'`, `s² h''` and the loss from `u`, `u'`, `u''` of Eq. 6, of which they are what is left of a quotient by `s`.
    #[test]
    fn slope_bend_and_loss_are_those_of_eq_6() {
        let forcing = Forcing { acceleration: -0.7, jerk: 0.4, snap: -1.3, rounding: (0.0, 0.0) };
        for omega in [0.3f64, 1.0, 2.0, 8.0] {
            let flow = Flow::new(omega);
            for x in [0.7, 1.5, 2.0] {
                let s = x / omega.max(1.0);
                let (u, rate) = eq_6(omega, s, (0.0, 0.5), &forcing);
                let (sin, cos) = (omega * s).sin_cos();
                let second = u - 0.7 + 0.4 * sin / omega - 1.3 * (1.0 - cos) / (omega * omega);
                let motion = flow.after_impact(s, 0.5, &forcing);
                assert_relative_eq!(motion.slope, rate - u / s, epsilon = 1e-14);
                assert_relative_eq!(motion.loss, rate - 2.0 * u / s + 0.5, epsilon = 1e-14);
                assert_relative_eq!(motion.bend, s * second - 2.0 * (rate - u / s), epsilon = 1e-13);
            }
        }
    }

    /// The number of terms is what the length asks for: 3 below 0.009, 6 below 0.32, all from there on.
    #[test]
    fn no_more_terms_are_summed_than_the_length_asks_for() {
        let forcing = Forcing { acceleration: -0.7, jerk: 0.4, snap: -1.3, rounding: (0.0, 0.0) };
        let flow = Flow::new(1.0);
        let bits = |sums: Sums<f64>| [sums.value, sums.slope, sums.bend].map(|of| of.map(f64::to_bits));
        let start = [0.5, forcing.acceleration];
        let (mut differ_at_three, mut differ_at_six) = (0, 0);
        for k in 0..=100 {
            let shorten = 1.0 - 0.005 * f64::from(k);
            let [short, middle] = [shorten * FEW.1, shorten * SOME.1];
            let three = bits(flow.first_terms::<3>(short, start, &forcing));
            let six = [short, middle].map(|s| bits(flow.first_terms::<6>(s, start, &forcing)));
            let all = bits(flow.first_terms::<TERMS>(middle, start, &forcing));
            let found = [short, middle].map(|s| bits(flow.sums(s, start, &forcing)));
            // The limit itself belongs to the longer stretches.
            assert_eq!(found, if k == 0 { [six[0], all] } else { [three, six[1]] });
            differ_at_three += usize::from(three != six[0]);
            differ_at_six += usize::from(six[1] != all);
        }
        assert!(differ_at_three > 10 && differ_at_six > 10, "{differ_at_three}, {differ_at_six}");
    }

    #[test]
    fn fewer_terms_for_a_short_stretch_change_nothing() {
        let forcing = Forcing { acceleration: -0.7, jerk: 0.4, snap: -1.3, rounding: (0.0, 0.0) };
        for omega in [0.5f64, 3.0, 20.0] {
            let flow = Flow::new(omega);
            for x in [FEW.1, SOME.1] {
                let s = 0.999 * x / omega.max(1.0);
                let short = flow.after_impact(s, 0.25 * s, &forcing);
                let all = flow.first_terms::<TERMS>(s, [0.25 * s, forcing.acceleration], &forcing);
                let full = Motion::after_impact(s, 0.25 * s, &forcing, all);
                assert_relative_eq!(short.deflated, full.deflated, epsilon = 4e-16 * s, max_relative = 4e-16);
                assert_relative_eq!(short.loss, full.loss, max_relative = 4e-16);
            }
        }
    }

    /// `1/n!`, rounded once: exact integers up to 24! fit 128 bits, and the double nearest to them is divided into 1.
    fn inverse_factorial(n: usize) -> f64 {
        1.0 / (1..=n as u128).product::<u128>() as f64
    }

    /// Every coefficient by itself, as the sum of all may hide an error of one: `1/(2m+1)!` and `1/(2m+2)!`, and times `q_m = (1 - (-ω²)^m)/(1 + ω²)`.
    #[test]
    fn every_coefficient_is_right_to_its_last_digits() {
        for omega in [0.01f64, 0.5, 2.0, 8.0, 200.0] {
            let square = omega * omega;
            for (index, Row { free, forced }) in Flow::new(omega).rows.into_iter().enumerate() {
                let m = index + 1;
                // Σ (-ω²)^k, k < m: where all are of a size they are few.
                let q = (0..m as i32).rev().fold(0.0, |sum, k| sum + (-square).powi(k));
                for (which, n) in [2 * m + 1, 2 * m + 2].into_iter().enumerate() {
                    assert_relative_eq!(free[which], inverse_factorial(n), max_relative = 4e-15);
                    assert_relative_eq!(forced[which], q * inverse_factorial(n), max_relative = 1e-14);
                }
            }
        }
    }
}
