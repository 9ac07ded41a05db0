//! The kinds of response that a run has to reach.

use serde::{Deserialize, Serialize};

use super::{reference::Reference, whole::BoutEnding};
use crate::cases::shaking::Shaking;

/// What a response may be an example of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Example {
    /// The ground never reaches the threshold.
    NeverRocks,
    /// The block comes to rest while the ground shakes.
    RestsWhileShaken,
    /// It comes to rest after the shaking.
    RestsAfterwards,
    /// It overturns while the ground shakes.
    OverturnsWhileShaken,
    /// It overturns after the shaking.
    OverturnsAfterwards,
    /// The response ends while the block rocks.
    EndsInTheAir,
    /// The shaking ends while the block rocks.
    ShakingEndsInTheAir,
    /// The block rocks more than once.
    SeveralBouts,
    /// The ground starts above the threshold.
    StartsAboveTheThreshold,
    /// The shaking ends within its first half period.
    ShortPulse,
    /// A restitution below a half.
    LowRestitution,
    /// One above 0.97.
    HighRestitution,
}

impl Example {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::NeverRocks,
        Self::RestsWhileShaken,
        Self::RestsAfterwards,
        Self::OverturnsWhileShaken,
        Self::OverturnsAfterwards,
        Self::EndsInTheAir,
        Self::ShakingEndsInTheAir,
        Self::SeveralBouts,
        Self::StartsAboveTheThreshold,
        Self::ShortPulse,
        Self::LowRestitution,
        Self::HighRestitution,
    ];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::NeverRocks => "never rocks",
            Self::RestsWhileShaken => "rests while shaken",
            Self::RestsAfterwards => "rests afterwards",
            Self::OverturnsWhileShaken => "overturns while shaken",
            Self::OverturnsAfterwards => "overturns afterwards",
            Self::EndsInTheAir => "response ends in the air",
            Self::ShakingEndsInTheAir => "shaking ends in the air",
            Self::SeveralBouts => "several bouts",
            Self::StartsAboveTheThreshold => "starts above the threshold",
            Self::ShortPulse => "within half a period",
            Self::LowRestitution => "eta below 0.5",
            Self::HighRestitution => "eta above 0.97",
        }
    }

    /// What a response is an example of, as far as it is known.
    pub(super) fn of(shaking: &Shaking, reference: &Reference) -> Vec<Self> {
        let lasts = shaking.lasts.unwrap_or(f64::INFINITY);
        let known = reference.known.iter().filter(|known| known.ending.is_some()).count();
        let bouts: Vec<_> = reference.nominal.bouts.iter().take(known).collect();
        let any = |outcome: BoutEnding, after: bool| {
            bouts.iter().any(|bout| bout.outcome == outcome && (bout.end > lasts) == after)
        };
        let holds = |reach: Self| match reach {
            Self::NeverRocks => shaking.case.epsilon() <= 0.0,
            Self::RestsWhileShaken => any(BoutEnding::Rest, false),
            Self::RestsAfterwards => any(BoutEnding::Rest, true),
            Self::OverturnsWhileShaken => any(BoutEnding::Overturned, false),
            Self::OverturnsAfterwards => any(BoutEnding::Overturned, true),
            Self::EndsInTheAir => any(BoutEnding::Cut, false) || any(BoutEnding::Cut, true),
            Self::ShakingEndsInTheAir => bouts.iter().any(|bout| bout.begin < lasts && bout.end > lasts),
            Self::SeveralBouts => bouts.len() > 1,
            Self::StartsAboveTheThreshold => {
                shaking.phase.is_some() && bouts.first().is_some_and(|bout| bout.begin == 0.0)
            }
            Self::ShortPulse => lasts * shaking.case.omega() < std::f64::consts::PI && !bouts.is_empty(),
            Self::LowRestitution => shaking.case.eta() < 0.5,
            Self::HighRestitution => shaking.case.eta() > 0.97,
        };
        Self::ALL.into_iter().filter(|reach| holds(*reach)).collect()
    }
}
