//! What the gate is for: the methods agree, and with values from outside.

use approx::assert_relative_eq;
use chattercheck::{
    cases::generate::Generator,
    gate::{judge::Judges, report::Report, run},
    measure::{
        observables::{Observable, Observed},
        zeno,
    },
    panel::{self, Settings},
};
use contract::{Case, Ending, Normalisation, Oracle, Slenderness};

fn oracle(name: &str, settings: &Settings) -> Box<dyn Oracle> {
    panel::one(name, settings, "linear").unwrap()
}

fn observed(oracle: &dyn Oracle, case: &Case) -> Observed {
    Observed::new(case, oracle.history(case).unwrap())
}

fn reference_case(impacts: usize) -> Case {
    Case::from_amplitude(1.03, 2.0, 0.92).unwrap().with_max_impacts(impacts).unwrap()
}

/// The chattering time of the reference case, to more digits than a double has.
const TAU_CH: f64 = 1.125_947_676_933_812_1;

#[test]
fn a_thousand_random_cases_of_sixty_impacts_are_not_lost_and_agree() {
    let closed = oracle("closed-form", &Settings::default());
    let ode = oracle("ode", &Settings { rtol: Some(1e-11), ..Settings::default() });
    let mut impacts = 0;
    for named in Generator::Random.cases(2, 1000, closed.as_ref()) {
        let case = named.case.with_max_impacts(60).unwrap();
        let (exact, found) = (observed(closed.as_ref(), &case), observed(ode.as_ref(), &case));
        assert!(!matches!(found.history.ending, Ending::Lost(_)), "{named} is lost");
        for n in 1..=exact.history.impacts.len().min(found.history.impacts.len()) {
            let (one, two) = (exact.at(Observable::Interval, n).unwrap(), found.at(Observable::Interval, n).unwrap());
            let error = (two.value / one.value - 1.0).abs();
            // Where the case itself is ill-conditioned the claim says so.
            assert!(error < f64::max(1e-8, two.uncertainty), "{named}, impact {n}: {error:e}");
            impacts += 1;
        }
    }
    assert!(impacts > 40_000, "{impacts} impacts compared");
}

#[test]
fn the_sum_is_closed_to_the_last_digits() {
    let closed = observed(oracle("closed-form", &Settings::default()).as_ref(), &reference_case(60));
    let eq75 = zeno::eq75(&closed.history, 0.92).unwrap();
    assert!((1e-6..3e-5).contains(&(eq75 - TAU_CH).abs()), "Eq. 75 is off by {:e}", eq75 - TAU_CH);
    let time = closed.chattering_time.unwrap();
    assert!((time.value - TAU_CH).abs() < 3e-14, "higher orders are off by {:e}", time.value - TAU_CH);
    assert!((time.value - TAU_CH).abs() <= time.uncertainty && time.uncertainty < 1e-11, "{:e}", time.uncertainty);
}

#[test]
fn the_claimed_error_of_the_chattering_time_holds_at_every_depth() {
    let closed = oracle("closed-form", &Settings::default());
    let mut closed_early = 0;
    for named in Generator::Spaced.cases(1, 0, closed.as_ref()) {
        let deep = observed(closed.as_ref(), &named.case.with_max_impacts(2000).unwrap());
        let Some(exact) = deep.chattering_time else { continue };
        for impacts in [20, 30, 45, 60, 90, 130, 200] {
            // As soon as the oracle itself is sure of rest.
            let shallow = observed(closed.as_ref(), &named.case.with_max_impacts(impacts).unwrap());
            let Some(time) = shallow.chattering_time else { continue };
            closed_early += 1;
            let error = (time.value - exact.value).abs();
            let claimed = time.uncertainty + exact.uncertainty;
            assert!(error <= claimed, "{named}, {impacts} impacts: off by {error:e}, claimed {claimed:e}");
        }
    }
    assert!(closed_early > 500, "{closed_early}");
}

