//! The series against its known values, against Eq. 4 itself, and at its ends.

use crate::exact;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

use asymptotic::{Asymptotic, coefficients};
use contract::{Case, Decline, Ending, Horizon, Limit, Loss, Oracle};

/// Computed with mpmath in 40 digits, from Eqs 62, 58 and 64.
#[test]
fn the_coefficients_are_right_to_1e_14() {
    for (eta, x, u) in [
        (0.1, 5.675837125537666198, 0.76189117801965144489),
        (0.5, 6.2267358562642380915, 5.1285208624978896035),
        (0.8, 7.9913026711383324675, 19.462845284730231268),
        (0.92, 10.827447906756615075, 64.107088919593142471),
        (0.97, 15.504327395720413509, 225.48965720053078969),
        (0.99, 23.787780562681327656, 921.60208880472366555),
    ] {
        let sums = coefficients(eta).unwrap();
        assert!((sums.x / x - 1.0).abs() < 1e-14 && (sums.u / u - 1.0).abs() < 1e-14, "eta {eta}: {sums:?}");
    }
    assert_eq!(coefficients(1.0 - 1e-7), None);
}

#[test]
fn the_papers_example_comes_to_rest_at_0_70298_of_half_a_period() {
    let history = Asymptotic::new().history(&Case::from_amplitude(1.03, 2.0, 0.92).unwrap()).unwrap();
    let tau_ch = history.chattering_time.unwrap();
    assert!((tau_ch.value / FRAC_PI_2 - 0.70298).abs() < 5e-6, "{tau_ch:?}");
    assert!((tau_ch.value - 1.125947676933812).abs() < tau_ch.uncertainty);
    assert_eq!((history.impacts.len(), history.ending), (60, Ending::AtRest));
    let [first, second, ..] = history.impacts[..] else { panic!("no impacts") };
    // Eqs 31, 35, 64.
    let epsilon = 1.03_f64 - 1.0;
    assert!((first.time - 2.0 * (2.0 * epsilon).sqrt()).abs() < 1e-15);
    assert!((first.velocity - 0.92 * 8.0 * SQRT_2 / 3.0 * epsilon.powf(1.5)).abs() < 1e-16);
    assert_eq!(second.interval, first.velocity);
    for (impact, sign) in history.impacts.iter().zip([1.0, -1.0].into_iter().cycle()) {
        assert_eq!(impact.velocity.signum(), sign);
    }
}

/// To this order a velocity is a number of `η` times `ε^(3/2)/ω` (Eqs 35 and 56), an interval one times `ε^(1/2)/ω` or `ε^(3/2)/ω` (Eqs 31 and 43): four times the `ε`
/// makes each exactly 8 or 2 times as large, at every impact and for every restitution.
#[test]
fn impacts_scale_with_the_distance_to_the_threshold() {
    for eta in [0.01, 0.1, 0.25, 0.5, 0.9, 0.99] {
        let of = |epsilon: f64, omega: f64| {
            let case = Case::from_epsilon(epsilon, omega, eta).and_then(|case| case.with_max_impacts(12)).unwrap();
            Asymptotic::new().history(&case).unwrap().impacts
        };
        let base = of(1e-4, 2.0);
        for (n, (small, large)) in base.iter().zip(of(4e-4, 2.0)).enumerate() {
            let power = if n % 2 == 0 { 2.0 } else { 8.0 };
            assert!((large.interval / small.interval / power - 1.0).abs() < 1e-14, "eta {eta}, impact {}", n + 1);
            assert!((large.velocity / small.velocity / 8.0 - 1.0).abs() < 1e-14, "eta {eta}, impact {}", n + 1);
        }
        for (slow, fast) in base.iter().zip(of(1e-4, 6.0)) {
            assert!((slow.velocity / fast.velocity / 3.0 - 1.0).abs() < 1e-14, "eta {eta}");
            assert!((slow.interval / fast.interval / 3.0 - 1.0).abs() < 1e-14, "eta {eta}");
        }
    }
}

