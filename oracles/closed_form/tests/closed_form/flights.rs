//! Single flights from anywhere: the motion is that of Eq. 4, and the impact is the first time that it comes back to the base.

use closed_form::ClosedForm;
use contract::{Arrival, Case, Departure, Ground, Oracle};
use proptest::prelude::*;

const WAYS: [&str; 4] = ["from the base", "in the air", "at rest above the threshold", "on still ground"];

/// A departure of the way, at the times and speeds that make it one; `x`, `y` and `z` are in (0, 1).
fn departure(case: &Case, way: usize, [x, y, z]: [f64; 3]) -> Departure {
    let time = x / case.omega();
    let side = if z > 0.5 { 1.0 } else { -1.0 };
    let shaking = Departure { ground: Ground::Shaking, time, side, rotation: 0.0, velocity: 0.2 * y };
    match way {
        0 => shaking,
        1 => Departure { rotation: 0.3 * z, velocity: 0.4 * (y - 0.5), ..shaking },
        // The forcing is over the threshold from 0 to T/2 less twice asin(1/a), on the side to which the block leaves.
        2 => {
            let over = 2.0 * (1.0 / case.amplitude()).acos() / case.omega();
            Departure { time: over * 10f64.powf(-5.0 * x), side: -1.0, velocity: 0.0, ..shaking }
        }
        _ => Departure { ground: Ground::Still, rotation: 0.3 * z, ..shaking },
    }
}

