//! Changes that must not matter: each is tried, each finds a mistake that no other form of the question shows, and a record tends to what it samples.

use std::{
    f64::consts::{PI, TAU},
    sync::Arc,
};

use chattercheck::{
    cases::{
        generate,
        shaking::{AnyMotion, Question},
    },
    gate::{
        responses::{self, Relation, Responder, Wrong},
        verdict::Verdict,
    },
};
use contract::{Body, Motion, Record, Sinusoid, Stretch};

use crate::mistaken::{Mistaken, method};

fn mistaken(ask: fn(&Question) -> Question) -> Mistaken {
    Mistaken::new("closed-form", ask)
}

fn questions() -> Vec<(String, Question)> {
    let motions = (1..).zip(generate::motions(1, 60));
    let motions = motions.map(|(number, asked)| (format!("motion/{number}"), Question::Motion(asked)));
    let shakings = (1..).zip(generate::shakings(1, 30));
    let shakings = shakings.map(|(number, asked)| (format!("response/{number}"), Question::Sinusoid(asked)));
    motions.chain(shakings).collect()
}

/// Whether this change, and no truth, shows the mistake.
fn shows(relation: Relation, ask: fn(&Question) -> Question) -> bool {
    questions().iter().any(|(_, question)| {
        let findings = responses::examine_with(&[&mistaken(ask)], question, &[relation]).findings;
        findings.iter().any(|finding| matches!(finding.wrong, Wrong::Changes(found, _) if found == relation))
    })
}

fn on(asked: &AnyMotion, motion: Motion) -> Question {
    Question::Motion(AnyMotion { motion: Arc::new(motion), ..asked.clone() })
}

/// With the terms of each stretch, from when it holds, written in another way.
fn of_terms(question: &Question, change: impl Fn(f64, &[Sinusoid]) -> Vec<Sinusoid>) -> Question {
    let Question::Motion(asked) = question else { return question.clone() };
    let Motion::Sinusoids(stretches) = asked.motion.as_ref() else { return question.clone() };
    let mut from = 0.0;
    let stretch = |of: &Stretch| {
        let terms = change(from, &of.terms);
        from = of.until;
        Stretch { until: of.until, terms }
    };
    on(asked, Motion::Sinusoids(stretches.iter().map(stretch).collect()))
}

fn of_record(question: &Question, change: impl Fn(&Record) -> Record) -> Question {
    let Question::Motion(asked) = question else { return question.clone() };
    let Motion::Record(of) = asked.motion.as_ref() else { return question.clone() };
    on(asked, Motion::Record(change(of)))
}

fn with_eta(asked: &AnyMotion, factor: f64) -> Question {
    let body = Body::new(asked.body.eta() * factor, asked.body.alpha()).unwrap();
    Question::Motion(AnyMotion { body, ..asked.clone() })
}

/// Every form of every question has the same answer of a method that is right, whether its flights are formulas or series.
#[test]
fn no_change_matters_to_a_method_that_is_right() {
    for name in ["closed-form", "taylor", "taylor/slender"] {
        let method = method(name);
        let mut tried = 0;
        for (of, question) in questions() {
            let examined = responses::examine_with(&[&method], &question, &Relation::ALL);
            assert!(examined.findings.is_empty(), "{of}: {:?}", examined.findings);
            tried += examined.related.len();
        }
        assert!(tried > 100, "{name}: {tried}");
    }
}

