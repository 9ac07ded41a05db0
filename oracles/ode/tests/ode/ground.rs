//! Flights on ground that moves in other ways than a case has it: pulses, sums, wavelets, records.

use contract::{
    Arrival, Body, Decline, Departure, FlightSolver, Ground, Loss, Motion, Oracle, Ricker, Sinusoid, Stretch,
};
use ode::{Equation, Flights, Ode, Solver};

use crate::common::{Random, case, linear};

const DEFAULT: Solver = Solver::Tsit45;
/// What the flights of the default method are worth.
const WORTH: f64 = 1e-11;

fn solver(motion: &Motion, eta: f64) -> Box<dyn FlightSolver> {
    linear(DEFAULT).flights_on(&Body::new(eta, None).unwrap(), motion).unwrap()
}

fn nonlinear(motion: &Motion, alpha: f64) -> Box<dyn FlightSolver> {
    let body = Body::new(0.8, Some(alpha)).unwrap();
    Ode::new(Equation::Nonlinear, DEFAULT).flights_on(&body, motion).unwrap()
}

fn departure(time: f64, side: f64, rotation: f64, velocity: f64) -> Departure {
    Departure { ground: Ground::Shaking, time, side, rotation, velocity }
}

fn impact(solver: &dyn FlightSolver, departure: &Departure) -> (f64, f64) {
    match solver.fly(departure, 1e3) {
        Arrival::Impact { interval, speed } => (interval, speed),
        other => panic!("{departure:?}: {other:?}"),
    }
}

/// The times of the impacts, and rest with what is left uncertain of it, which is down to `accuracy`.
fn bout(solver: &dyn FlightSolver, eta: f64, mut from: Departure, accuracy: f64) -> (Vec<f64>, f64, f64) {
    let mut times = Vec::new();
    for _ in 0..2000 {
        let (interval, speed) = impact(solver, &from);
        from = Departure { time: from.time + interval, side: -from.side, rotation: 0.0, velocity: eta * speed, ..from };
        times.push(from.time);
        if let Some(left) = solver.time_to_rest(&from).filter(|left| left.uncertainty < accuracy) {
            return (times, from.time + left.value, left.uncertainty);
        }
    }
    panic!("no rest after {}", from.time);
}

fn sinusoid(amplitude: f64, omega: f64, phase: f64) -> Sinusoid {
    Sinusoid { amplitude, omega, phase }
}

fn stretches(of: &[(f64, &[Sinusoid])]) -> Motion {
    let stretch = |&(until, terms): &(f64, &[Sinusoid])| Stretch { until, terms: terms.to_vec() };
    Motion::sinusoids(of.iter().map(stretch).collect()).unwrap()
}

fn ricker(antisymmetric: bool) -> Motion {
    Motion::ricker(Ricker { amplitude: 1.2, omega: 3.0, center: 2.0, antisymmetric }).unwrap()
}

/// Rough: a slope of its own in each of forty steps, and a jump to nothing at the end.
fn record() -> Motion {
    let mut random = Random(7);
    Motion::record(0.07, 0.5, (0..41).map(|_| random.between(-2.6, 2.6)).collect()).unwrap()
}

/// A motion of every kind.
fn motions() -> [Motion; 6] {
    [
        Motion::one_sine(1.3, 2.0).unwrap(),
        stretches(&[
            (1.1, &[sinusoid(0.9, 2.0, 0.1), sinusoid(0.3, 5.0, 0.0)]),
            (1.6, &[]),
            (4.0, &[sinusoid(-1.1, 3.0, 0.4)]),
        ]),
        Motion::mavroeidis_papageorgiou(1.3, 3.0, 1.5, 0.3).unwrap(),
        ricker(false),
        ricker(true),
        record(),
    ]
}

