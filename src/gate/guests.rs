//! The engines in a run, simulators of somebody else: what they answer is looked at more closely than what the panel does.

use contract::Case;

use super::{examine::Examination, finding::Finding, known::Known};

/// Who is a guest in a panel, and what is done for it. By default nobody is.
#[derive(Clone, Copy)]
pub struct Guests<'a> {
    /// Whether the oracle of this name is one.
    pub is_guest: &'a (dyn Fn(&str) -> bool + Sync),
    /// Failures of guests that are known.
    pub known: &'a [Known],
    /// Told the name of a guest and a case to which its answer was found right, from any thread.
    pub was_right: &'a (dyn Fn(&str, &Case) + Sync),
}

impl Default for Guests<'_> {
    fn default() -> Self {
        Self { is_guest: &|_| false, known: &[], was_right: &|_, _| {} }
    }
}

impl Guests<'_> {
    /// What is wrong with the answer of the guest at this place. Where the judge has looked at it, or the other one of a pair is a guest too, a pair that
    /// disagrees says nothing.
    pub(super) fn against(&self, examination: &Examination, place: usize) -> Vec<Finding> {
        let Some(guest) = examination.answers.get(place).map(|answer| answer.oracle.as_str()) else {
            return Vec::new();
        };
        let is_judged = examination.judgements.iter().any(|judgement| judgement.place == place);
        let is_against = |finding: &Finding| match finding {
            Finding::Law { oracle, .. } | Finding::Refuted { oracle, .. } => oracle == guest,
            Finding::Pair { oracles, .. } => {
                let others = || oracles.iter().filter(|oracle| *oracle != guest);
                !is_judged && others().count() == 1 && others().all(|other| !(self.is_guest)(other))
            }
            Finding::Broke { .. } => false,
        };
        examination.findings().into_iter().filter(is_against).collect()
    }
}
