//! The kinds of response that a run has to reach.

use serde::{Deserialize, Serialize};

use super::{reference::Reference, whole::BoutEnding};
use crate::cases::shaking::Question;
use contract::Motion;

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
    /// On a sum of sinusoids or a pulse that is one.
    OnASum,
    /// On a wavelet.
    OnAWavelet,
    /// On a record.
    OnARecord,
    /// The block does not start from rest.
    StartsMoving,
    /// It rocks through a time in which the ground holds it down, and comes to rest in a later one.
    RestsInALaterGap,
    /// It comes to rest on a record next to a sample, within a fifth of the step.
    RestsAtAKink,
}

impl Example {
    /// All of them.
    pub const ALL: [Self; 18] = [
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
        Self::OnASum,
        Self::OnAWavelet,
        Self::OnARecord,
        Self::StartsMoving,
        Self::RestsInALaterGap,
        Self::RestsAtAKink,
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
            Self::OnASum => "on a sum of sinusoids",
            Self::OnAWavelet => "on a wavelet",
            Self::OnARecord => "on a record",
            Self::StartsMoving => "does not start from rest",
            Self::RestsInALaterGap => "rests in a later gap",
            Self::RestsAtAKink => "rests at a kink",
        }
    }

    /// What a response is an example of, as far as it is known.
    pub(super) fn of(question: &Question, reference: &Reference) -> Vec<Self> {
        let lasts = question.lasts();
        let known = reference.known.iter().filter(|known| known.ending.is_some()).count();
        let bouts: Vec<_> = reference.nominal.bouts.iter().take(known).collect();
        let problem = &reference.nominal.problem;
        let any = |outcome: BoutEnding, after: bool| {
            bouts.iter().any(|bout| bout.outcome == outcome && (bout.end > lasts) == after)
        };
        let motion = match question {
            Question::Sinusoid(_) => None,
            Question::Motion(asked) => Some((asked.motion.as_ref(), asked.start)),
        };
        let starts_above = problem.ground(0.0).abs() > 1.0;
        let rests = || bouts.iter().filter(|bout| bout.outcome == BoutEnding::Rest && bout.end < lasts);
        let holds = |reach: Self| match (reach, question) {
            (Self::NeverRocks, Question::Sinusoid(shaking)) => shaking.case.epsilon() <= 0.0,
            (Self::NeverRocks, Question::Motion(_)) => reference.nominal.bouts.is_empty(),
            (Self::RestsWhileShaken, _) => any(BoutEnding::Rest, false),
            (Self::RestsAfterwards, _) => any(BoutEnding::Rest, true),
            (Self::OverturnsWhileShaken, _) => any(BoutEnding::Overturned, false),
            (Self::OverturnsAfterwards, _) => any(BoutEnding::Overturned, true),
            (Self::EndsInTheAir, _) => any(BoutEnding::Cut, false) || any(BoutEnding::Cut, true),
            (Self::ShakingEndsInTheAir, _) => bouts.iter().any(|bout| bout.begin < lasts && bout.end > lasts),
            (Self::SeveralBouts, _) => bouts.len() > 1,
            (Self::StartsAboveTheThreshold, Question::Sinusoid(shaking)) => {
                shaking.phase.is_some() && bouts.first().is_some_and(|bout| bout.begin == 0.0)
            }
            (Self::StartsAboveTheThreshold, Question::Motion(_)) => starts_above && !bouts.is_empty(),
            (Self::ShortPulse, Question::Sinusoid(shaking)) => {
                lasts * shaking.case.omega() < std::f64::consts::PI && !bouts.is_empty()
            }
            (Self::ShortPulse, Question::Motion(_)) => false,
            (Self::LowRestitution, _) => question.eta() < 0.5,
            (Self::HighRestitution, _) => question.eta() > 0.97,
            (Self::OnASum, _) => matches!(motion, Some((Motion::Sinusoids(_), _))) && !bouts.is_empty(),
            (Self::OnAWavelet, _) => matches!(motion, Some((Motion::Ricker(_), _))) && !bouts.is_empty(),
            (Self::OnARecord, _) => matches!(motion, Some((Motion::Record(_), _))) && !bouts.is_empty(),
            (Self::StartsMoving, _) => motion.is_some_and(|(_, start)| start != (0.0, 0.0)) && !bouts.is_empty(),
            (Self::RestsInALaterGap, Question::Motion(_)) => {
                rests().any(|bout| problem.misses_a_gap(bout.begin, bout.end))
            }
            (Self::RestsInALaterGap, Question::Sinusoid(_)) => false,
            (Self::RestsAtAKink, _) => match motion {
                Some((Motion::Record(record), _)) => rests().any(|bout| {
                    let samples = bout.end / record.dt;
                    (samples - samples.round()).abs() < 0.2
                }),
                _ => false,
            },
        };
        Self::ALL.into_iter().filter(|reach| holds(*reach)).collect()
    }
}
