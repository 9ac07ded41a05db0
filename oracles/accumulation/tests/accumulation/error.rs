//! What is claimed.

use contract::{Closure, Motion, Ricker};

use super::{impact, left, series, sines};

/// As the speed goes to 0, what is wrong after the n-th term is the next one.
#[test]
fn the_error_after_n_terms_is_the_next_one() {
    let motion = sines(&[(1.03, 2.0, 0.5), (0.2, 5.0, 0.1)]);
    let departure = impact(-1.0, 1.0, 2e-4);
    let terms = series(16, 0.8, None, &motion).terms(&departure).unwrap();
    let terms = terms.as_slice();
    let after = |n: usize| -> f64 { terms[n..].iter().rev().sum() };
    for n in 1..=8 {
        let share = after(n) / terms[n];
        assert!((share - 1.0).abs() < 0.05, "{n}: {share} {terms:?}");
    }
}

/// No order is more wrong than it claims, from the first impact at which it does not decline; and the claims are not much too wide.
#[test]
fn no_claim_is_smaller_than_the_error() {
    let ricker = Motion::ricker(Ricker { amplitude: 1.3, omega: 3.0, center: 2.5, antisymmetric: true }).unwrap();
    let motions = [sines(&[(1.03, 2.0, 0.5)]), sines(&[(0.7, 2.0, 0.2), (0.6, 3.3, -1.0)]), ricker];
    let (mut answers, mut ratios) = (0, Vec::new());
    for (motion, alpha) in motions.iter().flat_map(|motion| [(motion, None), (motion, Some(0.3))]) {
        for k in 0..60_i32 {
            let time = 0.5 + 0.047 * f64::from(k);
            let eta = [0.5, 0.8, 0.95][k as usize % 3];
            let departure = impact(if k % 2 == 0 { 1.0 } else { -1.0 }, time, 0.02 * 0.5_f64.powi(k % 8));
            let Ok(best) = series(16, eta, alpha, motion).time_left(&departure) else { continue };
            for order in 1..=10 {
                let Ok(claimed) = series(order, eta, alpha, motion).time_left(&departure) else { continue };
                let error = (claimed.value - best.value).abs();
                assert!(
                    error <= claimed.uncertainty + best.uncertainty,
                    "{order} {departure:?} {eta}: {error:e} {claimed:?}"
                );
                answers += 1;
                if error > 1e3 * best.uncertainty {
                    ratios.push(claimed.uncertainty / error);
                }
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    assert!(answers > 200 && median < 3.0, "{answers} {median}");
}

/// What is left of a slower block lies between bounds that are narrower, as they fall with its speed.
#[test]
fn bounds_contain_the_sum_and_close_in() {
    let motion = sines(&[(1.03, 2.0, 0.5)]);
    for alpha in [None, Some(0.3)] {
        let mut widths = Vec::new();
        for k in 0..6 {
            let departure = impact(1.0, 0.9, 5e-4 * 0.1_f64.powi(k));
            let closure = series(8, 0.8, alpha, &motion);
            let (least, most) = closure.bounds(&departure).unwrap();
            let sum = closure.time_left(&departure).unwrap();
            assert!(
                least <= sum.value + sum.uncertainty && sum.value - sum.uncertainty <= most,
                "{k}: {least} {sum:?} {most}"
            );
            widths.push((most - least) / sum.value);
        }
        assert!(widths.windows(2).all(|pair| pair[1] < 0.2 * pair[0] || pair[1] < 1e-5), "{widths:?}");
    }
}

/// The block of the check value: 1.02 thresholds, omega 2, eta 0.6, one sine. It rests at 1.158296102357345982791668, stepped with many digits; from an impact in the
/// middle of its chattering the series says so.
#[test]
fn a_one_sine_pulse_ends_when_it_has_to() {
    let motion = Motion::one_sine(1.02, 2.0).unwrap();
    let (side, time, velocity) = (-1.0, 1.1573126614752404093, 7.2415266359373610441e-5);
    let rest = left(12, 0.6, &motion, &impact(side, time, velocity));
    assert!((time + rest.value - 1.158296102357345982791668).abs() < 1e-15 + rest.uncertainty, "{rest:?}");
    assert!(rest.uncertainty < 1e-12);
}
