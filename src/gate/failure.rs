//! A case in which something was wrong.

use std::fmt;

use contract::{Case, Model};
use serde::{Deserialize, Serialize};

use crate::{
    cases::{case_file, generate::Named},
    gate::{
        examine::Examination,
        finding::Finding,
        parting::{Parting, partings},
    },
};

/// A case in which something was wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// The case.
    pub named: Named,
    /// What was wrong; never empty.
    pub findings: Vec<Finding>,
    /// The oracles with which neither the judge nor any law found anything wrong.
    pub sound: Vec<String>,
    /// Judges that refute oracles which agree among themselves.
    pub suspect_judges: Vec<String>,
    /// What shows it: the histories of those that are wrong or differ, or of one that is wrong and one that is sound.
    pub see: Vec<See>,
    /// The impacts around the first that is wrong, beside those of another; not of every failure where there are many.
    pub partings: Vec<Parting>,
}

/// The history of an oracle, to be looked at.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct See {
    /// Its name.
    pub oracle: String,
    /// The case, as flags of the command line.
    pub flags: String,
}

/// What makes failures look alike: who is to blame, as far as the findings of one case can tell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cause {
    /// A judge that refutes oracles which agree among themselves.
    Judge(String),
    /// Oracles that break a law, or are refuted, or are the one that is in every pair that disagrees.
    Oracles(Vec<String>),
    /// An engine that broke in the way of this name, with nothing else that is wrong.
    Broken(String, String),
    /// Pairs that disagree, with nothing to tell which of the two is wrong.
    Pairs(Vec<[String; 2]>),
}

impl Failure {
    /// The failure of a case, if anything is wrong with it.
    pub fn of(named: &Named, examination: &Examination) -> Option<Self> {
        let findings = examination.findings();
        let (sound, suspect_judges) = (examination.sound(), examination.suspect_judges());
        let see = see(&named.case, examination, &findings, &sound);
        let partings = partings(examination, &findings, &sound);
        (!findings.is_empty()).then(|| Self { named: named.clone(), findings, sound, suspect_judges, see, partings })
    }

    /// What this failure is grouped by.
    pub fn cause(&self) -> Cause {
        Cause::of(&self.findings, &self.suspect_judges)
    }
}

impl Cause {
    /// The cause that findings point to.
    pub fn of(findings: &[Finding], suspect_judges: &[String]) -> Self {
        if let Some(judge) = suspect_judges.first() {
            return Self::Judge(judge.clone());
        }
        if let Some(Finding::Broke { oracle, breakdown, .. }) = findings.first()
            && findings.iter().all(Finding::is_breakdown)
        {
            return Self::Broken(oracle.clone(), breakdown.clone());
        }
        let by_itself = |finding: &Finding| match finding {
            Finding::Law { oracle, .. } | Finding::Refuted { oracle, .. } => Some(oracle.clone()),
            Finding::Pair { .. } | Finding::Broke { .. } => None,
        };
        let mut oracles: Vec<String> = findings.iter().filter_map(by_itself).collect();
        if oracles.is_empty() {
            oracles.extend(common(findings).map(str::to_owned));
        }
        if oracles.is_empty() {
            let pair = |finding: &Finding| match finding {
                Finding::Pair { oracles, .. } => Some(oracles.clone()),
                Finding::Law { .. } | Finding::Refuted { .. } | Finding::Broke { .. } => None,
            };
            return Self::Pairs(findings.iter().filter_map(pair).collect());
        }
        oracles.sort();
        oracles.dedup();
        Self::Oracles(oracles)
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Judge(judge) => write!(f, "{judge}, the judge, which refutes oracles that agree among themselves"),
            Self::Broken(oracle, breakdown) => write!(f, "{oracle}, which broke: {breakdown}"),
            Self::Oracles(oracles) => f.write_str(&oracles.join(", ")),
            Self::Pairs(pairs) => {
                let pairs: Vec<String> = pairs.iter().map(|pair| pair.join(" : ")).collect();
                write!(f, "one of the two of {}", pairs.join(", "))
            }
        }
    }
}

/// The histories of two oracles: those first concerned, or the first of them and one that is sound.
fn see(case: &Case, examination: &Examination, findings: &[Finding], sound: &[String]) -> Vec<See> {
    let mut oracles: Vec<&str> = Vec::new();
    for oracle in findings.iter().flat_map(Finding::oracles).chain(sound.iter().map(String::as_str)) {
        if !oracles.contains(&oracle) {
            oracles.push(oracle);
        }
    }
    let see = |oracle: &str| {
        let answer = examination.answers.iter().find(|answer| answer.oracle == oracle)?;
        // The linear model has no slenderness, and an option that a method does not use is refused.
        let case = if answer.model == Model::Linear { without_slenderness(case)? } else { *case };
        Some(See { oracle: oracle.to_owned(), flags: case_file::flags(&case) })
    };
    oracles.into_iter().take(2).filter_map(see).collect()
}

fn without_slenderness(case: &Case) -> Option<Case> {
    let bare = Case::from_epsilon(case.epsilon(), case.omega(), case.eta()).ok()?;
    bare.with_max_impacts(case.max_impacts()).ok()?.with_horizon(case.horizon()).ok()
}

/// The one oracle that is in all of several pairs that disagree.
pub fn common(findings: &[Finding]) -> Option<&str> {
    let pairs: Vec<Vec<&str>> = findings.iter().map(Finding::oracles).filter(|oracles| oracles.len() == 2).collect();
    let mut in_all = pairs.first()?.iter().filter(|oracle| pairs.iter().all(|pair| pair.contains(oracle)));
    match (pairs.len(), in_all.next(), in_all.next()) {
        (2.., Some(oracle), None) => Some(oracle),
        _ => None,
    }
}

/// Failures by their cause, in the order in which each cause was first met.
pub fn by_cause<T>(failures: &[T], cause: impl Fn(&T) -> Cause) -> Vec<(Cause, Vec<&T>)> {
    let mut groups: Vec<(Cause, Vec<&T>)> = Vec::new();
    for failure in failures {
        let of = cause(failure);
        match groups.iter_mut().find(|(known, _)| *known == of) {
            Some((_, group)) => group.push(failure),
            None => groups.push((of, vec![failure])),
        }
    }
    groups
}

/// How many names of failures like the one that is shown are given.
const NAMES: usize = 4;

/// Where else the same is wrong, in a line.
pub fn likewise(names: &[&str]) -> String {
    let shown = names.iter().take(NAMES).copied().collect::<Vec<_>>().join(", ");
    let more = if names.len() > NAMES { format!(" and {} more", names.len() - NAMES) } else { String::new() };
    format!("likewise {shown}{more}")
}