/// `φ''` by Eq. 4, away from the base: `u'' = u - 1 - i f` with `f = a sin(ωτ + ψ)`.
fn acceleration(case: &Case, departure: &Departure, s: f64, rotation: f64) -> f64 {
    let f = match departure.ground {
        Ground::Shaking => {
            let (sin, cos) = (case.omega() * (departure.time + s)).sin_cos();
            (case.epsilon() * (2.0 + case.epsilon())).sqrt() * sin + cos
        }
        Ground::Still => 0.0,
    };
    rotation - 1.0 - departure.side * f
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_flight_obeys_the_equation_and_ends_at_its_first_root(
        way in 0..WAYS.len(), log_epsilon in -5.0..-1.0f64, omega in 0.5..8.0f64, places in [0.01..1.0f64, 0.01..1.0f64, 0.01..1.0f64],
    ) {
        let case = Case::from_epsilon(10f64.powf(log_epsilon), omega, 0.9).unwrap();
        let departure = departure(&case, way, places);
        let flights = ClosedForm.flights(&case).unwrap();
        let horizon = 3.0;
        let arrival = flights.fly(&departure, horizon);
        let length = match arrival {
            Arrival::Impact { interval, .. } => interval,
            Arrival::Overturned { after } => after,
            Arrival::Aloft { .. } => horizon,
            Arrival::Lost(loss) => return Err(TestCaseError::fail(format!("{} lost: {loss:?}", WAYS[way]))),
        };
        let at = |s: f64| flights.motion(&departure, s);
        let size = (0..=50).map(|k| at(length * f64::from(k) / 50.0)).fold(0.0f64, |size, (u, v)| size.max(u.abs() + v.abs()));
        for k in 1..50 {
            let s = length * f64::from(k) / 50.0;
            let (u, v) = at(s);
            prop_assert!(u > 0.0, "{} {departure:?}: {u:e} at {s} of {length}", WAYS[way]);
            // The derivatives by differences, to the sixth order of a step that is small beside the flight and the period.
            let h = 1e-2 * length.min(1.0 / omega).min(s).min(length - s);
            let by = |of: fn((f64, f64)) -> f64| {
                let [a, b, c] = [1.0, 2.0, 3.0].map(|n| of(at(s + n * h)) - of(at(s - n * h)));
                (45.0 * a - 9.0 * b + c) / (60.0 * h)
            };
            let tolerance = 1e-9 * size / h.min(1.0);
            prop_assert!((by(|state| state.0) - v).abs() < tolerance, "{} {departure:?}", WAYS[way]);
            prop_assert!((by(|state| state.1) - acceleration(&case, &departure, s, u)).abs() < tolerance, "{} {departure:?}", WAYS[way]);
        }
        if let Arrival::Impact { interval, speed } = arrival {
            let (u, v) = at(interval);
            prop_assert!(u.abs() < 1e-12 * size && (v + speed).abs() < 1e-9 * size, "{} {departure:?}: {u:e} {v} {speed}", WAYS[way]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Nothing is called overturned by a motion of the ground that is beyond the horizon: where it is, it overturns as well on ground that stops there.
    #[test]
    fn overturning_is_certain_whenever_the_ground_stops(
        epsilon in 0.3..6.0f64, omega in 0.3..3.0f64, share in 0.01..1.0f64, horizon in 0.05..4.0f64,
    ) {
        let case = Case::from_epsilon(epsilon, omega, 0.9).unwrap();
        let flights = ClosedForm.flights(&case).unwrap();
        let over = 2.0 * (1.0 / case.amplitude()).acos() / omega;
        let start =
            Departure { ground: Ground::Shaking, time: share * over, side: -1.0, rotation: 0.0, velocity: 0.0 };
        let (rotation, velocity) = match flights.fly(&start, horizon) {
            Arrival::Overturned { after } => {
                prop_assert!(after <= horizon);
                flights.motion(&start, after)
            }
            Arrival::Aloft { rotation, velocity } => {
                // The state is that of the horizon, from where the free flight has its own say.
                prop_assert_eq!((rotation, velocity), flights.motion(&start, horizon));
                return Ok(());
            }
            _ => return Ok(()),
        };
        let still = Departure { ground: Ground::Still, rotation, velocity, ..start };
        prop_assert_eq!(flights.fly(&still, 1e3), Arrival::Overturned { after: 0.0 });
    }
}

/// On still ground a block that leaves its base below the balance, `u' < 1`, comes back as fast as it left, again and again, and rests; at the balance and above
/// it does not come back.
#[test]
fn on_still_ground_what_comes_back_rests() {
    let flights = ClosedForm.flights(&Case::from_epsilon(0.03, 2.0, 0.9).unwrap()).unwrap();
    for velocity in [1e-12, 0.5, 0.999, 1.0_f64.next_down(), 1.0, 1.0_f64.next_up(), 1.001, 1.019, 2.0] {
        let departure = Departure { ground: Ground::Still, time: 0.0, side: 1.0, rotation: 0.0, velocity };
        let comes_back = matches!(flights.fly(&departure, 1e3), Arrival::Impact { .. });
        assert_eq!(comes_back, velocity < 1.0, "{velocity}");
        assert_eq!(flights.rests(&departure), comes_back, "{velocity}");
        assert_eq!(flights.time_to_rest(&departure).is_some(), comes_back, "{velocity}");
    }
}

/// The ground stops after a quarter of a cycle. The block overturns if `u + u' > 1` then, and from no amplitude below: by Eq. 6 and the growing part of free
/// rocking, that is from a = 1.97010957 on.
#[test]
fn a_block_overturns_after_a_quarter_of_a_cycle_from_the_right_amplitude_on() {
    let overturns = |a: f64| {
        let case = Case::from_amplitude(a, 1.0, 0.9).unwrap();
        let flights = ClosedForm.flights(&case).unwrap();
        // The motion starts with phase 0; time is counted from the threshold, the block leaves there.
        let lasts = std::f64::consts::FRAC_PI_2 - (1.0 / a).asin();
        let start = Departure { ground: Ground::Shaking, time: 0.0, side: -1.0, rotation: 0.0, velocity: 0.0 };
        match flights.fly(&start, lasts) {
            Arrival::Overturned { .. } => true,
            Arrival::Aloft { rotation, velocity } => {
                let still = Departure { ground: Ground::Still, rotation, velocity, ..start };
                matches!(flights.fly(&still, 1e3), Arrival::Overturned { .. })
            }
            other => panic!("{other:?}"),
        }
    };
    let (mut low, mut high) = (1.5, 2.5);
    while high - low > 1e-12 {
        let middle = 0.5 * (low + high);
        if overturns(middle) { high = middle } else { low = middle }
    }
    assert!((low - 1.970_109_57).abs() < 5e-9, "{low}");
}
