//! What the series is: coefficients, sums and times that other programs and formulas give.

use contract::{Closure, Departure, Estimate, Ground, Motion, Ricker};

use super::{impact, left, series, sines};

/// The first three coefficients where f = 0.3, f' = -0.8, f'' = 1.5 and eta = 0.9.
#[test]
fn the_first_coefficients_are_those_of_the_formulas() {
    // f = p + q with p = A sin(x) and q = B cos(x), of two frequencies: three numbers of it are as they have to be.
    let motion =
        sines(&[(-0.8, 1.0, 0.0), (-1.5, 1.0, std::f64::consts::FRAC_PI_2), (1.8, 0.0, std::f64::consts::FRAC_PI_2)]);
    let expected = [
        (1.0, [21.631000578369004, -89.07971415871765, 3478.537431009309]),
        (-1.0, [22.325043377674962, -81.03463604481992, 3709.923732986080]),
    ];
    for (side, expected) in expected {
        let v = 1e-4;
        let terms = series(8, 0.9, None, &motion).terms(&impact(side, 0.0, v)).unwrap();
        for (n, (term, expected)) in terms.as_slice().iter().zip(expected).enumerate() {
            let coefficient = term / v.powi(n as i32 + 1);
            assert!((coefficient / expected - 1.0).abs() < 3e-14, "{side} {n}: {coefficient} {expected}");
        }
    }
}

/// Under a constant pull the series is `Σ 2/(2m+1) [(v/C)^(2m+1) + (ηv/D)^(2m+1)]/(1 - η^(4m+2))`, to any order.
#[test]
fn a_constant_pull_is_the_exact_sum() {
    for (f, eta, v) in [(0.3, 0.9, 0.05), (-0.9, 0.6, 0.02), (0.0, 0.99, 0.2), (0.6, 0.2, 0.1)] {
        let motion = Motion::record(100.0, 1.0, vec![f, f]).unwrap();
        for side in [1.0, -1.0] {
            let terms = series(16, eta, None, &motion).terms(&impact(side, 0.0, v)).unwrap();
            let (own, other) = (v / (1.0 + side * f), eta * v / (1.0 - side * f));
            for (n, term) in (1..).zip(terms.as_slice()) {
                let exact = match n % 2 {
                    0 => 0.0,
                    _ => 2.0 / f64::from(n) * (own.powi(n) + other.powi(n)) / (1.0 - eta.powi(2 * n)),
                };
                let first = terms.as_slice()[0];
                assert!((term - exact).abs() <= 1e-13 * exact + 1e-22 * first, "{f} {side} {n}: {term} {exact}");
            }
        }
    }
}

/// Free rocking is the sum over all impacts of `2 atanh(v)`.
#[test]
fn free_rocking_is_a_sum_of_its_own() {
    let (eta, v) = (0.7_f64, 0.1_f64);
    let sum: f64 = (0..200).rev().map(|k| 2.0 * (v * eta.powi(k)).atanh()).sum();
    let still = Departure { ground: Ground::Still, ..impact(1.0, 7.0, v) };
    let Estimate { value, uncertainty } = left(16, eta, &sines(&[(5.0, 1.0, 0.3)]), &still);
    assert!((value - sum).abs() <= uncertainty && uncertainty < 1e-14, "{value} {sum} {uncertainty:e}");
}

/// Times to 25 digits by stepping with 50: all kinds of motion, and both equations.
#[test]
fn what_is_left_is_what_stepping_with_many_digits_takes() {
    let sine = || sines(&[(1.03, 2.0, 0.5)]);
    let ricker =
        |antisymmetric| Motion::ricker(Ricker { amplitude: 1.2, omega: 3.0, center: 2.5, antisymmetric }).unwrap();
    let straight = Motion::record(0.5, 1.0, vec![0.3, -0.1]).unwrap();
    let cases = [
        (sine(), None, impact(1.0, 0.9, 2e-4), 0.8, 0.004426335689387336031390175),
        (sine(), None, impact(-1.0, 0.9, 1e-4), 0.92, 0.006226215672044857741127766),
        (
            sines(&[(0.7, 2.0, 0.2), (0.6, 3.3, -1.0)]),
            None,
            impact(-1.0, 1.7, 1e-4),
            0.6,
            0.002196709569714076307408833,
        ),
        (ricker(false), None, impact(1.0, 2.9, 5e-5), 0.8, 0.0005151081519375131892518094),
        (ricker(true), None, impact(-1.0, 2.6, 5e-5), 0.8, 0.0005906817498535211683190491),
        (straight, None, impact(1.0, 0.0, 0.0002), 0.9, 0.004322655812196341676505668),
        (sine(), Some(0.3), impact(1.0, 0.9, 2e-4), 0.8, 0.004492908471650057293971049),
        (sine(), Some(0.3), impact(-1.0, 0.9, 1e-4), 0.92, 0.006319613645071734647843486),
        // The pull is a thousandth, and keeps its digits.
        (sines(&[(1.03, 2.0, 0.0)]), None, impact(-1.0, 0.9085, 2e-8), 0.8, 0.0001031943018000352955822447),
    ];
    for (place, (motion, alpha, departure, eta, expected)) in cases.iter().enumerate() {
        let closure = series(16, *eta, *alpha, motion);
        let Estimate { value, uncertainty } = closure.time_left(departure).unwrap();
        let off = (value - expected).abs();
        assert!(off <= uncertainty && uncertainty <= 1e-12 * expected, "{place}: {value} {expected} {uncertainty:e}");
        let (least, most) = closure.bounds(departure).unwrap();
        assert!(least <= *expected && *expected <= most && most <= 1.5 * least, "{place}: {least} {expected} {most}");
    }
}

/// `R(v, t) = T + R'(η w, t + T)`, with a flight over a straight line in closed form: `v = (c + j a) tanh a - j (a coth a - 1)`, `w - v = 2j (a coth a - 1)`.
#[test]
fn what_is_left_is_a_flight_and_what_is_left_after_it() {
    let (eta, slope) = (0.8, -0.7);
    let motion = Motion::record(1.0, 1.0, vec![0.4, 0.4 + slope]).unwrap();
    for (side, time, half) in [(1.0, 0.1, 0.002_f64), (-1.0, 0.2, 0.001), (-1.0, 0.05, 0.0003)] {
        let (pull, grows) = (1.0 + side * (0.4 + slope * time), side * slope);
        let square = half * half;
        let gain = grows * square * (1.0 / 3.0 - square / 45.0);
        let (v, w) = ((pull + grows * half) * half.tanh() - gain, (pull + grows * half) * half.tanh() + gain);
        let whole = left(12, eta, &motion, &impact(side, time, v));
        let rest = left(12, eta, &motion, &impact(-side, time + 2.0 * half, eta * w));
        let off = (whole.value - 2.0 * half - rest.value).abs();
        assert!(off <= whole.uncertainty + rest.uncertainty + 4.0 * f64::EPSILON * time, "{side} {time}: {off:e}");
    }
}

/// A block that is as good as slender obeys Eq. 4.
#[test]
fn a_slender_block_is_that_of_the_linear_equation() {
    let motion = sines(&[(1.03, 2.0, 0.5)]);
    let departure = impact(1.0, 0.9, 5e-4);
    let linear = left(8, 0.8, &motion, &departure);
    let slender = series(8, 0.8, Some(1e-7), &motion).time_left(&departure).unwrap();
    assert!((linear.value / slender.value - 1.0).abs() < 1e-13, "{linear:?} {slender:?}");
}
