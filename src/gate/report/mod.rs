//! What a verification run found, as data; and as text and JUnit.

mod junit;
mod text;

use std::collections::BTreeMap;

use contract::Ending;
use serde::{Deserialize, Serialize};

use crate::{
    cases::{
        case_file::CaseFields,
        generate::{Generator, Named},
    },
    gate::{
        compare::{Agreement, Comparison, Figure},
        examine::{Examination, Finding, Pairing},
        judge::{Calibration, ClaimOverError},
        ladder::Descent,
        run::Failure,
        tolerance,
    },
    measure::observables::Observable,
    panel,
};

pub use junit::junit;
pub use text::{failure_text, finding_text, text};

/// The whole report. It holds no times and no names of machines: the same seed gives the same report, on any number of threads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The version of this program.
    pub version: String,
    /// The seed of the random cases.
    pub seed: u64,
    /// The names of the oracles.
    pub oracles: Vec<String>,
    /// What was exercised.
    pub reach: Reach,
    /// How often each oracle declined, by reason.
    pub declines: BTreeMap<String, BTreeMap<String, usize>>,
    /// Every pair of oracles.
    pub pairs: Vec<Pair>,
    /// The interval ratio of each oracle against its law.
    pub ratio_law: BTreeMap<String, WorstFigure>,
    /// How the claims of each oracle compare with its true errors, on the cases that were judged.
    pub judged: Judged,
    /// The ladders.
    pub ladders: Vec<Descent>,
    /// Cases in which something was wrong.
    pub failures: Vec<FailedCase>,
    /// What is wrong with the run as a whole: an oracle that never answered, a pair that was never compared, a ladder that does not hold.
    pub shortfalls: Vec<String>,
    /// `pass` or `fail`.
    pub verdict: String,
}

/// What the judge found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Judged {
    /// How many cases it was to be asked.
    pub asked: usize,
    /// Of how many it judged every history; also of those in which something was wrong.
    pub cases: usize,
    /// For each oracle and observable, its claims in multiples of its true errors.
    pub claims: BTreeMap<String, BTreeMap<Observable, ClaimOverError>>,
}

/// What a run exercised.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Reach {
    /// How many cases.
    pub cases: usize,
    /// Of them, from each generator.
    pub by_generator: BTreeMap<Generator, usize>,
    /// Histories of all oracles, by how they ended.
    pub endings: BTreeMap<String, usize>,
    /// Impacts in the histories of all oracles.
    pub impacts: usize,
    /// The shortest interval that two oracles agreed on.
    pub deepest_interval: Option<f64>,
    /// The smallest and largest of each parameter.
    pub epsilon: Option<(f64, f64)>,
    /// See `epsilon`.
    pub omega: Option<(f64, f64)>,
    /// See `epsilon`.
    pub eta: Option<(f64, f64)>,
}

/// What came out for a pair of oracles.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Their names.
    pub oracles: [String; 2],
    /// How many cases were compared.
    pub compared: usize,
    /// How many impacts.
    pub impacts: usize,
    /// Of them, how many in name only: with claims so wide that nearly anything would have passed.
    pub vacuous: usize,
    /// How many chattering times, and of them, how many in name only.
    pub chattering_times: usize,
    /// See `chattering_times`.
    pub vacuous_times: usize,
    /// Cases in which one of the two gave no history.
    pub absent: usize,
    /// Cases that are different problems to the two, by reason.
    pub incomparable: BTreeMap<String, usize>,
    /// Cases that are complete for one and incomplete for the other, within what they claim.
    pub too_close: usize,
    /// Cases in which they disagree.
    pub disagreements: usize,
    /// For each observable the figure that used most of its allowance, among those of cases in which they agree; those of the failures are
    /// listed with them.
    pub worst: BTreeMap<Observable, WorstFigure>,
}

/// A figure, its share of the allowance, and the case that gave it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorstFigure {
    /// The figure.
    #[serde(flatten)]
    pub figure: Figure,
    /// The share of the allowance.
    pub share: f64,
    /// The case.
    pub case: String,
}

/// A case in which something was wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FailedCase {
    /// Its name.
    pub name: String,
    /// Its parameters.
    pub case: CaseFields,
    /// What was wrong.
    pub findings: Vec<Finding>,
    /// The oracles whose answers the judge confirmed.
    #[serde(default)]
    pub confirmed: Vec<String>,
}

