//! What the linear model leaves out, against the enclosure of the nonlinear one; and the linear model corrected by it.

use chattercheck::{
    gate::{
        calibration::Calibration,
        compare::{Agreement, Slack, compare},
        judge::Judges,
        tolerance,
    },
    measure::{
        asking::ask,
        conditioning::Conditioning,
        critical,
        observables::{Observable, Observed},
    },
    motion::linearisation::{Corrected, Linearisation, Shift},
    panel,
};
use contract::{Case, Decline, Ending, History, Horizon, Model, Normalisation, Oracle, Slenderness, SlendernessShift};
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};

fn with(case: Case, alpha: f64, normalisation: Normalisation) -> Case {
    case.with_slenderness(Slenderness::new(alpha, normalisation).unwrap())
}

/// The case `ε`, `ω`, `η`, and how far and to how many impacts it is followed.
fn case_of([epsilon, omega, eta]: [f64; 3], horizon: Horizon, impacts: usize) -> Case {
    let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
    case.with_max_impacts(impacts).unwrap().with_horizon(horizon).unwrap()
}

/// The closed form, corrected.
fn corrected() -> Corrected {
    Corrected::new(panel::stepper())
}

/// The history of Eq. 2 within proven bounds.
fn proven(case: &Case) -> Observed {
    let enclosure = enclosure::Enclosure::new(Model::Nonlinear);
    Observed::new(case, enclosure.history(case).unwrap())
}

/// The linearisation of a case for a block of slenderness `alpha`, and the nonlinear history.
fn both(case: Case, alpha: f64) -> (Linearisation, Observed) {
    let case = with(case, alpha, Normalisation::Threshold);
    (Linearisation::new(panel::stepper().as_ref(), &case).unwrap(), proven(&case))
}

