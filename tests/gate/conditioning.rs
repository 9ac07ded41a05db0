//! The derivatives of the impacts by the parameters, and the tolerances that are made of them.

use crate::effort::pick;
use chattercheck::{
    cases::generate::{Generator, Named},
    gate::{
        compare::{Agreement, Slack, compare},
        judge::Judges,
        report::Report,
        run,
    },
    measure::{
        asking::ask,
        conditioning::Conditioning,
        critical,
        observables::{Observable, Observed},
        zeno,
    },
    panel,
};
use contract::{Case, Ending, History, Oracle, Sensitivity};
use proptest::prelude::*;

fn stepper() -> Box<dyn Oracle> {
    panel::default().swap_remove(0)
}

/// The history of a case for the closed form, and the derivatives of its impacts.
fn differentiated(case: &Case) -> (Observed, Vec<Sensitivity>) {
    let stepper = stepper();
    (Observed::new(case, stepper.history(case).unwrap()), stepper.sensitivities(case).unwrap())
}

/// The case of these parameters, `ε`, `ω` and `η`.
fn case_of([epsilon, omega, eta]: [f64; 3], impacts: usize) -> Case {
    Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(impacts).unwrap()
}

/// A decimal of up to 36 places as a whole number of 1e-36, so that the difference of two loses nothing.
fn exactly(decimal: &str) -> i128 {
    let (mantissa, exponent) = decimal.split_once('e').map_or((decimal, 0), |(m, e)| (m, e.parse::<i32>().unwrap()));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: String = format!("{whole}{fraction}");
    let places = 36 + exponent - i32::try_from(fraction.len()).unwrap();
    let digits = if places < 0 {
        digits[..digits.len().saturating_sub(places.unsigned_abs() as usize)].to_owned()
    } else {
        digits + &"0".repeat(places as usize)
    };
    if digits.is_empty() || digits == "-" { 0 } else { digits.parse().unwrap() }
}

/// Central differences of the printed equations with many digits are the derivatives, to the square of the step.
#[test]
fn the_derivatives_are_differences_of_many_digits() {
    let printed = printed::Printed::with_digits(36).unwrap();
    let places = [[1e-6, 5.0, 0.7], [0.0379, 2.0, 0.92], [0.03, 2.0, 0.92], [0.01, 0.5, 0.85]];
    for place in places.into_iter().take(pick("places of the derivatives", 2, 4)) {
        const IMPACTS: usize = 16;
        let case = case_of(place, IMPACTS);
        let (_, found) = differentiated(&case);
        let time =
            |case: &Case| exactly(&printed.chattering_time_decimal(&case.with_max_impacts(200).unwrap()).unwrap());
        let deep = case.with_max_impacts(120).unwrap();
        let (observed, of_deep) = differentiated(&deep);
        let tail = zeno::sensitivity(&observed.history, &of_deep, deep.eta()).unwrap();
        for parameter in 0..3 {
            let moved = |by: f64| {
                let mut moved = place;
                moved[parameter] *= 1.0 + by;
                moved
            };
            let step = 2f64.powi(-30);
            let (up, down) = (moved(step), moved(-step));
            let width = up[parameter] - down[parameter];
            let (up, down) = (case_of(up, IMPACTS), case_of(down, IMPACTS));
            let (one, two) = (printed.decimals(&up).unwrap(), printed.decimals(&down).unwrap());
            assert_eq!((one.len(), two.len()), (IMPACTS, IMPACTS));
            let slope = |one: &str, two: &str| (exactly(one) - exactly(two)) as f64 * 1e-36 / width;
            for n in 0..IMPACTS {
                let expected = [
                    slope(&one[n].time, &two[n].time),
                    slope(&one[n].interval, &two[n].interval),
                    slope(&one[n].velocity, &two[n].velocity),
                ];
                let found = [found[n].time, found[n].interval, found[n].velocity].map(|by| by[parameter]);
                for (found, expected) in found.into_iter().zip(expected) {
                    let error = (found - expected).abs();
                    assert!(
                        error <= 1e-9 * expected.abs(),
                        "{place:?} by {parameter}, impact {}: {found} for {expected}",
                        n + 1
                    );
                }
            }
            let expected = (time(&up) - time(&down)) as f64 * 1e-36 / width;
            let error = (tail[parameter] / expected - 1.0).abs();
            assert!(error < 1e-8, "{place:?}: tau_ch by {parameter} is {} for {expected}", tail[parameter]);
        }
    }
}

