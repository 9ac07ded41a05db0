//! The claims of the series against exact stepping of Eq. 4, over a seeded random sample.

use crate::{effort::pick, exact};
use asymptotic::{Asymptotic, Order};
use contract::{Case, Oracle};

/// Largest and median ratio of error to claim, for one quantity.
#[derive(Default)]
struct Ratios(Vec<f64>);

impl Ratios {
    fn summary(&mut self) -> (f64, f64) {
        self.0.sort_by(f64::total_cmp);
        (*self.0.last().unwrap(), self.0[self.0.len() / 2])
    }
}

#[derive(Default)]
struct Measured {
    time: Ratios,
    interval: Ratios,
    velocity: Ratios,
    chattering_time: Ratios,
    declined_by_tenth: [[usize; 2]; 10],
}

/// Relative error, the larger of those relative to the value and to the truth.
fn relative(value: f64, truth: f64) -> f64 {
    (value / truth - 1.0).abs().max((truth / value - 1.0).abs())
}

fn measure(seed: u64, cases: usize) -> Measured {
    let mut uniform = exact::uniform(seed);
    let mut measured = Measured::default();
    for k in 0..cases {
        let eta = match k % 8 {
            0 => 0.05 + 0.45 * uniform(),
            1 => 0.97 + 0.025 * uniform(),
            _ => 0.5 + 0.47 * uniform(),
        };
        let omega = match k % 10 {
            2 => 0.02,
            3 => 0.1,
            4 => 20.0,
            _ => 0.5 * 16_f64.powf(uniform()),
        };
        let critical = exact::critical(omega, eta);
        let beyond = Case::from_epsilon(critical * (1.001 + uniform()), omega, eta).unwrap();
        assert!(Asymptotic::new().history(&beyond).is_err(), "complete, it says, but is not: {beyond:?}");
        let most = 0.98 * critical;
        let epsilon = if k % 3 == 0 { most * uniform() } else { 1e-8 * (most / 1e-8).powf(uniform()) };
        let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
        let tenth = &mut measured.declined_by_tenth[((10.0 * epsilon / most) as usize).min(9)];
        tenth[1] += 1;
        let Ok(history) = Asymptotic::new().history(&case) else {
            tenth[0] += 1;
            continue;
        };
        let truth = exact::chattering_time(epsilon, omega, eta).unwrap();
        let estimate = history.chattering_time.unwrap();
        measured.chattering_time.0.push((estimate.value - truth).abs() / estimate.uncertainty);
        let (impacts, _) = exact::impacts(epsilon, omega, eta, 60);
        assert_eq!((history.impacts.len(), impacts.len()), (60, 60));
        for (impact, truth) in history.impacts.iter().zip(&impacts) {
            let claim = impact.uncertainty;
            measured.time.0.push((impact.time - truth.time).abs() / claim.time);
            measured.interval.0.push(relative(impact.interval, truth.interval) / claim.interval);
            measured.velocity.0.push(relative(impact.velocity, truth.velocity) / claim.velocity);
        }
    }
    measured
}

fn check(mut measured: Measured) {
    println!("declined, of all, by tenths of the critical epsilon: {:?}", measured.declined_by_tenth);
    for (name, ratios) in [
        ("time", &mut measured.time),
        ("interval", &mut measured.interval),
        ("velocity", &mut measured.velocity),
        ("chattering time", &mut measured.chattering_time),
    ] {
        let (worst, median) = ratios.summary();
        println!("{name}: error/claim at worst {worst:.3}, in the median {median:.3}, of {}", ratios.0.len());
        assert!(worst < 1.0, "{name}: the claim is smaller than the error, {worst}");
        assert!(median > 0.01, "{name}: the claim is more than 100 times the error in the median, {median}");
    }
}

/// At `T/2` the ground begins to push the other way: a chattering time that may lie beyond is none, whatever the order.
#[test]
fn no_chattering_time_may_lie_beyond_half_a_period() {
    let orders = [Order::Paper, Order::Terms(1), Order::Terms(2), Order::Terms(4), Order::Terms(16)];
    for (omega, eta) in [(0.5, 0.5), (2.0, 0.2), (2.0, 0.92)] {
        let critical = exact::critical(omega, eta);
        for order in orders {
            let oracle = Asymptotic::new().with_order(order).unwrap();
            for k in 0..=10 {
                let case = Case::from_epsilon(critical * (0.9 + 0.01 * f64::from(k)), omega, eta).unwrap();
                let case = case.with_max_impacts(1).unwrap();
                let Ok(history) = oracle.history(&case) else { continue };
                let time = history.chattering_time.unwrap();
                let latest = time.value + time.uncertainty;
                assert!(latest < std::f64::consts::PI / omega, "{order:?}, {case:?}: {time:?}");
            }
        }
    }
}

#[test]
fn the_claims_cover_the_errors() {
    check(measure(0x9E37_79B9_7F4A_7C15, pick("cases of the paper's series", 90, 600)));
}

/// The sample that the constants were calibrated on takes minutes: its beginning, when quick.
#[test]
fn the_claims_cover_the_errors_of_the_sample_that_they_were_calibrated_on() {
    check(measure(0xD1B5_4A32_D192_ED03, pick("cases of the calibration", 30, 6_000)));
}