/// `f` as the contract says it, without care for its last digits.
fn f(motion: &Motion, tau: f64) -> f64 {
    match motion {
        Motion::Sinusoids(stretches) => stretches
            .iter()
            .find(|of| tau < of.until)
            .map_or(0.0, |of| of.terms.iter().map(|term| term.amplitude * (term.omega * tau + term.phase).sin()).sum()),
        Motion::Ricker(of) if tau >= 2.0 * of.center => 0.0,
        Motion::Ricker(of) => {
            let y = of.omega * (tau - of.center) / if of.antisymmetric { 3.0_f64 } else { 2.0 }.sqrt();
            let p = if of.antisymmetric { (y.powi(3) - 3.0 * y) / 1.3801 } else { 1.0 - y * y };
            of.amplitude * p * (-0.5 * y * y).exp()
        }
        Motion::Record(of) => {
            let k = (tau / of.dt).floor();
            let sample = |k: usize| of.samples.get(k).map(|sample| sample * of.scale);
            let (Some(from), Some(to)) = (sample(k as usize), sample(k as usize + 1)) else { return 0.0 };
            from + (to - from) * (tau / of.dt - k)
        }
    }
}

/// Check values to 24 digits, by another method.
#[test]
fn a_sine_pulse_is_followed_into_rest_twice() {
    let solver = solver(&Motion::one_sine(1.02, 2.0).unwrap(), 0.6);
    let start = (1.0_f64 / 1.02).asin() / 2.0;
    for (start, side, rest) in [
        (start, -1.0, 1.158296102357345982791668),
        (start + core::f64::consts::FRAC_PI_2, 1.0, 2.729092429152242602022990),
    ] {
        let (_, found, uncertainty) = bout(solver.as_ref(), 0.6, departure(start, side, 0.0, 0.0), 1e-13);
        assert!((found - rest).abs() < WORTH + uncertainty, "{found} {rest}");
    }
}

/// From half of alpha: `u'' = u - 1`, and each later flight by itself, `T = 2 artanh v`.
#[test]
fn free_rocking_is_housners() {
    for motion in [stretches(&[(f64::INFINITY, &[])]), Motion::one_sine(0.0, 1.0).unwrap()] {
        let solver = solver(&motion, 0.9);
        let (times, rest, uncertainty) = bout(solver.as_ref(), 0.9, departure(0.0, 1.0, 0.5, 0.0), 1e-12);
        assert!((times[0] - 1.31695789692).abs() < WORTH && (times[1] - 3.40475479406).abs() < WORTH, "{times:?}");
        assert!((rest - 18.5189610108).abs() < 2e-10 + uncertainty, "{rest}");
    }
}

/// A sinusoid that is said as a motion is that of the case, on both equations.
#[test]
fn a_sinusoid_is_that_of_the_case() {
    for (a, omega, eta) in [(1.03, 2.0, 0.92), (1.02, 0.7, 0.6), (1.001, 4.0, 0.8)] {
        let motion = stretches(&[(f64::INFINITY, &[sinusoid(a, omega, (1.0_f64 / a).asin())])]);
        let block = contract::Slenderness::new(0.2, contract::Normalisation::Threshold).unwrap();
        let case = case(a, omega, eta).with_slenderness(block);
        let body = Body::new(eta, Some(0.2)).unwrap();
        for equation in [Equation::Linear, Equation::Nonlinear] {
            let ode = Ode::new(equation, DEFAULT);
            let (solver, own) = (ode.flights_on(&body, &motion).unwrap(), ode.impacts(&case).unwrap());
            let mut from = departure(0.0, -1.0, 0.0, 0.0);
            for expected in own.impacts.iter().take(20) {
                let (interval, speed) = impact(solver.as_ref(), &from);
                // The excess of the case is known to more digits than `a` leaves of it here.
                assert!((interval / expected.interval - 1.0).abs() < 1e-9, "{a} {interval} {expected:?}");
                from = departure(expected.time, -from.side, 0.0, eta * speed);
            }
        }
    }
}