/// The part of a report that is gathered case by case.
#[derive(Debug, Default)]
pub struct Tally {
    reach: Reach,
    declines: BTreeMap<String, BTreeMap<String, usize>>,
    answered: BTreeMap<String, usize>,
    pairs: BTreeMap<(usize, usize), Pair>,
    ratio_law: BTreeMap<String, WorstFigure>,
    judged: usize,
    to_judge: usize,
    claims: BTreeMap<String, Calibration>,
}

impl WorstFigure {
    fn new(named: &Named, figure: Figure) -> Self {
        Self { figure, share: figure.share(), case: named.to_string() }
    }
}

impl Tally {
    /// An empty tally of a run in which so many cases are to be judged.
    pub fn expecting(to_judge: usize) -> Self {
        Self { to_judge, ..Self::default() }
    }

    /// The tally of one case.
    pub fn of(named: &Named, examination: &Examination) -> Self {
        let mut tally = Self::default();
        let case = &named.case;
        let reach = &mut tally.reach;
        reach.cases = 1;
        reach.by_generator.insert(named.generator, 1);
        reach.epsilon = Some((case.epsilon(), case.epsilon()));
        reach.omega = Some((case.omega(), case.omega()));
        reach.eta = Some((case.eta(), case.eta()));
        for answer in &examination.answers {
            let Some(observed) = answer.observed() else { continue };
            *tally.answered.entry(answer.oracle.clone()).or_default() += 1;
            *reach.endings.entry(ending_name(observed.history.ending)).or_default() += 1;
            reach.impacts += observed.history.impacts.len();
        }
        for (oracle, decline) in examination.declines() {
            *tally.declines.entry(oracle.to_owned()).or_default().entry(decline.reason().to_owned()).or_default() += 1;
        }
        for (answer, checked) in examination.answers.iter().zip(&examination.checked) {
            if let Some(figure) = checked.ratio {
                tally.ratio_law.insert(answer.oracle.clone(), WorstFigure::new(named, figure));
            }
        }
        // A case is judged when every history that an oracle gave is.
        let histories = examination.answers.iter().filter(|answer| answer.observed().is_some()).count();
        tally.judged = usize::from(histories > 0 && examination.judgements.len() == histories);
        for judgement in &examination.judgements {
            if let Some(answer) = examination.answers.get(judgement.place) {
                tally.claims.insert(answer.oracle.clone(), judgement.calibration.clone());
            }
        }
        for (i, j, outcome) in &examination.pairs {
            let interval = |place: usize, n: usize| {
                let impacts = &examination.answers.get(place)?.observed()?.history.impacts;
                Some(impacts.get(n.checked_sub(1)?)?.interval)
            };
            let pair = tally.pairs.entry((*i, *j)).or_default();
            match outcome {
                Pairing::Absent => pair.absent = 1,
                Pairing::Incomparable(why) => {
                    pair.incomparable.insert((*why).to_owned(), 1);
                }
                Pairing::Compared(comparison) => {
                    pair.add_comparison(named, comparison);
                    let deepest = interval(*i, comparison.impacts);
                    if comparison.agreement == Agreement::Agree && comparison.vacuous == 0 {
                        tally.reach.deepest_interval = smaller(tally.reach.deepest_interval, deepest);
                    }
                }
            }
        }
        tally
    }

    /// Adds the tally of a later case.
    pub fn add(&mut self, other: Self) {
        let (mine, theirs) = (&mut self.reach, other.reach);
        mine.cases += theirs.cases;
        mine.impacts += theirs.impacts;
        add_counts(&mut mine.by_generator, theirs.by_generator);
        add_counts(&mut mine.endings, theirs.endings);
        mine.deepest_interval = smaller(mine.deepest_interval, theirs.deepest_interval);
        mine.epsilon = wider(mine.epsilon, theirs.epsilon);
        mine.omega = wider(mine.omega, theirs.omega);
        mine.eta = wider(mine.eta, theirs.eta);
        add_counts(&mut self.answered, other.answered);
        for (oracle, reasons) in other.declines {
            add_counts(self.declines.entry(oracle).or_default(), reasons);
        }
        for (oracle, worst) in other.ratio_law {
            keep_worst(&mut self.ratio_law, oracle, worst);
        }
        self.judged += other.judged;
        self.to_judge += other.to_judge;
        for (oracle, calibration) in other.claims {
            self.claims.entry(oracle).or_default().add_all(calibration);
        }
        for (places, pair) in other.pairs {
            self.pairs.entry(places).or_default().add(pair);
        }
    }
}

