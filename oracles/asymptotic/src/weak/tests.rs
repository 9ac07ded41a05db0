use std::f64::consts::SQRT_2;

use super::{flight::Push, sum::terms};
use crate::series::Series;

const TERMS: usize = 3;

/// `1 - x²/2 + f₃ x³/6 + f₄ x⁴/24` about the peak, from where it is 0 before it or from the peak itself: the coefficients of the time of rest in units of `(ε/κ)^(1/2)`,
/// with only those causes that are asked for.
fn coefficients(eta: f64, from_the_peak: bool, [third, fourth, lift, level]: [f64; 4]) -> Vec<f64> {
    let at = |place: usize, value: f64| {
        let mut series = Series::constant(0.0, TERMS);
        series.0[place] = value;
        series
    };
    let mut derivatives = vec![at(0, 1.0), at(0, 0.0), at(0, -1.0), at(1, third), at(2, fourth)];
    let moved = |derivatives: &[Series<f64>], x: &Series<f64>| -> Vec<Series<f64>> {
        let power = |j: usize| (1..=j).fold(at(0, 1.0), |power, j| power.times(x).scaled(1.0 / j as f64));
        (0..5).map(|k| (k..5).fold(at(0, 0.0), |sum, n| sum.plus(&derivatives[n].times(&power(n - k))))).collect()
    };
    if !from_the_peak {
        let mut x = at(0, -SQRT_2);
        for _ in 0..4 {
            let here = moved(&derivatives, &x);
            x = x.minus(&here[0].over(&here[1]));
        }
        derivatives = moved(&derivatives, &x);
        derivatives[0] = at(0, 0.0);
    }
    terms(Push { derivatives, kinks: Vec::new(), lift: at(2, lift), level: at(2, level) }, eta).unwrap()
}

/// `X, X₃, X₃₃, X₄, X_l, X_e`.
fn functions_of_eta(eta: f64, from_the_peak: bool) -> [f64; 6] {
    let of = |causes| coefficients(eta, from_the_peak, causes);
    let skew = of([1.0, 0.0, 0.0, 0.0]);
    let second = |causes| of(causes)[2];
    let [x4, xl, xe] = [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]].map(second);
    [skew[0], skew[1], skew[2], x4, xl, xe]
}

/// By other programs, in 25 digits and more, to the digits that are printed here.
#[test]
fn coefficients_are_those_of_another_program() {
    for (eta, from_the_peak, known) in [
        (0.6, false, [6.56678945789439, 1.63660255727381, 2.67505749768, 2.04826013877, 3.13687465312, 5.35722386330]),
        (0.92, false, [10.8274479067566, 5.77393205482, 13.3419963281, 11.1707361807, 4.77720736970, 33.0788932303]),
        (0.6, true, [4.13649685797, 1.60176214571, 1.58926265255, 1.10494008553, 1.06895940187, 2.48397859678]),
        (0.92, true, [7.33695824118, 4.32456234035, 7.05202969992, 5.42512088608, 1.60412031126, 15.1903472631]),
    ] {
        let found = functions_of_eta(eta, from_the_peak);
        for (found, known) in found.iter().zip(known) {
            // Half a unit of the twelfth digit, and a little for the rest.
            let digit = 10_f64.powf(f64::log10(known).floor() - 11.0);
            assert!((found - known).abs() < 0.6 * digit, "{eta} {from_the_peak}: {found} is not {known}");
        }
    }
}

/// A peak of two straight lines, in units of the time that it rises.
fn kinked(eta: f64, fall_by_rise: f64) -> f64 {
    let constant = |value| Series::constant(value, 1);
    let push = Push {
        derivatives: vec![constant(0.0), constant(1.0)],
        kinks: vec![(1.0, -1.0 - fall_by_rise)],
        lift: constant(0.0),
        level: constant(0.0),
    };
    terms(push, eta).unwrap()[0]
}

#[test]
fn of_a_kinked_peak_too() {
    for (eta, known) in [(0.92, 11.8361417916), (0.6, 5.92199379881)] {
        let found = kinked(eta, 1.0);
        assert!((found / known - 1.0).abs() < 5e-12, "{eta}: {found} is not {known}");
    }
    // Where it falls off steeply the block falls at once, and where it hardly falls for long.
    assert!(kinked(0.6, 100.0) < kinked(0.6, 1.0) && kinked(0.6, 0.1) > 5.0 * kinked(0.6, 1.0));
}

/// About a smooth peak `X` is that of Eq. 65, in units of `(ε/κ)^(1/2)` with `κ = ω²`.
#[test]
fn the_first_function_is_that_of_the_paper() {
    for eta in [0.3, 0.6, 0.9, 0.97] {
        let found = functions_of_eta(eta, false);
        let paper = crate::coefficients(eta).unwrap();
        assert!((found[0] / paper.x - 1.0).abs() < 1e-12, "{eta}: {found:?} {paper:?}");
    }
}