/// From rest above the threshold, and from the base, the air and rest, each flight obeys the equation of motion up to its impact: second differences are the
/// acceleration, away from where that jumps.
#[test]
fn flights_obey_the_equation_over_all_breakpoints() {
    let mut random = Random(3);
    for motion in &motions() {
        for (solver, alpha) in [(solver(motion, 0.8), None), (nonlinear(motion, 0.3), Some(0.3_f64))] {
            for _ in 0..12 {
                let time = random.between(0.0, 0.8 * motion.duration());
                let side = if random.between(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
                let (rotation, velocity) = if random.between(0.0, 1.0) < 0.5 {
                    (0.0, random.between(0.01, 0.4))
                } else {
                    (random.between(0.0, 0.3), random.between(-0.3, 0.3))
                };
                let from = departure(time, side, rotation, velocity);
                let (arrival, horizon) = (solver.fly(&from, 2.0), 2.0);
                let end = match arrival {
                    Arrival::Impact { interval, speed } => {
                        let (u, du) = solver.motion(&from, interval);
                        assert!(u.abs() < 1e-11 && (du + speed).abs() < 1e-10, "{from:?} {u} {du} {speed}");
                        interval
                    }
                    Arrival::Aloft { rotation, velocity } => {
                        assert_eq!(solver.motion(&from, horizon), (rotation, velocity));
                        horizon
                    }
                    Arrival::Overturned { after } => after,
                    Arrival::Lost(loss) => panic!("{motion:?} {from:?}: {loss}"),
                };
                for part in 1..20 {
                    let (s, h) = (end * f64::from(part) / 20.0, 1e-3 * end.min(1.0));
                    let [before, now, after] = [s - h, s, s + h].map(|s| solver.motion(&from, s));
                    assert!(now.0 > 0.0, "{from:?}: no impact before the first");
                    let [low, mid, high] = [s - h, s, s + h].map(|s| f(motion, time + s));
                    let (angle, alpha_) = alpha.map_or((0.0, 1.0), |alpha| (alpha * (1.0 - now.0), alpha));
                    let second = |f: f64| match alpha {
                        None => now.0 - 1.0 - side * f,
                        Some(alpha) => -(angle.sin() + alpha.tan() * side * f * angle.cos()) / alpha_,
                    };
                    let found = (after.1 - before.1) / (2.0 * h);
                    // Between what it is at both ends, where it has a kink or a jump.
                    let steps = [low, high].map(|f| (second(f) - second(mid)).abs());
                    let allowed = 1e-5 + 2.0 * steps[0].max(steps[1]);
                    assert!((found - second(mid)).abs() < allowed, "{motion:?} {from:?} {s}: {found} {}", second(mid));
                    assert!(((after.0 - before.0) / (2.0 * h) - now.1).abs() < 1e-5, "{from:?} {s}");
                }
            }
        }
    }
}

/// On one straight line of a record: `v = (c + j a) tanh a - j (a coth a - 1)`, and it lands with `v + 2 j (a coth a - 1)` after `T = 2a`.
#[test]
fn a_flight_on_a_straight_line_is_the_closed_form() {
    let solver = solver(&Motion::record(8.0, 1.0, vec![-0.4, 0.8]).unwrap(), 0.8);
    for (time, side) in [(0.5, 1.0), (0.5, -1.0), (3.0, 1.0), (3.0, -1.0)] {
        let (c, j) = (1.0 + side * (-0.4 + 0.15 * time), side * 0.15);
        for a in [1e-6, 1e-3, 0.1, 0.5] {
            let coth = if a < 0.01 { a * a / 3.0 } else { a / f64::tanh(a) - 1.0 };
            let velocity = (c + j * a) * a.tanh() - j * coth;
            let (interval, speed) = impact(solver.as_ref(), &departure(time, side, 0.0, velocity));
            assert!((interval / (2.0 * a) - 1.0).abs() < 1e-11, "{time} {a} {interval}");
            assert!((speed / (velocity + 2.0 * j * coth) - 1.0).abs() < 1e-11, "{time} {a} {speed}");
        }
    }
}

/// Over two constants with a jump in between, flown in closed form: `u = c + (u_0 - c) cosh s + u_0' sinh s`; and the jump may be anywhere in the flight.
#[test]
fn a_flight_goes_over_a_jump() {
    let level = |f: f64| sinusoid(f, 0.0, core::f64::consts::FRAC_PI_2);
    for jump in [1e-13_f64, 1e-6, 0.1, 0.3, 0.45] {
        let motion = stretches(&[(1.0, &[level(0.25)]), (9.0, &[level(-0.5)])]);
        let solver = solver(&motion, 0.8);
        let (v, c, after) = (0.3_f64, 1.25, 0.5);
        let (u, w) = (c - c * jump.cosh() + v * jump.sinh(), -c * jump.sinh() + v * jump.cosh());
        // By x = tanh(s/2): (2c - u) x^2 - 2 w x - u = 0.
        let x = (w + (w * w + (2.0 * after - u) * u).sqrt()) / (2.0 * after - u);
        let s = 2.0 * x.atanh();
        let speed = -((u - after) * s.sinh() + w * s.cosh());
        let (interval, found) = impact(solver.as_ref(), &departure(1.0 - jump, 1.0, 0.0, v));
        assert!((interval - jump - s).abs() < 1e-11, "{jump}: {interval} {}", jump + s);
        assert!((found - speed).abs() < 1e-11, "{jump}: {found} {speed}");
    }
}

/// From rest: at a crossing of the threshold the rotation grows as `s^3`, above it, after a jump, as `s^2`.
#[test]
fn flights_start_from_rest() {
    // One cosine starts with a jump to 1.04; the pull is -0.04 there.
    for alpha in [None, Some(0.2)] {
        let of = |motion: &Motion| alpha.map_or_else(|| solver(motion, 0.8), |alpha| nonlinear(motion, alpha));
        let gain = alpha.map_or(1.0, |alpha: f64| alpha.sin() / alpha);
        let jump = of(&Motion::one_cosine(1.04, 3.0).unwrap());
        let crossing = of(&Motion::record(1.0, 1.0, vec![0.0, 2.0, 0.0]).unwrap());
        for s in [1e-3, 1e-2] {
            let (rotation, velocity) = jump.motion(&departure(0.0, -1.0, 0.0, 0.0), s);
            assert!((rotation / (0.5 * gain * 0.04 * s * s) - 1.0).abs() < 0.01, "{s}: {rotation}");
            assert!((velocity / (gain * 0.04 * s) - 1.0).abs() < 0.03, "{s}: {velocity}");
            let (rotation, velocity) = crossing.motion(&departure(0.5, -1.0, 0.0, 0.0), s);
            assert!((rotation / (gain * s * s * s / 3.0) - 1.0).abs() < 1e-4, "{s}: {rotation}");
            assert!((velocity / (gain * s * s) - 1.0).abs() < 1e-4, "{s}: {velocity}");
        }
        // A rounding before the sample at which the threshold is passed, and after it.
        let kink = of(&Motion::record(0.1, 1.0, vec![0.0, 1.0, 2.0, 0.0]).unwrap());
        for time in [0.1 - 1e-17, 0.1 - 3e-17, 0.1, 0.1 + 3e-17] {
            let (interval, _) = impact(kink.as_ref(), &departure(time, -1.0, 0.0, 0.0));
            let (at_kink, _) = impact(kink.as_ref(), &departure(0.1, -1.0, 0.0, 0.0));
            assert!((interval - at_kink).abs() < 1e-11);
        }
        // Nothing pushes.
        assert_eq!(crossing.fly(&departure(0.2, -1.0, 0.0, 0.0), 1.0), Arrival::Lost(Loss::Stalled));
        assert_eq!(crossing.fly(&departure(1.5, -1.0, 0.0, 0.0), 1.0), Arrival::Lost(Loss::Stalled));
    }
}

/// Splitting a stretch, or a straight line of a record, changes nothing to the last bit.
#[test]
fn halves_are_the_whole() {
    let term = sinusoid(1.1, 2.0, 0.3);
    let whole = stretches(&[(9.0, &[term])]);
    let halves = stretches(&[(1.0, &[term]), (1.3, &[term]), (9.0, &[term])]);
    let start = departure((f64::asin(1.0 / 1.1) - 0.3) / 2.0, -1.0, 0.0, 0.0);
    let of = |motion: &Motion| bout(solver(motion, 0.8).as_ref(), 0.8, start, 1e-12);
    assert_eq!(of(&whole), of(&halves));
    let line = |step: f64, samples: &[f64]| Motion::record(step, 1.0, samples.to_vec()).unwrap();
    let (one, two) = (line(1.0, &[0.0, 2.0, -1.0]), line(0.5, &[0.0, 1.0, 2.0, 0.5, -1.0]));
    let of = |motion: &Motion| impact(solver(motion, 0.8).as_ref(), &departure(0.5, -1.0, 0.0, 0.0));
    assert_eq!(of(&one), of(&two));
}

/// A record of a wavelet, sampled ever finer, tends to the wavelet as the square of its step.
#[test]
fn a_record_of_a_wavelet_tends_to_it() {
    for antisymmetric in [false, true] {
        let motion = ricker(antisymmetric);
        let from = departure(1.2, 1.0, 0.0, 0.3);
        let (exact, speed) = impact(solver(&motion, 0.8).as_ref(), &from);
        let errors = [0.04, 0.02, 0.01].map(|dt| {
            let samples = (0..=(4.0 / dt) as usize).map(|k| f(&motion, k as f64 * dt)).collect();
            let (found, same) = impact(solver(&Motion::record(dt, 1.0, samples).unwrap(), 0.8).as_ref(), &from);
            (found - exact).abs() + (same - speed).abs()
        });
        for pair in errors.windows(2) {
            assert!((3.5..4.5).contains(&(pair[0] / pair[1])), "{errors:?}");
        }
    }
}

/// What is proven of the rest comes true, on every motion and equation, and is conservative: bounds of later impacts are inside of those of earlier ones.
#[test]
fn rest_is_where_it_is_said_to_be() {
    let mut proofs = 0;
    for motion in &motions() {
        for solver in [solver(motion, 0.8), nonlinear(motion, 0.3)] {
            let mut random = Random(11);
            for _ in 0..10 {
                let mut from = departure(
                    random.between(0.0, motion.duration()),
                    1.0,
                    0.0,
                    10_f64.powf(random.between(-4.0, -1.0)),
                );
                let mut between: Option<(f64, f64)> = None;
                for _ in 0..60 {
                    let Arrival::Impact { interval, speed } = solver.fly(&from, 10.0) else { break };
                    from = departure(from.time + interval, -from.side, 0.0, 0.8 * speed);
                    let Some(left) = solver.time_to_rest(&from) else {
                        assert_eq!(between, None, "{motion:?} {from:?}: what was certain is so later");
                        continue;
                    };
                    assert!(solver.rests(&from));
                    let (low, high) =
                        (from.time + left.value - left.uncertainty, from.time + left.value + left.uncertainty);
                    if let Some((least, most)) = between {
                        assert!(
                            low > least - 1e-12 && high < most + 1e-12,
                            "{motion:?} {from:?}: {low} {high} {between:?}"
                        );
                    }
                    between = Some((low, high));
                    proofs += 1;
                }
            }
        }
    }
    assert!(proofs > 2000, "{proofs}");
}

/// No rest is certain over the end of a pulse that jumps, or where the ground pushes.
#[test]
fn rest_is_not_said_over_a_jump() {
    let level = |f: f64| sinusoid(f, 0.0, core::f64::consts::FRAC_PI_2);
    let motion = stretches(&[(1.0, &[level(0.5)]), (9.0, &[level(2.0)])]);
    let solver = solver(&motion, 0.8);
    // On constant ground what is left is about 2 v (1/1.5 + 0.8/0.5)/0.36.
    let left = |velocity: f64| 2.0 * velocity * (1.0 / 1.5 + 0.8 / 0.5) / 0.36;
    let velocity = 1e-3;
    assert!(solver.rests(&departure(1.0 - 3.0 * left(velocity), 1.0, 0.0, velocity)));
    assert!(!solver.rests(&departure(1.0 - 0.5 * left(velocity), 1.0, 0.0, velocity)));
    assert!(!solver.rests(&departure(2.0, 1.0, 0.0, 1e-9)) && !solver.rests(&departure(2.0, -1.0, 0.0, 1e-9)));
    let ends = |last: f64| solver_of_record(&[0.5, 0.25, last]);
    let late = departure(2.0 - 1e-4, 1.0, 0.0, velocity);
    assert!(ends(0.0).rests(&late) && !ends(0.01).rests(&late));
}

fn solver_of_record(samples: &[f64]) -> Box<dyn FlightSolver> {
    solver(&Motion::record(1.0, 1.0, samples.to_vec()).unwrap(), 0.8)
}

/// Only once neither the rest of the motion nor still ground brings it back.
#[test]
fn overturning_is_certain_on_still_ground_too() {
    let level = |f: f64| sinusoid(f, 0.0, core::f64::consts::FRAC_PI_2);
    let motion = stretches(&[(0.8, &[level(-3.0)]), (4.0, &[level(1.5)]), (9.0, &[])]);
    let solver = solver(&motion, 0.8);
    // Away from the base at first, and above alpha, but brought back by what follows.
    let from = departure(0.0, 1.0, 0.0, 0.0);
    let (rotation, _) = solver.motion(&from, 0.8);
    let Arrival::Overturned { after } = solver.fly(&from, 9.0) else { panic!("it overturns") };
    let (u, w) = solver.motion(&from, after);
    assert!(rotation > 0.6 && u + w > 4.0, "{u} {w}");
    let weaker = departure(0.4, 1.0, 0.0, 0.0);
    assert!(matches!(solver.fly(&weaker, 9.0), Arrival::Impact { .. }));
    let still = Departure { ground: Ground::Still, ..departure(0.0, 1.0, 1.1, 0.0) };
    assert!(matches!(solver.fly(&still, 9.0), Arrival::Overturned { after } if after < 0.1));
}

/// Every method integrates every motion, as accurately as its tolerance.
#[test]
fn all_methods_agree() {
    for motion in &motions() {
        let body = Body::new(0.8, None).unwrap();
        let from = departure(0.3, -1.0, 0.0, 0.3);
        let of = |method: Solver| impact(linear(method).flights_on(&body, motion).unwrap().as_ref(), &from).0;
        let [exact, others @ ..] = Solver::ALL.map(of);
        for (other, method) in others.into_iter().zip(&Solver::ALL[1..]) {
            assert!((other / exact - 1.0).abs() < 300.0 * method.default_rtol(), "{method}: {other} {exact}");
        }
        let coarse = linear(DEFAULT).with_rtol(1e-4).unwrap().flights_on(&body, motion).unwrap();
        let off = (impact(coarse.as_ref(), &from).0 / exact - 1.0).abs();
        assert!(off > 1e-12 && off < 1e-2, "{off}: the tolerance is used");
    }
}

#[test]
fn what_cannot_be_done_is_declined() {
    let motion = Motion::one_sine(1.1, 2.0).unwrap();
    let body = Body::new(0.8, None).unwrap();
    let declined = |ode: Ode| ode.flights_on(&body, &motion).err();
    assert_eq!(declined(Ode::new(Equation::Nonlinear, DEFAULT)), Some(Decline::NeedsSlenderness));
    assert!(matches!(declined(linear(DEFAULT).with_flights(Flights::Naive)), Some(Decline::Unsupported { .. })));
    // The linear equation takes no notice of a slenderness.
    let slender = Body::new(0.8, Some(0.3)).unwrap();
    let of = |body: &Body| {
        impact(linear(DEFAULT).flights_on(body, &motion).unwrap().as_ref(), &departure(0.1, 1.0, 0.0, 0.2))
    };
    assert_eq!(of(&body), of(&slender));
}