impl Pair {
    fn add_comparison(&mut self, named: &Named, comparison: &Comparison) {
        self.compared = 1;
        self.impacts = comparison.impacts;
        self.vacuous = comparison.vacuous;
        self.chattering_times = usize::from(comparison.chattering_time.is_some());
        self.vacuous_times = usize::from(comparison.chattering_time == Some(false));
        match comparison.agreement {
            Agreement::Agree => {
                for (&observable, &figure) in &comparison.worst {
                    self.worst.insert(observable, WorstFigure::new(named, figure));
                }
            }
            Agreement::TooClose => self.too_close = 1,
            Agreement::Disagree(_) => self.disagreements = 1,
        }
    }

    fn add(&mut self, other: Self) {
        self.compared += other.compared;
        self.impacts += other.impacts;
        self.vacuous += other.vacuous;
        self.chattering_times += other.chattering_times;
        self.vacuous_times += other.vacuous_times;
        self.absent += other.absent;
        self.too_close += other.too_close;
        self.disagreements += other.disagreements;
        add_counts(&mut self.incomparable, other.incomparable);
        for (observable, worst) in other.worst {
            keep_worst(&mut self.worst, observable, worst);
        }
    }

    /// The observable that used least of its allowance where it came nearest to it, and that share.
    fn used(&self) -> (Observable, f64) {
        let shares = self.worst.iter().map(|(&observable, worst)| (observable, worst.share));
        shares.min_by(|(_, one), (_, two)| one.total_cmp(two)).unwrap_or((Observable::Interval, 0.0))
    }

    /// What the comparisons of the pair fail to prove, if anything.
    fn shortfall(&self) -> Option<String> {
        let [one, two] = &self.oracles;
        let too_many = |vacuous: usize, all: usize| vacuous as f64 > tolerance::VACUOUS.value * all as f64;
        if self.impacts == 0 {
            Some(format!("{one} and {two}: no impact was compared"))
        } else if self.chattering_times == 0 {
            Some(format!("{one} and {two}: no chattering time was compared"))
        } else if too_many(self.vacuous, self.impacts) {
            let (vacuous, impacts) = (self.vacuous, self.impacts);
            Some(format!(
                "{one} and {two} claim so little that {vacuous} of {impacts} impacts were compared in name only"
            ))
        } else if too_many(self.vacuous_times, self.chattering_times) {
            let (vacuous, times) = (self.vacuous_times, self.chattering_times);
            Some(format!(
                "{one} and {two} claim so little that {vacuous} of {times} chattering times were compared in name only"
            ))
        } else if self.compared >= 100 && self.disagreements == 0 && self.used().1 < tolerance::USED.value {
            let (observable, share) = self.used();
            Some(format!("{one} and {two} allow so much that the worst {observable} uses {share:.1e} of it"))
        } else if 2 * self.too_close > self.compared {
            Some(format!("{one} and {two} end differently in {} of {} cases", self.too_close, self.compared))
        } else {
            None
        }
    }
}

impl Judged {
    /// What is wrong with the claims as a whole. A claim that is too small is a finding of its case.
    fn shortfalls(&self) -> impl Iterator<Item = String> {
        let (asked, cases) = (self.asked, self.cases);
        let silent = (cases as f64) < tolerance::JUDGED.value * asked as f64;
        let silent = silent.then(|| format!("the judge was asked {asked} cases and judged {cases}"));
        let wide = move |(oracle, claims): (&String, &BTreeMap<Observable, ClaimOverError>)| {
            let enough = claims.iter().filter(|(_, figure)| figure.numbers >= ENOUGH_TO_CALIBRATE);
            let (observable, figure) = enough.max_by(|(_, one), (_, two)| one.median.total_cmp(&two.median))?;
            let most = tolerance::CALIBRATION.value;
            (cases >= ENOUGH_TO_CALIBRATE && figure.median > most).then(|| {
                let median = figure.median;
                format!("{oracle} claims {median:.0} times its true error in the median ({observable}), {most} at most")
            })
        };
        silent.into_iter().chain(self.claims.iter().filter_map(wide))
    }
}

/// A median of fewer cases, or of fewer numbers, says little: the numbers of one case go together.
const ENOUGH_TO_CALIBRATE: usize = 100;

