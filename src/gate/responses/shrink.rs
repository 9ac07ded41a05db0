//! From a response that disagrees to the smallest one that still does in the same way.

use std::sync::Arc;

use contract::{Body, Case, Motion, Ricker, Sinusoid, Slenderness, Stretch};

use super::{
    examine::{Finding, Wrong, examine_with},
    whole::Responder,
};
use crate::{
    cases::shaking::{AnyMotion, Question, Shaking},
    gate::shrink::fewer_digits,
};

/// How many candidates are tried at the most.
const TRIES: usize = 300;

/// The smallest response found that still has a finding of the same method and kind, and that finding. Smaller means: shorter, without an end of the
/// shaking, a phase or a slenderness that do not matter, and numbers with fewer digits.
pub fn shrink(responders: &[&dyn Responder], question: &Question, finding: &Finding) -> (Question, Finding) {
    let concerned: Vec<&dyn Responder> =
        responders.iter().copied().filter(|responder| responder.name() == finding.method).collect();
    let relations = if let Wrong::Changes(relation, _) = finding.wrong { vec![relation] } else { Vec::new() };
    let fails = |question: &Question| {
        let found = examine_with(&concerned, question, &relations).findings;
        found.into_iter().find(|found| found.wrong.resembles(&finding.wrong))
    };
    let mut best = (question.clone(), finding.clone());
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

/// Questions smaller than this one, the smallest first.
fn smaller(question: &Question, finding: &Finding) -> Vec<Question> {
    // Nothing after the disagreement matters.
    let soon = 1.01 * finding.wrong.time() + 0.01;
    let sooner = (soon < question.until()).then(|| question.ending(soon));
    let others: Vec<Question> = match question {
        Question::Sinusoid(shaking) => smaller_shakings(shaking).into_iter().map(Question::Sinusoid).collect(),
        Question::Motion(asked) => smaller_motions(asked).into_iter().map(Question::Motion).collect(),
    };
    sooner.into_iter().chain(others).collect()
}

/// On motions with fewer parts, and numbers with fewer digits.
fn smaller_motions(asked: &AnyMotion) -> Vec<AnyMotion> {
    let AnyMotion { body, motion, start, until } = asked;
    let mut candidates = Vec::new();
    let mut motions = |made: Option<Motion>| {
        candidates.extend(made.map(|motion| AnyMotion { motion: Arc::new(motion), ..asked.clone() }));
    };
    match motion.as_ref() {
        Motion::Sinusoids(stretches) => {
            for k in 0..stretches.len() {
                let mut fewer = stretches.clone();
                fewer.remove(k);
                motions(Motion::sinusoids(fewer).ok());
            }
            for (k, stretch) in stretches.iter().enumerate() {
                let mut with = |stretch: Stretch| {
                    let mut changed = stretches.clone();
                    if let Some(slot) = changed.get_mut(k) {
                        *slot = stretch;
                    }
                    motions(Motion::sinusoids(changed).ok());
                };
                for n in 0..stretch.terms.len() {
                    let mut terms = stretch.terms.clone();
                    let term = terms.remove(n);
                    // A scene has one term at least.
                    if !terms.is_empty() {
                        with(Stretch { terms, ..*stretch });
                    }
                    let fewer = fewer_digits(term.amplitude).map(|amplitude| Sinusoid { amplitude, ..term });
                    let fewer = fewer.chain(fewer_digits(term.omega).map(|omega| Sinusoid { omega, ..term }));
                    let fewer = fewer.chain(fewer_digits(term.phase).map(|phase| Sinusoid { phase, ..term }));
                    for term in fewer {
                        let mut terms = stretch.terms.clone();
                        if let Some(slot) = terms.get_mut(n) {
                            *slot = term;
                        }
                        with(Stretch { terms, ..*stretch });
                    }
                }
                fewer_digits(stretch.until).for_each(|until| with(Stretch { until, terms: stretch.terms.clone() }));
            }
        }
        Motion::Ricker(of) => {
            let fewer = fewer_digits(of.amplitude).map(|amplitude| Ricker { amplitude, ..*of });
            let fewer = fewer.chain(fewer_digits(of.omega).map(|omega| Ricker { omega, ..*of }));
            let fewer = fewer.chain(fewer_digits(of.center).map(|center| Ricker { center, ..*of }));
            fewer.for_each(|of| motions(Motion::ricker(of).ok()));
        }
        Motion::Record(of) => {
            let count = of.samples.len();
            for kept in [count / 2, count - count / 4, count.saturating_sub(1)] {
                motions(Motion::record(of.dt, of.scale, of.samples.iter().take(kept).copied().collect()).ok());
            }
            for digits in 1..6 {
                let round = |sample: &f64| format!("{sample:.digits$e}").parse().unwrap_or(*sample);
                let rounded: Vec<f64> = of.samples.iter().map(round).collect();
                if *rounded != *of.samples {
                    motions(Motion::record(of.dt, of.scale, rounded).ok());
                }
            }
            fewer_digits(of.dt).for_each(|dt| motions(Motion::record(dt, of.scale, of.samples.to_vec()).ok()));
            fewer_digits(of.scale).for_each(|scale| motions(Motion::record(of.dt, scale, of.samples.to_vec()).ok()));
        }
    }
    if *start != (0.0, 0.0) {
        candidates.push(AnyMotion { start: (0.0, 0.0), ..asked.clone() });
        let rotations = fewer_digits(start.0).map(|rotation| (rotation, start.1));
        let starts = rotations.chain(fewer_digits(start.1).map(|velocity| (start.0, velocity)));
        candidates.extend(starts.map(|start| AnyMotion { start, ..asked.clone() }));
    }
    let mut bodies = |made: Result<Body, _>| {
        candidates.extend(made.ok().map(|body| AnyMotion { body, ..asked.clone() }));
    };
    if let Some(alpha) = body.alpha() {
        bodies(Body::new(body.eta(), None));
        fewer_digits(alpha).for_each(|alpha| bodies(Body::new(body.eta(), Some(alpha))));
    }
    fewer_digits(body.eta()).for_each(|eta| bodies(Body::new(eta, body.alpha())));
    if until.is_finite() {
        candidates.extend(fewer_digits(*until).map(|until| AnyMotion { until, ..asked.clone() }));
    }
    candidates
}

/// On sinusoids without what does not matter, and numbers with fewer digits.
fn smaller_shakings(shaking: &Shaking) -> Vec<Shaking> {
    let Shaking { case, phase, lasts, until } = *shaking;
    let mut candidates = Vec::new();
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
