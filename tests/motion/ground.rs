//! Scenes whose ground is no sinusoid: pulses, sums, records, and blocks that start in motion, against values to 20 digits and more by another method.

use std::{fmt::Write as _, sync::Arc};

use assert_cmd::Command;
use chattercheck::{
    measure::ground::acceleration,
    motion::{
        response::{Bout, OnMotion, Response, Termination},
        scene::Scene,
    },
    panel::{self, Settings},
};
use contract::{Arrival, Body, Model, Motion, Ricker, Sinusoid, Stretch};

use crate::effort::pick;

/// A block with the restitution given, under the linear model.
fn scene(eta: f64, rest: &str) -> Scene {
    let block = format!("[block]\nradius = 1\nslenderness = 0.2\nrestitution = {eta:?}\n");
    Scene::parse(&format!("{block}{rest}\n[ask]\nmodel = \"linear\"\n")).unwrap()
}

fn response(scene: &Scene) -> Response {
    let request = scene.on_motion(None, Termination::Exact).unwrap();
    Response::on_motion(panel::stepper_on(&request.body, &request.motion).as_ref(), &request).unwrap()
}

fn rests(response: &Response) -> Vec<(f64, f64)> {
    response.bouts.iter().map(|bout| (bout.begin(), bout.end())).collect()
}

#[allow(clippy::excessive_precision)] // as they came
const ONE_SINE: [(f64, f64); 2] = [
    (0.686_220_902_318_046_065_9, 1.158_296_102_357_345_982_791_668),
    (2.257_017_229_112_942_522_561_358, 2.729_092_429_152_242_602_022_990),
];

#[test]
fn a_sine_pulse_sets_the_block_off_twice() {
    let pulse = "[ground]\npulse = \"one-sine\"\namplitude = { over-threshold = 1.02 }\nfrequency = { omega = 2 }\n";
    let response = response(&scene(0.6, pulse));
    assert_eq!(response.bouts.len(), 2);
    for ((from, to), (begin, end)) in rests(&response).into_iter().zip(ONE_SINE) {
        assert!((from - begin).abs() < 1e-15 && (to - end).abs() < 1e-14, "{from} {to}");
    }
    // It is worth what it claims.
    for (bout, (_, end)) in response.bouts.iter().zip(ONE_SINE) {
        assert!((bout.end() - end).abs() <= bout.uncertainty() && bout.uncertainty() < 1e-13);
    }
    assert_eq!(response.end, std::f64::consts::PI);
}

/// Released from half of alpha: `u'' = u - 1` from there, and each later flight by itself; the sum in closed form.
#[test]
fn a_block_that_is_released_rocks_freely() {
    let still = "[ground]\namplitude = { over-threshold = 0 }\nfrequency = { omega = 1 }\n";
    for (rotation, side) in [(0.5, 1.0), (-0.5, -1.0)] {
        let response = response(&scene(0.9, &format!("{still}[start]\nrotation = {rotation}\n")));
        let [bout] = &response.bouts[..] else { panic!("{:?}", rests(&response)) };
        let times: Vec<f64> = bout.impact_times().take(2).collect();
        for (time, expected) in times.iter().zip([1.316_957_896_92, 3.404_754_794_06]) {
            assert!((time - expected).abs() < 1e-11, "{times:?}");
        }
        assert!((bout.end() - 18.518_961_010_8).abs() < 1e-10, "{}", bout.end());
        // To the other side after the first impact.
        let (_, _, velocity) = bout.impact_list(0.9).next().unwrap();
        assert!(velocity * side < 0.0);
    }
    // From the base with a speed: `2 Σ artanh(η^k v)`.
    let response = response(&scene(0.8, &format!("{still}[start]\nvelocity = 0.5\n")));
    let sum: f64 = (0..200).map(|k| 2.0 * f64::atanh(0.8_f64.powi(k) * 0.5)).sum();
    assert!((response.bouts[0].end() - sum).abs() < 1e-13, "{} {sum}", response.bouts[0].end());
}

