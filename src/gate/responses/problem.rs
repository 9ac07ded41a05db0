//! The problem as it is written: a block, the ground, and the equations of motion as they are printed. Nothing here is rearranged to keep digits: it is to be
//! read beside the paper.

use std::f64::consts::PI;

use contract::Model;

use super::ground::Ground;
use crate::cases::shaking::Question;

/// A block on moving ground, as the plain follower sees it.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub eta: f64,
    /// The slenderness angle of Eq. 2; `None` for Eq. 4.
    alpha: Option<f64>,
    /// The rotation at which the block lies on its side, in `φ`, where its slenderness is known.
    pub lies_at: f64,
    /// `tan α`, with which every acceleration is made.
    tangent: f64,
    ground: Ground,
    /// The rotation and the velocity at first; from rest if both are 0.
    pub start: (f64, f64),
    /// When the ground comes to rest.
    pub lasts: f64,
    /// When the response ends at the latest.
    pub until: f64,
}

impl Problem {
    /// Of `question`, under the equation of `model`; `None` where the nonlinear one lacks a slenderness.
    pub fn new(question: &Question, model: Model) -> Option<Self> {
        let alpha = match model {
            Model::Linear => None,
            Model::Nonlinear => Some(question.alpha()?),
        };
        let (ground, lasts) = Ground::of(question);
        let start = if let Question::Motion(asked) = question { asked.start } else { (0.0, 0.0) };
        Some(Self {
            eta: question.eta(),
            alpha,
            lies_at: question.alpha().map_or(f64::INFINITY, |alpha| 0.5 * PI / alpha),
            tangent: alpha.map_or(0.0, f64::tan),
            ground,
            start,
            lasts,
            until: question.until(),
        })
    }

    /// The same with every number moved by about `delta` relative; one mix of directions for each sign.
    pub fn moved(&self, delta: f64) -> Self {
        let by = |share: f64| 1.0 + share * delta;
        let alpha = self.alpha.map(|alpha| alpha * by(0.5));
        Self {
            eta: self.eta * (1.0 - 0.6 * delta.abs()),
            alpha,
            tangent: alpha.map_or(0.0, f64::tan),
            ground: self.ground.moved(delta),
            start: (self.start.0 * by(1.0), self.start.1 * by(-0.6)),
            lasts: self.lasts * by(self.ground.stretched()),
            ..self.clone()
        }
    }

    /// The amplitude of what the ground may still do at `tau`.
    pub fn amplitude(&self, tau: f64) -> f64 {
        if tau < self.lasts { self.ground.amplitude() } else { 0.0 }
    }

    /// How fast that changes at the most.
    pub fn slope(&self, tau: f64) -> f64 {
        if tau < self.lasts { self.ground.slope() } else { 0.0 }
    }

    /// The ground acceleration.
    pub fn ground(&self, tau: f64) -> f64 {
        self.ground_after(tau, 0.0)
    }

    /// The same `s` after `tau`, by what holds at `tau`.
    pub fn ground_after(&self, tau: f64, s: f64) -> f64 {
        if tau < self.lasts { self.ground.at(tau, s) } else { 0.0 }
    }

    /// When the ground next makes a block rock that rests at `tau`, if it does, and to which side the block then rotates.
    pub fn next_start(&self, tau: f64) -> Option<(f64, f64)> {
        if tau >= self.lasts {
            return None;
        }
        self.ground.next_start(tau, self.lasts.min(self.until)).filter(|(start, _)| *start < self.lasts)
    }

    /// When after `tau` another formula holds for the ground; infinite for never.
    pub fn change(&self, tau: f64) -> f64 {
        if tau < self.lasts { self.ground.change(tau).min(self.lasts) } else { f64::INFINITY }
    }

    /// How long it is until then.
    pub fn until_change(&self, tau: f64) -> f64 {
        self.change(tau) - tau
    }

    /// Whether the ground held the block down for a while between two times, and pushed again.
    pub fn misses_a_gap(&self, begin: f64, end: f64) -> bool {
        let looks = (0..1000).map(|look| begin + (end - begin) * f64::from(look) / 1000.0);
        let pushes = looks.map(|time| self.ground(time).abs() > 1.0);
        let (_, changes) = pushes.fold((true, 0), |(before, changes), now| (now, changes + usize::from(now != before)));
        changes > 2
    }

    /// How long after `tau` the ground stays as it is: below the threshold, and of one formula.
    pub fn stays(&self, tau: f64) -> f64 {
        let ends = self.until_change(tau);
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

    /// The longest step: short beside the times in which the ground and the unstable balance change things.
    pub fn longest_step(&self) -> f64 {
        let rate = 1.0 + self.amplitude(0.0) * self.tangent;
        (0.5 / self.ground.rate().max(rate.sqrt())).min(0.5 * self.ground.shortest_push())
    }

    /// The longest step where the ground pushes the block away at `tau`: short beside the time for which it does.
    pub fn step_of_push(&self, tau: f64) -> f64 {
        if tau < self.lasts { self.longest_step().min(0.5 * self.ground.pushes(tau)) } else { self.longest_step() }
    }
}
