//! Eq. 2 as printed, references of 50 digits, limits and outcomes.

use contract::{Case, Decline, Ending, History, Horizon, Normalisation, Oracle, Slenderness};

use crate::Taylor;
use crate::equation::{Block, excess};
use crate::series::{Scale, Terms, expand};

fn case(a: f64, omega: f64, eta: f64, alpha: f64) -> Case {
    let slenderness = Slenderness::new(alpha, Normalisation::Threshold).unwrap();
    Case::from_amplitude(a, omega, eta).unwrap().with_slenderness(slenderness)
}

fn solve(case: &Case) -> History {
    Taylor.history(case).unwrap()
}

fn close(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() <= relative, "{found:?} is not {expected:?}: {:e}", found / expected - 1.0);
}

/// `φ''` of Eq. 2 as printed.
fn printed(a: f64, omega: f64, alpha: f64, side: f64, tau: f64, phi: f64) -> f64 {
    let f = a * (omega * tau + (1.0 / a).asin()).sin();
    let angle = alpha * (side - phi);
    -(angle.sin() + alpha.tan() * f * angle.cos()) / alpha
}

#[test]
fn the_series_satisfies_eq_2_as_printed() {
    for (a, omega, alpha, side, tau, u, w) in [
        (1.03, 2.0, 0.2, -1.0, 0.3, 0.02, 0.01),
        (1.5, 1.0, 0.5, 1.0, 0.7, 0.3, -0.4),
        (3.0, 4.0, 1.2, -1.0, 2.0, 1.3, 0.9),
        (1.001, 0.5, 0.01, 1.0, 0.1, 1e-5, 1e-4),
    ] {
        let block = Block::new(a - 1.0, omega, 0.9, alpha);
        let scale = Scale { time: 0.1, velocity: 0.5 };
        let unit = scale.time * scale.velocity;
        let all = Terms { most: 24, negligible: 0.0 };
        let series = expand(&block, &block.forcing(side, tau), &scale, (u / unit, w / scale.velocity), all);
        for xi in [0.0_f64, 0.2, 0.7, 1.0] {
            let (mut value, mut second) = (0.0, 0.0);
            for (k, c) in (0_i32..).zip(series.from(0)) {
                value += c * xi.powi(k);
                second += f64::from(k * (k - 1)) * c * if k < 2 { 0.0 } else { xi.powi(k - 2) };
            }
            let (phi, found) = (side * value * unit, side * second * unit / (scale.time * scale.time));
            let expected = printed(a, omega, alpha, side, tau + scale.time * xi, phi);
            assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} {expected}");
        }
    }
}

/// `a, ω, η, α`.
type Parameters = (f64, f64, f64, f64);
/// `n, τ_n, Δτ_{n-1}, φ'_n`.
type Reference = (usize, f64, f64, f64);

/// By series of Eq. 2 as printed, with mpmath at 50 digits, for the doubles.
#[test]
#[allow(clippy::excessive_precision)]
fn references_of_many_digits() {
    for ((a, omega, eta, alpha), rows) in REFERENCES {
        let history = solve(&case(a, omega, eta, alpha));
        assert_eq!(history.ending, Ending::AtRest);
        for (n, time, interval, velocity) in rows {
            let impact = history.impacts[n - 1];
            close(impact.time, time, 1e-13);
            assert!((impact.time - time).abs() <= impact.uncertainty.time);
            close(impact.interval, interval, impact.uncertainty.interval);
            close(impact.velocity, velocity, impact.uncertainty.velocity);
            assert!(impact.uncertainty.interval < 1e-10 && impact.uncertainty.velocity < 1e-10);
        }
    }
}

#[allow(clippy::excessive_precision, clippy::unreadable_literal)]
const REFERENCES: [(Parameters, [Reference; 5]); 3] = [
    (
        (1.03, 2.0, 0.92, 0.2),
        [
            (1, 0.48780213729986013939, 0.48780213729986013939, 0.017671273613812828236),
            (3, 0.61130968995633183582, 0.10324060546471328752, 0.017444735944748960421),
            (10, 0.83908449988244107708, 0.02048668917834794344, -0.010784749618523591894),
            (40, 1.1009084834214379197, 0.0030362127961466005812, -0.00084798071419912696012),
            (60, 1.1212819710470490904, 0.00060570239101223182912, -0.00015808160142861561106),
        ],
    ),
    (
        (1.001, 0.5, 0.8, 0.4),
        [
            (1, 0.35850189481948164975, 0.35850189481948164975, 0.0003738057652552048765),
            (3, 0.42295047352124607302, 0.064063062728084169002, 0.00027927536852720632138),
            (10, 0.48751116644669214497, 0.000085909825685973121074, -0.000066282023491521957645),
            (40, 0.50712314221599919857, 1.1006279349882578028e-7, -8.4831433723854059778e-8),
            (60, 0.50714639153482634939, 1.2689879237716365192e-9, -9.7807742376428018241e-10),
        ],
    ),
    (
        (1.03, 20.0, 0.7, 0.1),
        [
            (1, 0.048583025990474059867, 0.048583025990474059867, 0.0013354506095718431053),
            (3, 0.056636996425229203005, 0.0065344938822276720184, 0.00072699595579803157998),
            (10, 0.062797115669330886673, 0.00011724766577831778168, -0.000063296422589585464848),
            (40, 0.063451891096117344593, 2.6808760014387926867e-9, -1.4358670469507474961e-9),
            (60, 0.063451905733348845867, 2.1391324037575647632e-12, -1.1457110203344864878e-12),
        ],
    ),
];

