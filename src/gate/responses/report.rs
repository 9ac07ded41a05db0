//! What was found in whole responses, as data and as text.

use std::fmt::Write;

use serde::{Deserialize, Serialize};

use super::{
    described::described,
    examine::Finding,
    failure::Failure,
    reach::Example,
    relations::Relation,
    shortfall::{Shortfall, shortfalls},
    tally::{MethodCounts, Tally},
};
use crate::{
    cases::shaking::Question,
    gate::{failure::likewise, shortfall::NotJudged, verdict::Verdict},
};

/// What was found in the responses of a run.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// What was run and counted.
    #[serde(flatten)]
    pub tally: Tally,
    /// Those in which something was wrong.
    pub failures: Vec<Failed>,
    /// What is wrong with the run as a whole.
    pub shortfalls: Vec<Shortfall>,
    /// What the run was too small to judge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_judged: Vec<NotJudged>,
}

/// A response in which something was wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Failed {
    /// Its name.
    pub name: String,
    /// `a`, of a sinusoid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub a: Option<f64>,
    /// `ω`, of a sinusoid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub omega: Option<f64>,
    /// What another motion is, in a line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<String>,
    /// `η`.
    pub eta: f64,
    /// `α`, where it has one.
    pub alpha: Option<f64>,
    /// The phase at `τ = 0`; none for the threshold.
    pub phase: Option<f64>,
    /// When the shaking ends, `τ`; none for never.
    pub lasts: Option<f64>,
    /// When the response ends at the latest; none for where nothing can happen any more.
    pub until: Option<f64>,
    /// What was wrong.
    pub findings: Vec<Finding>,
}

impl Report {
    /// The report on responses of which these failed.
    pub(super) fn new(tally: Tally, failures: &[Failure]) -> Self {
        let (shortfalls, not_judged) = shortfalls(&tally);
        Self { tally, failures: failures.iter().map(Failed::from).collect(), shortfalls, not_judged }
    }

    /// With what was found in other responses of the same run. What is concluded waits for [`Self::in_order`].
    pub(in crate::gate) fn and(mut self, other: Self) -> Self {
        self.tally.add_all(other.tally);
        self.failures.extend(other.failures);
        self
    }

    /// In the order of the run, and concluded from all of it.
    pub(in crate::gate) fn in_order(mut self) -> Self {
        // Those on sinusoids come first.
        let number = |name: &str| {
            let number = name.rsplit('/').next().and_then(|number| number.parse().ok()).unwrap_or(usize::MAX);
            (!name.starts_with("response/"), number)
        };
        self.tally.names.sort_by_key(|name| number(name));
        self.tally.left_out.sort_by_key(|name| number(name));
        self.failures.sort_by_key(|failed| number(&failed.name));
        let (shortfalls, not_judged) = shortfalls(&self.tally);
        Self { shortfalls, not_judged, ..self }
    }

    /// What the responses make of the run.
    pub fn verdict(&self) -> Verdict {
        Verdict::of(self.failures.len(), self.shortfalls.iter().map(Shortfall::verdict))
    }
}

impl From<&Failure> for Failed {
    fn from(failure: &Failure) -> Self {
        let question = &failure.question;
        let (sine, motion) = match question {
            Question::Sinusoid(shaking) => (Some(shaking), None),
            Question::Motion(asked) => (None, Some(described(asked))),
        };
        Self {
            name: failure.name.clone(),
            a: sine.map(|sine| sine.case.amplitude()),
            omega: sine.map(|sine| sine.case.omega()),
            motion,
            eta: question.eta(),
            alpha: question.alpha(),
            phase: sine.and_then(|sine| sine.phase),
            lasts: Some(question.lasts()).filter(|lasts| lasts.is_finite()),
            until: Some(question.until()).filter(|until| until.is_finite()),
            findings: failure.findings.clone(),
        }
    }
}

