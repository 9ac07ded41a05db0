//! What a run of whole responses fails to prove as a whole, although every one of them may be right. Any of these turns it red.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::{
    reach::Example,
    relations::Relation,
    tally::{MethodCounts, Tally},
};
use crate::gate::{shortfall::NotJudged, tolerance, verdict::Verdict};

/// One thing that a run fails to prove.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Shortfall {
    /// The run was ended before all responses were run.
    Interrupted {
        /// How many were run.
        examined: usize,
        /// Of how many.
        handed: usize,
    },
    /// In too many responses nothing is known from some time on.
    TooClose {
        /// In how many.
        too_close: usize,
        /// Of how many.
        responses: usize,
    },
    /// A method declined more than it may.
    Declined {
        /// Its name.
        method: String,
        /// How many responses.
        declined: usize,
        /// Of how many.
        asked: usize,
    },
    /// A method is allowed so much that nothing ever comes near to it.
    Unused {
        /// Its name.
        method: String,
        /// The largest share of the allowance that an impact used.
        used: f64,
    },
    /// No impact of a method was compared, and no rest of one that foretells them.
    NoImpact {
        /// Its name.
        method: String,
    },
    /// A method was never asked a question in another form.
    NeverAskedAgain {
        /// Its name.
        method: String,
    },
    /// A change that must not matter was never tried.
    NeverTried {
        /// Which.
        relation: Relation,
    },
    /// A kind of response was never met.
    NeverMet {
        /// The kind.
        example: Example,
    },
}

/// What is wrong with the run, and what it was too small to judge.
pub(super) fn shortfalls(tally: &Tally) -> (Vec<Shortfall>, Vec<NotJudged>) {
    let (responses, needed) = (tally.responses, tolerance::RESPONSES_WHOLE.value as usize);
    if !tally.left_out.is_empty() {
        let handed = responses + tally.left_out.len();
        return (vec![Shortfall::Interrupted { examined: responses, handed }], Vec::new());
    }
    if responses < needed {
        let what = "that whole responses reach and compare everything".to_owned();
        return (Vec::new(), vec![NotJudged { what, cases: responses, needed }]);
    }
    let too_close = tally.too_close;
    let unclear = (share(too_close, responses) > tolerance::RESPONSES_TOO_CLOSE.value)
        .then_some(Shortfall::TooClose { too_close, responses });
    let never_met = Example::ALL.into_iter().filter(|example| !tally.reach.contains_key(example));
    let of_methods = tally.methods.iter().flat_map(|(name, counts)| of_method(name, counts));
    let never_met = never_met.map(|example| Shortfall::NeverMet { example });
    let never_tried = Relation::ALL.into_iter().filter(|relation| !tally.relations.contains_key(relation));
    let never_tried = never_tried.map(|relation| Shortfall::NeverTried { relation });
    (unclear.into_iter().chain(of_methods).chain(never_met).chain(never_tried).collect(), Vec::new())
}

fn of_method(name: &str, counts: &MethodCounts) -> Vec<Shortfall> {
    let method = name.to_owned();
    let MethodCounts { answered, declined, impacts, rests, wrong, used, related, .. } = *counts;
    let asked = answered + declined;
    let mut found = Vec::new();
    // What foretells rests declines what it does not foresee.
    let foretells = rests > 0;
    if !foretells && share(declined, asked) > tolerance::RESPONSES_DECLINED.value {
        found.push(Shortfall::Declined { method: method.clone(), declined, asked });
    }
    if related == 0 {
        found.push(Shortfall::NeverAskedAgain { method: method.clone() });
    }
    if impacts == 0 && !foretells {
        found.push(Shortfall::NoImpact { method });
    } else if wrong == 0 && used < tolerance::RESPONSES_USED.value {
        found.push(Shortfall::Unused { method, used });
    }
    found
}

fn share(count: usize, of: usize) -> f64 {
    count as f64 / of.max(1) as f64
}

impl Shortfall {
    /// What it means for the run.
    pub fn verdict(&self) -> Verdict {
        Verdict::of_shortfall(matches!(self, Self::Interrupted { .. }))
    }
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interrupted { examined, handed } => {
                write!(f, "interrupted after {examined} of {handed} whole responses: the report is partial")
            }
            Self::TooClose { too_close, responses } => {
                write!(f, "{too_close} of {responses} whole responses are too close to call")
            }
            Self::Declined { method, declined, asked } => {
                write!(f, "{method} declined {declined} of {asked} whole responses")
            }
            Self::Unused { method, used } => {
                write!(
                    f,
                    "{method} is allowed so much that no impact and no rest of a whole response uses more than {used:.1e} of it"
                )
            }
            Self::NoImpact { method } => write!(f, "{method}: no impact and no rest of a whole response was compared"),
            Self::NeverAskedAgain { method } => {
                write!(f, "{method}: no whole response was asked again in a form that must not matter")
            }
            Self::NeverTried { relation } => write!(f, "no whole response was asked again {}", relation.name()),
            Self::NeverMet { example } => write!(f, "no whole response of the kind \"{}\" was met", example.name()),
        }
    }
}

#[cfg(test)]
mod tests;