#[test]
fn every_impact_is_resolved_down_to_intervals_of_1e_20() {
    let case = reference_case(560);
    let ode = observed(oracle("ode", &Settings::default()).as_ref(), &case);
    let closed = observed(oracle("closed-form", &Settings::default()).as_ref(), &case);
    assert_eq!((ode.history.ending, closed.history.ending), (Ending::AtRest, Ending::AtRest));
    assert!(ode.history.impacts.last().unwrap().interval < 1e-20);
    for n in 1..=560 {
        let of = |observed: &Observed| observed.at(Observable::Interval, n).unwrap().value;
        assert_relative_eq!(of(&ode), of(&closed), max_relative = 1e-9);
    }
}

#[test]
fn the_models_differ_by_what_the_slenderness_costs() {
    let linear = observed(oracle("closed-form", &Settings::default()).as_ref(), &reference_case(80));
    let nonlinear = oracle("ode", &Settings { equation: Some("nonlinear"), ..Settings::default() });
    let at = |alpha: f64, normalisation: Normalisation| {
        let case = reference_case(80).with_slenderness(Slenderness::new(alpha, normalisation).unwrap());
        let time = observed(nonlinear.as_ref(), &case).chattering_time.unwrap().value;
        time / linear.chattering_time.unwrap().value - 1.0
    };
    // Threshold normalisation: 3.1e-3 alpha^2. Slender normalisation: a third of the time.
    assert_relative_eq!(at(0.2, Normalisation::Threshold).abs(), 1.24e-4, max_relative = 0.02);
    assert_relative_eq!(at(0.1, Normalisation::Threshold).abs(), 3.1e-5, max_relative = 0.02);
    assert_relative_eq!(at(0.2, Normalisation::Slender), -0.34, max_relative = 0.02);
}

#[test]
fn slender_normalisation_is_threshold_normalisation_at_a_smaller_amplitude() {
    let nonlinear = oracle("ode", &Settings { equation: Some("nonlinear"), ..Settings::default() });
    let (alpha, a) = (0.15_f64, 1.03);
    let of = |a: f64, normalisation: Normalisation| {
        let case = Case::from_amplitude(a, 2.0, 0.9).unwrap();
        let case = case.with_slenderness(Slenderness::new(alpha, normalisation).unwrap());
        observed(nonlinear.as_ref(), &case)
    };
    let slender = of(a, Normalisation::Slender);
    let threshold = of(a * alpha / alpha.tan(), Normalisation::Threshold);
    for n in 1..=60 {
        let interval = |observed: &Observed| observed.at(Observable::Interval, n).unwrap().value;
        assert_relative_eq!(interval(&slender), interval(&threshold), max_relative = 1e-8);
    }
}

#[test]
fn the_printed_equations_with_many_digits_agree_with_every_method() {
    let oracles = panel::select("closed-form,ode/linear/tsit45,asymptotic/paper,printed").unwrap();
    let panel: Vec<&dyn Oracle> = oracles.iter().map(AsRef::as_ref).collect();
    let cases: Vec<_> = Generator::Spaced
        .cases(1, 0, panel[0])
        .into_iter()
        .step_by(11)
        .map(|mut named| {
            named.case = named.case.with_max_impacts(40).unwrap();
            named
        })
        .collect();
    let report =
        Report::new(&run::run(&panel, &Judges::default(), &cases, 0, None, &()), &chattercheck::panel::roles());
    assert!(report.passes(), "{}", chattercheck::gate::report::text(&report));
    assert!(report.pairs.iter().all(|pair| pair.compared == cases.len() || pair.absent > 0));
}

#[test]
fn the_critical_amplitude_is_where_direct_stepping_finds_it() {
    let closed = oracle("closed-form", &Settings::default());
    for (omega, eta, critical, digits) in
        [(2.0, 0.92, 1.038_015_538_7, 2e-10), (0.5, 0.92, 1.033_02, 1e-5), (8.0, 0.92, 1.038_36, 1e-5)]
    {
        let (below, above) = chattercheck::measure::critical::bracket(closed.as_ref(), omega, eta).unwrap().unwrap();
        assert!(below < above && (1.0 + below - critical).abs() < digits, "omega = {omega}: {}", 1.0 + below);
    }
}
