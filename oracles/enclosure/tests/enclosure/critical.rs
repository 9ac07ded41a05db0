//! The critical amplitude, the endings on both sides of it, and how narrow everything is below it.

use crate::effort::pick;
use contract::{Case, Ending, Model, Normalisation, Slenderness};
use enclosure::{Enclosure, critical_amplitude, critical_amplitude_near};

fn case(epsilon: f64, omega: f64, eta: f64) -> Case {
    Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(20).unwrap()
}

/// Its width, and that of the chattering times at shares of it.
fn check(omega: f64, eta: f64) {
    let critical = critical_amplitude(omega, eta).unwrap();
    assert!(critical.amplitude.width() <= 1e-12);
    // The known approach leaves few amplitudes to try, where halving alone would take more than forty.
    assert!(critical.tried <= 36, "{omega} {eta}: {} amplitudes", critical.tried);
    let ending = |epsilon: f64| {
        Enclosure::new(Model::Linear).enclose(&case(epsilon, omega, eta)).map(|enclosed| enclosed.ending)
    };
    // Another search, with other digits, and never the wrong ending.
    for away in [1e-12, 1e-9, 1e-5] {
        assert_eq!(ending(critical.epsilon_complete - away), Ok(Ending::AtRest), "{omega} {eta} {away:e}");
        assert_eq!(ending(critical.epsilon_incomplete + away), Ok(Ending::Incomplete), "{omega} {eta} {away:e}");
    }
    for share in [0.2, 0.6, 0.9, 0.99] {
        let below = case(share * critical.epsilon_complete, omega, eta);
        let time = Enclosure::new(Model::Linear).enclose(&below).unwrap().chattering_time.unwrap();
        assert!(time.width() <= 1e-13, "{below:?}: {:e}", time.width());
        for alpha in [0.1, 0.4] {
            let block = below.with_slenderness(Slenderness::new(alpha, Normalisation::Threshold).unwrap());
            let enclosed = Enclosure::new(Model::Nonlinear).enclose(&block).unwrap();
            // The block that is not slender has a critical amplitude of its own.
            assert!(share > 0.9 || enclosed.ending == Ending::AtRest || alpha > 0.3, "{block:?}");
            assert!(enclosed.chattering_time.is_none_or(|time| time.width() <= 1e-11));
        }
    }
}

#[test]
fn known_values() {
    let critical = critical_amplitude(2.0, 0.92).unwrap();
    assert_eq!(critical.amplitude.contains("1.0380155387302"), Some(false));
    assert!(critical.amplitude.lower() < 1.03801553875 && critical.amplitude.upper() > 1.03801553865);
    assert!((critical.exponent - 0.60018).abs() < 1e-5);
    assert!(critical.epsilon_complete < critical.epsilon_incomplete);
}

#[test]
fn moderate_restitution() {
    let all = [0.5, 2.0, 8.0].map(|omega| [0.5, 0.7, 0.85].map(|eta| (omega, eta))).concat();
    for (omega, eta) in pick("critical amplitudes", vec![all[1], all[3], all[8]], all) {
        check(omega, eta);
    }
}

#[test]
fn high_restitution() {
    for (omega, eta) in pick("critical amplitudes", vec![(2.0, 0.92)], vec![(2.0, 0.92), (0.5, 0.97), (8.0, 0.97)]) {
        check(omega, eta);
    }
}

/// Pairs at which the search once asked for a margin between bounds that had crossed.
#[test]
fn the_search_ends_where_the_prediction_is_within_a_hair() {
    for (omega, eta) in [(1.0, 0.65), (0.5, 0.52), (6.0, 0.6), (6.0, 0.779), (1.7, 0.58)] {
        let critical = critical_amplitude(omega, eta).unwrap();
        assert!(critical.amplitude.width() <= 1e-12, "{omega} {eta}");
    }
}

/// A worse search proves the same, later. The last digit of a power may differ between machines, and with it one amplitude.
#[test]
fn the_search_tries_as_few_amplitudes_as_it_did() {
    let recorded = [(0.5, 0.5, 30), (8.0, 0.7, 13), (1.0, 0.65, 17), (5.0, 0.85, 13), (2.0, 0.92, 13), (0.5, 0.97, 14)];
    for &(omega, eta, recorded) in &recorded[..pick("critical amplitudes", 4, 6)] {
        let tried = critical_amplitude(omega, eta).unwrap().tried;
        assert!(tried.abs_diff(recorded) <= 1, "{omega} {eta}: {tried} instead of {recorded}");
    }
}

/// Two proofs are enough for who knows where it is; who is wrong gets the same, later.
#[test]
fn whoever_knows_it_has_it_proven_at_once() {
    for (omega, eta) in [(2.0, 0.6), (0.5, 0.92), (8.0, 0.5)] {
        let found = critical_amplitude(omega, eta).unwrap();
        let middle = 0.5 * (found.epsilon_complete + found.epsilon_incomplete);
        let near = critical_amplitude_near(omega, eta, middle).unwrap();
        assert_eq!(near.tried, 2);
        assert!(near.epsilon_complete < found.epsilon_incomplete && found.epsilon_complete < near.epsilon_incomplete);
        for wrong in [0.5 * middle, middle - 1e-9, middle + 1e-9, 1.5 * middle] {
            let late = critical_amplitude_near(omega, eta, wrong).unwrap();
            assert!(late.amplitude.width() <= 1e-12 && late.tried > 2, "{omega} {eta} {wrong}");
            assert!(
                late.epsilon_complete < found.epsilon_incomplete && found.epsilon_complete < late.epsilon_incomplete
            );
        }
        for refused in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(critical_amplitude_near(omega, eta, refused).is_err());
        }
    }
}