/// Complete chattering, incomplete chattering, and flights of up to 2.8 past half a period.
fn places() -> [(Case, &'static [usize]); 5] {
    [
        (case_of([0.03, 2.0, 0.92], Horizon::HalfPeriod, 200), &[1, 2, 7, 40, 120, 200]),
        (case_of([0.01, 0.6, 0.8], Horizon::HalfPeriod, 120), &[1, 2, 7, 40, 120]),
        (case_of([0.06, 2.0, 0.92], Horizon::HalfPeriod, 200), &[1, 2, 4, 5]),
        (case_of([0.4, 2.0, 0.5], Horizon::Until(9.0), 8), &[1, 2, 3, 4]),
        (case_of([1.2, 3.0, 0.8], Horizon::Until(6.0), 8), &[1, 2, 3, 4]),
    ]
}

/// A number of the linear model, what it is shifted by, and the number of the nonlinear model: time, interval and velocity of impact `n`, or the
/// chattering time for none; in the scale of the shift.
fn numbers((linear, nonlinear): &(Linearisation, Observed), n: Option<usize>) -> Vec<(Shift, f64)> {
    let Some(n) = n else {
        let pair = linear.linear.chattering_time.zip(nonlinear.chattering_time);
        let of = |(one, two): (contract::Estimate, contract::Estimate)| {
            (linear.chattering_time.unwrap(), two.value - one.value)
        };
        return pair.into_iter().map(of).collect();
    };
    let (shift, one) = (&linear.impacts[n - 1], &linear.linear.history.impacts[n - 1]);
    let two = &nonlinear.history.impacts[n - 1];
    vec![
        (shift.time, two.time - one.time),
        (shift.interval, two.interval / one.interval - 1.0),
        (shift.velocity, two.velocity / (linear.velocity_scale * one.velocity) - 1.0),
    ]
}

/// The derivative by `α²` is the limit of the difference of the models over `α²`, extrapolated from four slendernesses.
#[test]
fn the_derivative_is_the_limit_of_the_difference_between_the_models() {
    for (case, impacts) in places() {
        let rungs = [0.16, 0.08, 0.04, 0.02].map(|alpha: f64| (alpha, both(case, alpha)));
        for n in impacts.iter().copied().map(Some).chain([None]) {
            let differences = rungs.each_ref().map(|(alpha, rung)| {
                numbers(rung, n).into_iter().map(|(_, difference)| difference / (alpha * alpha)).collect::<Vec<_>>()
            });
            for (place, (shift, _)) in numbers(&rungs[0].1, n).into_iter().enumerate() {
                // Neville's table in powers of α².
                let mut column = differences.each_ref().map(|rung| rung[place]).to_vec();
                for power in [4.0, 16.0, 64.0] {
                    column = column.windows(2).map(|two| (power * two[1] - two[0]) / (power - 1.0)).collect();
                }
                let off = (column[0] / shift.derivative - 1.0).abs();
                assert!(off < 1e-6, "{case:?}, impact {n:?}, number {place}: {} {}", column[0], shift.derivative);
            }
        }
    }
}

/// Four orders where the difference of the models has two.
#[test]
fn what_is_left_after_the_first_order_falls_as_the_fourth_power() {
    for (case, impacts) in places() {
        let alphas = [0.12, 0.06, 0.03];
        let rungs = alphas.map(|alpha| both(case, alpha));
        for n in impacts.iter().copied().map(Some).chain([None]) {
            let left = rungs.each_ref().map(|rung| {
                numbers(rung, n).into_iter().map(|(shift, by)| (by - shift.first_order).abs()).collect::<Vec<_>>()
            });
            for (place, (wide, narrow)) in left[1].iter().zip(&left[2]).enumerate() {
                let order = (wide / narrow).log2();
                assert!((order - 4.0).abs() < 0.1, "{case:?}, impact {n:?}, number {place}: order {order}");
            }
        }
    }
}

/// The figure of the linear model's error at `a = 1.03`, `ω = 2`, `η = 0.92`.
#[test]
fn the_linear_chattering_time_of_figure_2_is_off_by_3_4e_3_alpha_squared() {
    let case = with(Case::from_amplitude(1.03, 2.0, 0.92).unwrap(), 0.2, Normalisation::Threshold);
    let case = case.with_max_impacts(300).unwrap();
    let found = Linearisation::new(panel::stepper().as_ref(), &case).unwrap().chattering_time.unwrap();
    assert!((found.derivative - 3.438e-3).abs() < 2e-6, "{found:?}");
}

/// Random cases up to 0.99 of the way to `a_cr` and beyond it, always the same.
fn random(count: usize, seed: u8) -> Vec<Case> {
    let share = prop_oneof![3 => 0.02..0.98, 2 => (0.01f64.ln()..0.2f64.ln()).prop_map(|gap: f64| 1.0 - gap.exp()), 1 => 1.02..1.8];
    let logarithmic = |low: f64, high: f64| (low.ln()..high.ln()).prop_map(f64::exp);
    let strategy = (share, logarithmic(0.5, 8.0), 0.5..0.97, logarithmic(0.02, 0.5));
    let config = Config { failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]));
    let case = |(share, omega, eta, alpha): (f64, f64, f64, f64)| {
        let epsilon = share * critical::interpolated(omega, eta).unwrap();
        let impacts = (1e-9_f64.ln() / eta.ln()).ceil() as usize + 20;
        with(case_of([epsilon, omega, eta], Horizon::HalfPeriod, impacts), alpha, Normalisation::Threshold)
    };
    (0..count).map(|_| case(strategy.new_tree(&mut runner).unwrap().current())).collect()
}

/// What the judge says of an oracle on these cases: how many it answered, in how many it is refuted, and how its claims compare with its errors.
fn judged(oracle: &dyn Oracle, cases: &[Case]) -> (usize, usize, Calibration) {
    let enclosure = enclosure::Enclosure::new(Model::Nonlinear);
    let judges = Judges { oracles: vec![&enclosure], every: 1, closing: None };
    let (mut answered, mut refuted, mut calibration) = (0, 0, Calibration::default());
    for case in cases {
        let judgements = judges.judge(case, &[ask(oracle, case)], |_| true);
        for judgement in judgements {
            answered += 1;
            refuted += usize::from(judgement.refuted.is_some());
            calibration.add_all(judgement.calibration);
        }
    }
    (answered, refuted, calibration)
}

