//! Whatever is asked ends, in an answer or a decline.

use contract::{Case, Decline, Ending, Horizon, Limit, Model, Normalisation, Oracle, Slenderness};
use enclosure::{Bounds, Enclosed, Enclosure};

fn case(epsilon: f64, omega: f64, eta: f64) -> Case {
    Case::from_epsilon(epsilon, omega, eta).unwrap()
}

fn both(case: &Case, alpha: f64) -> [Result<Enclosed, Decline>; 2] {
    let block = case.with_slenderness(Slenderness::new(alpha, Normalisation::Threshold).unwrap());
    [Enclosure::new(Model::Linear).enclose(case), Enclosure::new(Model::Nonlinear).enclose(&block)]
}

#[test]
fn the_ends_of_the_ranges() {
    for (epsilon, omega, eta) in [
        (1e-60, 2.0, 0.92),
        (1e-60, 1e-6, 0.5),
        (1e9, 2.0, 0.92),
        (1e9, 1e6, 0.92),
        (0.03, 1e-6, 0.92),
        (0.03, 1e6, 0.92),
        (0.03, 2.0, 1e-6),
        (0.1, 2.0, 1.0 - 1e-15),
        (10.0, 0.1, 0.9),
    ] {
        for enclosed in both(&case(epsilon, omega, eta), 0.2) {
            let ending = enclosed.unwrap().ending;
            assert!(
                matches!(ending, Ending::AtRest | Ending::Incomplete | Ending::Overturned),
                "{epsilon} {omega} {eta}: {ending:?}"
            );
        }
    }
    for alpha in [1e-100, 1e-12, 1.57] {
        assert!(both(&case(0.03, 2.0, 0.92), alpha).iter().all(Result::is_ok), "{alpha}");
    }
}

#[test]
fn as_many_impacts_as_there_are() {
    for eta in [0.5, 0.92] {
        let all = case(0.03, 2.0, eta).with_max_impacts(Case::MOST_IMPACTS).unwrap();
        let enclosed = Enclosure::new(Model::Linear).enclose(&all).unwrap();
        let last = enclosed.impacts.last().unwrap();
        assert!(enclosed.ending == Ending::AtRest && last.velocity.upper().abs() < 1e-249);
        assert!(last.interval.width() <= 1e-17 * last.interval.upper());
    }
}

#[test]
fn chaos_past_half_a_period_has_a_limit() {
    let long = case(0.1, 2.0, 0.92).with_max_impacts(3).unwrap().with_horizon(Horizon::Until(1e6)).unwrap();
    let enclosed = Enclosure::new(Model::Linear).enclose(&long).unwrap();
    assert_eq!((enclosed.ending, enclosed.impacts.len()), (Ending::LimitReached(Limit::Impacts), 3));
}

#[test]
fn what_is_out_of_range_is_declined() {
    let linear = Enclosure::new(Model::Linear);
    for refused in [case(1e-70, 2.0, 0.9), case(0.1, 1e-9, 0.9), case(0.1, 1e9, 0.9), case(0.1, 2.0, 1e-9)] {
        assert!(matches!(linear.enclose(&refused), Err(Decline::OutOfRange { .. })), "{refused:?}");
    }
    assert_eq!(Enclosure::new(Model::Nonlinear).enclose(&case(0.1, 2.0, 0.9)), Err(Decline::NeedsSlenderness));
    assert!(linear.with_digits(0).is_err() && linear.with_digits(Enclosure::MOST_DIGITS + 1).is_err());
    assert_eq!(linear.with_digits(30).unwrap().digits(), 30);
    for still in [-1.0, -0.5, 0.0] {
        assert_eq!(linear.enclose(&case(still, 2.0, 0.9)).unwrap().ending, Ending::NeverRocks);
    }
}

#[test]
fn it_tells_what_it_is_and_how_many_digits_it_has() {
    for (model, name) in [(Model::Linear, "enclosure/linear"), (Model::Nonlinear, "enclosure/nonlinear")] {
        let oracle = Enclosure::new(model);
        assert_eq!((oracle.name(), oracle.model(), oracle.digits()), (name, model, 17));
    }
    for digits in [1_u32, 12, 13, 30, 100] {
        let oracle = Enclosure::new(Model::Linear).with_digits(digits).unwrap();
        let enclosed = oracle.enclose(&case(0.01, 2.0, 0.5).with_max_impacts(3).unwrap()).unwrap();
        // log2(10) = 3.32 bits each; up to twelve digits doubles are tried first.
        let least = if digits > 12 { 3.32 * f64::from(digits) + 12.0 } else { 53.0 };
        assert!(oracle.digits() == digits && f64::from(enclosed.bits) >= least, "{digits}: {} bits", enclosed.bits);
        assert!(f64::from(enclosed.bits) < 2.0 * least + 64.0, "{digits}: {} bits", enclosed.bits);
    }
}

/// The middle of each interval and half its width, and no more than that and the rounding to doubles.
#[test]
fn a_history_claims_what_is_proven() {
    for digits in [5_u32, 12, 17] {
        let enclosed =
            Enclosure::new(Model::Linear).with_digits(digits).unwrap().enclose(&case(0.03, 2.0, 0.92)).unwrap();
        let history = enclosed.history();
        let check = |bounds: &Bounds, value: f64, claim: f64| {
            assert!(value - claim <= bounds.lower() && bounds.upper() <= value + claim, "{bounds:?}: {value} {claim}");
            let half = 0.5 * (bounds.upper() - bounds.lower());
            assert!(claim <= 1.01 * half + 4.0 * f64::EPSILON * value.abs(), "{bounds:?}: {value} {claim}");
        };
        assert_eq!((history.impacts.len(), history.ending), (enclosed.impacts.len(), enclosed.ending));
        for (impact, bounds) in history.impacts.iter().zip(&enclosed.impacts) {
            let claim = impact.uncertainty;
            check(&bounds.time, impact.time, claim.time);
            check(&bounds.interval, impact.interval, claim.interval * impact.interval);
            check(&bounds.velocity, impact.velocity, claim.velocity * impact.velocity.abs());
        }
        let (estimate, bounds) = (history.chattering_time.unwrap(), enclosed.chattering_time.unwrap());
        check(&bounds, estimate.value, estimate.uncertainty);
    }
}
