#![allow(clippy::excessive_precision)] // Check values are written with the digits that they came with.

use super::*;
use contract::{Ground as Shaking, Motion, Sinusoid, Stretch};

/// The impacts from rest at the time `start`, until rest is known to `accuracy`; and when it is, and how well.
fn bout(motion: &Motion, eta: f64, start: f64, side: f64, accuracy: f64) -> (Vec<f64>, f64, f64) {
    let flights = Flights::new(motion, eta).unwrap();
    let mut departure = Departure { ground: Shaking::Shaking, time: start, side, rotation: 0.0, velocity: 0.0 };
    let mut impacts = Vec::new();
    let mut low = 0.0;
    loop {
        match flights.fly(&departure, 100.0) {
            Arrival::Impact { interval, speed } => {
                // A compensated sum.
                let time = departure.time + (interval + low);
                low = (interval + low) - (time - departure.time);
                departure =
                    Departure { time, side: -departure.side, velocity: eta * speed, rotation: 0.0, ..departure };
            }
            other => panic!("{other:?} after {impacts:?}"),
        }
        impacts.push(departure.time);
        if let Some(left) = flights.time_to_rest(&departure)
            && left.uncertainty < accuracy
        {
            return (impacts, departure.time + left.value, left.uncertainty);
        }
    }
}

/// Check values, to 24 digits, by another method.
#[test]
fn a_sine_pulse_is_followed_into_rest_and_out_of_it() {
    let motion = Motion::one_sine(1.02, 2.0).unwrap();
    let start = (1.0_f64 / 1.02).asin() / 2.0;
    let (impacts, rest, uncertainty) = bout(&motion, 0.6, start, -1.0, 1e-14);
    assert!(
        (rest - 1.158_296_102_357_345_982_79).abs() < 1e-14 + uncertainty,
        "{rest} {uncertainty:e} {}",
        impacts.len()
    );
    let again = start + std::f64::consts::FRAC_PI_2;
    assert!((again - 2.257_017_229_112_942_522_56).abs() < 1e-15);
    let (_, rest, _) = bout(&motion, 0.6, again, 1.0, 1e-14);
    assert!((rest - 2.729_092_429_152_242_602).abs() < 2e-14, "{rest}");
}

/// A sinusoid is what it is to the method that this crate has for it alone.
#[test]
fn a_sinusoid_is_that_of_the_case() {
    for (a, omega, eta) in [(1.03, 2.0, 0.92), (1.02, 0.7, 0.6), (1.001, 4.0, 0.8)] {
        let case = contract::Case::from_amplitude(a, omega, eta).unwrap();
        let own = contract::Oracle::history(&crate::ClosedForm, &case).unwrap();
        let term = Sinusoid { amplitude: a, omega, phase: (1.0 / a).asin() };
        let motion = Motion::sinusoids(vec![Stretch { until: f64::INFINITY, terms: vec![term] }]).unwrap();
        let (impacts, _, _) = bout(&motion, eta, 0.0, -1.0, 1e-13);
        for (n, (time, expected)) in impacts.iter().zip(&own.impacts).enumerate() {
            assert!((time - expected.time).abs() < 2e-12, "{a} {n}: {time} {}", expected.time);
        }
    }
}

/// Splitting a stretch changes nothing, to the last bit.
#[test]
fn a_stretch_in_two_is_the_same() {
    let term = Sinusoid { amplitude: 1.1, omega: 2.0, phase: 0.3 };
    let stretch = |until: f64| Stretch { until, terms: vec![term] };
    let one = Motion::sinusoids(vec![stretch(9.0)]).unwrap();
    let two = Motion::sinusoids(vec![stretch(1.0), stretch(1.3), stretch(9.0)]).unwrap();
    let start = ((1.0_f64 / 1.1).asin() - 0.3) / 2.0;
    assert_eq!(bout(&one, 0.8, start, -1.0, 1e-13).0, bout(&two, 0.8, start, -1.0, 1e-13).0);
}

/// A record of a sinusoid tends to it as the square of its step.
#[test]
fn a_record_of_a_sinusoid_tends_to_it() {
    let rest = |dt: f64| {
        let samples: Vec<f64> = (0..(6.0 / dt) as usize).map(|k| 1.03 * (2.0 * k as f64 * dt).sin()).collect();
        let at = |x: f64| 1.03 * (2.0 * x).sin();
        // Where the straight line between two samples passes the threshold.
        let k = (1..).find(|k| at(f64::from(*k) * dt) > 1.0).unwrap();
        let (low, high) = (at(f64::from(k - 1) * dt), at(f64::from(k) * dt));
        let start = (f64::from(k - 1) + (1.0 - low) / (high - low)) * dt;
        bout(&Motion::record(dt, 1.0, samples).unwrap(), 0.8, start, -1.0, 1e-12).1
    };
    let exact = {
        let term = Sinusoid { amplitude: 1.03, omega: 2.0, phase: 0.0 };
        let motion = Motion::sinusoids(vec![Stretch { until: 9.0, terms: vec![term] }]).unwrap();
        bout(&motion, 0.8, (1.0_f64 / 1.03).asin() / 2.0, -1.0, 1e-12).1
    };
    let errors = [0.02, 0.01, 0.005, 0.0025].map(|dt| (rest(dt) - exact).abs());
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.5..2.5).contains(&order), "{errors:?}");
    }
}

/// Whatever is glanced over is what the search finds with nothing handed over: the states agree within the bound on the error, and no root is passed.
#[test]
fn a_glance_is_near_and_passes_no_root() {
    let mut seed = 7_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut glanced, mut worst) = (0, 0.0_f64);
    for _ in 0..300 {
        let (dt, strength) = (0.01 + 0.05 * random(), 0.5 + 2.0 * random());
        let samples: Vec<f64> = (0..400).map(|_| strength * (2.0 * random() - 1.0)).collect();
        let motion = Motion::record(dt, 1.0, samples).unwrap();
        let flights = Flights::new(&motion, 0.9).unwrap();
        let departure = Departure {
            ground: Shaking::Shaking,
            time: 100.0 * dt * random(),
            side: 1.0,
            rotation: 0.0,
            velocity: 0.05 + random(),
        };
        let flight = flights.flight(&departure, 200.0 * dt);
        let end = match flights.fly(&departure, 200.0 * dt) {
            Arrival::Impact { interval, .. } => interval,
            Arrival::Overturned { after } => after,
            _ => 200.0 * dt,
        };
        // As far as it is certain that no root has been passed, the flight goes on.
        let start = 0.3 * end;
        let Some(mut glance) = Glance::new(&flight, start, flight.at(start)) else { panic!("a record has no waves") };
        let ends = flight.changes.iter().map(|change| change.at).filter(|at| *at > start);
        for to in ends {
            let Some((rotation, velocity)) = glance.above(&flight, to) else { break };
            assert!(to < end * (1.0 + 1e-12) || end >= 200.0 * dt || rotation + velocity > 1.0, "{to} is past {end}");
            let exact = flight.at(to);
            let off = (rotation - exact.0).abs().max((velocity - exact.1).abs());
            worst = worst.max(off / (glance.error() + glance::rounding(&flight, to)));
            glanced += 1;
        }
    }
    assert!(glanced > 3000 && worst < 1.0, "{glanced} {worst}");
}