/// The formulas against Eq. 4 and not the page: relative errors of every quantity at the first impacts vanish with `ε`, in proportion.
#[test]
fn impacts_tend_to_those_of_eq_4() {
    for (omega, eta) in [(0.5, 0.6), (2.0, 0.92), (7.0, 0.8)] {
        let errors = |epsilon: f64| -> Vec<f64> {
            let history = Asymptotic::new().history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).unwrap();
            let (truth, _) = exact::impacts(epsilon, omega, eta, 20);
            let pairs = history.impacts.iter().zip(&truth);
            pairs
                .flat_map(|(a, b)| {
                    [a.time / b.time - 1.0, a.interval / b.interval - 1.0, a.velocity / b.velocity - 1.0]
                })
                .collect()
        };
        for (large, small) in errors(1e-5).iter().zip(&errors(1e-7)) {
            assert!(
                (small * 100.0 - large).abs() < 1e-2 * large.abs() + 1e-6,
                "omega {omega}: {large:e}, then {small:e}"
            );
        }
    }
}

#[test]
fn the_chattering_time_is_wrong_by_2_2_epsilon() {
    let error = |epsilon: f64| {
        let estimate = Asymptotic::new()
            .history(&Case::from_epsilon(epsilon, 2.0, 0.92).unwrap())
            .unwrap()
            .chattering_time
            .unwrap();
        estimate.value / exact::chattering_time(epsilon, 2.0, 0.92).unwrap() - 1.0
    };
    for epsilon in [1e-4, 1e-5, 1e-6] {
        let slope = (error(epsilon) / error(epsilon / 10.0)).log10();
        assert!((0.95..1.05).contains(&slope), "slope {slope} at {epsilon}");
        assert!((error(epsilon) / epsilon - 2.22).abs() < 0.02, "{}", error(epsilon) / epsilon);
    }
}

#[test]
fn it_ends_and_declines_as_the_contract_says() {
    let case = Case::from_amplitude(1.02, 2.0, 0.92).unwrap();
    let until = |time| Asymptotic::new().history(&case.with_horizon(Horizon::Until(time)).unwrap()).unwrap();
    assert_eq!(until(10.0).ending, Ending::AtRest);
    let early = until(0.6);
    assert_eq!(early.ending, Ending::LimitReached(Limit::Time));
    assert!(early.impacts.last().unwrap().time <= 0.6 && early.impacts.len() < 60);
    assert_eq!(Asymptotic::new().history(&case.with_max_impacts(7).unwrap()).unwrap().impacts.len(), 7);

    for a in [0.5, 1.0] {
        let history = Asymptotic::new().history(&Case::from_amplitude(a, 2.0, 0.92).unwrap()).unwrap();
        assert_eq!((history.ending, history.impacts.len()), (Ending::NeverRocks, 0));
    }
    let reason = |a, omega, eta| {
        let case = Case::from_amplitude(a, omega, eta).unwrap();
        Asymptotic::new().history(&case).unwrap_err().reason().to_owned()
    };
    assert_eq!(reason(1.05, 2.0, 0.92), "not convergent");
    assert_eq!(reason(1.0001, 0.01, 0.92), "not convergent");
    assert_eq!(reason(1e9, 2.0, 0.92), "not convergent");
    assert_eq!(reason(1.0001, 2.0, 0.999), "out of range");
}

#[test]
fn it_declines_or_answers_but_does_not_panic_at_the_corners() {
    for epsilon in [f64::MIN_POSITIVE, 1e-200, 1e-16, 1.0] {
        for omega in [f64::MIN_POSITIVE, 1e-100, 1.0, 1e300] {
            for eta in [f64::MIN_POSITIVE, 0.5, 0.99, 1.0 - f64::EPSILON] {
                if let Ok(history) = Asymptotic::new().history(&Case::from_epsilon(epsilon, omega, eta).unwrap()) {
                    assert!(history.impacts.iter().all(|i| i.time > 0.0 && i.interval > 0.0 && i.velocity != 0.0));
                    assert!(
                        history.impacts.iter().all(|i| i.uncertainty.interval > 0.0 && i.uncertainty.interval < 10.0)
                    );
                }
            }
        }
    }
}