impl Report {
    /// The report of a run. A whole run has to prove something by itself; that of a few chosen cases only has to have compared anything.
    pub fn new(
        oracles: &[&str],
        seed: u64,
        tally: Tally,
        ladders: Vec<Descent>,
        failures: &[Failure],
        whole: bool,
    ) -> Self {
        let name = |place: usize| oracles.get(place).copied().unwrap_or_default().to_owned();
        let pairs: Vec<Pair> =
            tally.pairs.into_iter().map(|((i, j), pair)| Pair { oracles: [name(i), name(j)], ..pair }).collect();
        let claims = tally.claims.iter().map(|(oracle, claims)| (oracle.clone(), claims.figures())).collect();
        let judged = Judged { asked: tally.to_judge, cases: tally.judged, claims };
        let shortfalls = if whole {
            let silent = oracles
                .iter()
                .filter(|oracle| !tally.answered.contains_key(**oracle))
                .map(|oracle| format!("{oracle} answered no case: a gate where everything is declined proves nothing"));
            let declined = tally.declines.iter().filter_map(|(oracle, reasons)| {
                let (declined, cases) = (reasons.values().sum::<usize>(), tally.reach.cases);
                let allowed = panel::may_decline(oracle) * cases as f64;
                let too_many = declined as f64 > allowed.max(MOST_DECLINES_OF_FEW);
                too_many.then(|| {
                    format!("{oracle} declined {declined} of {cases} cases, {allowed:.0} expected at the most")
                })
            });
            let alone = (oracles.len() < 2).then(|| "fewer than two oracles: nothing was compared".to_owned());
            let crooked = ladders.iter().filter(|descent| !descent.holds()).map(Descent::describe);
            silent
                .chain(declined)
                .chain(alone)
                .chain(pairs.iter().filter_map(Pair::shortfall))
                .chain(judged.shortfalls())
                .chain(crooked)
                .collect()
        } else if pairs.iter().all(|pair| pair.impacts == pair.vacuous) {
            vec![
                "nothing was compared: the oracles declined, or claim so little that nearly anything would have passed"
                    .to_owned(),
            ]
        } else {
            Vec::new()
        };
        let failures: Vec<FailedCase> = failures
            .iter()
            .map(|failure| FailedCase {
                name: failure.named.to_string(),
                case: CaseFields::from(&failure.named.case),
                findings: failure.findings.clone(),
                confirmed: failure.confirmed.clone(),
            })
            .collect();
        let verdict = if failures.is_empty() && shortfalls.is_empty() { "pass" } else { "fail" };
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            seed,
            oracles: oracles.iter().map(|&oracle| oracle.to_owned()).collect(),
            reach: tally.reach,
            declines: tally.declines,
            pairs,
            ratio_law: tally.ratio_law,
            judged,
            ladders,
            failures,
            shortfalls,
            verdict: verdict.to_owned(),
        }
    }

    /// Whether nothing was wrong.
    pub fn passes(&self) -> bool {
        self.failures.is_empty() && self.shortfalls.is_empty()
    }
}

/// In a run of few cases as many declines prove nothing.
const MOST_DECLINES_OF_FEW: f64 = 10.0;

/// A short name for an ending, for counting.
fn ending_name(ending: Ending) -> String {
    match ending {
        Ending::NeverRocks => "never-rocks",
        Ending::AtRest => "at-rest",
        Ending::Incomplete => "incomplete",
        Ending::Overturned => "overturned",
        Ending::LimitReached(_) => "limit-reached",
        Ending::Lost(_) => "lost",
    }
    .to_owned()
}

fn add_counts<K: Ord>(mine: &mut BTreeMap<K, usize>, theirs: BTreeMap<K, usize>) {
    for (key, count) in theirs {
        *mine.entry(key).or_default() += count;
    }
}

/// Keeps the figure with the larger share; the earlier case where they are equal.
fn keep_worst<K: Ord>(mine: &mut BTreeMap<K, WorstFigure>, key: K, theirs: WorstFigure) {
    match mine.get(&key) {
        Some(worst) if worst.share >= theirs.share => {}
        _ => {
            mine.insert(key, theirs);
        }
    }
}

fn smaller(one: Option<f64>, two: Option<f64>) -> Option<f64> {
    match (one, two) {
        (Some(one), Some(two)) => Some(one.min(two)),
        _ => one.or(two),
    }
}

fn wider(one: Option<(f64, f64)>, two: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (one, two) {
        (Some((low, high)), Some((lower, higher))) => Some((low.min(lower), high.max(higher))),
        _ => one.or(two),
    }
}
