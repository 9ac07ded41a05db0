//! Next to the threshold of a block whose amplitude is given over `g α`, nearly all digits of `a - 1` cancel: whoever answers says so.
//! The truths are proven by the enclosure for the doubles that are given.

use chattercheck::{
    measure::asking::ask,
    motion::{
        response::{Response, Termination},
        scene::Scene,
    },
    panel::{self, Settings},
    plan::Plan,
};
use contract::{Case, Normalisation, Slenderness};

/// `ε`, `α` and the chattering time; `ω = 2`, `η = 0.9`.
const NEXT_TO: [(f64, f64, f64); 2] = [
    (0.003346720854506602, 0.1, 0.000_000_169_701_051_832_427_1),
    (0.09260497968758208, 0.5, 0.000_000_155_480_720_305_953_2),
];

#[test]
fn every_method_claims_what_the_rounding_of_the_threshold_does() {
    for (epsilon, alpha, truth) in NEXT_TO {
        let slenderness = Slenderness::new(alpha, Normalisation::Slender).unwrap();
        let case = Case::from_epsilon(epsilon, 2.0, 0.9).unwrap().with_slenderness(slenderness);
        let case = case.with_max_impacts(256).unwrap();
        for name in ["taylor", "ode/nonlinear/tsit45", "ode/nonlinear/bdf", "enclosure/nonlinear"] {
            let oracle = panel::one(name, &Settings::default(), "nonlinear").unwrap();
            let Some(time) = ask(oracle.as_ref(), &case).observed().and_then(|observed| observed.chattering_time)
            else {
                continue;
            };
            let off = (time.value - truth).abs();
            assert!(off <= time.uncertainty.max(1e-15 * truth), "{name} {alpha}: off by {off:e}, {time:?}");
        }
    }
}

/// A scene has its own numbers rounded, whatever its amplitude is given over.
#[test]
fn a_scene_next_to_its_threshold_is_not_said_to_be_known() {
    for amplitude in ["{ over-slender-threshold = 1.0033467208545066 }", "{ g = 0.10033467208545061 }"] {
        let text = format!(
            "[block]\nradius = 1.3\nslenderness = 0.1\nrestitution = 0.9\n[ground]\namplitude = {amplitude}\nfrequency = {{ omega = 2 }}\n"
        );
        let scene = Scene::parse(&text).unwrap();
        let truth = NEXT_TO[0].2;
        let request = scene.response(None, Termination::Exact).unwrap();
        let oracle = panel::stepper_of(scene.ask.model);
        if let Some(bout) = Response::new(oracle.as_ref(), &request).unwrap().bouts.first() {
            assert!(bout.is_unsure() || (bout.duration - truth).abs() < bout.uncertainty(), "{amplitude}: {bout:?}");
        }
        let answers = scene.answers(oracle.as_ref()).unwrap();
        let known = answers.chattering_time.and_then(|time| time.seconds);
        assert_eq!(known, None, "{amplitude}");
        let answer = Plan::new(scene.question().unwrap()).answer();
        let says = answer.chattering_time();
        assert!(says.is_none_or(|time| time.uncertainty > 0.1 * time.value), "{amplitude}: {says:?}");
    }
}

/// The time of an end is a double, and the slenderness too: no end of a bout is claimed to be exact.
#[test]
fn no_end_is_claimed_to_be_known_better_than_a_double_can_say() {
    for (alpha, model, a) in [("0.1", "linear", 1.01), ("0.1", "linear", 1.5), ("1.5707963267948", "nonlinear", 3.01)] {
        let text = format!(
            "[block]\nradius = 1.3\nslenderness = {alpha}\nrestitution = 0.92\n[ground]\namplitude = {{ over-threshold = {a} }}\nfrequency = {{ omega = 2 }}\n[ask]\nmodel = \"{model}\"\n"
        );
        let scene = Scene::parse(&text).unwrap();
        let request = scene.response(None, Termination::Exact).unwrap();
        let response = Response::new(panel::stepper_of(scene.ask.model).as_ref(), &request).unwrap();
        for bout in &response.bouts {
            assert!(bout.uncertainty() >= 1e-16 * bout.end(), "{bout:?}");
        }
        // One rounding of the slenderness moves the overturning of this block by a thousandth.
        if model == "nonlinear" {
            let bout = response.bouts.last().unwrap();
            assert!(bout.uncertainty() > 1e-4 * bout.duration, "{} {}", bout.uncertainty(), bout.duration);
        }
    }
}