#[test]
fn the_last_impact_of_a_history_is_at_its_horizon_or_before() {
    let case = Case::from_amplitude(1.02, 2.0, 0.92).unwrap();
    let whole = Asymptotic::new().history(&case).unwrap();
    for (n, impact) in whole.impacts.iter().enumerate().take(30).skip(1) {
        for (until, listed) in [(impact.time.next_down(), n), (impact.time, n + 1)] {
            let history = Asymptotic::new().history(&case.with_horizon(Horizon::Until(until)).unwrap()).unwrap();
            assert_eq!((history.impacts.len(), history.ending), (listed, Ending::LimitReached(Limit::Time)));
        }
    }
    let tau_ch = whole.chattering_time.unwrap().value;
    for (until, ending) in [(tau_ch, Ending::AtRest), (tau_ch.next_down(), Ending::LimitReached(Limit::Time))] {
        let early = case.with_horizon(Horizon::Until(until)).unwrap().with_max_impacts(3).unwrap();
        assert_eq!(Asymptotic::new().history(&early).unwrap().ending, ending);
    }
}

/// Impacts whose numbers leave the range of normal doubles are not listed.
#[test]
fn what_has_lost_its_digits_to_underflow_is_lost() {
    for (epsilon, eta) in [(1e-3, 0.01), (1e-50, 0.5), (1e-20, 0.05)] {
        let case = Case::from_epsilon(epsilon, 2.0, eta).unwrap().with_max_impacts(3000).unwrap();
        let history = Asymptotic::new().history(&case).unwrap();
        assert_eq!(history.ending, Ending::Lost(Loss::NotFinite));
        assert!(history.impacts.iter().all(|impact| impact.interval.is_normal() && impact.velocity.is_normal()));
        assert!(history.impacts.last().unwrap().velocity.abs() < 1e-300);
    }
}

#[test]
fn the_papers_order_is_offered_as_far_as_its_claims_were_calibrated() {
    let of = |epsilon, omega, eta| {
        let history = Asymptotic::new().history(&Case::from_epsilon(epsilon, omega, eta).unwrap());
        history.map(|_| ()).map_err(|decline| match decline {
            Decline::OutOfRange { field, .. } => field,
            _ => "none",
        })
    };
    for (epsilon, omega, eta) in
        [(1e-60, 2.0, 0.9), (1e-8, 1e-3, 0.9), (1e-8, 1e6, 0.9), (1e-8, 2.0, 1e-3), (1e-8, 2.0, 0.995)]
    {
        assert_eq!(of(epsilon, omega, eta), Ok(()), "{epsilon} {omega} {eta}");
    }
    for (epsilon, omega, eta, field) in [
        (0.99e-60, 2.0, 0.9, "epsilon"),
        (1e-8, 0.99e-3, 0.9, "omega"),
        (1e-8, 1.01e6, 0.9, "omega"),
        (1e-8, 2.0, 0.99e-3, "eta"),
        (1e-8, 2.0, 0.9951, "eta"),
    ] {
        assert_eq!(of(epsilon, omega, eta), Err(field), "{epsilon} {omega} {eta}");
    }
    // The reason tells what Eq. 65 gives, and what it claims.
    let (epsilon, omega, eta) = (0.05, 2.0, 0.92);
    let why = Asymptotic::new().history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).unwrap_err().to_string();
    let share = coefficients(eta).unwrap().chattering_time(epsilon, omega) / FRAC_PI_2;
    assert!(why.contains(&format!("tau_ch = {share:.4} T/2")), "{why}");
}