/// `1 - τ_ch/(T/2) ~ K (a_cr - a)^β`, so the derivative of `τ_ch` by `a` grows with the exponent `β - 1`.
#[test]
fn the_condition_grows_towards_the_critical_amplitude_as_the_self_similar_bounce_says() {
    for (omega, eta) in [(2.0, 0.92), (0.7, 0.92), (2.0, 0.7)] {
        let (below, _) = critical::bracket(stepper().as_ref(), omega, eta).unwrap().unwrap();
        let slope = |rung: i32| {
            let case = case_of([below - 10f64.powi(-rung), omega, eta], 3000);
            let (observed, found) = differentiated(&case);
            assert_eq!(observed.history.ending, Ending::AtRest);
            let slope = zeno::sensitivity(&observed.history, &found, eta).unwrap()[0];
            assert!(slope > 0.0, "a stronger excitation keeps the block rocking for longer");
            slope
        };
        let slopes: Vec<f64> = (3..=12).map(slope).collect();
        let orders: Vec<f64> = slopes.windows(2).map(|two| -(two[1] / two[0]).log10()).collect();
        let expected = beta(eta) - 1.0;
        let off: Vec<f64> = orders.iter().map(|order| (order - expected).abs()).collect();
        // Between 1e-8 and 1e-11; a_cr itself is known to a few units of 1e-18 only, relative to 1e-12 that is 1e-6.
        assert!(off[5..8].iter().all(|off| *off < 2e-3), "omega {omega}, eta {eta}: {orders:?}, expected {expected}");
        assert!(off[7] < 0.2 * off[0], "the exponent is not approached: {orders:?}, expected {expected}");
    }
}

/// `β(0.92) = 0.60018`, `β(0.7) = 0.60321`.
#[test]
fn the_exponent_is_that_of_the_self_similar_bounce() {
    assert!((beta(0.92) - 0.60018).abs() < 1e-5 && (beta(0.7) - 0.60321).abs() < 1e-5);
}

/// The exponent with which `τ_ch` approaches `T/2`. Close to it the pull towards the base on one side falls to zero linearly and the flights
/// of the other side take no time, so two impacts act as one bounce with restitution `η²`. With `x` the flight over the time left, the bounce
/// that repeats itself has `(1-x)²(3-x) = η²(3-2x)`, and `β = -ln(1-x)/ln μ`, `μ` the derivative of one `u = x/2 - x²/6` by that before it.
fn beta(eta: f64) -> f64 {
    let squared = eta * eta;
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let x: f64 = 0.5 * (low + high);
        if (1.0 - x).powi(2) * (3.0 - x) > squared * (3.0 - 2.0 * x) { low = x } else { high = x }
    }
    let x = low;
    // u' = η² (x/2 - x²/3)/(1-x)²: derivatives of it and of u by x
    let left = 1.0 - x;
    let next = squared * ((0.5 - 2.0 * x / 3.0) * left + 2.0 * (0.5 * x - x * x / 3.0)) / left.powi(3);
    let mu = next / (0.5 - x / 3.0);
    -left.ln() / mu.ln()
}

