//! One response through all methods.

use std::fmt;

use contract::Model;
use serde::{Deserialize, Serialize};

use super::{
    compare::{self, Used},
    difference::Difference,
    laws::{self, Law},
    reach::Example,
    reference::{Expected, Reference},
    relations::Relation,
    whole::{BoutEnding, Responder, Whole},
};
use crate::cases::shaking::Question;

/// At how many times the table of a response is compared.
const ROWS: usize = 48;

/// What came out for one response.
#[derive(Debug, Clone, Default)]
pub struct Examination {
    /// What was wrong.
    pub findings: Vec<Finding>,
    /// Of each method, by name: what was compared, or that it declined.
    pub asked: Vec<(String, Compared)>,
    /// Which changes that must not matter were tried of which method, by name, where something happens to the block.
    pub related: Vec<(String, Relation)>,
    /// What the response is an example of, by the plain follower.
    pub reach: Vec<Example>,
    /// Whether the outcome of one of the models is too close to call from some time on.
    pub too_close: bool,
}

/// What was compared of one method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Compared {
    /// It declined.
    Declined,
    /// So many bouts, impacts and rows.
    Answered {
        /// How many bouts it has.
        bouts: usize,
        /// How many of its impacts were compared at the most.
        impacts: usize,
        /// How many rows.
        rows: usize,
        /// The largest share of what is allowed that an impact used.
        used: f64,
    },
    /// It lists no impacts, and when the block comes to rest was compared so often.
    Foretold {
        /// How often.
        rests: usize,
        /// The largest share of what is allowed that a rest used.
        used: f64,
    },
}

/// Something wrong with the response of one method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// The method.
    pub method: String,
    /// The equation of motion that it solves.
    #[serde(with = "ModelName")]
    pub model: Model,
    /// What is wrong.
    pub wrong: Wrong,
    /// Other methods of which the same is wrong at the same place, and which so agree with this one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub agreeing: Vec<String>,
}

/// The contract knows no files: this is how a report writes its models.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Model", rename_all = "kebab-case")]
enum ModelName {
    Linear,
    Nonlinear,
}

/// What is wrong with a response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wrong {
    /// A law is broken, at this time.
    Breaks(Law, f64),
    /// It is not what it has to be.
    Differs(Difference),
    /// A change that must not matter does: the answer to the question in its other form is another.
    Changes(Relation, Difference),
}

impl Wrong {
    /// The same kind of mistake, whatever the numbers.
    pub fn resembles(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Breaks(one, _), Self::Breaks(other, _)) => one == other,
            (Self::Differs(one), Self::Differs(other)) => one.what.resembles(other.what),
            (Self::Changes(one, _), Self::Changes(other, _)) => one == other,
            _ => false,
        }
    }

    /// When it shows.
    pub fn time(&self) -> f64 {
        match self {
            Self::Breaks(_, time) => *time,
            Self::Differs(difference) | Self::Changes(_, difference) => difference.time,
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.method)?;
        match &self.wrong {
            Wrong::Breaks(law, time) => write!(f, "{} (τ = {time:.9})", law.broken())?,
            Wrong::Differs(difference) => difference.fmt(f)?,
            Wrong::Changes(relation, difference) => {
                write!(f, "asked {}, which must not matter, another answer: {difference}", relation.name())?
            }
        }
        if self.agreeing.is_empty() {
            return Ok(());
        }
        let suspect = match &self.wrong {
            Wrong::Breaks(..) | Wrong::Changes(..) => "what they share",
            Wrong::Differs(_) => "what they share, or the plain follower,",
        };
        write!(f, "; {} the same: {suspect} is suspect", self.agreeing.join(" and "))
    }
}

/// The response that `question` asks for by every method, examined.
pub fn examine(responders: &[&dyn Responder], question: &Question) -> Examination {
    examine_with(responders, question, &[])
}

