//! The covariance against products of matrices, and its derivatives against differences of flights.

use super::*;
use crate::{
    flow::Flow,
    forcing::{Excitation, Forcing},
    march,
    takeoff::Outcome,
    twofold::Twofold,
};
use approx::assert_relative_eq;
use proptest::prelude::*;

fn takeoff(time: f64, speed: f64) -> Takeoff<'static> {
    let excitation: &Excitation = Box::leak(Box::new(Excitation::new(0.3, 2.0)));
    let flow: &Flow<f64> = Box::leak(Box::new(Flow::new(2.0)));
    let time = Twofold { high: time, low: 0.0 };
    let forcing: Forcing = excitation.forcing(1.0, excitation.half_phase(time));
    Takeoff { excitation, flow, time, sign: 1.0, speed, forcing, guess: None, horizon: 100.0 }
}

/// The duration of a flight, the end that it is followed to, and the logarithm of the speed that it lands with.
fn flown(time: f64, speed: f64) -> [f64; 3] {
    let Outcome::Landing(landing) = march::fly(takeoff(time, speed)) else { panic!("no impact") };
    [landing.interval.ln(), time + landing.interval, (-landing.velocity).ln()]
}

/// Errors that are large beside what a flight adds come out as the derivatives of the flight say, here by differences.
#[test]
fn errors_are_carried_as_flights_that_start_a_little_later_or_faster_end() {
    for (time, speed) in [(0.4, 0.3), (0.9, 0.2), (1.2, 0.3), (3.0, 0.2)] {
        let step = 1e-6;
        let [late, early] = [flown(time + step, speed), flown(time - step, speed)];
        let [fast, slow] = [flown(time, speed * (1.0 + step)), flown(time, speed * (1.0 - step))];
        // By the time, absolute, and by the speed, relative.
        let slope =
            |index: usize| [(late[index] - early[index]) / (2.0 * step), (fast[index] - slow[index]) / (2.0 * step)];
        let [interval, end, landed] = [slope(0), slope(1), slope(2)];
        let Outcome::Landing(landing) = takeoff(time, speed).fly() else { panic!("no impact") };
        let (a, b, c) = (3e20, -1e20, 2e20);
        let (after, of_interval) = Errors { time: a, both: b, speed: c }.after(&takeoff(time, speed), &landing);
        let product = |x: [f64; 2], y: [f64; 2]| x[0] * y[0] * a + (x[0] * y[1] + x[1] * y[0]) * b + x[1] * y[1] * c;
        for (found, expected) in [
            (of_interval, product(interval, interval)),
            (after.time, product(end, end)),
            (after.both, product(end, landed)),
            (after.speed, product(landed, landed)),
        ] {
            assert!(
                (found - expected).abs() <= 1e-7 * 1e20 + 1e-7 * expected.abs(),
                "{time} {speed}: {found:e} {expected:e}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// The same linear map, written as rows that act on four independent errors: of the time and the speed before, of the rotation and of
    /// the loss at the impact.
    #[test]
    fn the_covariance_is_that_of_a_linear_map(
        interval in 0.3..3.0f64, velocity in 0.3..3.0f64, (sinh, cosh) in (0.3..3.0f64, 0.3..3.0f64), (tilt, turn) in (-3.0..3.0f64, -3.0..3.0f64),
        (acceleration, off_parabola) in (-3.0..3.0f64, -3.0..3.0f64), (rotation, loss) in (0.3..3.0f64, 0.3..3.0f64), speed in 0.3..3.0f64,
        (a, c, share) in (0.3..3.0f64, 0.3..3.0f64, -0.8..0.8f64),
    ) {
        let takeoff = takeoff(0.4, speed);
        let landing = Landing {
            interval,
            loss: 0.0,
            velocity: -velocity,
            acceleration,
            off_parabola,
            by_speed: (sinh, cosh),
            by_time: (tilt, turn),
            rounding: (rotation, loss),
        };
        // u = 0 at the end: ds = -du/u'
        let stretch = [tilt / velocity / interval, sinh * speed / velocity / interval, 1.0 + rotation / velocity, 0.0];
        let end = [1.0 + tilt / velocity, sinh * speed / velocity, interval * stretch[2], 0.0];
        // d(-u')/(-u'): what the start changes, and the move of the impact by ds; of its own error only what is off the parabola.
        let landed = [
            -(turn + acceleration * tilt / velocity) / velocity,
            -(cosh * speed + acceleration * sinh * speed / velocity) / velocity,
            -off_parabola / velocity * interval * stretch[2],
            loss / velocity,
        ];
        let both = share * (a * c).sqrt();
        let product = |x: [f64; 4], y: [f64; 4]| {
            x[0] * y[0] * a + (x[0] * y[1] + x[1] * y[0]) * both + x[1] * y[1] * c + x[2] * y[2] + x[3] * y[3]
        };
        let (after, of_interval) = Errors { time: a, both, speed: c }.after(&takeoff, &landing);
        let near = |found: f64, expected: f64, size: f64| (found - expected).abs() <= 1e-12 * (size + expected.abs());
        let size = |x: [f64; 4]| 3.0 * x.iter().map(|entry| entry * entry).sum::<f64>();
        prop_assert!(near(of_interval, product(stretch, stretch), size(stretch)), "interval");
        prop_assert!(near(after.time, product(end, end), size(end)), "time");
        prop_assert!(near(after.speed, product(landed, landed), size(landed)), "speed");
        prop_assert!(near(after.both, product(end, landed), size(end) + size(landed)), "both");
    }
}

/// A flight that starts with nothing known for sure and undoes it: of a variance that cancels, 1e-15 of its largest term is left.
#[test]
fn a_variance_that_cancels_leaves_what_rounding_leaves_of_it() {
    assert_eq!(resolved(2e-15, 1.0), 2e-15);
    assert_eq!(resolved(1e-20, 2.0), 2e-15);
    assert_eq!(resolved(-1.0, 2.0), 2e-15);
    assert!(resolved(f64::NAN, 2.0).is_nan());
}

/// By the time and by the speed alike, so that with errors of opposite sign all three cancel.
#[test]
fn no_number_is_claimed_to_be_known_because_its_errors_cancel() {
    let takeoff = takeoff(0.4, 1.0);
    let landing = Landing {
        interval: 1.0,
        loss: 0.0,
        velocity: -1.0,
        acceleration: 0.0,
        off_parabola: 0.0,
        by_speed: (2.0, -3.0),
        by_time: (2.0, -3.0),
        rounding: (-1.0, 0.0),
    };
    let (after, of_interval) = Errors { time: 1.0, both: -1.0, speed: 1.0 }.after(&takeoff, &landing);
    assert_eq!(of_interval, 4e-15); // of 2² · 1
    assert_relative_eq!(after.speed, 9e-15, max_relative = 1e-15); // of 3² · 1
    let (after, _) = Errors { time: 1.0, both: -1.5, speed: 2.0 }.after(&takeoff, &landing);
    // Of the time: (1 + 2, 2) on 1, -1.5, 2: 9 - 18 + 8
    assert!(after.time == 1e-15, "{:e}", after.time);
}

/// Next to a grazing impact there is no claim, and no sign or quotient that is not a number.
#[test]
fn where_the_flight_only_touches_the_base_nothing_is_claimed() {
    for velocity in [0.0, 0.1] {
        let landing = Landing {
            interval: 1.0,
            loss: 0.0,
            velocity,
            acceleration: 1.0,
            off_parabola: 0.0,
            by_speed: (1.0, 1.0),
            by_time: (0.0, 1.0),
            rounding: (1.0, 1.0),
        };
        let (after, of_interval) = Errors::NONE.after(&takeoff(0.4, 1.0), &landing);
        assert_eq!(of_interval, f64::INFINITY);
        assert_eq!(after.claims(of_interval), [f64::INFINITY; 3]);
    }
}

/// Three standard errors, each 2⁻⁵³ of a square root.
#[test]
fn claims_are_three_standard_errors() {
    let errors = Errors { time: 4.0, both: 0.0, speed: 16.0 };
    assert_eq!(errors.claims(9.0), [6.0, 9.0, 12.0].map(|claim| claim / 2f64.powi(53)));
    for large in (Errors { time: 1e200, both: 0.0, speed: 1e200 }).claims(1e200) {
        assert_relative_eq!(large, 3e100 / 2f64.powi(53), max_relative = 1e-15);
    }
    for (time, interval, speed) in
        [(f64::INFINITY, 1.0, 1.0), (1.0, f64::INFINITY, 1.0), (1.0, 1.0, f64::INFINITY), (1.0, f64::NAN, 1.0)]
    {
        assert_eq!(Errors { time, both: 0.0, speed }.claims(interval), [f64::INFINITY; 3]);
    }
    // Their sum is no double any more.
    assert_eq!(Errors { time: f64::MAX, both: 0.0, speed: f64::MAX }.claims(1.0), [f64::INFINITY; 3]);
    assert_eq!(Errors { time: f64::MAX, both: 0.0, speed: 0.0 }.claims(f64::MAX), [f64::INFINITY; 3]);
}
