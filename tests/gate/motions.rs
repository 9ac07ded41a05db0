//! Motions of the ground that are no steady sinusoids under the gate: mistakes planted in what a method makes of the ground are found, made small, and written as
//! scenes that show them.

use std::sync::Arc;

use chattercheck::{
    cases::{
        generate,
        shaking::{AnyMotion, Question},
    },
    gate::responses::{self, Responder},
    motion::{response::Termination, scene::Scene},
};
use contract::{Motion, Record, Ricker, Sinusoid, Stretch};

use crate::mistaken::Mistaken;

fn misled(name: &str, ask: fn(&AnyMotion) -> AnyMotion) -> Mistaken {
    Mistaken::new(name, move |question| match question {
        Question::Motion(asked) => Question::Motion(ask(asked)),
        Question::Sinusoid(_) => question.clone(),
    })
}

fn questions() -> Vec<(String, Question)> {
    let motions = generate::motions(1, 60).into_iter().enumerate();
    motions.map(|(n, motion)| (format!("motion/{n}"), Question::Motion(motion))).collect()
}

/// How many of the responses fail.
fn wrong(method: &dyn Responder) -> usize {
    responses::run(&[method], &questions(), &()).1.len()
}

fn with(asked: &AnyMotion, motion: Option<Motion>) -> AnyMotion {
    AnyMotion { motion: motion.map_or_else(|| Arc::clone(&asked.motion), Arc::new), ..asked.clone() }
}

fn of_records(asked: &AnyMotion, change: impl Fn(&Record) -> Record) -> AnyMotion {
    with(asked, if let Motion::Record(of) = asked.motion.as_ref() { Some(Motion::Record(change(of))) } else { None })
}

/// Whoever does it: asked the right question each is right.
#[test]
fn a_method_that_is_asked_what_it_is_held_against_is_right() {
    for name in ["closed-form", "taylor", "taylor/slender"] {
        assert_eq!(wrong(&misled(name, AnyMotion::clone)), 0, "{name}");
    }
}

#[test]
fn mistakes_in_the_ground_are_found() {
    let found = |name: &str, ask: fn(&AnyMotion) -> AnyMotion| wrong(&misled(name, ask)) > 0;
    // A record whose times are off by 1e-9, whose samples are held instead of joined, or that goes on with its last sample.
    assert!(found("closed-form", |asked| of_records(asked, |of| Record { dt: of.dt * (1.0 + 1e-9), ..of.clone() })));
    assert!(found("taylor", |asked| of_records(asked, |of| {
        let held = of.samples.iter().flat_map(|sample| [*sample, *sample]).collect();
        Record { dt: 0.5 * of.dt, samples: held, ..of.clone() }
    })));
    assert!(found("closed-form", |asked| of_records(asked, |of| {
        let last = of.samples[of.samples.len() - 1];
        let longer = of.samples.iter().copied().chain([last; 40]).collect();
        Record { samples: longer, ..of.clone() }
    })));
    // A pulse of the sine that ends a little late, and a phase that is off in the tenth digit.
    assert!(found("closed-form", |asked| with(
        asked,
        if let Motion::Sinusoids(of) = asked.motion.as_ref() {
            let late = of.iter().map(|one| Stretch { until: one.until * (1.0 + 1e-9), terms: one.terms.clone() });
            Some(Motion::Sinusoids(late.collect()))
        } else {
            None
        }
    )));
    assert!(found("taylor", |asked| with(
        asked,
        if let Motion::Sinusoids(of) = asked.motion.as_ref() {
            let shifted = |term: &Sinusoid| Sinusoid { phase: term.phase + 1e-10, ..*term };
            let stretch = |one: &Stretch| Stretch { until: one.until, terms: one.terms.iter().map(shifted).collect() };
            Some(Motion::Sinusoids(of.iter().map(stretch).collect()))
        } else {
            None
        }
    )));
    // A wavelet of the other kind where the rounded peak is not that of its definition.
    assert!(found("taylor", |asked| with(
        asked,
        if let Motion::Ricker(of) = asked.motion.as_ref() {
            let peak = if of.antisymmetric { 1.3801 / 1.380_119_046_1 } else { 1.0 };
            Some(Motion::Ricker(Ricker { amplitude: of.amplitude * peak, ..*of }))
        } else {
            None
        }
    )));
    // The start to the other side.
    assert!(found("closed-form", |asked| AnyMotion { start: (-asked.start.0, -asked.start.1), ..asked.clone() }));
}

/// What was found is made small, still disagrees, and its scene asks the very same question.
#[test]
fn what_disagrees_on_a_motion_is_shrunk_to_a_scene() {
    let folder = tempfile::tempdir().unwrap();
    let records = misled("closed-form", |asked| of_records(asked, |of| Record { dt: of.dt * 1.01, ..of.clone() }));
    let starts = misled("taylor", |asked| AnyMotion { start: (-asked.start.0, -asked.start.1), ..asked.clone() });
    for (method, at_most) in [(&records, 20), (&starts, 20)] {
        let (_, failures) = responses::run(&[method], &questions(), &());
        let failure = &failures[0];
        let (question, finding) = responses::shrink(&[method], &failure.question, &failure.findings[0]);
        assert!(responses::examine(&[method], &question).findings.contains(&finding));
        let size = |question: &Question| format!("{question:?}").len();
        assert!(size(&question) < size(&failure.question), "{question:?} from {:?}", failure.question);
        let path = folder.path().join("shown.toml");
        let text = responses::scene_text(failure, 1, &question, &finding, &path);
        std::fs::write(&path, &text).unwrap();
        let Question::Motion(asked) = &question else { panic!("{question:?}") };
        if let Motion::Record(of) = asked.motion.as_ref() {
            assert!(of.samples.len() <= at_most, "{} samples are left", of.samples.len());
            std::fs::write(responses::samples_path(&path), responses::samples_text(&question).unwrap()).unwrap();
        }
        let scene = Scene::parse_in(&text, folder.path()).unwrap();
        let until = Some(asked.until).filter(|until| until.is_finite());
        let read = scene.on_motion(until, Termination::Exact).unwrap();
        assert!(*read.motion == *asked.motion && read.start == asked.start, "{text}\n{:?}\n{:?}", read, asked.motion);
        assert_eq!(read.body.eta(), asked.body.eta());
    }
}

/// The seed alone makes them, and they reach what they are for.
#[test]
fn motions_are_those_of_the_seed() {
    assert_eq!(generate::motions(7, 20), generate::motions(7, 20));
    assert_ne!(generate::motions(7, 1), generate::motions(8, 1));
    let motions = generate::motions(1, 200);
    let count = |is: fn(&AnyMotion) -> bool| motions.iter().filter(|asked| is(asked)).count();
    assert!(count(|asked| matches!(*asked.motion, Motion::Record(_))) > 30);
    assert!(count(|asked| matches!(*asked.motion, Motion::Ricker(Ricker { antisymmetric: true, .. }))) > 5);
    assert!(count(|asked| asked.start != (0.0, 0.0)) > 10 && count(|asked| asked.until.is_finite()) > 20);
}