/// Said as a sum, as a stretch of its own, and shifted: a sinusoid gives the response that it gives as a sinusoid.
#[test]
fn a_sinusoid_is_the_same_however_it_is_said() {
    let sine = "[ground]\namplitude = { over-threshold = 1.03 }\nfrequency = { omega = 2 }\nphase = 0.4\n";
    let plain = scene(0.92, &format!("{sine}duration = {{ cycles = 2 }}\n"));
    let request = plain.response(None, Termination::Exact).unwrap();
    let expected = Response::new(panel::stepper().as_ref(), &request).unwrap();
    let sum = format!(
        "[ground]\nsinusoids = [ {{ amplitude = {{ over-threshold = 1.03 }}, frequency = {{ omega = 2 }}, phase = 0.4 }} ]\nduration = {{ tau = {:?} }}\n",
        2.0 * std::f64::consts::PI
    );
    let found = response(&scene(0.92, &sum));
    assert_eq!(found.bouts.len(), expected.bouts.len());
    for (one, two) in rests(&found).into_iter().zip(rests(&expected)) {
        assert!((one.0 - two.0).abs() < 1e-14 && (one.1 - two.1).abs() < 1e-12, "{one:?} {two:?}");
    }
}

/// The Taylor series and the general solvers on the linear equation follow what the closed form follows, and wavelets that it does not; on the nonlinear one a
/// slender block is nearly the same.
#[test]
fn methods_agree_on_every_motion() {
    let taylor = panel::stepper_of(Model::Nonlinear);
    let ode = |method, rtol| {
        let settings = Settings { method: Some(method), rtol, ..Settings::default() };
        panel::one("ode", &settings, "linear").unwrap()
    };
    let others = [taylor, ode("tsit45", None), ode("esdirk34", None), ode("tsit45", Some(1e-9))];
    for ground in [
        "pulse = \"one-sine\"\namplitude = { over-threshold = 1.02 }\nfrequency = { omega = 2 }",
        "pulse = \"one-cosine\"\namplitude = { over-threshold = 1.04 }\nfrequency = { omega = 3 }",
        "pulse = \"mavroeidis-papageorgiou\"\namplitude = { over-threshold = 1.1 }\nfrequency = { omega = 3 }\ngamma = 1.5\nphase = 0.3",
        "sinusoids = [ { amplitude = { over-threshold = 0.9 }, frequency = { omega = 2 }, phase = 0.1 }, { amplitude = { over-threshold = 0.3 }, frequency = { omega = 5 } } ]\nduration = { tau = 12 }",
    ] {
        let scene = scene(0.6, &format!("[ground]\n{ground}\n"));
        let request = scene.on_motion(None, Termination::Exact).unwrap();
        let one = response(&scene);
        for oracle in &others {
            let other = Response::on_motion(oracle.as_ref(), &request).unwrap();
            assert!(!one.bouts.is_empty() && one.bouts.len() == other.bouts.len(), "{ground}");
            for (bout, same) in one.bouts.iter().zip(&other.bouts) {
                let allowed = bout.uncertainty() + same.uncertainty();
                assert!(
                    (bout.end() - same.end()).abs() <= allowed && allowed < 1e-4,
                    "{ground} {}: {} {} {allowed:e}",
                    oracle.name(),
                    bout.end(),
                    same.end()
                );
            }
        }
    }
    for name in ["ricker", "ricker-antisymmetric"] {
        let ground = format!(
            "[ground]\npulse = \"{name}\"\namplitude = {{ over-threshold = 1.03 }}\nfrequency = {{ omega = 4 }}\ncenter = {{ tau = 2 }}\n"
        );
        let linear = response(&scene(0.6, &ground));
        let text = format!("[block]\nradius = 1\nslenderness = 1e-4\nrestitution = 0.6\n{ground}");
        let slender = response(&Scene::parse(&text).unwrap());
        assert!(!linear.bouts.is_empty() && linear.bouts.len() == slender.bouts.len(), "{name}");
        for (one, other) in rests(&linear).into_iter().zip(rests(&slender)) {
            assert!((one.1 - other.1).abs() < 1e-6, "{name}: {one:?} {other:?}");
        }
    }
}

