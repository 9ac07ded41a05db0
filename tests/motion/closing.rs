//! Responses whose rest comes from one impact by the local series, against those that close the whole list.

use std::sync::Arc;

use chattercheck::{
    motion::{
        certainty::certified,
        closed::Closed,
        criterion::{Crossing, criteria, critical_scale},
        response::{BoutEnd, OnMotion, Request, Response, Termination},
    },
    panel,
};
use contract::{Body, Case, Model, Motion, Ricker};

/// Linear, from rest, followed to its end.
pub fn request(motion: Motion, eta: f64) -> OnMotion {
    OnMotion {
        body: Body::new(eta, None).unwrap(),
        motion: Arc::new(motion),
        rounding: 0.0,
        start: (0.0, 0.0),
        until: f64::INFINITY,
        lies_at: None,
        termination: Termination::Exact,
        most_impacts: Request::MOST_IMPACTS,
    }
}

fn motions() -> Vec<(Motion, f64)> {
    let ricker = Ricker { amplitude: 1.03, omega: 4.0, center: 2.5, antisymmetric: true };
    let samples: Vec<f64> = (0..120).map(|k| 1.05 * (2.0 * 0.05 * f64::from(k)).sin()).collect();
    vec![
        (Motion::one_sine(1.02, 2.0).unwrap(), 0.6),
        (Motion::ricker(ricker).unwrap(), 0.8),
        (Motion::mavroeidis_papageorgiou(1.1, 3.0, 1.5, 0.3).unwrap(), 0.7),
        (Motion::record(0.05, 1.0, samples).unwrap(), 0.8),
    ]
}

#[test]
fn both_ways_to_close_a_sequence_agree() {
    let mut rests = 0;
    for (motion, eta) in motions() {
        let request = request(motion, eta);
        let stepper = || panel::stepper_on(&request.body, &request.motion);
        let listed = Response::on_motion(stepper().as_ref(), &request).unwrap();
        let closed = Closed::new("closed".to_owned(), stepper(), panel::closing());
        let closed = Response::on_motion(&closed, &request).unwrap();
        assert_eq!(listed.bouts.len(), closed.bouts.len(), "{:?}", request.motion);
        for (one, other) in listed.bouts.iter().zip(&closed.bouts) {
            assert_eq!(one.outcome.name(), other.outcome.name());
            let (BoutEnd::Complete { uncertainty: own }, BoutEnd::Complete { uncertainty }) =
                (one.outcome, other.outcome)
            else {
                continue;
            };
            let apart = (one.end() - other.end()).abs();
            assert!(apart <= own + uncertainty && own + uncertainty < 1e-8, "{apart:e} {own:e} {uncertainty:e}");
            rests += 1;
        }
    }
    assert!(rests >= 4, "{rests}");
}

/// A sinusoid is a case, and its list is closed by extrapolation.
#[test]
fn a_case_is_closed_by_one_impact_as_by_all_of_them() {
    for (a, omega, eta) in [(1.03, 2.0, 0.92), (1.01, 0.7, 0.6), (1.002, 4.0, 0.85)] {
        let request = Request::new(Case::from_amplitude(a, omega, eta).unwrap(), None, 9.0 / omega).unwrap();
        let listed = Response::new(panel::stepper().as_ref(), &request).unwrap();
        let closed = Closed::new("closed".to_owned(), panel::stepper(), panel::closing());
        let closed = Response::new(&closed, &request).unwrap();
        for (one, other) in listed.bouts.iter().zip(&closed.bouts) {
            let apart = (one.duration - other.duration).abs();
            assert!(apart <= one.uncertainty() + other.uncertainty(), "{a}: {apart:e}");
        }
    }
}

/// What the first trusted impact alone says is what comes, to what is claimed and what rounding does to both.
#[test]
fn what_is_predicted_comes() {
    for (motion, eta) in motions() {
        let request = request(motion, eta);
        let stepper = panel::stepper_on(&request.body, &request.motion);
        let response = Response::on_motion(stepper.as_ref(), &request).unwrap();
        let found = criteria((stepper.as_ref(), panel::closing().as_ref()), &request, &response).unwrap();
        let mut told = 0;
        for (bout, criterion) in response.bouts.iter().zip(&found) {
            let Some(predicted) = criterion.predicted else { continue };
            let off = (predicted.rest.value - bout.end()).abs();
            let allowed = predicted.rest.uncertainty + bout.uncertainty() + 1e-13;
            assert!(off <= allowed && allowed < 1e-4, "{off:e} {predicted:?}");
            assert!(predicted.time < bout.end() && predicted.impact >= 1);
            told += 1;
        }
        assert!(told > 0, "{:?}", request.motion);
    }
}

/// The general a_cr: one sine is a sinusoid until its half period ends, so the scale at which chattering turns incomplete is a_cr over its amplitude.
#[test]
fn the_critical_scale_of_a_sine_is_its_critical_amplitude() {
    let request = request(Motion::one_sine(1.02, 2.0).unwrap(), 0.6);
    let stepper = panel::stepper_on(&request.body, &request.motion);
    let crossing = critical_scale(stepper.as_ref(), &request, 2.0).unwrap().unwrap();
    let critical = 1.122_593_927_069_722 / 1.02;
    let off = (0.5 * (crossing.lower + crossing.upper) / critical - 1.0).abs();
    assert!(off < 1e-13 && crossing.upper > crossing.lower, "{crossing:?} {critical}");
    assert_eq!(critical_scale(stepper.as_ref(), &request, 1.05).unwrap(), None);
}

/// The judge proves what the search found, from both sides; and not what is not so.
#[test]
fn the_critical_scale_is_proven() {
    let request = request(Motion::one_sine(1.02, 2.0).unwrap(), 0.6);
    let stepper = panel::stepper_on(&request.body, &request.motion);
    let judge = panel::judge_of(Model::Linear).unwrap();
    let crossing = critical_scale(stepper.as_ref(), &request, 2.0).unwrap().unwrap();
    let proven = certified(judge.as_ref(), &request, &crossing, |fate| fate.incomplete).unwrap();
    let critical = 1.122_593_927_069_722 / 1.02;
    assert!(proven.lower < critical && critical < proven.upper, "{proven:?} {critical}");
    assert!(proven.upper / proven.lower - 1.0 < 1e-10, "{proven:?}");
    let elsewhere = Crossing { lower: 1.05, upper: 1.050_000_01, happens_above: true };
    assert_eq!(certified(judge.as_ref(), &request, &elsewhere, |fate| fate.incomplete), None);
    assert_eq!(certified(judge.as_ref(), &request, &crossing, |fate| fate.overturned), None);
}