/// The same, and the question is asked again in these other forms that must not matter.
pub fn examine_with(responders: &[&dyn Responder], question: &Question, relations: &[Relation]) -> Examination {
    let mut examination = Examination::default();
    for model in [Model::Linear, Model::Nonlinear] {
        let of_model: Vec<&&dyn Responder> = responders.iter().filter(|responder| responder.model() == model).collect();
        if of_model.is_empty() {
            continue;
        }
        let Some(reference) = Reference::new(question, model) else { continue };
        examination.reach.extend(Example::of(question, &reference));
        examination.too_close |= reference.until.is_finite();
        let mut findings = Vec::new();
        for responder in of_model.into_iter().filter(|responder| responder.is_asked(question)) {
            let name = responder.name().to_owned();
            let Some(whole) = responder.respond(question, ROWS) else {
                examination.asked.push((name, Compared::Declined));
                continue;
            };
            let (wrong, used) = wrong(&whole, &reference, responder.accuracy());
            let compared = if responder.lists_impacts() {
                Compared::answered(&whole, &reference, used.by_impacts)
            } else {
                Compared::foretold(&whole, &reference, used.by_rests)
            };
            examination.asked.push((name.clone(), compared));
            let wrong = wrong.or_else(|| {
                relations.iter().find_map(|relation| {
                    let answer = answer_changes(*responder, question, *relation, &whole, &reference)?;
                    if !whole.bouts.is_empty() {
                        examination.related.push((name.clone(), *relation));
                    }
                    answer.map(|difference| Wrong::Changes(*relation, difference))
                })
            });
            findings.extend(wrong.map(|wrong| Finding { method: name, model, wrong, agreeing: Vec::new() }));
        }
        examination.findings.extend(with_agreeing(&findings));
    }
    examination
}

/// What is wrong with a response, if anything, and the share of the allowance that it used.
fn wrong(whole: &Whole, reference: &Reference, accuracy: f64) -> (Option<Wrong>, Used) {
    let broken = laws::broken(whole, &reference.nominal.problem).map(|(law, time)| Wrong::Breaks(law, time));
    let (difference, used) = compare::first_difference(whole, reference, accuracy);
    (broken.or(difference.map(Wrong::Differs)), used)
}

/// How the answer to the question in its other form differs from the first, as far as its conditioning tells: of the plain follower nothing else is taken. `None` where
/// there is no such form, or the method has no answer to it.
fn answer_changes(
    responder: &dyn Responder,
    question: &Question,
    relation: Relation,
    first: &Whole,
    reference: &Reference,
) -> Option<Option<Difference>> {
    let changed = relation.change(question).filter(|changed| responder.is_asked(&changed.question))?;
    let again = changed.back(responder.respond(&changed.question, 1)?);
    // The same method follows a block that falls as far as before.
    let expected = reference.expected();
    let until = first.told_until.map_or(expected.until, |told| told.min(expected.until));
    let expected = Expected { bouts: &first.bouts, falls: false, until, ..expected };
    Some(compare::of_bouts(&again, &expected, Reference::scale_of_two(responder.accuracy())).0)
}

/// Each finding with the names of the others at the same place.
fn with_agreeing(findings: &[Finding]) -> Vec<Finding> {
    let same = |one: &Finding, other: &Finding| match (&one.wrong, &other.wrong) {
        (Wrong::Differs(one), Wrong::Differs(other)) => one.what == other.what && one.time == other.time,
        (Wrong::Changes(of, one), Wrong::Changes(other_of, other)) => {
            of == other_of && one.what == other.what && one.time == other.time
        }
        (Wrong::Breaks(..), Wrong::Breaks(..)) => one.wrong == other.wrong,
        _ => false,
    };
    let agreeing = |finding: &Finding| {
        let others = findings.iter().filter(|other| other.method != finding.method && same(finding, other));
        others.map(|other| other.method.clone()).collect()
    };
    findings.iter().map(|finding| Finding { agreeing: agreeing(finding), ..finding.clone() }).collect()
}

impl Compared {
    fn foretold(whole: &Whole, reference: &Reference, used: f64) -> Self {
        let known = whole.bouts.iter().zip(&reference.known);
        let rests = known.filter(|(bout, known)| bout.outcome == BoutEnding::Rest && known.ending.is_some()).count();
        Self::Foretold { rests, used }
    }

    fn answered(whole: &Whole, reference: &Reference, used: f64) -> Self {
        let known = whole.bouts.iter().zip(&reference.known);
        let impacts = known.map(|(bout, known)| bout.impacts.len().min(known.impacts.len())).sum();
        Self::Answered { bouts: whole.bouts.len(), impacts, rows: whole.rows.len(), used }
    }
}