/// No number is further from the enclosure than claimed, and the claims are not far larger than the errors.
#[test]
fn what_is_left_is_claimed_and_not_much_more() {
    let cases = random(80, 7);
    let (answered, refuted, calibration) = judged(&corrected(), &cases);
    assert!(answered >= 70 && refuted == 0, "{answered} answered, {refuted} refuted");
    for (observable, figure) in calibration.figures() {
        assert!(figure.smallest >= 1.0, "{observable}: {}", figure.smallest);
        assert!(figure.median <= 0.1 * tolerance::CALIBRATION.value, "{observable}: {}", figure.median);
    }
}

/// The linear oracle with shifts that are tampered with.
struct Tampered {
    honest: Box<dyn Oracle>,
    how: fn(usize, &mut [f64; 3]),
}

impl Oracle for Tampered {
    fn name(&self) -> &str {
        "tampered"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        self.honest.history(case)
    }

    fn slenderness_shifts(&self, case: &Case) -> Option<Vec<SlendernessShift>> {
        let mut shifts = self.honest.slenderness_shifts(case)?;
        for (n, shift) in shifts.iter_mut().enumerate() {
            for coefficients in [&mut shift.time, &mut shift.interval, &mut shift.velocity] {
                (self.how)(n, coefficients);
            }
        }
        Some(shifts)
    }
}

/// A first order with the wrong sign, or off by a half or a tenth; one that stops being carried from flight to flight; a second and third
/// order that are left out of the claims.
#[test]
fn shifts_that_are_wrong_are_refuted() {
    type Fault = fn(usize, &mut [f64; 3]);
    let faults: [(&str, Fault); 5] = [
        ("sign", |_, coefficients| coefficients[0] = -coefficients[0]),
        ("half", |_, coefficients| coefficients[0] *= 0.5),
        ("a tenth", |_, coefficients| coefficients[0] *= 1.1),
        ("not carried", |n, coefficients| {
            if n > 0 {
                *coefficients = [0.0; 3];
            }
        }),
        ("small claims", |_, coefficients| (coefficients[1], coefficients[2]) = (0.0, 0.0)),
    ];
    let cases = random(12, 3);
    for (what, how) in faults {
        let (answered, refuted, _) =
            judged(&Corrected::new(Box::new(Tampered { honest: panel::stepper(), how })), &cases);
        assert!(answered >= 6 && 10 * refuted >= 8 * answered, "{what}: {refuted} of {answered}");
    }
}

