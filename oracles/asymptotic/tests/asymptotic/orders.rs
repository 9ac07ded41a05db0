//! The series to any order: its coefficients, what it claims, and where it declines.

use crate::{effort::pick, exact};
use asymptotic::{Asymptotic, Expansion, Order, coefficients};
use contract::{Case, Decline, Ending, Oracle};

fn of_order(terms: usize) -> Asymptotic {
    Asymptotic::new().with_order(Order::Terms(terms)).unwrap()
}

/// A prototype in another language, and the enclosure.
#[test]
fn the_known_coefficients_and_the_known_value() {
    let expansion = Expansion::new(2.0, 0.92, 40, 0).unwrap();
    let known = [10.82745, 40.03021, 503.4466, 7945.463, 142977.1];
    for (coefficient, known) in expansion.coefficients().iter().zip(known) {
        assert!((coefficient.value / known - 1.0).abs() < 5e-7, "{coefficient:?} is not {known}");
    }
    let time = expansion.chattering_time(12, 1.001 - 1.0).unwrap().value;
    assert!((time / 0.17183800443567367494 - 1.0).abs() < 4e-16, "{time:?}");
}

/// The first coefficient is that of Eq. 65, computed by another recursion; and all are positive, as far as they were ever looked at.
#[test]
fn coefficients_begin_with_the_papers_and_are_positive_and_precise() {
    for (omega, eta) in [(0.5, 0.5), (8.0, 0.5), (1.0, 0.7), (2.0, 0.92), (0.5, 0.97), (2.0, 0.98)] {
        let expansion = Expansion::new(omega, eta, 40, 0).unwrap();
        let all = expansion.coefficients();
        assert!((all[0].value / coefficients(eta).unwrap().x - 1.0).abs() < 4e-16, "{omega} {eta}");
        for coefficient in all {
            assert!(coefficient.value > 0.0, "{omega} {eta} {coefficient:?}");
            assert!(coefficient.error < 1.4e-16 * coefficient.value, "{omega} {eta} {coefficient:?}");
            // Rounding to a double may take half of the last place.
            assert!(coefficient.error >= 0.5 * f64::EPSILON * coefficient.value, "{omega} {eta} {coefficient:?}");
        }
    }
}

/// Against exact stepping: the error falls as the power of `ε` that the order says, for the chattering time and for impacts of both kinds.
#[test]
fn errors_fall_with_the_order() {
    let (omega, eta) = (1.5, 0.8);
    for order in 1..=4 {
        let errors = |epsilon: f64| -> Vec<f64> {
            let history = of_order(order).history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).unwrap();
            let (truth, _) = exact::impacts(epsilon, omega, eta, 12);
            let whole = history.chattering_time.unwrap().value / exact::chattering_time(epsilon, omega, eta).unwrap();
            let each = history.impacts.iter().zip(&truth).map(|(a, b)| a.time / b.time);
            // To the lowest order odd flights take no time, and one term of theirs is kept all the same.
            each.skip(if order == 1 { 12 } else { 0 }).chain([whole]).map(|ratio| (ratio - 1.0).abs()).collect()
        };
        let (large, small) = (4e-3_f64, 2e-3_f64);
        for (n, (large, small)) in errors(large).into_iter().zip(errors(small)).enumerate() {
            if small > 1e-12 {
                let slope = (large / small).log2();
                assert!((slope - order as f64).abs() < 0.35, "order {order}, impact {}: {slope}", n + 1);
            }
        }
    }
}