/// A mirror image moves the other way at the same times, to the last bit.
#[test]
fn a_mirror_image_is_one() {
    let record = |scale: &str| {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes");
        let ground = format!("[ground]\nrecord = {{ file = \"shaking.AT2\", units = \"g\", {scale} }}\n");
        let text =
            format!("[block]\nradius = 1\nslenderness = 0.2\nrestitution = 0.9\n{ground}[ask]\nmodel = \"linear\"\n");
        response(&Scene::parse_in(&text, folder.as_ref()).unwrap())
    };
    let (one, other) = (record("scale = 1.0"), record("scale = -1.0"));
    assert_eq!(rests(&one), rests(&other));
    // A direction is a sign.
    assert_eq!(other, record("direction = -1"));
    assert_eq!(one, record("direction = -1, scale = -1"));
    assert!(!one.bouts.is_empty());
    let velocities = |response: &Response| -> Vec<f64> {
        response.bouts.iter().flat_map(|bout| bout.impact_list(0.9).map(|(.., velocity)| velocity)).collect()
    };
    assert_eq!(velocities(&one), velocities(&other).iter().map(|velocity| -velocity).collect::<Vec<_>>());
}

/// Laws of every response: times never decrease, each impact loses energy, the block rests only while the ground holds it.
#[test]
fn a_response_to_a_record_keeps_the_laws() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes");
    let scene = Scene::parse_in(&std::fs::read_to_string(format!("{path}/earthquake.toml")).unwrap(), path.as_ref());
    let mut scene = scene.unwrap();
    scene.ask.model = Model::Linear;
    let response = response(&scene);
    assert!(response.bouts.len() >= 2, "{:?}", rests(&response));
    let mut before = 0.0;
    for bout in &response.bouts {
        assert!(bout.begin() >= before);
        assert!(
            (response.ground.acceleration(bout.begin()).abs() - 1.0).abs() < 1e-9,
            "off where the threshold is passed"
        );
        let mut now = bout.begin();
        for time in bout.impact_times() {
            assert!(time >= now);
            now = time;
        }
        assert!(bout.flights.iter().all(|flight| !matches!(flight.arrival, Arrival::Lost(_))));
        before = bout.end();
        assert!(before >= now && bout.is_known());
        assert!(response.ground.acceleration(before).abs() < 1.0);
    }
}

trait Known {
    fn is_known(&self) -> bool;
}

impl Known for Bout {
    fn is_known(&self) -> bool {
        !self.is_unsure() && self.outcome.is_rest()
    }
}

/// The amplitude of a pulse of Mavroeidis and Papageorgiou is not its peak: the guide says what that is.
#[test]
fn the_peaks_of_the_pulse_of_mavroeidis_and_papageorgiou_are_those_of_the_guide() {
    let peak = |gamma: f64, nu: f64| {
        let motion = Motion::mavroeidis_papageorgiou(1.0, 2.0, gamma, nu).unwrap();
        let at = |k: i32| acceleration(&motion, motion.duration() * f64::from(k) / 4e4).abs();
        (0..=40_000).map(at).fold(0.0, f64::max)
    };
    let guide = include_str!("../../src/guide/scenes.md");
    let said = guide.split("For `nu = 0`").nth(1).unwrap().split("\n\n").next().unwrap();
    for (gamma, expected) in
        [(1.0, "0.880"), (2.0, "0.906"), (3.0, "0.946"), (0.8, "0.920"), (0.5, "1.155"), (0.3, "1.738"), (0.1, "5.018")]
    {
        assert_eq!(format!("{:.3}", peak(gamma, 0.0)), expected, "{gamma}");
        assert!(said.contains(expected), "{said}");
        assert!((peak(gamma, std::f64::consts::FRAC_PI_2) - 1.0).abs() < 1e-6, "{gamma}");
    }
}

