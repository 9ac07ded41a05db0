//! One case through the whole panel: every oracle's answer, every law, every pair.

use contract::{Case, Decline, Model, Normalisation, Oracle};
use serde::{Deserialize, Serialize};

use crate::{
    gate::{
        compare::{Agreement, Comparison, Disagreement, Slack, compare},
        endings,
        judge::Judgement,
        laws::{self, Breach, Checked, Law},
    },
    measure::{
        asking::{Answer, Reply, ask},
        conditioning::Conditioning,
        model_gap::ModelGap,
    },
};

/// Everything that came out of one case.
pub struct Examination {
    /// The answers, in the order of the panel.
    pub answers: Vec<Answer>,
    /// What the laws say of each answer.
    pub checked: Vec<Checked>,
    /// Every pair of answers, by their places in the panel.
    pub pairs: Vec<(usize, usize, Pairing)>,
    /// What the judge says, where it was asked.
    pub judgements: Vec<Judgement>,
}

/// What came out of a pair.
pub enum Pairing {
    /// The two histories were compared.
    Compared(Comparison),
    /// One of them gave no history to compare.
    Absent,
    /// The histories are of different problems.
    Incomparable(&'static str),
}

/// One thing that is wrong with a case: what a red gate has to show.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// Two oracles disagree.
    Pair {
        /// Their names.
        oracles: [String; 2],
        /// On what.
        disagreement: Disagreement,
    },
    /// An oracle breaks a law.
    Law {
        /// Its name.
        oracle: String,
        /// Which, and where.
        breach: Breach,
    },
    /// An oracle is further from a proven enclosure than it claims.
    Refuted {
        /// Its name.
        oracle: String,
        /// The name of the judge.
        judge: String,
        /// On what; the first of the two values is the judge's.
        disagreement: Disagreement,
    },
}

/// Asks every oracle of the panel, and compares.
pub fn examine(panel: &[&dyn Oracle], case: &Case) -> Examination {
    examine_answers(panel, case, panel.iter().map(|oracle| ask(*oracle, case)).collect(), |_, _| true)
}

/// Compares answers that the oracles of the panel have already given to this case: those pairs, by their places, that are `wanted`, and
/// against the laws those that are wanted with themselves.
pub fn examine_answers(
    panel: &[&dyn Oracle],
    case: &Case,
    answers: Vec<Answer>,
    wanted: impl Fn(usize, usize) -> bool,
) -> Examination {
    let checked = answers
        .iter()
        .enumerate()
        .map(|(place, answer)| match &answer.reply {
            _ if !wanted(place, place) => Checked::default(),
            Reply::Observed(observed) => {
                let checked = laws::check(case, answer.model, observed);
                let breach = checked.breach.or_else(|| endings::breach(panel, case, &answers, place));
                Checked { breach, ..checked }
            }
            Reply::Declined(_) => Checked::default(),
            Reply::Panicked(message) => {
                let how = format!("panicked: {message}");
                Checked { breach: Some(Breach { law: Law::Answers, impact: 0, how }), ratio: None }
            }
        })
        .collect();
    let gap = model_gap(panel, &answers, case);
    let conditioning = Conditioning::of(panel, &answers, case);
    let mut pairs = Vec::new();
    for (i, first) in answers.iter().enumerate() {
        for (j, second) in answers.iter().enumerate().skip(i + 1).filter(|(j, _)| wanted(i, *j)) {
            pairs.push((i, j, pair(case, first, second, Slack { conditioning: &conditioning, gap: gap.as_ref() })));
        }
    }
    Examination { answers, checked, pairs, judgements: Vec::new() }
}

/// The gap between the models on this case, by the first linear oracle that has a history. `None` if no pair needs it, or there is none.
fn model_gap(panel: &[&dyn Oracle], answers: &[Answer], case: &Case) -> Option<ModelGap> {
    let has = |model| answers.iter().any(|answer| answer.model == model && answer.observed().is_some());
    if !(has(Model::Linear) && has(Model::Nonlinear)) {
        return None;
    }
    let (oracle, answer) =
        panel.iter().zip(answers).find(|(_, a)| a.model == Model::Linear && a.observed().is_some())?;
    ModelGap::new(*oracle, case, answer.observed()?).ok().flatten()
}

