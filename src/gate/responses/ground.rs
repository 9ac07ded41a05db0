//! The motion of the ground as it is written, `a sin(ωτ + phase)` from `τ = 0` until it ends, in multiples of the threshold; and the equations of motion
//! as they are printed. Nothing here is rearranged to keep digits: it is to be read beside the paper.

use std::f64::consts::PI;

use contract::Model;

use crate::cases::shaking::Shaking;

/// A block on shaking ground, as the plain follower sees it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Problem {
    /// `a - 1`.
    epsilon: f64,
    pub omega: f64,
    pub eta: f64,
    /// The slenderness angle of Eq. 2; `None` for Eq. 4.
    alpha: Option<f64>,
    /// The rotation at which the block lies on its side, in `φ`, where its slenderness is known.
    pub lies_at: f64,
    /// `tan α`, with which every acceleration is made.
    tangent: f64,
    phase: f64,
    /// When the ground comes to rest.
    pub lasts: f64,
    /// When the response ends at the latest.
    pub until: f64,
}

impl Problem {
    /// Of `shaking`, under the equation of `model`; `None` where the nonlinear one lacks a slenderness.
    pub fn new(shaking: &Shaking, model: Model) -> Option<Self> {
        let case = &shaking.case;
        let alpha = match model {
            Model::Linear => None,
            Model::Nonlinear => Some(case.slenderness()?.alpha()),
        };
        let problem = Self {
            epsilon: case.epsilon(),
            omega: case.omega(),
            eta: case.eta(),
            alpha,
            lies_at: case.slenderness().map_or(f64::INFINITY, |slenderness| 0.5 * PI / slenderness.alpha()),
            tangent: alpha.map_or(0.0, f64::tan),
            phase: 0.0,
            lasts: shaking.lasts.unwrap_or(f64::INFINITY),
            until: shaking.until,
        };
        Some(Self { phase: shaking.phase.unwrap_or_else(|| problem.threshold_phase()), ..problem })
    }

    /// The same with every number moved by about `delta` relative; one mix of directions for each sign.
    pub fn moved(&self, delta: f64, from_threshold: bool) -> Self {
        let by = |share: f64| 1.0 + share * delta;
        let other = f64::from(u8::from(delta < 0.0)) * 2.0 - 1.0;
        let alpha = self.alpha.map(|alpha| alpha * by(0.5));
        let moved = Self {
            epsilon: self.epsilon * by(1.0),
            omega: self.omega * by(-0.7),
            eta: self.eta * (1.0 - 0.6 * delta.abs()),
            alpha,
            tangent: alpha.map_or(0.0, f64::tan),
            lasts: self.lasts * by(0.4),
            ..*self
        };
        let phase = if from_threshold { moved.threshold_phase() } else { self.phase + 0.8 * other * delta.abs() };
        Self { phase, ..moved }
    }

    /// `ψ`, with `sin ψ = 1/a`.
    fn threshold_phase(&self) -> f64 {
        1.0_f64.atan2((self.epsilon * (2.0 + self.epsilon)).max(0.0).sqrt())
    }

    /// The amplitude of what the ground may still do at `tau`.
    pub fn amplitude(&self, tau: f64) -> f64 {
        if tau < self.lasts { 1.0 + self.epsilon } else { 0.0 }
    }

    /// The ground acceleration.
    pub fn ground(&self, tau: f64) -> f64 {
        if tau < self.lasts { self.shaken(tau) } else { 0.0 }
    }

    /// The same while it shakes.
    pub fn shaken(&self, tau: f64) -> f64 {
        (1.0 + self.epsilon) * (self.omega * tau + self.phase).sin()
    }

    /// When the ground next makes a block rock that rests at `tau`, if it does, and to which side the block then rotates.
    pub fn next_start(&self, tau: f64) -> Option<(f64, f64)> {
        if self.epsilon <= 0.0 || tau >= self.lasts {
            return None;
        }
        let lobe = self.threshold_phase();
        let past = self.omega * tau + self.phase - lobe;
        let turns = (past / PI).floor();
        // Above the threshold from ψ to π - ψ.
        let above = past - turns * PI < PI - 2.0 * lobe;
        let turns = if above { turns } else { turns + 1.0 };
        let start = if above { tau } else { (lobe + turns * PI - self.phase) / self.omega };
        let side = if turns.rem_euclid(2.0) == 0.0 { -1.0 } else { 1.0 };
        (start < self.lasts).then_some((start.max(tau), side))
    }

    /// How long after `tau` the ground stays as it is: below the threshold, and shaking or at rest.
    pub fn stays(&self, tau: f64) -> f64 {
        if tau >= self.lasts {
            return f64::INFINITY;
        }
        let ends = self.lasts - tau;
        self.next_start(tau).map_or(ends, |(start, _)| ends.min(start - tau))
    }

    /// `φ''` on the side `i`, with the ground acceleration `f`: Eq. 4, or Eq. 2 with `ü_g/g = f tan α`.
    pub fn acceleration(&self, i: f64, f: f64, phi: f64) -> f64 {
        match self.alpha {
            None => phi - i - f,
            Some(alpha) => {
                let (sin, cos) = (alpha * (i - phi)).sin_cos();
                -(sin + self.tangent * f * cos) / alpha
            }
        }
    }

    /// A bound on the acceleration away from the base at the rotation `u`.
    pub fn push(&self, tau: f64, u: f64) -> f64 {
        u.max(1.0) + self.amplitude(tau) * (1.0 + self.tangent)
    }

    /// Whether the acceleration can't point back to the base any more, whatever a ground of this amplitude does, and the block moves outwards.
    pub fn is_lost(&self, tau: f64, u: f64, w: f64) -> bool {
        let amplitude = self.amplitude(tau);
        let beyond = match self.alpha {
            None => u >= 1.0 + amplitude,
            Some(alpha) => alpha * (u - 1.0) >= (amplitude * self.tangent).atan(),
        };
        beyond && w >= 0.0
    }

    /// The longest step: short beside the times in which the ground and the unstable balance change things, and than the time for which the ground
    /// acceleration is above the threshold.
    pub fn longest_step(&self) -> f64 {
        let rate = 1.0 + self.amplitude(0.0) * self.tangent;
        let above = (PI - 2.0 * self.threshold_phase()) / self.omega;
        (0.5 / self.omega.max(rate.sqrt())).min(0.5 * above)
    }
}
