//! What is wrong with a run as a whole, although every case may be right: it did not prove what a run has to prove. Any of these turns it red.
//!
//! What is counted or measured over many cases is only demanded where there were many: a small run, or a small share of one, is not red for being
//! small. What it could not judge is listed beside.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::{
    gate::{
        calibration::{self, Band},
        expected,
        identity::Identity,
        ladder::Descent,
        pair::Pair,
        roles::Roles,
        run::Run,
        tolerance,
        verdict::Verdict,
    },
    measure::observables::Observable,
};

/// One thing that a run fails to prove.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Shortfall {
    /// Fewer than two oracles.
    Alone,
    /// The cases that were examined are not those that were to be run.
    Unaccounted {
        /// What was to be run.
        handed: Identity,
        /// What was.
        examined: Identity,
    },
    /// The run was ended before all cases were run: what it found stands, what it would have found is not known.
    Interrupted {
        /// How many cases were run.
        examined: usize,
        /// Of how many.
        handed: usize,
    },
    /// An oracle gave no history at all.
    Silent {
        /// Its name.
        oracle: String,
    },
    /// An engine for the nonlinear block was asked nothing, for no case has the slenderness that it takes.
    NotAsked {
        /// Its name.
        oracle: String,
        /// How many cases there were.
        cases: usize,
    },
    /// An oracle declined more than it may.
    Declined {
        /// Its name.
        oracle: String,
        /// How many cases.
        declined: usize,
        /// Of how many.
        cases: usize,
        /// How many it may decline.
        allowed: f64,
    },
    /// A pair was never compared by an impact.
    NoImpact {
        /// Their names.
        oracles: [String; 2],
    },
    /// A pair was never compared by a chattering time.
    NoChatteringTime {
        /// Their names.
        oracles: [String; 2],
    },
    /// A pair claims so little that most of what was compared would have passed anyway.
    InNameOnly {
        /// Their names.
        oracles: [String; 2],
        /// Whether chattering times are meant; otherwise impacts.
        times: bool,
        /// How many.
        vacuous: usize,
        /// Of how many.
        compared: usize,
    },
    /// A pair allows so much that nothing ever comes near to it.
    Unused {
        /// Their names.
        oracles: [String; 2],
        /// The observable that uses least of what is allowed.
        observable: Observable,
        /// The share of it that it uses where it uses most.
        share: f64,
    },
    /// A pair ends differently, within what it claims, in most of the cases.
    TooClose {
        /// Their names.
        oracles: [String; 2],
        /// How many cases.
        too_close: usize,
        /// Of how many.
        compared: usize,
    },
    /// The judge judged too few of the cases that it was asked.
    Unjudged {
        /// How many it was asked.
        asked: usize,
        /// How many it judged.
        judged: usize,
    },
    /// An oracle claims far more than its true error.
    TooWide {
        /// Its name.
        oracle: String,
        /// Of which observable.
        observable: Observable,
        /// The median of its claims in multiples of its true errors.
        median: f64,
        /// What that may be.
        allowed: f64,
    },
    /// An oracle's claims have changed against its true errors, to less or to more than what is on record.
    Recalibrated {
        /// Its name.
        oracle: String,
        /// Of which observable.
        observable: Observable,
        /// The median of its claims in multiples of its true errors.
        median: f64,
        /// What is on record.
        recorded: f64,
    },
    /// A ladder on which a difference does not fall at the order at which it has to.
    Crooked {
        /// The ladder.
        descent: Descent,
    },
    /// A known divergence that no longer shows: the entry is out of date, or the gate has stopped looking.
    NoLongerDiverges {
        /// What the entry says.
        divergence: String,
    },
    /// A known failure of an engine that no longer fails: the entry is out of date, or the gate has stopped looking.
    NoLongerFails {
        /// The name of the engine.
        oracle: String,
        /// What the entry says.
        failure: String,
        /// In how many cases it did not show.
        met: usize,
        /// The file and the line of the entry.
        entry: String,
    },
    /// Nothing at all was compared, or in name only.
    NothingCompared,
}

/// What a run was too small to judge, as one reads it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NotJudged {
    /// What.
    pub what: String,
    /// How many cases there were.
    pub cases: usize,
    /// How many it takes.
    pub needed: usize,
}

/// How many cases it takes until a share of them, a worst figure or a median says something.
const MANY: usize = 100;
/// How many until an oracle that never answered, or a pair that never met, is one that never does.
const SEVERAL: usize = 20;

