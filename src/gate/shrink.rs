//! From a case that fails to the smallest one that still fails in the same way.

use contract::{Case, Horizon, Oracle, Slenderness};

use crate::gate::{
    examine::{examine, examine_and_judge},
    finding::Finding,
    judge::Judges,
    laws::Law,
};

/// How many candidates are tried for one case at the most: it is counted, not timed, so that the same run shrinks to the same cases.
const TRIES: usize = 120;

/// The smallest case found that still fails in the same way.
#[derive(Debug, Clone, PartialEq)]
pub struct Shrunk {
    /// The case.
    pub case: Case,
    /// What is wrong with it.
    pub finding: Finding,
    /// The oracles that it takes to see it, by name.
    pub oracles: Vec<String>,
    /// How many candidates were tried.
    pub tried: usize,
}

/// The case as it is.
pub fn unshrunk(panel: &[&dyn Oracle], case: &Case, finding: &Finding) -> Shrunk {
    let oracles = concerned(panel, finding).iter().map(|oracle| oracle.name().to_owned()).collect();
    Shrunk { case: *case, finding: finding.clone(), oracles, tried: 0 }
}

/// The smallest case found that still has a finding resembling `finding`, and that finding. Smaller means: fewer impacts, no slenderness where it
/// does not matter, and parameters with fewer digits.
pub fn shrink(panel: &[&dyn Oracle], judges: &Judges, case: &Case, finding: &Finding) -> Shrunk {
    let concerned: Vec<&dyn Oracle> = concerned(panel, finding);
    let fails = |case: &Case| {
        let examination = match finding {
            // Who bears witness that a block lands again may be refuted.
            Finding::Law { breach, .. } if breach.law == Law::OverturnedStays => {
                examine_and_judge(&concerned, judges, case, true)
            }
            Finding::Refuted { .. } => examine_and_judge(&concerned, judges, case, true),
            Finding::Law { .. } if finding.breaks(Law::TimeLeft) => examine_and_judge(&concerned, judges, case, false),
            Finding::Pair { .. } | Finding::Law { .. } | Finding::Broke { .. } => examine(&concerned, case),
        };
        examination.findings().into_iter().find(|found| found.resembles(finding))
    };
    let mut best = unshrunk(panel, case, finding);
    'again: while best.tried < TRIES {
        for candidate in smaller(&best.case, &best.finding) {
            if best.tried >= TRIES {
                break;
            }
            best.tried += 1;
            if let Some(found) = fails(&candidate) {
                (best.case, best.finding) = (candidate, found);
                continue 'again;
            }
        }
        break;
    }
    best
}

/// The oracles that it takes to see a finding: those that it is about; the first of the panel, which the gap between the models comes from; and
/// another to compare with. Whether an ending stays is asked where those of others differ, so that takes them all.
fn concerned<'a>(panel: &[&'a dyn Oracle], finding: &Finding) -> Vec<&'a dyn Oracle> {
    let about = finding.oracles();
    let of_endings = finding.breaks(Law::RestStays) || finding.breaks(Law::OverturnedStays);
    let other = panel.iter().position(|oracle| !about.contains(&oracle.name()));
    let is_needed = |(place, oracle): &(usize, &&dyn Oracle)| {
        *place == 0 || of_endings || about.contains(&oracle.name()) || (about.len() < 2 && Some(*place) == other)
    };
    panel.iter().enumerate().filter(is_needed).map(|(_, oracle)| *oracle).collect()
}

/// Cases smaller than this one, the smallest first.
fn smaller(case: &Case, finding: &Finding) -> Vec<Case> {
    let mut candidates = Vec::new();
    let parts = Parts::of(case);
    // No more impacts than the finding needs to show.
    for impacts in [finding.impact(), case.max_impacts() / 2, case.max_impacts() - 1] {
        if (1..case.max_impacts()).contains(&impacts) {
            candidates.extend(Parts { impacts, ..parts }.case());
        }
    }
    if parts.slenderness.is_some() {
        candidates.extend(Parts { slenderness: None, ..parts }.case());
    }
    if parts.horizon != Horizon::HalfPeriod {
        candidates.extend(Parts { horizon: Horizon::HalfPeriod, ..parts }.case());
    }
    candidates.extend(fewer_digits(parts.omega).filter_map(|omega| Parts { omega, ..parts }.case()));
    candidates.extend(fewer_digits(parts.eta).filter_map(|eta| Parts { eta, ..parts }.case()));
    candidates.extend(fewer_digits(parts.epsilon).filter_map(|epsilon| Parts { epsilon, ..parts }.case()));
    if let Some(slenderness) = parts.slenderness {
        candidates.extend(fewer_digits(slenderness.alpha()).filter_map(|alpha| {
            let slenderness = Slenderness::new(alpha, slenderness.normalisation()).ok();
            Parts { slenderness, ..parts }.case()
        }));
    }
    candidates
}

/// A value rounded to fewer and fewer digits than it has, the fewest first.
pub(super) fn fewer_digits(value: f64) -> impl Iterator<Item = f64> {
    let digits = format!("{value:e}").bytes().take_while(|&byte| byte != b'e').filter(u8::is_ascii_digit).count();
    (1..digits).filter_map(move |kept| format!("{value:.*e}", kept - 1).parse().ok())
}

/// The parts of a case, to be put together again.
#[derive(Clone, Copy)]
struct Parts {
    epsilon: f64,
    omega: f64,
    eta: f64,
    slenderness: Option<Slenderness>,
    impacts: usize,
    horizon: Horizon,
}

impl Parts {
    fn of(case: &Case) -> Self {
        Self {
            epsilon: case.epsilon(),
            omega: case.omega(),
            eta: case.eta(),
            slenderness: case.slenderness(),
            impacts: case.max_impacts(),
            horizon: case.horizon(),
        }
    }

    fn case(self) -> Option<Case> {
        let case = Case::from_epsilon(self.epsilon, self.omega, self.eta).ok()?;
        let case = self.slenderness.map_or(case, |slenderness| case.with_slenderness(slenderness));
        case.with_max_impacts(self.impacts).ok()?.with_horizon(self.horizon).ok()
    }
}