/// Every rung passes: with the claims and the condition of the case, and with no exception of its own.
#[test]
fn the_ladder_towards_the_critical_amplitude_passes() {
    let panel = panel::select("closed-form,ode/linear/tsit45,ode/nonlinear/tsit45,taylor").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let rungs: Vec<Named> = Generator::Edge
        .cases(1, 0, stepper().as_ref())
        .into_iter()
        .filter(|named| named.name.contains("alpha="))
        .collect();
    assert_eq!(rungs.len(), 40);
    let rungs: Vec<Named> = rungs.into_iter().step_by(pick("step along the ladder", 3, 1)).collect();
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    let run = run::run(&panel, &judges, &rungs, 1, None, &());
    let report = Report::new(&run, &chattercheck::panel::roles());
    assert!(report.passes() && run.failures.is_empty(), "{}", chattercheck::gate::report::text(&report));
}

/// Towards `a_cr` the allowance for the rounding of the parameters grows, and stays below the distance that is left.
#[test]
fn the_condition_of_the_chattering_time_enters_through_the_contract() {
    let (below, _) = critical::bracket(stepper().as_ref(), 2.0, 0.92).unwrap().unwrap();
    let mut before = 0.0;
    for rung in [3, 6, 9, 12] {
        let case = case_of([below - 10f64.powi(-rung), 2.0, 0.92], 2000);
        let answer = ask(stepper().as_ref(), &case);
        let conditioning = Conditioning::by(stepper().as_ref(), &case, answer.observed().unwrap()).unwrap();
        let kappa = conditioning.at(Observable::ChatteringTime, 0);
        assert!(kappa > 5.0 * before, "{kappa} after {before}");
        let left = std::f64::consts::FRAC_PI_2 - answer.observed().unwrap().chattering_time.unwrap().value;
        assert!(f64::EPSILON * kappa < 1e-3 * left, "{kappa} at {left} from T/2");
        before = kappa;
    }
    // An oracle without derivatives is as before.
    let ode = panel::select("ode/linear/tsit45").unwrap().swap_remove(0);
    let case = case_of([0.03, 2.0, 0.92], 60);
    let observed = Observed::new(&case, ode.history(&case).unwrap());
    assert!(Conditioning::by(ode.as_ref(), &case, &observed).is_none());
    assert_eq!(Conditioning::of(&[ode.as_ref()], &[ask(ode.as_ref(), &case)], &case), Conditioning::default());
}

