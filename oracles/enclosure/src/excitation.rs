//! The excitation, without the cancellation where it balances gravity.
//!
//! With `sin ψ = 1/a` (Eq. 12), `f = a sin(ωτ + ψ) = cos 2θ + q sin 2θ`, where `θ = ωτ/2` and `q = a cos ψ = sqrt(ε(2 + ε))`. Hence
//! `1 - f = 2 sin θ (sin θ - q cos θ)` and `1 + f = 2 cos θ (cos θ + q sin θ)`: products of small numbers where they are small.

use crate::{directed::Directed, functions::sin_cos, interval::Interval};

/// The constants of an excitation.
pub struct Excitation<F> {
    /// `ω`.
    pub omega: Interval<F>,
    /// `q = sqrt(ε(2 + ε))`.
    quadrature: Interval<F>,
    /// `a = 1 + ε`.
    pub amplitude: Interval<F>,
}

/// Where in its period the excitation is: the sine and the cosine of `θ = ωτ/2`.
#[derive(Clone)]
pub struct HalfPhase<F> {
    sine: Interval<F>,
    cosine: Interval<F>,
}

/// The excitation at one moment, seen from the side `i` on which the block rotates.
#[derive(Clone)]
pub struct Pull<F> {
    /// `b = 1 + i f`: what pulls the block back to its base, in units of what gravity alone does.
    pub value: Interval<F>,
    /// `b' = i f'`.
    pub slope: Interval<F>,
}

impl<F: Directed> Excitation<F> {
    /// The excitation whose amplitude is `1 + epsilon` times the threshold.
    pub fn new(epsilon: &Interval<F>, omega: f64) -> Self {
        let two = Interval::exactly(2.0);
        Self {
            omega: Interval::exactly(omega),
            quadrature: (epsilon * &(epsilon + &two)).root(),
            amplitude: epsilon + &Interval::exactly(1.0),
        }
    }

    /// The phase `interval` later. Turning the phase keeps what is small accurate, at a cost in width that is at most `exp(θ)` in all.
    pub fn later(&self, phase: &HalfPhase<F>, interval: &Interval<F>) -> HalfPhase<F> {
        let half_turn = &(&self.omega * interval) * &Interval::exactly(0.5);
        let (sine, cosine) = sin_cos(&half_turn);
        let unit = Interval::within(1.0);
        HalfPhase {
            sine: (&(&phase.sine * &cosine) + &(&phase.cosine * &sine)).and(&unit),
            cosine: (&(&phase.cosine * &cosine) - &(&phase.sine * &sine)).and(&unit),
        }
    }

    /// The pull on the side `i = +1` or `i = -1`.
    pub fn pull(&self, phase: &HalfPhase<F>, side: Side) -> Pull<F> {
        let HalfPhase { sine: s, cosine: c } = phase;
        let two = Interval::exactly(2.0);
        let q = &self.quadrature;
        let value = match side {
            Side::Minus => &(&two * s) * &(s - &(q * c)),
            Side::Plus => &(&two * c) * &(c + &(q * s)),
        };
        // f' = ω (q cos 2θ - sin 2θ)
        let rate = &self.omega * &(&(q * &(&c.squared() - &s.squared())) - &(&two * &(s * c)));
        Pull { value, slope: if side == Side::Plus { rate } else { -&rate } }
    }
}

impl<F: Directed> HalfPhase<F> {
    /// At initiation.
    pub fn start() -> Self {
        Self { sine: Interval::zero(), cosine: Interval::exactly(1.0) }
    }
}

/// `i`, the sign of the rotation in a flight.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    Plus,
    Minus,
}

impl Side {
    /// The side of the next flight.
    pub fn other(self) -> Self {
        if self == Self::Plus { Self::Minus } else { Self::Plus }
    }

    /// `±1`.
    pub fn sign(self) -> f64 {
        if self == Self::Plus { 1.0 } else { -1.0 }
    }
}