#[test]
fn each_change_shows_a_mistake() {
    // The restitution of one side is another.
    assert!(shows(Relation::Mirrored, |question| match question {
        Question::Motion(asked) if first_is_negative(&asked.motion) => with_eta(asked, 1.0 - 1e-9),
        _ => question.clone(),
    }));
    // Phases count from where a stretch begins: right of one stretch.
    let own_clock: fn(&Question) -> Question = |question| {
        of_terms(question, |from, terms| {
            terms.iter().map(|term| Sinusoid { phase: term.phase - 1e-9 * from, ..*term }).collect()
        })
    };
    assert!(shows(Relation::Later, own_clock));
    assert!(shows(Relation::Split, own_clock));
    // Records of a short step are read by a step that is a little longer.
    assert!(shows(Relation::Split, |question| of_record(question, |of| {
        let dt = if of.samples.len() > 100 { of.dt * (1.0 + 1e-9) } else { of.dt };
        Record { dt, ..of.clone() }
    })));
    // Phases are brought back by a period of ten digits.
    assert!(shows(Relation::NextPeriod, ten_digits));
    // The first sinusoid is taken for the slowest.
    assert!(shows(Relation::Reordered, |question| of_terms(question, |_, terms| {
        let (first, last) = (terms.first().unwrap().omega, terms.last().unwrap().omega);
        let factor = if first > last { 1.0 - 1e-9 } else { 1.0 };
        terms.iter().map(|term| Sinusoid { amplitude: factor * term.amplitude, ..*term }).collect()
    })));
    // Weak ones are left out.
    assert!(shows(Relation::Halved, |question| of_terms(question, |_, terms| {
        terms.iter().filter(|term| term.amplitude.abs() > 0.3).copied().collect()
    })));
    // There is room for three.
    assert!(shows(Relation::AddedNothing, |question| of_terms(question, |_, terms| {
        terms.iter().take(3).copied().collect()
    })));
    // Samples are cut off where those of one unit never come.
    assert!(shows(Relation::Rescaled, |question| of_record(question, |of| {
        Record { samples: of.samples.iter().map(|sample| sample.clamp(-4.0, 4.0)).collect(), ..of.clone() }
    })));
    // The way of any motion takes another block than that of a steady sinusoid.
    assert!(shows(Relation::OnAnyMotion, |question| match question {
        Question::Motion(asked) => with_eta(asked, 1.0 - 1e-9),
        Question::Sinusoid(_) => question.clone(),
    }));
}

fn first_is_negative(motion: &Motion) -> bool {
    match motion {
        Motion::Sinusoids(stretches) => stretches[0].terms[0].amplitude < 0.0,
        Motion::Ricker(of) => of.amplitude < 0.0,
        Motion::Record(of) => of.samples[0] * of.scale < 0.0,
    }
}

fn ten_digits(question: &Question) -> Question {
    let brought_back = |term: &Sinusoid| {
        let phase = if term.phase > PI { term.phase - (TAU * 1e9).trunc() / 1e9 } else { term.phase };
        Sinusoid { phase, ..*term }
    };
    of_terms(question, |_, terms| terms.iter().map(brought_back).collect())
}

/// In a run a share of the questions is asked again: a mistake that only another form shows turns it red, and is made small like any other.
#[test]
fn a_change_that_matters_turns_a_run_red_and_is_shrunk() {
    let method = mistaken(ten_digits);
    let (report, failures) = responses::run(&[&method], &questions(), &());
    let changes = |wrong: &Wrong| matches!(wrong, Wrong::Changes(Relation::NextPeriod, _));
    let failure = failures.iter().find(|failure| changes(&failure.findings[0].wrong)).unwrap();
    assert_eq!(report.verdict(), Verdict::Fail);
    let text = responses::failures_text(&report);
    assert!(text.contains("asked with phases a period further, which must not matter, another answer"), "{text}");
    let (small, finding) = responses::shrink(&[&method], &failure.question, &failure.findings[0]);
    assert!(changes(&finding.wrong), "{finding}");
    let size = |question: &Question| format!("{question:?}").len();
    assert!(size(&small) < size(&failure.question), "{small:?} from {:?}", failure.question);
    let again = responses::examine_with(&[&method], &small, &[Relation::NextPeriod]).findings;
    assert!(again.contains(&finding), "{again:?}");
}

/// A record of a cosine tends to the cosine as the square of its step, in when and how fast the block hits its base.
#[test]
fn a_record_tends_to_the_motion_that_it_samples() {
    let (amplitude, omega) = (1.5, 2.0);
    let period = TAU / omega;
    for (name, alpha) in [("closed-form", None), ("taylor", Some(0.3))] {
        let method = method(name);
        let impacts = |motion: Motion| {
            let body = Body::new(0.7, alpha).unwrap();
            let asked = AnyMotion { body, motion: Arc::new(motion), start: (0.0, 0.0), until: period };
            method.respond(&Question::Motion(asked), 1).unwrap().bouts[0].impacts.clone()
        };
        let exact = impacts(Motion::one_cosine(amplitude, omega).unwrap());
        let errors = [64, 128, 256].map(|steps: u32| {
            let dt = period / f64::from(steps);
            let samples = (0..=steps).map(|k| amplitude * (omega * dt * f64::from(k)).cos()).collect();
            let sampled = impacts(Motion::record(dt, 1.0, samples).unwrap());
            [sampled[0].time - exact[0].time, sampled[0].before - exact[0].before]
        });
        for pair in errors.windows(2) {
            for (coarse, fine) in pair[0].iter().zip(pair[1]) {
                let ratio = coarse / fine;
                assert!((ratio - 4.0).abs() < 0.1, "{name}: {ratio}, {errors:?}");
            }
        }
    }
}
