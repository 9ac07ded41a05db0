//! The motion of the ground as it is written, in multiples of the threshold. Nothing here is rearranged to keep digits: it is to be read beside the formulas.

mod motion;
mod sinusoid;

use std::sync::Arc;

use contract::Motion;

use crate::cases::shaking::Question;
pub(super) use sinusoid::Sinusoid;

/// The ground as the plain follower sees it, from `τ = 0` until it comes to rest.
#[derive(Debug, Clone)]
pub(super) enum Ground {
    /// `a sin(ωτ + phase)`.
    Sinusoid(Sinusoid),
    /// Any motion.
    Motion(Arc<Motion>),
}

impl Ground {
    /// That of a question, and when it comes to rest.
    pub fn of(question: &Question) -> (Self, f64) {
        let ground = match question {
            Question::Sinusoid(shaking) => Self::Sinusoid(Sinusoid::of(shaking)),
            Question::Motion(asked) => Self::Motion(Arc::clone(&asked.motion)),
        };
        (ground, question.lasts())
    }

    /// The same with every number moved by about `delta` relative.
    pub fn moved(&self, delta: f64) -> Self {
        match self {
            Self::Sinusoid(sine) => Self::Sinusoid(sine.moved(delta)),
            Self::Motion(motion) => Self::Motion(Arc::new(motion::moved(motion, delta))),
        }
    }

    /// By what multiple of `delta` the time at which it comes to rest moves with it.
    pub fn stretched(&self) -> f64 {
        if let Self::Motion(motion) = self { motion::stretched(motion) } else { 0.4 }
    }

    /// A bound on the acceleration.
    pub fn amplitude(&self) -> f64 {
        match self {
            Self::Sinusoid(sine) => sine.amplitude(),
            Self::Motion(motion) => motion::amplitude(motion),
        }
    }

    /// A bound on how fast it changes.
    pub fn slope(&self) -> f64 {
        match self {
            Self::Sinusoid(sine) => sine.omega * sine.amplitude(),
            Self::Motion(motion) => motion::slope(motion),
        }
    }

    /// The largest frequency in it; 0 of straight lines.
    pub fn rate(&self) -> f64 {
        match self {
            Self::Sinusoid(sine) => sine.omega,
            Self::Motion(motion) => motion::rate(motion),
        }
    }

    /// The acceleration at `tau + s`, by the formula that holds at `tau`.
    pub fn at(&self, tau: f64, s: f64) -> f64 {
        match self {
            Self::Sinusoid(sine) => sine.at(tau + s),
            Self::Motion(motion) => motion::at(motion, tau, s),
        }
    }

    /// When after `tau` another formula begins to hold; infinite for never.
    pub fn change(&self, tau: f64) -> f64 {
        match self {
            Self::Sinusoid(_) => f64::INFINITY,
            Self::Motion(motion) => motion::change(motion, tau),
        }
    }

    /// When the ground next makes a block rock that rests at `tau`, before `until`, and to which side the block then rotates.
    pub fn next_start(&self, tau: f64, until: f64) -> Option<(f64, f64)> {
        match self {
            Self::Sinusoid(sine) => sine.next_start(tau),
            Self::Motion(motion) => motion::next_start(motion, tau, until),
        }
    }

    /// How long any push lasts at the least, where that is known.
    pub fn shortest_push(&self) -> f64 {
        if let Self::Sinusoid(sine) = self { sine.above() } else { f64::INFINITY }
    }

    /// For how long a push lasts that there is at `tau`.
    pub fn pushes(&self, tau: f64) -> f64 {
        match self {
            Self::Sinusoid(sine) => sine.above(),
            Self::Motion(motion) => motion::pushes(motion, tau),
        }
    }
}
