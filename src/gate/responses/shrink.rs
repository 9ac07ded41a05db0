//! From a response that disagrees to the smallest one that still does in the same way.

use contract::{Case, Slenderness};

use super::{
    examine::{Finding, examine},
    whole::Responder,
};
use crate::{cases::shaking::Shaking, gate::shrink::fewer_digits};

/// How many candidates are tried at the most.
const TRIES: usize = 300;

/// The smallest response found that still has a finding of the same method and kind, and that finding. Smaller means: shorter, without an end of the
/// shaking, a phase or a slenderness that do not matter, and numbers with fewer digits.
pub fn shrink(responders: &[&dyn Responder], shaking: &Shaking, finding: &Finding) -> (Shaking, Finding) {
    let concerned: Vec<&dyn Responder> =
        responders.iter().copied().filter(|responder| responder.name() == finding.method).collect();
    let fails = |shaking: &Shaking| {
        let found = examine(&concerned, shaking).findings;
        found.into_iter().find(|found| found.wrong.resembles(&finding.wrong))
    };
    let mut best = (*shaking, finding.clone());
    let mut tries = 0;
    'again: while tries < TRIES {
        for candidate in smaller(&best.0, &best.1) {
            tries += 1;
            if let Some(found) = fails(&candidate) {
                best = (candidate, found);
                continue 'again;
            }
            if tries >= TRIES {
                break;
            }
        }
        break;
    }
    best
}

/// Responses smaller than this one, the smallest first.
fn smaller(shaking: &Shaking, finding: &Finding) -> Vec<Shaking> {
    let Shaking { case, phase, lasts, until } = *shaking;
    let mut candidates = Vec::new();
    // Nothing after the disagreement matters.
    let soon = 1.01 * finding.wrong.time() + 0.01;
    if soon < until {
        candidates.push(Shaking { until: soon, ..*shaking });
    }
    if lasts.is_some() && until.is_finite() {
        candidates.push(Shaking { lasts: None, ..*shaking });
    }
    if phase.is_some() {
        candidates.push(Shaking { phase: None, ..*shaking });
        candidates.push(Shaking { phase: Some(0.0), ..*shaking });
        candidates.retain(|candidate| candidate != shaking);
    }
    let with = |a: f64, omega: f64, eta: f64, slenderness: Option<Slenderness>| {
        let case = Case::from_amplitude(a, omega, eta).ok()?;
        let case = slenderness.map_or(case, |slenderness| case.with_slenderness(slenderness));
        Some(Shaking { case, ..*shaking })
    };
    let (a, omega, eta, slenderness) = (case.amplitude(), case.omega(), case.eta(), case.slenderness());
    if slenderness.is_some() {
        candidates.extend(with(a, omega, eta, None));
    }
    candidates.extend(fewer_digits(a).filter_map(|a| with(a, omega, eta, slenderness)));
    candidates.extend(fewer_digits(omega).filter_map(|omega| with(a, omega, eta, slenderness)));
    candidates.extend(fewer_digits(eta).filter_map(|eta| with(a, omega, eta, slenderness)));
    if let Some(slenderness) = slenderness {
        candidates.extend(
            fewer_digits(slenderness.alpha()).filter_map(|alpha| {
                with(a, omega, eta, Some(Slenderness::new(alpha, slenderness.normalisation()).ok()?))
            }),
        );
    }
    candidates.extend(phase.into_iter().flat_map(fewer_digits).map(|phase| Shaking { phase: Some(phase), ..*shaking }));
    candidates.extend(lasts.into_iter().flat_map(fewer_digits).map(|lasts| Shaking { lasts: Some(lasts), ..*shaking }));
    if until.is_finite() {
        candidates.extend(fewer_digits(until).map(|until| Shaking { until, ..*shaking }));
    }
    candidates
}