/// Every row of a history is made of numbers, at the start of a flight too, by either model.
#[test]
fn a_history_has_no_gaps() {
    for (scene, model) in
        [("one_sine", "nonlinear"), ("one_sine", "linear"), ("earthquake", "nonlinear"), ("earthquake", "linear")]
    {
        let arguments = ["response", &format!("data/scenes/{scene}.toml"), "--model", model];
        let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
        let csv = String::from_utf8(output.stdout).unwrap();
        assert!(csv.lines().count() > 1000, "{scene}");
        for row in csv.lines().skip(1) {
            let finite = row.split(',').take(6).all(|cell| cell.parse().is_ok_and(f64::is_finite));
            assert!(finite, "{scene}, {model}: {row}");
        }
    }
}

/// Times are stretched, whatever the file says: the same samples, twice as far apart.
#[test]
fn a_stretched_record_is_slower() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes");
    let parse = |stretched: &str| {
        let block = "[block]\nwidth = 0.4\nheight = 2.2\nrestitution = 0.9\n";
        let ground = format!("[ground]\nrecord = {{ file = \"shaking.AT2\"{stretched} }}\n");
        Scene::parse_in(&format!("{block}{ground}"), folder.as_ref()).unwrap()
    };
    let [plain, stretched] = [parse(""), parse(", time_scale = 2.0")].map(|scene| response(&scene));
    assert_eq!(stretched.lasts, plain.lasts.map(|lasts| 2.0 * lasts));
    assert_eq!(stretched.acceleration(20.0), plain.acceleration(10.0));
}

