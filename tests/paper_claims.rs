//! Statements of the paper, and of what it leaves out, measured.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::expect_used)]

use approx::assert_relative_eq;
use chattercheck::{
    critical,
    observables::{Observable, Observed},
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
fn eq_68_is_a_statement_of_first_order() {
    // |v_{n+1}| = eta |v_n| up to a part proportional to the interval.
    let eta = 0.92;
    let history = observed("closed-form", 1.03, 2.0, eta, 200);
    let off = |n: usize| {
        let velocity = |n: usize| history.at(Observable::Velocity, n).unwrap().value.abs();
        let interval = history.at(Observable::Interval, n + 1).unwrap().value;
        (velocity(n + 1) / (eta * velocity(n)) - 1.0) / interval
    };
    assert!(off(150).abs() > 1e-2, "it is not of second order: {}", off(150));
    assert_relative_eq!(off(150), off(152), max_relative = 1e-3);
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
fn eqs_31_and_32_have_a_misprint_and_eq_34_has_not() {
    // tau_1 = (4 sqrt2/omega) eps^(1/2) + c eps^(3/2): the paper has 32(omega²-1)/(5 omega²) in c, the motion has 15 for 5.
    let omega: f64 = 3.0;
    let first = |epsilon: f64| {
        let case = Case::from_epsilon(epsilon, omega, 0.9).unwrap().with_max_impacts(1).unwrap();
        oracle("closed-form").history(&case).unwrap().impacts[0]
    };
    let epsilon = 1e-6;
    let root2 = 2.0_f64.sqrt();
    let second = (first(epsilon).time - 4.0 * root2 / omega * epsilon.sqrt()) / epsilon.powf(1.5);
    let with =
        |denominator: f64| -root2 / omega * (-1.0 + 32.0 * (omega * omega - 1.0) / (denominator * omega * omega));
    assert_relative_eq!(second, with(15.0), max_relative = 1e-4);
    assert!((second / with(5.0) - 1.0).abs() > 0.5, "as printed it would be {}", with(5.0));
    // Eq. 34, the velocity before the first impact
    let velocity = first(epsilon).velocity / 0.9;
    let leading = 16.0 * root2 / (3.0 * omega);
    let next = (velocity / epsilon.powf(1.5) - leading) / epsilon;
    assert_relative_eq!(
        next,
        4.0 * root2 / omega * (1.0 - 32.0 * (omega * omega - 1.0) / (15.0 * omega * omega)),
        max_relative = 1e-3
    );
}

#[test]
fn the_chattering_time_over_the_half_period_depends_a_little_on_omega() {
    // "depends solely on a and eta": within 3 % from omega = 1 to 8, and not at 0.5.
    let share = |omega: f64| observed("closed-form", 1.02, omega, 0.92, 120).chattering_time.unwrap().value * omega;
    let high = share(8.0);
    assert!((share(1.0) / high - 1.0).abs() < 0.03 && (share(2.0) / high - 1.0).abs() < 0.01);
    assert!((share(0.5) / high - 1.0).abs() > 0.03, "{}", share(0.5) / high);
}

#[test]
fn eqs_76_and_77_are_good_to_a_few_parts_in_a_thousand() {
    let stepper = oracle("closed-form");
    let exact = 1.0 + critical::bracket(stepper.as_ref(), 2.0, 0.92).unwrap().unwrap().0;
    assert_relative_eq!(critical::eq76(2.0, 0.92), 1.03732, epsilon = 1e-5);
    assert_relative_eq!(critical::eq77(0.92), 1.03790, epsilon = 1e-5);
    assert!((critical::eq76(2.0, 0.92) - exact).abs() < 1e-3 && (critical::eq77(0.92) - exact).abs() < 2e-4);
    // Fig. 7: "from omega = 0.5 to 8 a_cr differs only by 0.5 %"
    let of = |omega: f64| 1.0 + critical::bracket(stepper.as_ref(), omega, 0.92).unwrap().unwrap().0;
    assert_relative_eq!(of(8.0) / of(0.5) - 1.0, 0.005, max_relative = 0.05);
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

#[test]
fn fig_11_a_velocity_threshold_turns_incomplete_chattering_into_rest() {
    let history = observed("closed-form", 1.05, 2.0, 0.92, 60).history;
    assert_eq!(history.ending, Ending::Incomplete);
    let slowest = history.impacts.iter().map(|impact| impact.velocity.abs()).fold(f64::INFINITY, f64::min);
    // VelTol/(p alpha) = 5e-2 stops it, 5e-10 does not.
    assert!(slowest < 5e-2 && slowest > 5e-10, "{slowest}");
}
