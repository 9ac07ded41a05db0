use contract::{Body, Case, Decline, Ending, Followed, History, Horizon, Limit, Model, Motion, Oracle, Slenderness};

use crate::{
    bounds::Bounds,
    directed::Directed,
    enclosed_impact::{EnclosedImpact, enclosed_impact, estimate},
    interval::Interval,
    judge::{Enclosure, within},
    ladder::{Attempt, bits_for, climb},
    responses::EnclosedBout,
    sequence::{self, End, Sequence, Wanted},
};

/// Everything that is proven of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Enclosed {
    /// The impacts in order.
    pub impacts: Vec<EnclosedImpact>,
    /// How the history ends.
    pub ending: Ending,
    /// The chattering time `τ_ch`, where the chattering is complete.
    pub chattering_time: Option<Bounds>,
    /// With how many bits it was found.
    pub bits: u32,
}

/// How many impacts are followed to the proof of an ending if fewer are asked for.
const FOLLOWED: usize = 50_000;

impl Enclosure {
    /// Bounds for every impact that the case asks for, and for its chattering time.
    ///
    /// # Errors
    /// A [`Decline`] when the model needs a slenderness that the case does not have, a quantity is out of range, or the ending is undecided.
    pub fn enclose(&self, case: &Case) -> Result<Enclosed, Decline> {
        let slenderness = match self.model {
            Model::Linear => None,
            Model::Nonlinear => Some(case.slenderness().ok_or(Decline::NeedsSlenderness)?),
        };
        within("epsilon", case.epsilon(), -1.0, 1e9, "-1 <= epsilon <= 1e9")?;
        if case.epsilon() > 0.0 {
            within("epsilon", case.epsilon(), 1e-60, 1e9, "1e-60 <= epsilon <= 1e9")?;
        }
        within("omega", case.omega(), 1e-6, 1e6, "1e-6 <= omega <= 1e6")?;
        within("eta", case.eta(), 1e-6, 1.0, "1e-6 <= eta < 1")?;
        if let Horizon::Until(time) = case.horizon() {
            within("until", time, 0.0, 1e6, "until <= 1e6")?;
        }
        let width = (0.1_f64).powi(self.digits as i32);
        let attempt = Following { case, slenderness, width };
        let undecided = Decline::NotConvergent {
            why: "undecided: too near to the edge between complete and incomplete chattering, or to a grazing impact, for the digits that are tried".to_owned(),
        };
        // Doubles never give more than some twelve digits.
        let bits = if self.digits <= 12 { 53 } else { bits_for(self.digits) + 12 };
        climb(&attempt, bits).ok_or(undecided)
    }
}

/// A case followed with some number of digits.
struct Following<'a> {
    case: &'a Case,
    slenderness: Option<Slenderness>,
    width: f64,
}

impl Attempt for Following<'_> {
    type Answer = Option<Enclosed>;

    fn with<F: Directed>(&self) -> (Option<Enclosed>, bool) {
        let wanted = Wanted { impacts: self.case.max_impacts(), followed: FOLLOWED, width: 0.5 * self.width };
        let sequence = sequence::follow::<F>(self.case, self.slenderness, wanted);
        let narrow = |interval: &Interval<F>| interval.relative_width() <= self.width;
        let good = sequence.impacts.iter().all(|i| narrow(&i.time) && narrow(&i.interval) && narrow(&i.speed))
            && match &sequence.end {
                // With more digits fewer impacts can be followed.
                End::Complete(time) => narrow(time) || sequence.exhausted,
                End::Unclear => sequence.exhausted,
                _ => true,
            };
        (enclosed(sequence), good)
    }
}

/// What a sequence proves; `None` if that is nothing.
fn enclosed<F: Directed>(sequence: Sequence<F>) -> Option<Enclosed> {
    let impacts = sequence.impacts.into_iter().map(enclosed_impact);
    let (ending, chattering_time) = match &sequence.end {
        End::NeverRocks => (Ending::NeverRocks, None),
        End::Complete(time) => (Ending::AtRest, Some(Bounds::new(time)?)),
        End::HalfPeriod => (Ending::Incomplete, None),
        End::Horizon => (Ending::LimitReached(Limit::Time), None),
        End::Overturned => (Ending::Overturned, None),
        End::Impacts => (Ending::LimitReached(Limit::Impacts), None),
        End::Unclear => return None,
    };
    Some(Enclosed { impacts: impacts.collect::<Option<_>>()?, ending, chattering_time, bits: F::BITS })
}

impl Oracle for Enclosure {
    fn name(&self) -> &str {
        match self.model {
            Model::Linear => "enclosure/linear",
            Model::Nonlinear => "enclosure/nonlinear",
        }
    }

    fn model(&self) -> Model {
        self.model
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        Ok(self.enclose(case)?.history())
    }

    fn bouts_on(&self, body: &Body, motion: &Motion, asked: &Followed) -> Result<Vec<contract::Bout>, Decline> {
        Ok(self.enclose_on(body, motion, asked)?.iter().map(EnclosedBout::bout).collect())
    }
}

impl Enclosed {
    /// The same as a history: the middle of each interval, and half its width as what is claimed.
    pub fn history(&self) -> History {
        let impacts = self.impacts.iter().map(EnclosedImpact::impact);
        let chattering_time = self.chattering_time.as_ref().map(estimate);
        History { impacts: impacts.collect(), ending: self.ending, chattering_time }
    }
}