/// What is wrong with a run. One that is `whole` has to prove something by itself; one of a few chosen cases only has to have compared anything.
pub fn shortfalls(run: &Run, roles: &Roles) -> (Vec<Shortfall>, Vec<NotJudged>) {
    let mut found = Found::default();
    let (handed, examined) = (run.handed, run.tally.examined);
    if !run.left_out.is_empty() {
        // The cases that were run are no fair sample of all: nothing is concluded from how many of them were what.
        found.add(Some(Shortfall::Interrupted { examined: examined.cases, handed: handed.cases }));
        return (found.shortfalls, Vec::new());
    }
    found.add((handed != examined).then_some(Shortfall::Unaccounted { handed, examined }));
    if !run.whole {
        let nothing = run.pairs.iter().all(|pair| pair.impacts == pair.vacuous);
        found.add(nothing.then_some(Shortfall::NothingCompared));
        return (found.shortfalls, Vec::new());
    }
    found.add((run.oracles.len() < 2).then_some(Shortfall::Alone));
    let cases = examined.cases;
    if found.enough("that every oracle answers", cases, SEVERAL) {
        let answered = &run.tally.answered;
        // One that broke in every case is told by its cases.
        let says_nothing = |oracle: &&String| !answered.contains_key(*oracle) && !run.tally.broke.contains_key(*oracle);
        let silent = run.oracles.iter().filter(says_nothing);
        found.extend(silent.map(|oracle| Shortfall::Silent { oracle: oracle.clone() }));
    }
    if found.enough("how often an oracle declines", cases, MANY) {
        found.extend(run.tally.declines.iter().filter_map(|(oracle, reasons)| {
            let declined: usize = reasons.values().sum();
            let allowed = ((roles.may_decline)(oracle) * cases as f64).max(MOST_DECLINES_OF_FEW);
            (declined as f64 > allowed).then(|| Shortfall::Declined {
                oracle: oracle.clone(),
                declined,
                cases,
                allowed,
            })
        }));
    }
    if found.enough("what every pair compares", cases, SEVERAL) {
        let fewest = run.pairs.iter().map(|pair| pair.compared).min().unwrap_or(0);
        let used = cases >= MANY && fewest >= MANY;
        found.enough("that the claims are not too wide to find anything", if used { cases } else { fewest }, MANY);
        found.extend(run.pairs.iter().filter_map(|pair| of_pair(pair, roles)));
    }
    found.extend(of_judge(run));
    of_calibration(run, roles, &mut found);
    found.extend(run.known.iter().filter(|known| known.is_out_of_date).map(|known| Shortfall::NoLongerFails {
        oracle: known.oracle.clone(),
        failure: known.says.clone(),
        met: known.met,
        entry: known.entry.clone(),
    }));
    found.extend(of_ladders(run));
    found.extend(out_of_date(run));
    (found.shortfalls, found.not_judged)
}

/// In a run of few cases as many declines prove nothing.
pub(super) const MOST_DECLINES_OF_FEW: f64 = 10.0;

#[derive(Default)]
struct Found {
    shortfalls: Vec<Shortfall>,
    not_judged: Vec<NotJudged>,
}

impl Found {
    fn add(&mut self, shortfall: Option<Shortfall>) {
        self.shortfalls.extend(shortfall);
    }

    fn extend(&mut self, shortfalls: impl IntoIterator<Item = Shortfall>) {
        self.shortfalls.extend(shortfalls);
    }

    /// Whether there are enough cases; notes it where there are not.
    fn enough(&mut self, what: &str, cases: usize, needed: usize) -> bool {
        if cases < needed {
            self.not_judged.push(NotJudged { what: what.to_owned(), cases, needed });
        }
        cases >= needed
    }
}

