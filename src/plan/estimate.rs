//! What each method would get wrong, predicted from the numbers of the case alone.

use contract::Case;

use crate::{measure::critical, motion::linearisation::parameter, panel};

/// The parts of a relative error of the chattering time.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Errors {
    /// From solving another equation of motion than the one that is asked for.
    pub model: f64,
    /// From ending a series or a sum early.
    pub truncation: f64,
    /// From steps and rounding of the method.
    pub discretisation: f64,
    /// From the rounding of the case's own numbers.
    pub conditioning: f64,
}

impl Errors {
    /// All parts together.
    pub fn total(&self) -> f64 {
        self.model + self.truncation + self.discretisation + self.conditioning
    }
}

/// How near a case is to its critical amplitude, and what follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// `ε`, the distance to the threshold.
    pub epsilon: f64,
    /// `ω`.
    pub omega: f64,
    /// `r = (a - 1)/(a_cr - 1)`, of the linear model.
    pub share: f64,
    /// `(1 - r)^(β-1)`: how much more the chattering time answers to a change of the case than far below `a_cr`. Infinite from `a_cr` on.
    pub amplification: f64,
}

/// The relative linearisation error of the chattering time is `C α² ε/ω² (1 - r)^(β-1)`: the rotation that the two models disagree about is of the order
/// of `ε/ω²`, and towards `a_cr` its effect grows as that of any change does. `C` was 0.18 to 0.37 for every `η` from 0.5 to 0.97, `ω` from 0.5 to 8 and `r`
/// from 0.01 to 0.999 (`tests/motion/plan.rs` measures it against the enclosure); this is above all of them.
const LINEARISATION: f64 = 0.4;

/// The range in which that was measured, of `ω` and of `η`.
pub const MEASURED: [std::ops::RangeInclusive<f64>; 2] = [0.5..=8.0, 0.5..=0.97];

/// What is left of it where each flight is corrected to first order ([`Flights`](crate::motion::linearisation::Flights)) is
/// at most `C μ² ε²/ω² (1 + 1/ω²) (1 - r)^(β-1)` with `μ = 2(1/cos α - 1)`: a second order of the rotation, and of the slenderness. Calibrated, and measured against
/// the enclosure by `tests/motion/plan.rs`.
const SECOND_ORDER: f64 = 0.4;

/// What the quadrature leaves of the first order: three times what its rules are good to.
const QUADRATURE: f64 = 3e-6;

/// The interpolant of the critical amplitude is good to far less than this of `a_cr - 1`.
const NEXT_TO: f64 = 1e-9;

/// The unit round-off.
const UNIT: f64 = 0.5 * f64::EPSILON;

impl Place {
    /// The place of a case; `None` outside of the range in which the critical amplitude is interpolated and the errors were measured.
    pub fn of(case: &Case) -> Option<Self> {
        let (epsilon, omega, eta) = (case.epsilon(), case.omega(), case.eta());
        let [omegas, etas] = MEASURED;
        if !(omegas.contains(&omega) && etas.contains(&eta)) {
            return None;
        }
        let share = epsilon / critical::interpolated(omega, eta).ok()?;
        let exponent = panel::approach_exponent(eta);
        let amplification = if share < 1.0 { (1.0 - share).powf(exponent - 1.0) } else { f64::INFINITY };
        Some(Self { epsilon, omega, share, amplification })
    }

    /// The relative linearisation error for the slenderness `alpha`.
    pub fn linearisation(&self, alpha: f64) -> f64 {
        LINEARISATION * alpha * alpha * self.epsilon / (self.omega * self.omega) * self.amplification
    }

    /// What is left of it when its first order in `α²` is put back, flight by flight.
    pub fn second_order(&self, alpha: f64) -> f64 {
        let (mu, height) = (parameter(alpha), self.epsilon / self.omega);
        let second = mu * height * mu * height * (1.0 + 1.0 / (self.omega * self.omega));
        SECOND_ORDER * second * self.amplification + QUADRATURE * self.linearisation(alpha)
    }

    /// Whether it is so near to `a_cr` of the linear model, on either side, that the critical amplitude of the nonlinear model may be on its other side.
    ///
    /// Near `a_cr` `1 - τ/(T/2) ~ K (1 - r)^β` with `K β` of the order 1, so what changes `τ` by the part `e (1 - r)^(β-1)` of it changes `r` by `e`.
    pub fn is_near(&self, alpha: f64) -> bool {
        let shift = LINEARISATION * alpha * alpha * self.epsilon / (self.omega * self.omega);
        (self.share - 1.0).abs() <= (4.0 * shift).max(NEXT_TO)
    }

    /// The relative error from numbers of the case that are off by `rounding` (of `ε`, relative).
    pub fn conditioning(&self, rounding: f64) -> f64 {
        self.amplification * (rounding + UNIT)
    }

    /// The relative truncation error of the series of the chattering time after `terms` terms. Its coefficients fall about as those of a
    /// singularity of the power `β = 3/5`, `c_k/c_{k-1} = (k - 3/5)/((k + 1)(a_cr - 1))`, so what is left out is below a geometric series.
    pub fn series(&self, terms: usize) -> f64 {
        let k = terms as f64;
        0.45 * k.powf(-1.6) * self.share.powf(k) / (1.0 - self.share).max(0.0)
    }
}