/// What was exercised, in lines of a head and what is said.
pub fn exercised(report: &Report) -> Vec<(&'static str, String)> {
    let Tally { responses, too_close, reach, relations, methods, .. } = &report.tally;
    let sum = |of: fn(&MethodCounts) -> usize| -> usize { methods.values().map(of).sum() };
    let (bouts, impacts) = (sum(|method| method.bouts), sum(|method| method.impacts));
    let foretold = match sum(|method| method.rests) {
        0 => String::new(),
        rests => format!(", {rests} rests foretold"),
    };
    let mut lines = vec![(
        "responses",
        format!(
            "{responses} whole responses by {} methods against a plain follower: {bouts} bouts, {impacts} impacts{foretold}",
            methods.len()
        ),
    )];
    if let Some((name, method)) = methods.iter().max_by(|(_, one), (_, two)| one.used.total_cmp(&two.used)) {
        let used = 100.0 * method.used;
        let kinds = format!("{} of {} kinds of response", reach.len(), Example::ALL.len());
        lines.push((
            "",
            format!("{kinds}; {used:.0} % of what is allowed at the most: {name}; {too_close} too close to call"),
        ));
    }
    if !relations.is_empty() {
        let pairs: usize = relations.values().sum();
        let kinds = format!("{} of {} changes that must not matter", relations.len(), Relation::ALL.len());
        lines.push(("", format!("{kinds}, tried in {pairs} answers")));
    }
    lines
}

/// What went wrong, one thing after the other; empty where nothing did. Of responses in which the same is wrong with the same method, one is shown.
pub fn failures_text(report: &Report) -> String {
    let mut text: String = report.shortfalls.iter().map(|shortfall| format!("SHORTFALL: {shortfall}\n")).collect();
    let groups = by_kind(&report.failures);
    for group in groups.iter().take(SHOWN) {
        let Some((first, others)) = group.split_first() else { continue };
        text += &format!("{}\n", first.text());
        if !others.is_empty() {
            text += &format!("  {}\n", likewise(&others.iter().map(|failed| failed.name.as_str()).collect::<Vec<_>>()));
        }
    }
    if groups.len() > SHOWN {
        let more: usize = groups.iter().skip(SHOWN).map(Vec::len).sum();
        text += &format!("and {} other kinds of failure, in {more} more whole responses\n", groups.len() - SHOWN);
    }
    text
}

/// How many kinds of failure the text shows.
const SHOWN: usize = 5;

/// Failed responses by what is wrong with which methods, in the order in which each was first met.
fn by_kind(failures: &[Failed]) -> Vec<Vec<&Failed>> {
    let alike = |one: &Failed, other: &Failed| {
        let mut pairs = one.findings.iter().zip(&other.findings);
        let same = |(one, other): (&Finding, &Finding)| one.method == other.method && one.wrong.resembles(&other.wrong);
        one.findings.len() == other.findings.len() && pairs.all(same)
    };
    let mut groups: Vec<Vec<&Failed>> = Vec::new();
    for failed in failures {
        match groups.iter_mut().find(|group| group.first().is_some_and(|first| alike(first, failed))) {
            Some(group) => group.push(failed),
            None => groups.push(vec![failed]),
        }
    }
    groups
}

/// Every kind of response, and every method, in a line.
pub fn methods_text(report: &Report) -> String {
    let line = |(name, method): (&String, &MethodCounts)| {
        let MethodCounts { answered, declined, bouts, impacts, rows, wrong, related, rests, used } = method;
        let used = 100.0 * used;
        let compared = match rests {
            0 => format!("{bouts} bouts, {impacts} impacts, {rows} rows"),
            _ => format!("{rests} rests foretold"),
        };
        format!(
            "{name}: {answered} responses ({declined} declined), {compared}, {related} asked again, {wrong} wrong, {used:.1}% of the allowance used\n"
        )
    };
    let reached = report.tally.reach.iter().map(|(reach, count)| format!("{count} {}", reach.name()));
    let reached = format!("responses of each kind: {}\n", reached.collect::<Vec<_>>().join(", "));
    let tried = report.tally.relations.iter().map(|(relation, count)| format!("{count} {}", relation.name()));
    let tried = format!("asked again in a form that must not matter: {}\n", tried.collect::<Vec<_>>().join(", "));
    [reached, tried].into_iter().chain(report.tally.methods.iter().map(line)).collect()
}

impl Failed {
    /// For people, over several lines.
    pub fn text(&self) -> String {
        let Self { name, a, omega, motion, eta, alpha, phase, lasts, until, findings } = self;
        let mut text = format!("FAILED {name}: eta = {eta:?}");
        motion.iter().for_each(|motion| text += &format!(", {motion}"));
        let mut optional = |name: &str, value: &Option<f64>| {
            if let Some(value) = value {
                let _ = write!(text, ", {name} = {value:?}");
            }
        };
        optional("a", a);
        optional("omega", omega);
        optional("alpha", alpha);
        optional("phase", phase);
        optional("the shaking lasts", lasts);
        optional("until", until);
        findings.iter().for_each(|finding| {
            let _ = write!(text, "\n  {finding}");
        });
        text
    }
}
