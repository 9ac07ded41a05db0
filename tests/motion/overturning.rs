//! How strong a pulse has to be to overturn a block, against a plain integration of Eq. 2 that knows nothing of the harness, at many scales: a block may survive a
//! stronger pulse than one that overturns it.

use assert_cmd::Command;
use serde_json::Value;

const ALPHA: f64 = 0.2;
const GRAVITY: f64 = 9.80665;
const HERTZ: f64 = 2.0;
const RADIUS: f64 = 1.0;

/// Whether one sine of this peak, in multiples of `g tan α`, overturns the block: Runge and Kutta's steps of a fixed length, cut in halves at an impact.
fn overturns(scale: f64) -> bool {
    let p2 = 0.75 * GRAVITY / RADIUS;
    let eta = 1.0 - 1.5 * ALPHA.sin().powi(2);
    let ground = |t: f64| {
        if t < 1.0 / HERTZ { scale * ALPHA.tan() * (std::f64::consts::TAU * HERTZ * t).sin() } else { 0.0 }
    };
    // Where the ground exceeds the threshold the block leaves its base to the other side.
    let begin = (1.0 / scale).asin() / (std::f64::consts::TAU * HERTZ);
    let (mut t, mut theta, mut velocity, mut side) = (begin, 0.0_f64, 0.0_f64, -1.0_f64);
    let pull = |t: f64, theta: f64, side: f64| {
        let to_balance = ALPHA * side - theta;
        -p2 * (to_balance.sin() + ground(t) * to_balance.cos())
    };
    let step = |t: f64, theta: f64, velocity: f64, side: f64, h: f64| {
        let k1 = (velocity, pull(t, theta, side));
        let k2 = (velocity + 0.5 * h * k1.1, pull(t + 0.5 * h, theta + 0.5 * h * k1.0, side));
        let k3 = (velocity + 0.5 * h * k2.1, pull(t + 0.5 * h, theta + 0.5 * h * k2.0, side));
        let k4 = (velocity + h * k3.1, pull(t + h, theta + h * k3.0, side));
        (
            theta + h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0),
            velocity + h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1),
        )
    };
    let whole = 1e-3;
    loop {
        let mut h = whole;
        let mut next = step(t, theta, velocity, side, h);
        if side * next.0 < 0.0 {
            // The impact is within: as near to it as can be.
            let (mut inside, mut outside) = (0.0, whole);
            for _ in 0..50 {
                let middle = 0.5 * (inside + outside);
                if side * step(t, theta, velocity, side, middle).0 < 0.0 { outside = middle } else { inside = middle }
            }
            h = inside;
            next = step(t, theta, velocity, side, h);
            next = (0.0, eta * next.1);
            side = -side;
        }
        (t, theta, velocity) = (t + h, next.0, next.1);
        if theta.abs() > 1.5 {
            return true;
        }
        // On still ground it takes so much energy to pass the corner.
        let energy = 0.5 * velocity * velocity + p2 * (ALPHA - theta.abs()).cos();
        if t > 1.0 / HERTZ && energy < p2 && theta.abs() < ALPHA {
            return false;
        }
        assert!(t < 60.0, "neither falls nor calms down at {scale}");
    }
}

#[test]
fn every_change_of_fate_is_found() {
    let arguments = ["overturning", "data/scenes/sine_at_2_hz.toml", "--from", "1", "--to", "20", "--format", "json"];
    let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let changes: Vec<(f64, f64, bool)> = answer["overturning"]["changes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|change| {
            (
                change["lower"].as_f64().unwrap(),
                change["upper"].as_f64().unwrap(),
                change["happens_above"].as_bool().unwrap(),
            )
        })
        .collect();
    // It begins, ceases and begins again: between them a stronger pulse is survived.
    assert_eq!(changes.iter().map(|change| change.2).collect::<Vec<_>>(), [true, false, true], "{changes:?}");
    // The first change is proven by the judge, from both sides and as near as it can.
    let [lower, upper] = ["lower", "upper"].map(|end| answer["overturning"][end].as_f64().unwrap());
    assert_eq!(answer["overturning"]["certified"], true);
    assert!(
        lower <= changes[0].0 && changes[0].1 <= upper && upper / lower - 1.0 < 1e-8,
        "{lower} {upper} {changes:?}"
    );
    assert!(changes.iter().all(|(lower, upper, _)| lower < upper && upper - lower < 1e-14 * upper), "{changes:?}");
    let fate = |scale: f64| changes.iter().filter(|(_, upper, _)| *upper <= scale).count() % 2 == 1;
    let is_near = |scale: f64| changes.iter().any(|(lower, ..)| (scale / lower - 1.0).abs() < 1e-5);
    let mut asked = 0;
    // Many scales, and some just beside each change.
    let beside = changes.iter().flat_map(|(lower, ..)| [lower * (1.0 - 1e-4), lower * (1.0 + 1e-4)]);
    for scale in (0..600).map(|k| 1.05 + 18.95 * f64::from(k) / 600.0).chain(beside).filter(|scale| !is_near(*scale)) {
        assert_eq!(overturns(scale), fate(scale), "at {scale}, with changes at {changes:?}");
        asked += 1;
    }
    assert!(asked >= 600);
}
