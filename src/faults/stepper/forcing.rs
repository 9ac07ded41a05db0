//! The excitation as the stepper computes it.

use contract::Case;

use super::Wrong;
use crate::measure::clock::Sum;

/// `f = a sin(ωτ + ψ)` as `cos ωτ + q sin ωτ`, `q = a cos ψ` (Eq. 24), and the faults in it.
pub(super) struct Excitation {
    pub omega: f64,
    pub amplitude: f64,
    /// `a cos ψ`.
    quadrature: f64,
    /// What the faults in Eq. 8 multiply the forcing by.
    scale: f64,
    /// What is left of its derivatives in a flight.
    change: f64,
}

/// `g = -1 - i f` and its first two derivatives, and `f`, `f'` themselves.
#[derive(Clone, Copy)]
pub(super) struct Pull {
    pub pull: [f64; 3],
    pub forcing: (f64, f64),
}

impl Excitation {
    pub(super) fn new(case: &Case, wrong: &Wrong) -> Self {
        let (epsilon, omega) = (case.epsilon(), case.omega());
        let squared = omega * omega + 1.0;
        Self {
            omega,
            amplitude: 1.0 + epsilon,
            quadrature: (epsilon * (2.0 + (1.0 - wrong.square) * epsilon)).sqrt() * (1.0 - 2.0 * wrong.quadrant),
            scale: (1.0 - wrong.forcing) * (squared / (squared - 2.0 * wrong.denominator)),
            change: 1.0 - wrong.change,
        }
    }

    /// Sine and cosine of half the phase since initiation.
    pub(super) fn half(&self, time: Sum) -> (f64, f64) {
        let phase = time.times(0.5 * self.omega);
        let (sin, cos) = phase.high.sin_cos();
        (sin + phase.low * cos, cos - phase.low * sin)
    }

    /// The pull on the side `i = side`. In half angles `f - 1` and `f + 1` factor, and neither cancels.
    pub(super) fn pull(&self, side: f64, time: Sum) -> Pull {
        let (sin, cos) = self.half(time);
        let q = self.quadrature;
        let honest = if side < 0.0 { 2.0 * sin * (q * cos - sin) } else { -2.0 * cos * (cos + q * sin) };
        let f = -side * (1.0 + honest);
        let rate = self.omega * (q * (cos - sin) * (cos + sin) - 2.0 * sin * cos) * self.scale * self.change;
        let bend = self.omega * self.omega * f * self.scale * self.change;
        Pull {
            pull: [honest + side * (1.0 - self.scale) * f, -side * rate, side * bend],
            forcing: (f * self.scale, rate),
        }
    }

    /// Whether a window after an impact that is left with `speed` is sure to hold all flights that follow: in 0.4 of the time that the weaker
    /// pull needs to vanish at its fastest, pulls stay above 0.6 of what they are, and the flights, each at most `2v/(0.6 pull)` long, sum to less.
    pub(super) fn holds_down(&self, time: Sum, speed: f64, eta: f64) -> bool {
        let [one, two] = [-1.0, 1.0].map(|side| {
            let [pull, ..] = self.pull(side, time).pull;
            -pull
        });
        let window = 0.4 * one.min(two) / (self.omega * self.amplitude + 2.0 * speed);
        // 1.4 is more than what the changing pull can add to the speeds.
        let flights = 1.4 * speed * 2.0 / (0.6 * (1.0 - eta * eta)) * (1.0 / one + 1.0 / two);
        one > 0.0 && two > 0.0 && flights <= window
    }
}