fn any_case() -> impl Strategy<Value = Case> {
    (0.02..1.6f64, 0.5..8.0f64, 0.5..0.96f64, 0.02..0.5f64, any::<bool>()).prop_map(
        |(share, omega, eta, alpha, slender)| {
            let epsilon = share * critical::interpolated(omega, eta).unwrap();
            let (epsilon, normalisation) = match slender {
                false => (epsilon, Normalisation::Threshold),
                true => ((1.0 + epsilon) * alpha.tan() / alpha - 1.0, Normalisation::Slender),
            };
            with(case_of([epsilon, omega, eta], Horizon::HalfPeriod, 150), alpha, normalisation)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Under either normalisation, with the same ending.
    #[test]
    fn the_correction_agrees_with_the_nonlinear_solver(case in any_case()) {
        let taylor = panel::select("taylor").unwrap().swap_remove(0);
        let Ok(corrected) = corrected().history(&case) else { return Ok(()) };
        let solved = taylor.history(&case).unwrap();
        prop_assert_eq!((corrected.ending, corrected.impacts.len()), (solved.ending, solved.impacts.len()));
        let slack = Slack { conditioning: &Conditioning::default(), gap: None };
        let comparison = compare(&case, &Observed::new(&case, corrected), &Observed::new(&case, solved), slack);
        prop_assert_eq!(comparison.agreement, Agreement::Agree);
    }
}

/// Intervals of 1e-20 and less are corrected as accurately as the others.
#[test]
fn the_correction_is_relative_however_deep_the_sequence_goes() {
    let case = with(case_of([0.01, 2.0, 0.7], Horizon::HalfPeriod, 600), 0.1, Normalisation::Threshold);
    let corrected = corrected().history(&case).unwrap();
    let proven = proven(&case);
    let observed = Observed::new(&case, corrected);
    assert_eq!(observed.history.ending, Ending::AtRest);
    let n = observed.history.impacts.len();
    assert!(n == 600 && observed.history.impacts[n - 1].interval < 1e-80);
    for observable in [Observable::Interval, Observable::Velocity] {
        let (found, truth) = (observed.at(observable, n).unwrap(), proven.at(observable, n).unwrap());
        let error = (found.value / truth.value - 1.0).abs();
        assert!(error <= found.uncertainty && found.uncertainty < 1e-5, "{observable}: {error:e} {found:?}");
    }
}

#[test]
fn what_it_cannot_do_it_declines() {
    let corrected = corrected();
    let decline = |case: &Case| corrected.history(case).unwrap_err();
    let slender = case_of([0.03, 2.0, 0.92], Horizon::HalfPeriod, 100);
    assert_eq!(decline(&slender), Decline::NeedsSlenderness);
    // A stocky block next to a_cr: the terms do not fall.
    let (below, _) = critical::bracket(panel::stepper().as_ref(), 0.8, 0.92).unwrap().unwrap();
    let near = with(case_of([0.9999 * below, 0.8, 0.92], Horizon::HalfPeriod, 300), 0.4, Normalisation::Threshold);
    assert_eq!(decline(&near).reason(), "not convergent");
    let long = with(case_of([0.4, 2.0, 0.5], Horizon::Until(9.0), 8), 0.1, Normalisation::Threshold);
    assert_eq!(decline(&long).reason(), "unsupported");
    // An impact at the very end of the time that is followed: whether it is within is not known to the errors that are left.
    let followed = |end: f64| with(case_of([0.03, 2.0, 0.92], Horizon::Until(end), 100), 0.1, Normalisation::Threshold);
    let tenth = corrected.history(&followed(1.2)).unwrap().impacts[9];
    assert!(tenth.uncertainty.time > 0.0 && tenth.time < 1.2);
    for beside in [-0.9, 0.0, 0.9] {
        let end = tenth.time + beside * tenth.uncertainty.time;
        assert_eq!(decline(&followed(end)).reason(), "not convergent", "{beside} of its error from the end");
    }
    let away = 2.0 * tenth.uncertainty.time;
    assert_eq!(corrected.history(&followed(tenth.time - away)).unwrap().impacts.len(), 9);
    assert_eq!(corrected.history(&followed(tenth.time + away)).unwrap().impacts.len(), 10);
    // The solver with many digits does not know how its impacts move.
    let unknown = Corrected::new(panel::select("printed").unwrap().swap_remove(0));
    assert_eq!(unknown.history(&with(slender, 0.1, Normalisation::Threshold)).unwrap_err().reason(), "unsupported");
    // Below the threshold of Eq. 1, which 1.01 times that of Eq. 5 is for α = 0.2.
    let still = with(case_of([0.01, 2.0, 0.92], Horizon::HalfPeriod, 100), 0.2, Normalisation::Slender);
    assert_eq!(corrected.history(&still).unwrap().ending, Ending::NeverRocks);
}

#[test]
fn it_is_asked_by_name() {
    let settings = panel::Settings::default();
    let one = panel::one("closed-form/corrected", &settings, "nonlinear").unwrap();
    assert_eq!((one.name(), one.model()), ("closed-form/corrected", Model::Nonlinear));
    assert_eq!(panel::select("closed-form/corrected").unwrap().len(), 1);
    // The family of the closed form in the default panel is without it.
    assert_eq!(panel::select("closed-form").unwrap()[0].name(), "closed-form");
}
