use super::*;
use contract::{Oracle, Sinusoid, Stretch};

/// When a block rests that is set off at `start`; and how well that is known.
fn rest(flights: &dyn FlightSolver, eta: f64, start: f64, side: f64) -> (f64, f64) {
    let mut departure = Departure { ground: Ground::Shaking, time: start, side, rotation: 0.0, velocity: 0.0 };
    let mut low = 0.0;
    loop {
        match flights.fly(&departure, 100.0) {
            Arrival::Impact { interval, speed } => {
                let time = departure.time + (interval + low);
                low = (interval + low) - (time - departure.time);
                departure =
                    Departure { time, side: -departure.side, velocity: eta * speed, rotation: 0.0, ..departure };
            }
            other => panic!("{other:?} at {}", departure.time),
        }
        if let Some(left) = flights.time_to_rest(&departure)
            && left.uncertainty < 1e-14
        {
            return (departure.time + left.value, left.uncertainty);
        }
    }
}

/// Check values of the linear equation, to 24 digits, by another method.
#[test]
fn a_sine_pulse_on_the_linear_equation() {
    let motion = Motion::one_sine(1.02, 2.0).unwrap();
    let flights = Flights::new(&Body::new(0.6, None).unwrap(), &motion).unwrap();
    let (time, off) = rest(&flights, 0.6, (1.0_f64 / 1.02).asin() / 2.0, -1.0);
    assert!((time - 1.158_296_102_357_346).abs() < 2e-14 + off, "{time}");
}

/// A sinusoid is what it is to the method that this crate has for it alone.
#[test]
fn a_sinusoid_is_that_of_the_case() {
    for (a, omega, eta, alpha) in [(1.03, 2.0, 0.92, 0.3), (1.02, 0.7, 0.6, 0.8), (1.001, 4.0, 0.8, 0.05)] {
        let slenderness = contract::Slenderness::new(alpha, contract::Normalisation::Threshold).unwrap();
        let case = contract::Case::from_amplitude(a, omega, eta).unwrap().with_slenderness(slenderness);
        let own = crate::Taylor.history(&case.with_max_impacts(1).unwrap()).unwrap();
        let solver = crate::Taylor.flights(&case).unwrap();
        let term = Sinusoid { amplitude: a, omega, phase: (1.0 / a).asin() };
        let motion = Motion::sinusoids(vec![Stretch { until: f64::INFINITY, terms: vec![term] }]).unwrap();
        let flights = Flights::new(&Body::new(eta, Some(alpha)).unwrap(), &motion).unwrap();
        let mut departure = Departure { ground: Ground::Shaking, time: 0.0, side: -1.0, rotation: 0.0, velocity: 0.0 };
        for n in 0..60 {
            let (one, other) = (flights.fly(&departure, 10.0), solver.fly(&departure, 10.0));
            let (Arrival::Impact { interval, speed }, Arrival::Impact { interval: expected, speed: fast }) =
                (one, other)
            else {
                panic!("{n}: {one:?} {other:?}")
            };
            // The first flight hangs on the amplitude, whose angle is rounded here; and the pull of the others is a small difference where that is weak.
            let most = if n == 0 { 1e-11 } else { 4e-15 + 1e-17 / (a - 1.0) };
            assert!(
                (interval / expected - 1.0).abs() < most && (speed / fast - 1.0).abs() < most,
                "{a} {n}: {interval} {expected}"
            );
            departure =
                Departure { time: departure.time + expected, side: -departure.side, velocity: eta * fast, ..departure };
        }
        assert!((own.impacts[0].time / solver_first(&flights) - 1.0).abs() < 1e-11);
    }
}

fn solver_first(flights: &dyn FlightSolver) -> f64 {
    let departure = Departure { ground: Ground::Shaking, time: 0.0, side: -1.0, rotation: 0.0, velocity: 0.0 };
    match flights.fly(&departure, 10.0) {
        Arrival::Impact { interval, .. } => interval,
        other => panic!("{other:?}"),
    }
}

/// The series of each motion is its formula, and that of its slope, at a distance of a step.
#[test]
fn the_powers_of_a_motion_are_the_motion() {
    let ricker = |antisymmetric| {
        Motion::ricker(contract::Ricker { amplitude: 1.2, omega: 3.0, center: 2.5, antisymmetric }).unwrap()
    };
    let record = Motion::record(0.1, 2.0, (0..50).map(|k| f64::from(k * k % 7)).collect()).unwrap();
    for motion in [ricker(false), ricker(true), record, Motion::mavroeidis_papageorgiou(1.4, 3.0, 1.5, 0.3).unwrap()] {
        for start in [0.0, 0.33, 1.7, 2.41] {
            let Piece { powers, end, .. } = piece(&motion, start);
            let s = (0.5 * (end - start)).min(0.1);
            let sum = powers.iter().rev().fold(0.0, |sum, power| sum * s + power);
            let [there, ..] = piece(&motion, start + s).powers;
            assert!((sum - there).abs() < 1e-13, "{motion:?} {start}: {sum} {there}");
        }
    }
}

/// On still ground the linear block needs `2 Σ artanh(η^k v)` to rest, whatever speed it has: the formula of the nonlinear one with no slenderness left.
#[test]
fn free_rocking_of_the_slender_block_is_summed_from_any_speed() {
    let motion = Motion::one_sine(1.1, 2.0).unwrap();
    for eta in [0.5, 0.9, 0.952, 0.99] {
        let flights = Flights::new(&Body::new(eta, None).unwrap(), &motion).unwrap();
        for velocity in [1e-8, 1e-3, 0.1, 0.6, 0.99, 0.9999] {
            let from = Departure { ground: Ground::Still, time: 9.0, side: 1.0, rotation: 0.0, velocity };
            let exact: f64 = (0..4000).map(|k| 2.0 * f64::atanh(f64::powi(eta, k) * velocity)).sum();
            let left = flights.time_to_rest(&from).unwrap();
            assert!(
                flights.rests(&from) && (left.value / exact - 1.0).abs() < 1e-13,
                "{eta} {velocity}: {left:?} {exact}"
            );
            // The rounding of a speed counts next to the balance.
            assert!(left.uncertainty < 1e-13 * exact + 1e-15 / (1.0 - velocity));
        }
        for velocity in [1.0, 1.2] {
            let from = Departure { ground: Ground::Still, time: 9.0, side: 1.0, rotation: 0.0, velocity };
            assert!(!flights.rests(&from) && flights.time_to_rest(&from).is_none());
        }
    }
}