fn chattering() -> impl Strategy<Value = Case> {
    (0.02..0.9f64, 0.5..8.0f64, 0.5..0.96f64).prop_filter_map("complete chattering", |(share, omega, eta)| {
        let case = case_of([share * (critical::eq77(eta) - 1.0), omega, eta], 150);
        (stepper().history(&case).ok()?.ending == Ending::AtRest).then_some(case)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// A stronger excitation keeps the block rocking for longer, and so does a smaller loss at impact.
    #[test]
    fn the_chattering_time_grows_with_the_amplitude_and_the_restitution(case in chattering()) {
        let (observed, found) = differentiated(&case);
        let [by_a, _, by_eta] = zeno::sensitivity(&observed.history, &found, case.eta()).unwrap();
        prop_assert!(by_a > 0.0 && by_eta > 0.0, "{by_a}, {by_eta}");
        prop_assert!(found.iter().all(|of| of.time[0] > 0.0 && of.time[2] >= 0.0));
        // The first flight starts from rest and knows nothing of the restitution; the first velocity is proportional to it.
        prop_assert_eq!((found[0].time[2], found[0].interval[2]), (0.0, 0.0));
        let velocity = observed.history.impacts[0].velocity;
        prop_assert!((found[0].velocity[2] * case.eta() / velocity - 1.0).abs() < 1e-12);
    }

    /// The times are sums of the intervals (Eq. 42), and so are their derivatives.
    #[test]
    fn the_derivative_of_a_time_is_the_sum_of_those_of_the_intervals(case in chattering()) {
        let (_, found) = differentiated(&case);
        let mut sum = [0.0_f64; 3];
        for of in found {
            for (sum, (time, interval)) in sum.iter_mut().zip(of.time.iter().zip(of.interval)) {
                *sum += interval;
                prop_assert!((time - *sum).abs() <= 1e-12 * (time.abs() + interval.abs() + sum.abs()));
            }
        }
    }

    /// Where the excitation is fast against the block, `ωτ` is free of `ω`: `ω ∂τ/∂ω = -τ`. What is left is of order `1/ω²`.
    #[test]
    fn a_fast_excitation_scales_time(epsilon in 1e-4..0.02f64, omega in 1e3..1e5f64, eta in 0.5..0.9f64) {
        let case = case_of([epsilon, omega, eta], 40);
        let (observed, found) = differentiated(&case);
        for (impact, of) in observed.history.impacts.iter().zip(&found) {
            prop_assert!((of.time[1] * omega / impact.time + 1.0).abs() < 1e3 / (omega * omega));
            prop_assert!((of.interval[1] * omega / impact.interval + 1.0).abs() < 1e3 / (omega * omega));
        }
    }

    /// As `ε` falls, times go as its root and velocities as its power 3/2 (Eqs 31 and 35), with the derivatives that these have.
    #[test]
    fn weak_excitation_scales_as_the_powers_of_epsilon(exponent in -12.0..-6.0f64, omega in 0.5..8.0f64, eta in 0.5..0.9f64) {
        let epsilon = 10f64.powf(exponent);
        let (observed, found) = differentiated(&case_of([epsilon, omega, eta], 30));
        let History { impacts, .. } = observed.history;
        for (impact, of) in impacts.iter().zip(&found) {
            prop_assert!((of.time[0] * epsilon / impact.time - 0.5).abs() < 1e3 * epsilon);
            prop_assert!((of.velocity[0] * epsilon / impact.velocity - 1.5).abs() < 1e3 * epsilon);
        }
    }
}

/// What is allowed on top of the claims is `2^-53` times the condition, which is what differences of the history itself give.
#[test]
fn the_allowance_is_what_rounding_the_parameters_does() {
    let parameters = [0.03, 2.0, 0.92];
    let case = case_of(parameters, 60);
    let (observed, sensitivities) = differentiated(&case);
    let conditioning = Conditioning::new(&case, &observed, &sensitivities);
    let time = |parameters: [f64; 3]| {
        let case = case_of(parameters, 60);
        let observed = Observed::new(&case, stepper().history(&case).unwrap());
        (observed.history.impacts[39].time, observed.chattering_time.unwrap().value)
    };
    let (mut of_impact, mut of_end) = (0.0, 0.0);
    for place in 0..3 {
        let moved =
            |by: f64| std::array::from_fn(|index| parameters[index] * if index == place { 1.0 + by } else { 1.0 });
        let (above, below) = (time(moved(1e-6)), time(moved(-1e-6)));
        of_impact += (above.0 - below.0).abs() / 2e-6;
        of_end += (above.1 - below.1).abs() / 2e-6;
    }
    let off = |found: f64, expected: f64| (found / expected - 1.0).abs();
    assert!(off(conditioning.at(Observable::ImpactTime, 40), of_impact) < 1e-6);
    assert!(off(conditioning.at(Observable::ChatteringTime, 0), of_end) < 1e-6);
    // Two histories without claims that differ by a little less, and by a little more, than that.
    let unit = 0.5 * f64::EPSILON;
    let bare = |shift: f64| {
        let mut history = observed.history.clone();
        for impact in &mut history.impacts {
            impact.uncertainty = contract::Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        }
        let allowed = unit * conditioning.at(Observable::Velocity, 40);
        history.impacts[39].velocity *= 1.0 + shift * allowed;
        Observed { history, chattering_time: None }
    };
    // Where the condition is large enough for doubles to tell.
    assert!(conditioning.at(Observable::Velocity, 40) > 20.0);
    let agrees = |shift: f64| {
        let slack = Slack { conditioning: &conditioning, gap: None };
        compare(&case, &bare(0.0), &bare(shift), slack).agreement == Agreement::Agree
    };
    assert!(agrees(0.8) && !agrees(1.2));
}