/// By the command line: what an engineer sees.
#[test]
fn the_response_is_told_in_seconds_and_degrees() {
    let run = |arguments: &[&str]| {
        let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let (json, said) =
        run(&["response", "data/scenes/one_sine.toml", "--format", "json", "--impacts", "3", "--model", "linear"]);
    let document: serde_json::Value = serde_json::from_str(&json).unwrap();
    let bout = &document["bouts"][0];
    assert_eq!(bout["impact_times"].as_array().unwrap().len(), 3);
    assert_eq!(bout["impact_velocities"].as_array().unwrap().len(), 3);
    let (phi, theta) = (document["peak"]["phi"].as_f64().unwrap(), document["peak"]["theta"].as_f64().unwrap());
    let alpha = 0.2_f64.atan2(1.1).to_degrees();
    assert!((theta - phi * alpha).abs() < 1e-12 * theta.abs(), "{phi} {theta}");
    assert!(said.contains("degrees"), "{said}");
    let (csv, _) = run(&["response", "data/scenes/one_sine.toml", "--model", "linear", "--steps", "50"]);
    assert!(csv.starts_with("tau,t,phi,theta,phi_velocity,ground_acceleration,state\n"), "{csv}");
}

/// The record among the scenes is made here: a stationary motion of sixty waves with phases from a seed, of the spectrum of Kanai and Tajimi (ground of 2.5 Hz, damped
/// by 0.6), under the envelope `(t/4) exp(1 - t/4)`.
fn shaking() -> String {
    let mut seed: u64 = 20261129;
    let mut uniform = move || {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = seed;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    let waves: Vec<(f64, f64, f64)> = (1..=60)
        .map(|k| {
            let hertz = 0.2 * f64::from(k);
            let (ratio, damping) = ((hertz / 2.5).powi(2), 4.0 * 0.6 * 0.6);
            let power = (1.0 + damping * ratio) / ((1.0 - ratio).powi(2) + damping * ratio);
            (power.sqrt(), hertz, std::f64::consts::TAU * uniform())
        })
        .collect();
    let samples: Vec<f64> = (0..1000)
        .map(|k| {
            let t = 0.02 * f64::from(k);
            let sum: f64 =
                waves.iter().map(|(a, hertz, phase)| a * (std::f64::consts::TAU * hertz * t + phase).sin()).sum();
            0.042 * (t / 4.0) * (1.0 - t / 4.0).exp() * sum
        })
        .collect();
    let mut text = String::from(
        "A SYNTHETIC MOTION, MADE BY tests/motion/ground.rs\nSIXTY WAVES OF A KANAI-TAJIMI SPECTRUM, SEED 20261129\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   1000, DT=   .0200 SEC\n",
    );
    for row in samples.chunks(5) {
        for sample in row {
            write!(text, "{sample:15.7e}").unwrap();
        }
        text.push('\n');
    }
    text
}

#[test]
fn the_record_among_the_scenes_is_the_one_that_is_made_here() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/shaking.AT2");
    if std::env::var_os("CHATTERCHECK_WRITE_RECORD").is_some() {
        std::fs::write(path, shaking()).unwrap();
    }
    assert!(
        std::fs::read_to_string(path).unwrap() == shaking(),
        "run this test with CHATTERCHECK_WRITE_RECORD=1 to write it anew"
    );
}

/// A motion of the kind `kind` with random parameters.
fn random_motion(kind: u32, uniform: &mut impl FnMut(f64, f64) -> f64) -> Motion {
    let sinusoid = |uniform: &mut dyn FnMut(f64, f64) -> f64| Sinusoid {
        amplitude: uniform(0.3, 1.2),
        omega: uniform(0.7, 6.0),
        phase: uniform(-3.0, 3.0),
    };
    match kind {
        0 => Motion::mavroeidis_papageorgiou(
            uniform(1.05, 1.6),
            uniform(1.5, 6.0),
            uniform(1.2, 3.0),
            uniform(-3.0, 3.0),
        ),
        1 => Motion::ricker(Ricker {
            amplitude: uniform(1.05, 1.8),
            omega: uniform(2.0, 6.0),
            center: uniform(0.5, 2.0),
            antisymmetric: uniform(0.0, 1.0) < 0.5,
        }),
        2 => {
            let stretch = |until: f64, uniform: &mut dyn FnMut(f64, f64) -> f64| Stretch {
                until,
                terms: vec![sinusoid(uniform), sinusoid(uniform)],
            };
            Motion::sinusoids(vec![stretch(uniform(0.5, 2.0), uniform), stretch(uniform(3.0, 6.0), uniform)])
        }
        _ => {
            let waves = [sinusoid(uniform), sinusoid(uniform)];
            let dt = uniform(0.01, 0.1);
            let at = |tau: f64| waves.iter().map(|of| of.amplitude * (of.omega * tau + of.phase).sin()).sum::<f64>();
            let samples = (0..60).map(|k| at(f64::from(k) * dt) + 0.1 * uniform(-1.0, 1.0)).collect();
            Motion::record(dt, 1.0, samples)
        }
    }
    .unwrap()
}

/// On motions of every kind that nobody chose, the general solver goes the way of the others on both equations, as far as either says that it is sure.
#[test]
fn methods_agree_on_motions_that_nobody_chose() {
    let mut seed: u64 = 7;
    let mut uniform = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut compared = 0;
    for n in 0..pick("random motions", 12, 400) {
        let motion = Arc::new(random_motion(n as u32 % 4, &mut uniform));
        let (eta, alpha) = (uniform(0.5, 0.9), uniform(0.05, 0.4));
        for alpha in [None, Some(alpha)] {
            let body = Body::new(eta, alpha).unwrap();
            let request = OnMotion {
                body,
                motion: Arc::clone(&motion),
                rounding: 0.0,
                start: (0.0, 0.0),
                until: 30.0,
                lies_at: alpha.map(|alpha| std::f64::consts::FRAC_PI_2 / alpha),
                termination: Termination::Exact,
                most_impacts: 100_000,
            };
            let model = if alpha.is_some() { "nonlinear" } else { "linear" };
            let ode = panel::one("ode", &Settings::default(), model).unwrap();
            let [one, other] = [panel::stepper_on(&body, &motion), ode]
                .map(|oracle| Response::on_motion(oracle.as_ref(), &request).unwrap());
            for (bout, same) in one.bouts.iter().zip(&other.bouts) {
                if bout.is_unsure() || same.is_unsure() {
                    break;
                }
                let off = (bout.end() - same.end()).abs();
                let allowed = bout.uncertainty() + same.uncertainty() + 1e-12 * bout.end();
                assert_eq!(bout.outcome.name(), same.outcome.name(), "{n} {motion:?} {body:?}");
                assert!(off <= allowed, "{n} {motion:?} {body:?}: {} {} {allowed:e}", bout.end(), same.end());
                compared += 1;
            }
        }
    }
    assert!(compared >= 20, "{compared}");
}