/// What the comparisons of a pair fail to prove, if anything.
fn of_pair(pair: &Pair, roles: &Roles) -> Option<Shortfall> {
    let oracles = pair.oracles.clone();
    // A share of few cases says little, but for all of them.
    let most = if pair.compared >= MANY { tolerance::VACUOUS.value } else { 1.0 };
    let never_rests = oracles.iter().any(|oracle| (roles.never_rests)(oracle));
    let is_granted = oracles.iter().any(|oracle| (roles.granted)(oracle));
    let too_many = |vacuous: usize, all: usize| vacuous == all || vacuous as f64 > most * all as f64;
    if pair.impacts == 0 {
        Some(Shortfall::NoImpact { oracles })
    } else if pair.chattering_times == 0 && !never_rests {
        Some(Shortfall::NoChatteringTime { oracles })
    } else if too_many(pair.vacuous, pair.impacts) {
        Some(Shortfall::InNameOnly { oracles, times: false, vacuous: pair.vacuous, compared: pair.impacts })
    } else if pair.chattering_times > 0 && too_many(pair.vacuous_times, pair.chattering_times) {
        let (vacuous, compared) = (pair.vacuous_times, pair.chattering_times);
        Some(Shortfall::InNameOnly { oracles, times: true, vacuous, compared })
    } else if pair.compared >= MANY && pair.disagreements == 0 && !is_granted && pair.used().1 < tolerance::USED.value {
        let (observable, share) = pair.used();
        Some(Shortfall::Unused { oracles, observable, share })
    } else if 2 * pair.too_close > pair.compared {
        Some(Shortfall::TooClose { oracles, too_close: pair.too_close, compared: pair.compared })
    } else {
        None
    }
}

fn of_judge(run: &Run) -> Option<Shortfall> {
    let (asked, judged) = (run.tally.to_judge, run.tally.judged);
    let silent = asked >= SEVERAL && (judged as f64) < tolerance::JUDGED.value * asked as f64;
    silent.then_some(Shortfall::Unjudged { asked, judged })
}

/// What is wrong with the claims as a whole. A claim that is too small is a finding of its case.
fn of_calibration(run: &Run, roles: &Roles, found: &mut Found) {
    let judged = run.tally.judged;
    let many = run.tally.to_judge > 0 && found.enough("how the claims compare with the true errors", judged, MANY);
    if !many {
        return;
    }
    let record = found.enough("that the claims are as wide as on record", judged, calibration::CASES_ON_RECORD);
    for (oracle, claims) in run.tally.claims.iter().filter(|(oracle, _)| !(roles.granted)(oracle)) {
        for (observable, figure) in claims.figures() {
            let (oracle, median, allowed) = (oracle.clone(), figure.median, tolerance::CALIBRATION.value);
            if figure.numbers < MANY {
                continue;
            }
            if figure.median > allowed {
                found.add(Some(Shortfall::TooWide { oracle, observable, median, allowed }));
            } else if let Some(Band { recorded, .. }) =
                calibration::band(&oracle, observable).filter(|band| record && !band.contains(median))
            {
                found.add(Some(Shortfall::Recalibrated { oracle, observable, median, recorded }));
            }
        }
    }
}

fn of_ladders(run: &Run) -> impl Iterator<Item = Shortfall> {
    run.ladders.iter().filter_map(|descent| {
        let known = expected::table().iter().find(|entry| entry.excuses(descent));
        match (descent.holds(), known) {
            (false, None) => Some(Shortfall::Crooked { descent: descent.clone() }),
            (true, None) | (false, Some(_)) => None,
            (true, Some(entry)) => Some(Shortfall::NoLongerDiverges { divergence: entry.says() }),
        }
    })
}

fn out_of_date(run: &Run) -> impl Iterator<Item = Shortfall> {
    expected::table().iter().enumerate().filter_map(|(place, entry)| {
        let met = run.tally.known.get(&place)?;
        entry.is_out_of_date(*met).then(|| Shortfall::NoLongerDiverges { divergence: entry.says() })
    })
}

impl Shortfall {
    /// What it means for the run.
    pub fn verdict(&self) -> Verdict {
        Verdict::of_shortfall(matches!(self, Self::Interrupted { .. }))
    }

