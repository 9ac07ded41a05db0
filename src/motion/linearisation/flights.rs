//! Flights of the block as it is (Eq. 2), by those of the slender block and the first order of what the linear model leaves out.
//!
//! With `w = (α/sin α) u`, `u = iφ`, and `G = 1 + i f`, Eq. 2 under threshold normalisation is
//! `w'' = w - G - μ r + O(μ²)`, `r = (G - 1/2) w - G w²/2 + w³/6`, and Eq. 4 is what it is for `μ = 0`. So from the same start the rotation is
//! that of the slender block, `w₀`, and to first order, by variation of constants,
//!
//! ```text
//! w₁(T) = -μ ∫ sinh(T - s) r(s) ds   w₁'(T) = -μ ∫ cosh(T - s) r(s) ds
//! ```
//!
//! along `w₀`, and the impact moves to where `w₀ + w₁` is zero. Each flight starts where the one before it ended, corrected. So what is left
//! of the order `α⁴` is that of single flights, passed on as any change is; the curvature of the response to `α²`, which grows faster towards `a_cr`, is not in
//! it as it is in a derivative along the whole linear solution.

use contract::{Arrival, Case, Decline, Departure, FlightSolver, Ground, Loss, Oracle};

use super::{parameter, threshold};
use crate::measure::excitation::Excitation;

/// The nodes in (0, 1) and the weights of a rule of Gauss and Legendre.
type Rule = &'static [(f64, f64)];

/// Up to which `max(1, ω) T` a rule is good to 1e-6 of the integral, and the rule: of 4, 6 and 10 nodes.
const SHORT: (f64, Rule) = (
    0.3,
    &[
        (0.06943184420297371, 0.17392742256872679),
        (0.33000947820757187, 0.3260725774312732),
        (0.6699905217924281, 0.3260725774312732),
        (0.9305681557970262, 0.17392742256872679),
    ],
);
const MIDDLE: (f64, Rule) = (
    1.0,
    &[
        (0.03376524289842403, 0.08566224618958514),
        (0.16939530676686776, 0.18038078652406936),
        (0.38069040695840156, 0.23395696728634552),
        (0.6193095930415985, 0.23395696728634552),
        (0.8306046932331322, 0.18038078652406936),
        (0.9662347571015759, 0.08566224618958514),
    ],
);
const LONG: Rule = &[
    (0.013046735741414128, 0.03333567215434407),
    (0.06746831665550773, 0.0747256745752902),
    (0.16029521585048778, 0.109543181257991),
    (0.2833023029353764, 0.13463335965499826),
    (0.4255628305091844, 0.1477621123573764),
    (0.5744371694908156, 0.1477621123573764),
    (0.7166976970646236, 0.13463335965499826),
    (0.8397047841495122, 0.109543181257991),
    (0.9325316833444923, 0.0747256745752902),
    (0.9869532642585859, 0.03333567215434407),
];

/// The largest part of a flight that its impact may be moved by.
const LARGEST_SHIFT: f64 = 0.25;

/// The flights of one case.
pub struct Flights {
    linear: Box<dyn FlightSolver>,
    excitation: Excitation,
    mu: f64,
    /// `sin α/α`.
    scale: f64,
}

impl Flights {
    /// The flights of a case by those of the oracle `stepper` of the linear model.
    ///
    /// # Errors
    /// A [`Decline`] when the case has no slenderness, or the oracle declines it or has no single flights.
    pub fn new(stepper: &dyn Oracle, case: &Case) -> Result<Self, Decline> {
        let slenderness = case.slenderness().ok_or(Decline::NeedsSlenderness)?;
        let (linear, _) = threshold::of(case, slenderness)?;
        let alpha = slenderness.alpha();
        Ok(Self {
            linear: stepper.flights(&linear)?,
            excitation: Excitation::new(&linear),
            mu: parameter(alpha),
            scale: alpha.sin() / alpha,
        })
    }

    /// The departure of the slender block.
    fn linear(&self, departure: &Departure) -> Departure {
        let Departure { rotation, velocity, .. } = *departure;
        Departure { rotation: rotation / self.scale, velocity: velocity / self.scale, ..*departure }
    }

    /// `G` a time `s` after the departure.
    fn gravity(&self, departure: &Departure, s: f64) -> f64 {
        match departure.ground {
            Ground::Shaking => 1.0 + departure.side * self.excitation.at(departure.time + s),
            Ground::Still => 1.0,
        }
    }

    /// `w₁` and `w₁'` a time `stretch` after the departure of the slender block.
    fn left_out(&self, departure: &Departure, stretch: f64) -> (f64, f64) {
        let length = stretch * self.excitation.omega().max(1.0);
        let rule = if length <= SHORT.0 {
            SHORT.1
        } else if length <= MIDDLE.0 {
            MIDDLE.1
        } else {
            LONG
        };
        let (mut rotation, mut velocity) = (0.0, 0.0);
        for &(node, weight) in rule {
            let s = node * stretch;
            let (w, _) = self.linear.motion(departure, s);
            let gravity = self.gravity(departure, s);
            let rest = weight * w * ((gravity - 0.5) + w * (w * (1.0 / 6.0) - 0.5 * gravity));
            let growth = (stretch - s).exp();
            rotation += rest * (growth - 1.0 / growth);
            velocity += rest * (growth + 1.0 / growth);
        }
        let factor = -0.5 * self.mu * stretch;
        (factor * rotation, factor * velocity)
    }
}

impl FlightSolver for Flights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let start = self.linear(departure);
        let (interval, speed) = match self.linear.fly(&start, horizon) {
            Arrival::Impact { interval, speed } => (interval, speed),
            Arrival::Aloft { rotation, velocity } => {
                return Arrival::Aloft { rotation: self.scale * rotation, velocity: self.scale * velocity };
            }
            other => return other,
        };
        let (rotation, velocity) = self.left_out(&start, interval);
        let gravity = self.gravity(departure, interval);
        // There w₀ + w₁ = w₁ - (v - w₁') d - G d²/2, with v the linear speed.
        let falling = speed - velocity;
        let moved = rotation / (falling + 0.5 * gravity * rotation / falling);
        // Where it hardly lands the first order says nothing.
        if !(falling > 0.0 && moved.abs() < LARGEST_SHIFT * interval) {
            return Arrival::Lost(Loss::SolverFailed);
        }
        Arrival::Impact { interval: interval + moved, speed: self.scale * (falling + gravity * moved) }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        let start = self.linear(departure);
        let ((rotation, velocity), (by, turned)) = (self.linear.motion(&start, s), self.left_out(&start, s));
        (self.scale * (rotation + by), self.scale * (velocity + turned))
    }

    /// Never: a first order proves nothing.
    fn rests(&self, _: &Departure) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rule of `n` nodes is exact up to the power `2n - 1`, and not one further.
    #[test]
    fn the_rules_are_those_of_gauss_and_legendre() {
        for rule in [SHORT.1, MIDDLE.1, LONG] {
            let off = |power: i32| {
                let sum: f64 = rule.iter().map(|(node, weight)| weight * node.powi(power)).sum();
                (sum * f64::from(power + 1) - 1.0).abs()
            };
            let most = i32::try_from(2 * rule.len()).unwrap_or_default();
            assert!((0..most).all(|power| off(power) < 2e-14), "{rule:?}");
            assert!(off(most) > 1e-12, "{rule:?}");
        }
    }
}
