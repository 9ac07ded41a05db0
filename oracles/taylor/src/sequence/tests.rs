//! What is claimed, written out, and the sum of the intervals in whole numbers.

use super::*;
use crate::Taylor;
use contract::{Case, Normalisation, Oracle, Slenderness};

fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found:e} is not {expected:e}");
}

/// Flight after flight: the impacts, and how many steps beyond 40 all flights took so far.
fn chained(block: &Block, most: usize, end: f64) -> Vec<(f64, f64, f64, u32)> {
    let (mut time, mut side, mut speed, mut excess) = (0.0, -1.0, 0.0, 0);
    let mut found = Vec::new();
    while found.len() < most {
        let Landing::Impact { interval, speed: arrival, steps } = fly(block, side, time, speed, end - time) else {
            break;
        };
        excess += steps.saturating_sub(40);
        (time, side, speed) = (time + interval, -side, block.eta * arrival);
        found.push((time, interval, side * speed, excess));
    }
    found
}

/// An ordinary case, and one whose forcing is so fast that its flights take many steps: both are widened by what another run makes of them.
#[test]
fn claims_are_differences_of_runs_and_roundings() {
    let shaken = Block::new(60.0, 200.0, 0.8, 0.2);
    let mut widened = 0;
    for (block, end, least) in [(Block::new(0.03, 2.0, 0.92, 0.2), 1.5, 20), (shaken, 1.3, 6)] {
        let others =
            [Block { omega: block.omega * (1.0 + 1e-9), ..block }, Block { eta: block.eta * (1.0 - 1e-9), ..block }];
        let History { impacts, .. } = history(&block, &others, Horizon::Until(end), 20);
        let own = chained(&block, 20, end);
        let others = others.map(|other| chained(&other, 20, end));
        assert!(impacts.len() == own.len() && own.len() >= least);
        let mut worst = [[0.0f64; 3]; 2];
        for (n, impact) in impacts.iter().enumerate() {
            let (time, interval, velocity, excess) = own[n];
            near(impact.time, time, 1e-14);
            assert!((impact.interval - interval).abs() <= 1e-9 * interval);
            for (worst, other) in worst.iter_mut().zip(&others) {
                let apart = |one: f64, two: f64| (two / one - 1.0).abs();
                *worst = [
                    worst[0].max(apart(time, other[n].0)),
                    worst[1].max(apart(interval, other[n].1)),
                    worst[2].max(apart(velocity, other[n].2)),
                ];
            }
            let margin = 1.0 + 0.05 * f64::from(excess);
            let floor = 4e-15 + 1e-16 * (n as f64 + 1.0);
            let sum = |place: usize| floor + worst[0][place] + worst[1][place];
            // The runs of the test round a little differently.
            near(impact.uncertainty.time, 0.3 * time * margin * sum(0), 1e-4);
            near(impact.uncertainty.interval, 0.6 * margin * sum(1), 1e-4);
            near(impact.uncertainty.velocity, 0.6 * margin * sum(2), 1e-4);
            widened += excess;
        }
    }
    assert!(widened > 0, "no flight took more than 40 steps");
}

/// Without another run only the roundings are claimed; where another run has no such impact, nothing is.
#[test]
fn what_another_run_does_not_reach_is_not_claimed() {
    let block = Block::new(0.03, 2.0, 0.92, 0.2);
    let alone = history(&block, &[], Horizon::HalfPeriod, 5).impacts;
    for (n, impact) in (1..).zip(&alone) {
        let floor = 4e-15 + 1e-16 * f64::from(n);
        near(impact.uncertainty.interval, 0.6 * floor, 1e-12);
        near(impact.uncertainty.velocity, 0.6 * floor, 1e-12);
        near(impact.uncertainty.time, 0.3 * floor * impact.time, 1e-12);
    }
    let overturning = Block::new(9.0, 0.3, 0.92, 0.2);
    let with = history(&block, &[overturning], Horizon::HalfPeriod, 5).impacts;
    assert!(
        with.iter()
            .all(|impact| impact.uncertainty.interval == f64::INFINITY && impact.uncertainty.time == f64::INFINITY)
    );
}