/// Error over claim of the chattering time, at orders from 1 to 48, from the threshold to the critical amplitude; never above 1, and not far below.
#[test]
fn the_claims_cover_the_errors_and_are_near_them() {
    let mut ratios = Vec::new();
    for (omega, eta) in [(0.5, 0.5), (8.0, 0.5), (1.0, 0.7), (3.0, 0.85), (2.0, 0.92), (0.7, 0.97)] {
        let critical = exact::critical(omega, eta);
        for order in [1, 2, 3, 4, 6, 8, 16, 32, 48] {
            let expansion = Expansion::new(omega, eta, order + 4, 0).unwrap();
            for share in [0.01, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99] {
                let epsilon = share * critical;
                let truth = exact::chattering_time(epsilon, omega, eta).unwrap();
                let Some(estimate) = expansion.chattering_time(order, epsilon) else { continue };
                let (error, claim) = ((estimate.value - truth).abs(), estimate.uncertainty);
                if claim > 1e-11 * truth {
                    ratios.push(error / claim);
                    assert!(error < claim, "order {order} at {share} of {omega} {eta}: {error:e} of {claim:e}");
                }
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let (largest, median) = (ratios[ratios.len() - 1], ratios[ratios.len() / 2]);
    println!("error over claim: largest {largest}, median {median}, of {}", ratios.len());
    assert!(ratios.len() > 200 && median > 0.5, "of {}: median {median}", ratios.len());
}

#[test]
fn it_declines_where_it_claims_more_than_was_asked_and_past_the_critical_amplitude() {
    let case = |a: f64| Case::from_amplitude(a, 2.0, 0.92).unwrap();
    let asked = |tolerance: f64, a: f64| of_order(8).with_tolerance(tolerance).unwrap().history(&case(a));
    assert!(asked(1e-9, 1.003).is_ok());
    let why = asked(1e-9, 1.02).unwrap_err().to_string();
    assert!(why.contains("at most 1.0e-9 is accepted"), "{why}");
    for order in [1, 2, 4, 8, 16, 32, 64] {
        for a in [1.0381, 1.04, 1.1, 2.0, 1e6] {
            assert!(of_order(order).history(&case(a)).is_err(), "order {order} at {a}");
        }
    }
    for tolerance in [0.0, -1.0, 0.6, f64::NAN] {
        assert!(Asymptotic::new().with_tolerance(tolerance).is_err());
    }
    for terms in [0, 93, usize::MAX] {
        assert!(Asymptotic::new().with_order(Order::Terms(terms)).is_err());
    }
    for (omega, eta) in [(0.01, 0.9), (1e6, 0.9), (2.0, 0.001), (2.0, 0.995)] {
        let case = Case::from_epsilon(1e-6, omega, eta).unwrap();
        assert_eq!(of_order(4).history(&case).unwrap_err().reason(), "out of range", "{omega} {eta}");
    }
    let tiny = Case::from_epsilon(1e-205, 2.0, 0.92).unwrap();
    let many = case(1.01).with_max_impacts(6_000).unwrap();
    for case in [tiny, many] {
        assert_eq!(of_order(8).history(&case).unwrap_err().reason(), "out of range", "{case:?}");
    }
    let history = of_order(8).history(&case(1.0)).unwrap();
    assert_eq!(history.ending, Ending::NeverRocks);
}

/// As many digits as a prototype in another language found with 12 terms.
#[test]
fn twelve_terms_have_the_digits_that_they_should() {
    let expansion = Expansion::new(2.0, 0.92, 16, 0).unwrap();
    for (epsilon, digits) in [(1e-3, 15.0), (1e-2, 9.0), (3e-2, 3.0)] {
        let truth = exact::chattering_time(epsilon, 2.0, 0.92).unwrap();
        let error = (expansion.partial_sum(12, epsilon) / truth - 1.0).abs();
        assert!((-error.log10() - digits).abs() < 1.0, "epsilon = {epsilon}: {error:e}");
    }
}

/// The rotation itself enters Eq. 4 through `ε/ω²` alone, so `c_k` is a polynomial of degree `k` in `1/ω²`: its divided differences of higher
/// order vanish. Nothing in the recursion knows of that.
#[test]
fn coefficients_are_polynomials_of_one_over_omega_squared() {
    for eta in [0.5, 0.8, 0.92] {
        let places: Vec<f64> = (0..8).map(|k| 0.1 + 0.4 * f64::from(k)).collect();
        let values: Vec<Vec<f64>> = places
            .iter()
            .map(|q| {
                let expansion = Expansion::new(q.powf(-0.5), eta, 6, 0).unwrap();
                expansion.coefficients().iter().map(|coefficient| coefficient.value).collect()
            })
            .collect();
        for k in 0..6 {
            let mut row: Vec<f64> = values.iter().map(|of| of[k]).collect();
            let mut sizes = vec![row.iter().fold(0.0_f64, |most, value| most.max(value.abs()))];
            for order in 1..8 {
                row = (0..row.len() - 1).map(|i| (row[i + 1] - row[i]) / (places[i + order] - places[i])).collect();
                sizes.push(row.iter().fold(0.0_f64, |most, value| most.max(value.abs())));
            }
            assert!(sizes[k] > 1e-6 * sizes[0], "eta {eta}: c_{k} has no term of degree {k}: {sizes:?}");
            assert!(sizes[k + 1] < 1e-10 * sizes[0], "eta {eta}: c_{k} is of higher degree than {k}: {sizes:?}");
        }
    }
}

/// Error over claim of every quantity of every impact, against exact stepping, in random cases; and a case that is not complete is never called so.
#[test]
fn the_claims_cover_the_errors_of_impacts() {
    let mut uniform = exact::uniform(0x51AB_2D0C_90F1_37E5);
    let mut ratios: Vec<(f64, String)> = Vec::new();
    let mut answered = 0;
    let cases = pick("random cases of the series to any order", 30, 150);
    for _ in 0..cases {
        let (omega, eta) = (0.1 * 200_f64.powf(uniform()), 0.02 + 0.96 * uniform());
        let critical = exact::critical(omega, eta);
        for order in [1, 2, 4, 16, 48] {
            let oracle = of_order(order);
            let beyond = critical * (1.0 + 2e-4 + 0.1 * uniform().powi(4));
            let beyond = Case::from_epsilon(beyond, omega, eta).unwrap();
            assert!(oracle.history(&beyond).is_err(), "order {order} calls it complete: {beyond:?}");
            let epsilon = critical * (1.0 - uniform().powi(2)) * 0.999;
            let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
            let Ok(history) = oracle.history(&case) else { continue };
            answered += 1;
            let (truth, _) = exact::impacts(epsilon, omega, eta, 60);
            for (n, (impact, truth)) in history.impacts.iter().zip(&truth).enumerate() {
                let claim = impact.uncertainty;
                // What exact stepping in doubles is itself good to.
                let floor = 1e-12;
                let mut add = |what: &str, error: f64, claim: f64| {
                    ratios.push((
                        error / claim.max(floor),
                        format!("{what} of impact {}, order {order}, {case:?}", n + 1),
                    ));
                };
                add("time", (impact.time - truth.time).abs() / truth.time, claim.time / truth.time);
                add("interval", (impact.interval / truth.interval - 1.0).abs(), claim.interval);
                add("velocity", (impact.velocity / truth.velocity - 1.0).abs(), claim.velocity);
            }
        }
    }
    ratios.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (ratio, what) in ratios.iter().take(12) {
        println!("{ratio} {what}");
    }
    println!("{answered} answered");
    assert!(answered > 400 * cases / 150 && ratios[0].0 < 1.0, "{answered} answered, {:?}", ratios[0]);
}

#[test]
fn an_expansion_is_made_within_its_ranges_and_knows_them() {
    for (omega, eta, terms) in [(0.05, 0.01, 1), (1000.0, 0.3, 2), (2.0, 0.99, 1), (2.0, 0.02, 96)] {
        let expansion = Expansion::new(omega, eta, terms, 0).unwrap();
        assert_eq!((expansion.omega(), expansion.eta(), expansion.coefficients().len()), (omega, eta, terms));
    }
    for (omega, eta, terms, field) in [
        (0.0499, 0.5, 4, "omega"),
        (1001.0, 0.5, 4, "omega"),
        (2.0, 0.0099, 4, "eta"),
        (2.0, 0.991, 4, "eta"),
        (2.0, 0.5, 0, "order"),
        (2.0, 0.5, 97, "order"),
    ] {
        let declined = Expansion::new(omega, eta, terms, 0).map(|_| ());
        assert!(matches!(declined, Err(Decline::OutOfRange { field: of, .. }) if of == field), "{declined:?}");
    }
}

#[test]
fn a_shorter_expansion_is_the_beginning_of_the_longer() {
    let whole = Expansion::new(1.7, 0.6, 9, 4).unwrap();
    assert_eq!(whole.impacts(5, 1e-3).count(), 4);
    for terms in [4, 9, 20] {
        let short = whole.shortened(terms);
        assert_eq!(short.coefficients(), &whole.coefficients()[..terms.min(9)]);
        assert_eq!((short.omega(), short.eta(), short.impacts(3, 1e-3).count()), (1.7, 0.6, 0));
        assert_eq!(short.partial_sum(3, 0.01), whole.partial_sum(3, 0.01));
    }
    // c₀ ε^(1/2)/ω + c₁ ε^(3/2)/ω + ...
    for order in 0..=9 {
        let terms = (0..order).map(|k| whole.coefficients()[k].value * 0.01_f64.powf(0.5 + k as f64) / 1.7);
        let sum: f64 = terms.sum();
        assert!((whole.partial_sum(order, 0.01) - sum).abs() <= 4e-16 * sum, "{order}");
        if let Some(estimate) = whole.chattering_time(order, 0.01) {
            assert!((estimate.value - sum).abs() <= 4e-16 * sum);
        }
    }
}

/// What it found is told in the reason, and from which `ε` on it is asked at all.
#[test]
fn a_decline_says_what_was_found() {
    let case = |epsilon: f64| Case::from_epsilon(epsilon, 2.0, 0.92).unwrap();
    let expansion = Expansion::new(2.0, 0.92, 12, 0).unwrap();
    for epsilon in [0.02, 0.03] {
        let why = of_order(8).with_tolerance(1e-9).unwrap().history(&case(epsilon)).unwrap_err().to_string();
        let found = expansion.chattering_time(8, epsilon).unwrap();
        let share = found.value / std::f64::consts::FRAC_PI_2;
        let expected =
            format!("tau_ch = {share:.4} T/2 with a relative error of up to {:.2e}", found.uncertainty / found.value);
        assert!(why.contains(&expected), "{why} is not {expected}");
        // It answers to the tolerance that it has.
        let exactly = found.uncertainty / found.value;
        assert!(of_order(8).with_tolerance(1.001 * exactly).unwrap().history(&case(epsilon)).is_ok());
        assert!(of_order(8).with_tolerance(0.999 * exactly).unwrap().history(&case(epsilon)).is_err());
    }
    assert!(of_order(8).history(&case(1e-60)).is_ok() && of_order(8).history(&case(0.99e-60)).is_err());
    assert!(of_order(92).with_tolerance(0.5).is_ok() && of_order(1).name() == "asymptotic/order-1");
}
