//! Numbers of the paper, and of what it leaves out, to more digits than the claims of `src/studies/paper/claims` have.

use approx::assert_relative_eq;
use chattercheck::{
    measure::{
        critical,
        observables::{Observable, Observed},
    },
    panel::{self, Settings},
};
use contract::{Case, Ending, Oracle};

fn oracle(name: &str) -> Box<dyn Oracle> {
    panel::one(name, &Settings::default(), "linear").unwrap()
}

fn observed(name: &str, a: f64, omega: f64, eta: f64, impacts: usize) -> Observed {
    let case = Case::from_amplitude(a, omega, eta).unwrap().with_max_impacts(impacts).unwrap();
    Observed::new(&case, oracle(name).history(&case).unwrap())
}

#[test]
fn eq_73_interval_ratios_tend_to_eta_squared() {
    // Fig. 3: (a) and (b)
    for (a, omega, eta) in [(1.01, 5.0, 0.92), (1.03, 2.0, 0.86)] {
        let history = observed("closed-form", a, omega, eta, 200);
        let off = |n: usize| (history.at(Observable::IntervalRatio, n).unwrap().value / (eta * eta) - 1.0).abs();
        assert!(off(10) > 0.03, "early ratios are not yet there: {}", off(10));
        // "n of about 60": within half a per cent, and from there on it falls as the intervals do.
        assert!(off(60) < 5e-3, "{}", off(60));
        assert_relative_eq!(off(162) / off(160), eta * eta, max_relative = 1e-3);
    }
}

#[test]
fn eq_65_the_check_values_of_the_series() {
    let coefficient = |epsilon: f64, eta: f64| {
        let case = Case::from_epsilon(epsilon, 2.0, eta).unwrap();
        oracle("asymptotic").history(&case).unwrap().chattering_time.unwrap().value * 2.0 / epsilon.sqrt()
    };
    for (eta, x, u) in
        [(0.92, 10.827_447_906_756_6, 64.107_088_919_593_1), (0.80, 7.991_302_671_138_33, 19.462_845_284_730_2)]
    {
        assert_relative_eq!(coefficient(1e-20, eta), x, max_relative = 1e-14);
        assert_relative_eq!((coefficient(1e-2, eta) - x) / 1e-2, u, max_relative = 1e-12);
    }
    let at_103 = observed("asymptotic", 1.03, 2.0, 0.92, 60).chattering_time.unwrap().value;
    assert_relative_eq!(at_103 / std::f64::consts::FRAC_PI_2, 0.70298, max_relative = 1e-5);
    let exact = observed("closed-form", 1.03, 2.0, 0.92, 80).chattering_time.unwrap().value;
    assert_relative_eq!(exact / std::f64::consts::FRAC_PI_2, 0.71680, max_relative = 1e-5);
}

#[test]
fn the_approach_to_the_critical_amplitude_has_the_exponent_of_the_self_similar_bounce() {
    // 1 - tau_ch/(T/2) ~ K (a_cr - a)^beta, beta = -ln(1-x)/ln(mu) with (1-x)²(3-x) = eta²(3-2x); beta(0.7) = 0.60321
    let (omega, eta) = (2.0, 0.7);
    let stepper = oracle("closed-form");
    let critical = critical::bracket(stepper.as_ref(), omega, eta).unwrap().unwrap().0;
    let left = |gap: f64| {
        let case = Case::from_epsilon(critical - gap, omega, eta).unwrap().with_max_impacts(2000).unwrap();
        let observed = Observed::new(&case, stepper.history(&case).unwrap());
        assert_eq!(observed.history.ending, Ending::AtRest);
        1.0 - observed.chattering_time.unwrap().value * omega / std::f64::consts::PI
    };
    let exponent = (left(1e-8) / left(1e-10)).ln() / 100.0_f64.ln();
    assert_relative_eq!(exponent, 0.60321, max_relative = 1e-3);
}
