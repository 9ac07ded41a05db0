//! One case through the whole panel: every oracle's answer, every law, every pair.

use std::time::Instant;

use contract::{Case, Decline, Model, Normalisation, Oracle, conformance::Times};

use crate::{
    gate::{
        compare::{Agreement, Comparison, Slack, compare},
        endings,
        expected::{self, Divergence},
        finding::Finding,
        judge::{Judgement, Judges},
        laws::{self, Breach, Checked, Law},
        time_left,
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
    /// Known divergences whose regime the case is in, by their place in the table, and by how much the two differ.
    pub known: Vec<(usize, f64)>,
    /// How long each answer took, in seconds, where that was measured.
    pub seconds: Vec<f64>,
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

/// Asks every oracle of the panel, and compares.
pub fn examine(panel: &[&dyn Oracle], case: &Case) -> Examination {
    let timed = |oracle: &&dyn Oracle| {
        let start = Instant::now();
        (ask(*oracle, case), start.elapsed().as_secs_f64())
    };
    let (answers, seconds) = panel.iter().map(timed).unzip();
    Examination { seconds, ..examine_answers(panel, case, answers, |_, _| true) }
}

/// Asks every oracle of the panel, compares, and judges if that is `asked` for or something is wrong.
pub fn examine_and_judge(panel: &[&dyn Oracle], judges: &Judges, case: &Case, asked: bool) -> Examination {
    let mut examination = examine(panel, case);
    if let Some(closing) = judges.closing {
        time_left::check(closing, case, &examination.answers, &mut examination.checked);
    }
    let is_wrong = || examination.findings().iter().any(|finding| !finding.is_breakdown());
    if asked || is_wrong() {
        examination.judgements = judges.judge(case, &examination.answers, |_| true);
        examination.acquit(panel, case);
    }
    examination
}

/// Compares answers that the oracles of the panel have already given to this case: those pairs, by their places, that are `wanted`, and
/// against the laws those that are wanted with themselves.
pub fn examine_answers(
    panel: &[&dyn Oracle],
    case: &Case,
    answers: Vec<Answer>,
    wanted: impl Fn(usize, usize) -> bool,
) -> Examination {
    let by_itself = |(place, answer): (usize, &Answer)| match &answer.reply {
        _ if !wanted(place, place) => Checked::default(),
        Reply::Observed(observed) => {
            let times = panel.get(place).map_or(Times::AreSums, |oracle| oracle.times());
            laws::check(case, answer.model, observed, times)
        }
        Reply::Declined(_) | Reply::Broke(_) => Checked::default(),
        Reply::Panicked(message) => {
            let how = format!("panicked: {message}");
            Checked { breach: Some(Breach { law: Law::Answers, impact: 0, how }), ..Checked::default() }
        }
    };
    let mut checked: Vec<Checked> = answers.iter().enumerate().map(by_itself).collect();
    // Who breaks a law bears no witness against others.
    let sound: Vec<bool> = checked.iter().map(|checked| checked.breach.is_none()).collect();
    let is_sound = |place: usize| sound.get(place).is_some_and(|sound| *sound);
    for (place, checked) in
        checked.iter_mut().enumerate().filter(|(place, _)| is_sound(*place) && wanted(*place, *place))
    {
        checked.breach = endings::breach(panel, case, &answers, place, is_sound);
    }
    let gap = model_gap(panel, &answers, case);
    let conditioning = Conditioning::of(panel, &answers, case);
    let mut pairs = Vec::new();
    for (i, first) in answers.iter().enumerate() {
        for (j, second) in answers.iter().enumerate().skip(i + 1).filter(|(j, _)| wanted(i, *j)) {
            pairs.push((i, j, pair(case, first, second, Slack { conditioning: &conditioning, gap: gap.as_ref() })));
        }
    }
    let known = known(case, &answers, &pairs);
    Examination { answers, checked, pairs, judgements: Vec::new(), known, seconds: Vec::new() }
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

fn known(case: &Case, answers: &[Answer], pairs: &[(usize, usize, Pairing)]) -> Vec<(usize, f64)> {
    let mut known = Vec::new();
    for (i, j, pairing) in pairs {
        let (Some(first), Some(second)) = (answers.get(*i), answers.get(*j)) else { continue };
        let comparison = match pairing {
            Pairing::Compared(comparison) => Some(comparison),
            Pairing::Absent | Pairing::Incomparable(_) => None,
        };
        let seen = |(place, entry): (usize, &Divergence)| Some((place, entry.seen(case, first, second, comparison)?));
        known.extend(expected::table().iter().enumerate().filter_map(seen));
    }
    known
}

fn why_incomparable(case: &Case) -> &'static str {
    match case.slenderness().map(|slenderness| slenderness.normalisation()) {
        Some(Normalisation::Slender) => "slender normalisation: the models differ in their threshold",
        _ => "no bound on the difference between the models",
    }
}

impl Examination {
    /// Takes back that what is overturned lands again, where those that say so are refuted by the judge or break a law: they prove nothing.
    fn acquit(&mut self, panel: &[&dyn Oracle], case: &Case) {
        let is_accused =
            |checked: &Checked| checked.breach.as_ref().map(|breach| breach.law) == Some(Law::OverturnedStays);
        let is_refuted =
            |place: usize| self.judgements.iter().any(|judged| judged.place == place && judged.refuted.is_some());
        let is_broken = |place: usize| self.checked.get(place).is_some_and(|checked| checked.breach.is_some());
        let is_sound = |place: usize| !is_refuted(place) && !is_broken(place);
        let accused = self.checked.iter().enumerate().filter(|(_, checked)| is_accused(checked));
        let breach = |place: usize| endings::breach(panel, case, &self.answers, place, is_sound);
        let again: Vec<(usize, Option<Breach>)> = accused.map(|(place, _)| (place, breach(place))).collect();
        for (place, breach) in again {
            if let Some(checked) = self.checked.get_mut(place) {
                checked.breach = breach;
            }
        }
    }

    /// Everything that is wrong, laws and the judge first: a disagreement is often explained by them.
    pub fn findings(&self) -> Vec<Finding> {
        let name = |place: usize| self.answers.get(place).map_or_else(String::new, |answer| answer.oracle.clone());
        let laws =
            self.checked.iter().enumerate().filter_map(|(place, checked)| {
                Some(Finding::Law { oracle: name(place), breach: checked.breach.clone()? })
            });
        let pairs = self.pairs.iter().filter_map(|(i, j, pairing)| match pairing {
            Pairing::Compared(Comparison { agreement: Agreement::Disagree(disagreement), .. }) => {
                Some(Finding::Pair { oracles: [name(*i), name(*j)], disagreement: disagreement.clone() })
            }
            _ => None,
        });
        let refuted = self.judgements.iter().filter_map(|Judgement { place, judge, refuted, .. }| {
            let disagreement = refuted.clone()?;
            Some(Finding::Refuted { oracle: name(*place), judge: judge.clone(), disagreement, granted: false })
        });
        let broke = self.breakdowns().map(|(oracle, decline)| Finding::Broke {
            oracle: oracle.to_owned(),
            breakdown: decline.reason().to_owned(),
            how: decline.to_string(),
        });
        laws.chain(refuted).chain(pairs).chain(broke).collect()
    }

    /// Whether every history that an oracle gave was judged, and there was one.
    pub fn is_judged(&self) -> bool {
        let histories = self.answers.iter().filter(|answer| answer.observed().is_some()).count();
        histories > 0 && self.judgements.len() == histories
    }

    /// The names of the oracles with whose answers the judge found nothing wrong, nor any law.
    pub fn sound(&self) -> Vec<String> {
        let broken = |place: usize| self.checked.get(place).is_some_and(|checked| checked.breach.is_some());
        let sound = self.judgements.iter().filter(|judged| judged.refuted.is_none() && !broken(judged.place));
        sound.filter_map(|judgement| Some(self.answers.get(judgement.place)?.oracle.clone())).collect()
    }

    /// The judges that refute several oracles which agree among themselves: then it is more likely that the judge is wrong.
    pub fn suspect_judges(&self) -> Vec<String> {
        let mut judges: Vec<&str> = self.judgements.iter().map(|judgement| judgement.judge.as_str()).collect();
        judges.dedup();
        let is_suspect = |judge: &&str| {
            let refuted = |judgement: &&Judgement| judgement.judge == *judge && judgement.refuted.is_some();
            let refuted: Vec<usize> = self.judgements.iter().filter(refuted).map(|judgement| judgement.place).collect();
            let among_them = |(one, two, _): &&(usize, usize, Pairing)| refuted.contains(one) && refuted.contains(two);
            let mut pairs = self.pairs.iter().filter(among_them).peekable();
            pairs.peek().is_some()
                && pairs.all(|(.., pairing)| {
                    matches!(pairing, Pairing::Compared(Comparison { agreement: Agreement::Agree, .. }))
                })
        };
        judges.into_iter().filter(is_suspect).map(str::to_owned).collect()
    }

    /// The answers that are declines.
    pub fn declines(&self) -> impl Iterator<Item = (&str, &Decline)> {
        self.answers.iter().filter_map(|answer| match &answer.reply {
            Reply::Declined(decline) => Some((answer.oracle.as_str(), decline)),
            _ => None,
        })
    }

    /// The engines that broke, and how.
    pub fn breakdowns(&self) -> impl Iterator<Item = (&str, &Decline)> {
        self.answers.iter().filter_map(|answer| match &answer.reply {
            Reply::Broke(how) => Some((answer.oracle.as_str(), how)),
            _ => None,
        })
    }
}