#[test]
#[allow(clippy::excessive_precision)]
fn a_slender_block_is_linear() {
    let history = solve(&case(1.03, 2.0, 0.92, 1e-4));
    close(history.impacts[0].time, 0.487_764_790_632_652_10, 1e-9);
    close(history.impacts[39].time, 1.100_777_030_781_602_1, 1e-9);
    let history = solve(&case(1.03, 2.0, 0.92, 1e-8));
    close(history.impacts[0].time, 0.487_764_790_632_652_10, 1e-13);
    close(history.impacts[39].time, 1.100_777_030_781_602_1, 1e-13);
}

#[test]
fn deep_down_intervals_shrink_by_the_square_of_eta() {
    let deep = case(1.03, 2.0, 0.92, 0.2).with_max_impacts(10_000).unwrap();
    let history = solve(&deep);
    assert_eq!(history.ending, Ending::AtRest);
    let mut seen = 0;
    for pair in history.impacts.windows(3).filter(|p| p[2].interval < 1e-17) {
        close(pair[2].interval / pair[0].interval, 0.92 * 0.92, 1e-14);
        close(pair[2].velocity / pair[0].velocity, 0.92 * 0.92, 1e-14);
        assert!(pair[2].uncertainty.interval < 1e-9);
        seen += 1;
    }
    assert!(seen > 5000 && history.impacts.last().unwrap().interval < 1e-250);
}

#[test]
fn outcomes() {
    assert_eq!(solve(&case(1.0, 2.0, 0.92, 0.2)).ending, Ending::NeverRocks);
    assert!(solve(&case(0.9, 2.0, 0.92, 0.2)).impacts.is_empty());
    assert_eq!(solve(&case(1.001, 60.0, 0.1, 1.4)).ending, Ending::AtRest);
    assert_eq!(solve(&case(1.05, 2.0, 0.92, 0.2)).ending, Ending::Incomplete);
    assert_eq!(solve(&case(5.0, 0.3, 0.92, 0.3)).ending, Ending::Overturned);
    let until =
        case(1.05, 2.0, 0.92, 0.2).with_horizon(Horizon::Until(20.0)).unwrap().with_max_impacts(100_000).unwrap();
    let history = solve(&until);
    assert!(history.impacts.last().unwrap().time > core::f64::consts::FRAC_PI_2, "{:?}", history.ending);
    let few = case(1.03, 2.0, 0.92, 0.2).with_max_impacts(3).unwrap();
    assert_eq!(solve(&few).ending, Ending::LimitReached(contract::Limit::Impacts));
}

#[test]
fn refusals() {
    let bare = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
    assert_eq!(Taylor.history(&bare), Err(Decline::NeedsSlenderness));
    for refused in [case(1.03, 1e4, 0.9, 0.2), case(1.03, 1e-4, 0.9, 0.2), case(1.03, 2.0, 1e-7, 0.2)] {
        assert!(matches!(Taylor.history(&refused), Err(Decline::OutOfRange { .. })));
    }
    let tiny = Case::from_epsilon(1e-70, 2.0, 0.9).unwrap();
    let tiny = tiny.with_slenderness(Slenderness::new(0.2, Normalisation::Threshold).unwrap());
    assert!(matches!(Taylor.history(&tiny), Err(Decline::OutOfRange { field: "epsilon", .. })));
}

#[test]
fn the_slender_normalisation_lowers_the_amplitude() {
    let slender = |alpha| Slenderness::new(alpha, Normalisation::Slender).unwrap();
    for alpha in [0.1_f64, 0.5, 1.2, 1.5] {
        close(1.0 + excess(0.7, slender(alpha)).0, 1.7 * alpha / alpha.tan(), 1e-14);
    }
    close(excess(1e-9, slender(1e-5)).0, 1e-9 - 1e-10 / 3.0, 1e-9);
    let history = solve(&Case::from_amplitude(1.01, 2.0, 0.92).unwrap().with_slenderness(slender(0.2)));
    assert_eq!(history.ending, Ending::NeverRocks);
    let history = solve(&Case::from_amplitude(1.03, 2.0, 0.92).unwrap().with_slenderness(slender(0.2)));
    let same = solve(&case(1.03 * 0.2 / 0.2_f64.tan(), 2.0, 0.92, 0.2));
    close(history.impacts[30].time, same.impacts[30].time, 1e-11);
}

#[test]
fn near_the_threshold_and_far_in_time() {
    for epsilon in [1e-50, 1e-20, 1e-8] {
        let slenderness = Slenderness::new(0.2, Normalisation::Threshold).unwrap();
        let history = solve(&Case::from_epsilon(epsilon, 2.0, 0.92).unwrap().with_slenderness(slenderness));
        // The first flight lands near s with q s/6 = ω s²/24 - ...: ωτ_1 = 4q.
        close(history.impacts[0].time * 2.0, 4.0 * (2.0 * epsilon).sqrt(), 2.0 * epsilon.sqrt() + 1e-15);
        assert_eq!(history.impacts.len(), 60);
    }
}

/// The forcing turns while the block is all but at rest, and pushes it into a long flight. Agrees with 40 digits.
#[test]
fn a_flight_that_is_pushed_off() {
    let pushed = case(3.618_716_293_277_131_5, 30.928_204_456_179_774, 0.003, 0.516_343_875_433_054_5);
    let history = solve(&pushed.with_horizon(Horizon::Until(0.75)).unwrap());
    close(history.impacts[2].interval, 0.195_775_524_678_457_13, 1e-14);
    close(history.impacts[3].interval, 0.000_507_964_488_441_805_4, 1e-13);
}
