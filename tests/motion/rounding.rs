//! What is called the uncertainty of a rest against its error: random pulses, wavelets, sums and records, every method that flies, against what is proven.

use chattercheck::{
    cases::generate,
    motion::response::{Asked, BoutEnd, OnMotion, Response},
    panel::{self, Settings},
};
use contract::{Body, Followed, Model, Oracle};
use enclosure::{EnclosedEnd, Enclosure};

use crate::{closing, effort::pick};

/// The largest share of what is claimed that the errors of a method are, and how many rests were compared.
fn largest_share(oracle: &dyn Oracle, model: Model, seed: u64, count: usize) -> (f64, usize) {
    let judge = Enclosure::new(model).with_digits(20).unwrap();
    let (mut share, mut compared) = (0.0_f64, 0);
    for (n, asked) in generate::motions(seed, count).into_iter().enumerate() {
        let alpha = if model == Model::Linear { None } else { Some(asked.body.alpha().unwrap_or(0.1)) };
        let body = Body::new(asked.body.eta(), alpha).unwrap();
        let motion = asked.motion.as_ref().clone();
        let request = OnMotion { body, start: asked.start, until: asked.until, ..closing::request(motion, body.eta()) };
        let Ok(response) = Response::on_motion(oracle, &request) else { continue };
        let followed = Followed { start: asked.start, until: asked.until, most_impacts: 1 };
        let Ok(proven) = judge.enclose_on(&body, &request.motion, &followed) else { continue };
        for (bout, proven) in response.bouts.iter().zip(&proven) {
            let (BoutEnd::Complete { uncertainty }, EnclosedEnd::Rest(rest)) = (bout.outcome, &proven.end) else {
                break;
            };
            if bout.is_unsure() {
                break;
            }
            let error = (bout.end() - rest.middle().0).abs() - rest.width();
            if error > uncertainty {
                println!(
                    "{} {model:?} {n}: error {error:e}, uncertainty {uncertainty:e}, at {}",
                    oracle.name(),
                    bout.end()
                );
            }
            share = share.max(error / uncertainty);
            compared += 1;
        }
    }
    (share, compared)
}

#[test]
fn no_rest_is_further_off_than_is_said() {
    let count = pick("motions", 40, 1000);
    for (name, model) in [
        ("closed-form", Model::Linear),
        ("taylor", Model::Linear),
        ("taylor", Model::Nonlinear),
        ("ode", Model::Linear),
        ("ode", Model::Nonlinear),
    ] {
        let oracle =
            panel::one(name, &Settings::default(), if model == Model::Linear { "linear" } else { "nonlinear" })
                .unwrap();
        let (share, compared) = largest_share(oracle.as_ref(), model, 11, count);
        println!("{} {model:?}: {share:.3} of what is said, {compared} rests", oracle.name());
        assert!(share <= 1.0 && compared > count / 2, "{} {model:?}: {share} of {compared}", oracle.name());
    }
}

/// Two methods agree on the largest rotation to within what they say of it.
#[test]
fn no_largest_rotation_is_further_off_than_is_said() {
    let methods =
        ["closed-form", "taylor", "ode"].map(|name| panel::one(name, &Settings::default(), "linear").unwrap());
    let (mut share, mut compared) = (0.0_f64, 0);
    for asked in generate::motions(12, pick("motions for rotations", 150, 2000)) {
        let body = Body::new(asked.body.eta(), None).unwrap();
        let motion = asked.motion.as_ref().clone();
        let request = OnMotion { body, start: asked.start, until: asked.until, ..closing::request(motion, body.eta()) };
        let asked = Asked::Motion(request);
        let peaks: Vec<(f64, f64)> = methods
            .iter()
            .filter_map(|oracle| asked.with_rotation(oracle.as_ref()).ok()?.1)
            .map(|(peak, uncertainty)| (peak.rotation.abs(), uncertainty))
            .filter(|(_, uncertainty)| uncertainty.is_finite())
            .collect();
        for (k, one) in peaks.iter().enumerate() {
            for other in &peaks[..k] {
                share = share.max((one.0 - other.0).abs() / (one.1 + other.1));
                compared += 1;
            }
        }
    }
    println!("{share:.3} of what is said, {compared} pairs");
    assert!(share <= 1.0 && compared > 100, "{share} of {compared}");
}
