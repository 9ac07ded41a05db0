//! From a case that fails to the smallest one that still fails in the same way.

use contract::{Case, Horizon, Oracle, Slenderness};

use crate::gate::{
    examine::{Finding, examine},
    judge::Judges,
};

/// How many candidates are tried at the most.
const TRIES: usize = 400;

/// The smallest case found that still has a finding resembling `finding`, and that finding. Smaller means: fewer impacts, no slenderness where it
/// does not matter, and parameters with fewer digits.
pub fn shrink(panel: &[&dyn Oracle], judges: &Judges, case: &Case, finding: &Finding) -> (Case, Finding) {
    // Only the oracles of the finding matter, and the first of the panel, which the gap between models comes from.
    let concerned: Vec<&dyn Oracle> = panel
        .iter()
        .enumerate()
        .filter(|(place, oracle)| *place == 0 || finding.oracles().contains(&oracle.name()))
        .map(|(_, oracle)| *oracle)
        .collect();
    let fails = |case: &Case| {
        let examination = match finding {
            Finding::Refuted { .. } => judges.examine(&concerned, case, true),
            _ => examine(&concerned, case),
        };
        examination.findings().into_iter().find(|found| found.resembles(finding))
    };
    let mut best = (*case, finding.clone());
    let mut tries = 0;
    'again: while tries < TRIES {
        for candidate in smaller(&best.0, &best.1) {
            tries += 1;
            if let Some(found) = fails(&candidate) {
                best = (candidate, found);
                continue 'again;
            }
        }
        break;
    }
    best
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
fn fewer_digits(value: f64) -> impl Iterator<Item = f64> {
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