    /// What to do about it; an engine is somebody else's, and what is said of it its author can do.
    pub fn advice(&self, is_of_engine: bool) -> &'static str {
        match self {
            Self::NoChatteringTime { .. } if is_of_engine => {
                "the engine has to end with \"at-rest\" where infinitely many impacts follow; if it can't, never-at-rest = true in its manifest says so"
            }
            Self::Silent { .. } if is_of_engine => "chattercheck engine check says why the engine answers nothing",
            Self::Declined { .. } if is_of_engine => {
                "see what it declines above; may-decline in its manifest is the share of a run that it may"
            }
            Self::NotAsked { .. } => "give the cases a slenderness: alpha, in radians",
            Self::NoLongerFails { .. } => "delete the entry that is named",
            Self::Interrupted { .. } => "run it again to its end",
            Self::Unaccounted { .. }
            | Self::NoLongerDiverges { .. }
            | Self::Crooked { .. }
            | Self::TooWide { .. }
            | Self::Recalibrated { .. } => "that is a fault of chattercheck or of its oracles: please report it",
            Self::Alone
            | Self::Silent { .. }
            | Self::Declined { .. }
            | Self::NoImpact { .. }
            | Self::NoChatteringTime { .. }
            | Self::InNameOnly { .. }
            | Self::Unused { .. }
            | Self::TooClose { .. }
            | Self::Unjudged { .. }
            | Self::NothingCompared => {
                "ask for more cases (--cases N), or for more judging (--judge all); see what was declined"
            }
        }
    }

    /// Without the numbers of a ladder, for tables.
    pub fn in_short(&self) -> String {
        match self {
            Self::Crooked { descent } => descent.ladder.says().to_owned(),
            other => other.to_string(),
        }
    }

    /// The oracles that it is about.
    pub fn oracles(&self) -> Vec<&str> {
        match self {
            Self::Silent { oracle } | Self::NotAsked { oracle, .. } | Self::Declined { oracle, .. } => vec![oracle],
            Self::TooWide { oracle, .. } | Self::Recalibrated { oracle, .. } => vec![oracle],
            Self::NoLongerFails { oracle, .. } => vec![oracle],
            Self::NoImpact { oracles }
            | Self::NoChatteringTime { oracles }
            | Self::InNameOnly { oracles, .. }
            | Self::Unused { oracles, .. }
            | Self::TooClose { oracles, .. } => oracles.iter().map(String::as_str).collect(),
            Self::Crooked { descent } => descent.oracles.iter().map(String::as_str).collect(),
            Self::Alone
            | Self::Unaccounted { .. }
            | Self::Interrupted { .. }
            | Self::Unjudged { .. }
            | Self::NoLongerDiverges { .. }
            | Self::NothingCompared => Vec::new(),
        }
    }
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Alone => f.write_str("fewer than two oracles: nothing was compared"),
            Self::Unaccounted { handed, examined } => write!(
                f,
                "{} cases were to be run (hash {:016x}) and {} were examined (hash {:016x})",
                handed.cases, handed.hash, examined.cases, examined.hash
            ),
            Self::Interrupted { examined, handed } => {
                write!(f, "interrupted after {examined} of {handed} cases: the report is partial")
            }
            Self::Silent { oracle } => {
                write!(f, "{oracle} answered no case: a gate where everything is declined proves nothing")
            }
            Self::NotAsked { oracle, cases } => write!(
                f,
                "{oracle} was asked nothing: none of {cases} cases has a slenderness, which its model needs; give them one, as alpha = 0.2"
            ),
            Self::Declined { oracle, declined, cases, allowed } => {
                write!(f, "{oracle} declined {declined} of {cases} cases, {allowed:.0} expected at the most")
            }
            Self::NoImpact { oracles: [one, two] } => write!(f, "{one} and {two}: no impact was compared"),
            Self::NoChatteringTime { oracles: [one, two] } => {
                write!(f, "{one} and {two}: no chattering time was compared")
            }
            Self::InNameOnly { oracles: [one, two], times, vacuous, compared } => {
                let what = if *times { "chattering times" } else { "impacts" };
                write!(
                    f,
                    "{one} and {two} claim so little that {vacuous} of {compared} {what} were compared in name only"
                )
            }
            Self::Unused { oracles: [one, two], observable, share } => {
                write!(f, "{one} and {two} allow so much that the worst {observable} uses {share:.1e} of it")
            }
            Self::TooClose { oracles: [one, two], too_close, compared } => {
                write!(f, "{one} and {two} end differently in {too_close} of {compared} cases")
            }
            Self::Unjudged { asked, judged } => write!(f, "the judge was asked {asked} cases and judged {judged}"),
            Self::TooWide { oracle, observable, median, allowed } => write!(
                f,
                "{oracle} claims {median:.0} times its true error in the median ({observable}), {allowed} at most"
            ),
            Self::Recalibrated { oracle, observable, median, recorded } => write!(
                f,
                "{oracle} claims {median:.2} times its true error in the median ({observable}), {recorded:.2} on record"
            ),
            Self::Crooked { descent } => f.write_str(&descent.describe()),
            Self::NoLongerDiverges { divergence } => {
                write!(f, "a known divergence no longer shows: {divergence} (data/expected.toml)")
            }
            Self::NoLongerFails { failure, met, entry, .. } => {
                write!(f, "a known failure no longer shows in {met} cases: {failure}; delete it: {entry}")
            }
            Self::NothingCompared => f.write_str(
                "nothing was compared: the oracles declined, or claim so little that nearly anything would have passed",
            ),
        }
    }
}

#[cfg(test)]
mod tests;
