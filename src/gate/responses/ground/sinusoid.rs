//! `a sin(ωτ + phase)`.

use std::f64::consts::PI;

use crate::cases::shaking::Shaking;

/// A sinusoid.
#[derive(Debug, Clone, Copy)]
pub(in crate::gate::responses) struct Sinusoid {
    /// `a - 1`.
    epsilon: f64,
    pub omega: f64,
    phase: f64,
    /// Whether it starts at the threshold.
    from_threshold: bool,
}

impl Sinusoid {
    pub fn of(shaking: &Shaking) -> Self {
        let (epsilon, omega) = (shaking.case.epsilon(), shaking.case.omega());
        let sine = Self { epsilon, omega, phase: 0.0, from_threshold: shaking.phase.is_none() };
        Self { phase: shaking.phase.unwrap_or_else(|| sine.threshold_phase()), ..sine }
    }

    /// One mix of directions for each sign.
    pub fn moved(&self, delta: f64) -> Self {
        let other = f64::from(u8::from(delta < 0.0)) * 2.0 - 1.0;
        let (epsilon, omega) = (self.epsilon * (1.0 + delta), self.omega * (1.0 - 0.7 * delta));
        let moved = Self { epsilon, omega, ..*self };
        let phase = if self.from_threshold { moved.threshold_phase() } else { self.phase + 0.8 * other * delta.abs() };
        Self { phase, ..moved }
    }

    /// `ψ`, with `sin ψ = 1/a`.
    fn threshold_phase(&self) -> f64 {
        1.0_f64.atan2((self.epsilon * (2.0 + self.epsilon)).max(0.0).sqrt())
    }

    pub fn amplitude(&self) -> f64 {
        1.0 + self.epsilon
    }

    pub fn at(&self, tau: f64) -> f64 {
        (1.0 + self.epsilon) * (self.omega * tau + self.phase).sin()
    }

    /// For how long it is above the threshold in each half period.
    pub fn above(&self) -> f64 {
        (PI - 2.0 * self.threshold_phase()) / self.omega
    }

    /// When it next makes a block rock that rests at `tau`, and to which side the block then rotates.
    pub fn next_start(&self, tau: f64) -> Option<(f64, f64)> {
        if self.epsilon <= 0.0 {
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
        Some((start.max(tau), side))
    }
}