fn pair(case: &Case, first: &Answer, second: &Answer, slack: Slack) -> Pairing {
    let (Some(mine), Some(theirs)) = (first.observed(), second.observed()) else {
        return Pairing::Absent;
    };
    match (first.model, second.model, slack.gap) {
        (one, two, _) if one == two => Pairing::Compared(compare(case, mine, theirs, Slack { gap: None, ..slack })),
        (_, _, None) => Pairing::Incomparable(why_incomparable(case)),
        // The gap scales the velocities of the nonlinear one, which is the second.
        (Model::Linear, _, _) => Pairing::Compared(compare(case, mine, theirs, slack)),
        (Model::Nonlinear, _, _) => Pairing::Compared(compare(case, theirs, mine, slack)),
    }
}

fn why_incomparable(case: &Case) -> &'static str {
    match case.slenderness().map(|slenderness| slenderness.normalisation()) {
        Some(Normalisation::Slender) => "slender normalisation: the models differ in their threshold",
        _ => "no bound on the difference between the models",
    }
}

impl Examination {
    /// Everything that is wrong, laws and the judge first: a disagreement is often explained by them.
    pub fn findings(&self) -> Vec<Finding> {
        let name = |place: usize| self.answers.get(place).map_or_else(String::new, |answer| answer.oracle.clone());
        let laws =
            self.checked.iter().enumerate().filter_map(|(place, checked)| {
                Some(Finding::Law { oracle: name(place), breach: checked.breach.clone()? })
            });
        let pairs = self.pairs.iter().filter_map(|(i, j, outcome)| match outcome {
            Pairing::Compared(Comparison { agreement: Agreement::Disagree(disagreement), .. }) => {
                Some(Finding::Pair { oracles: [name(*i), name(*j)], disagreement: disagreement.clone() })
            }
            _ => None,
        });
        let refuted = self.judgements.iter().filter_map(|Judgement { place, judge, refuted, .. }| {
            let disagreement = refuted.clone()?;
            Some(Finding::Refuted { oracle: name(*place), judge: judge.clone(), disagreement })
        });
        laws.chain(refuted).chain(pairs).collect()
    }

    /// The names of the oracles that the judge was asked about and found nothing wrong with.
    pub fn confirmed(&self) -> Vec<String> {
        let sound = self.judgements.iter().filter(|judgement| judgement.refuted.is_none());
        sound.filter_map(|judgement| Some(self.answers.get(judgement.place)?.oracle.clone())).collect()
    }

    /// The answers that are declines.
    pub fn declines(&self) -> impl Iterator<Item = (&str, &Decline)> {
        self.answers.iter().filter_map(|answer| match &answer.reply {
            Reply::Declined(decline) => Some((answer.oracle.as_str(), decline)),
            _ => None,
        })
    }
}

impl Finding {
    /// The names of the oracles that it is about.
    pub fn oracles(&self) -> Vec<&str> {
        match self {
            Self::Pair { oracles, .. } => oracles.iter().map(String::as_str).collect(),
            Self::Law { oracle, .. } | Self::Refuted { oracle, .. } => vec![oracle],
        }
    }

    /// The first impact that it shows at.
    pub fn impact(&self) -> usize {
        match self {
            Self::Pair { disagreement, .. } | Self::Refuted { disagreement, .. } => disagreement.figure.impact,
            Self::Law { breach, .. } => breach.impact,
        }
    }

    /// Whether it is that an oracle breaks this law.
    pub fn breaks(&self, law: Law) -> bool {
        matches!(self, Self::Law { breach, .. } if breach.law == law)
    }

    /// Whether another finding is of the same oracles and kind, so that a smaller case with it shows the same problem.
    pub fn resembles(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Pair { oracles: mine, .. }, Self::Pair { oracles: theirs, .. }) => mine == theirs,
            (Self::Law { oracle: mine, breach: one }, Self::Law { oracle: theirs, breach: two }) => {
                mine == theirs && one.law == two.law
            }
            (Self::Refuted { oracle: mine, .. }, Self::Refuted { oracle: theirs, .. }) => mine == theirs,
            _ => false,
        }
    }
}