/// The oracle runs the case with `ε` off by 1e-14 and eight roundings of its normalisation, and with `ω` and `η` off by 1e-15.
#[test]
fn the_runs_beside_a_case() {
    for (alpha, normalisation) in [(0.2, Normalisation::Threshold), (0.3, Normalisation::Slender)] {
        let slenderness = Slenderness::new(alpha, normalisation).unwrap();
        let case = Case::from_epsilon(0.05, 2.0, 0.9).unwrap().with_slenderness(slenderness);
        let (epsilon, rounding) = crate::equation::excess(0.05, slenderness);
        let beside = [
            Block::new(epsilon * (1.0 + 1e-14 + 8.0 * rounding), 2.0, 0.9, alpha),
            Block::new(epsilon, 2.0 * (1.0 + 1e-15), 0.9 * (1.0 - 1e-15), alpha),
        ];
        let expected = history(&Block::new(epsilon, 2.0, 0.9, alpha), &beside, Horizon::HalfPeriod, case.max_impacts());
        assert_eq!(Taylor.history(&case).unwrap(), expected);
        assert!(expected.impacts.len() > 10);
    }
    assert_eq!((Taylor.name(), Taylor.model()), ("taylor", contract::Model::Nonlinear));
}

/// The time is the sum of the intervals to its last bit, after thousands of them.
#[test]
fn no_rounding_builds_up_in_the_time() {
    let (impacts, _) = run(&Block::new(0.005, 2.0, 0.96, 0.2), Horizon::HalfPeriod, 3000);
    let mut sum = 0_i128;
    let unit = 2f64.powi(110);
    for impact in &impacts {
        sum += (impact.interval * unit) as i128;
        assert!((impact.time - sum as f64 / unit).abs() <= 0.51 * f64::EPSILON * impact.time);
    }
    assert!(impacts.len() >= 60);
}

/// In the air at half a period; still rocking when the time is up; at rest when the speeds are as small as they can be held.
#[test]
fn how_a_run_ends() {
    let end = |block: &Block, horizon: Horizon, most: usize| {
        let (impacts, ending) = run(block, horizon, most);
        (impacts.len(), ending)
    };
    let resting = Block::new(0.03, 2.0, 0.5, 0.2);
    let (count, ending) = end(&resting, Horizon::HalfPeriod, 2000);
    assert_eq!(ending, Ending::AtRest);
    // 2^-k = 1e-280 at k = 930
    assert!((900..940).contains(&count), "{count}");
    assert_eq!(end(&resting, Horizon::HalfPeriod, 2), (2, Ending::LimitReached(Limit::Impacts)));
    // What has not overturned yet when the time is up may do so later.
    let overturning = Block::new(9.0, 0.3, 0.9, 0.2);
    assert_eq!(end(&overturning, Horizon::Until(0.1), 9), (0, Ending::LimitReached(Limit::Time)));
    assert_eq!(end(&overturning, Horizon::Until(30.0), 9), (0, Ending::Overturned));
    // Here it does so after an impact, at 2.744.
    let later = Block::new(0.2, 1.0, 0.7, 0.2);
    assert_eq!(end(&later, Horizon::Until(2.9), 9), (1, Ending::LimitReached(Limit::Time)));
    assert_eq!(end(&later, Horizon::Until(30.0), 9), (1, Ending::Overturned));
    let rocking = Block::new(0.08, 2.0, 0.9, 0.2);
    assert_eq!(end(&rocking, Horizon::HalfPeriod, 99).1, Ending::Incomplete);
    assert_eq!(end(&rocking, Horizon::Until(1.0), 99).1, Ending::LimitReached(Limit::Time));
    let (impacts, _) = run(&rocking, Horizon::Until(3.0), 99);
    let first = impacts[0].time;
    // An impact at the horizon is beyond it.
    assert_eq!(end(&rocking, Horizon::Until(first), 99).0, 0);
    assert_eq!(end(&rocking, Horizon::Until(first * 1.000_001), 99).0, 1);
    assert!(impacts.len() > 1 && impacts[0].velocity > 0.0 && impacts[1].velocity < 0.0);
}
