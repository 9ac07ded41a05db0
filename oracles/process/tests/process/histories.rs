//! Answers become histories, and wrong numbers stay what they are.

use contract::{Case, Decline, Ending, Estimate, Limit, Model, Normalisation, Oracle, Slenderness};
use process::{Claimed, Engine, Outcome, Tolerance};

use crate::common::{case, engine, launch};

const TOLERANCE: Tolerance = Tolerance { time: 1e-9, interval: 1e-8, velocity: 1e-7, tau_ch: 1e-6 };

fn tolerant(how: &str) -> Engine {
    let mut launch = launch(how);
    launch.tolerance = TOLERANCE;
    Engine::start(launch, None).unwrap()
}

/// The doubles of the engine arrive bit for bit, with the user's tolerance where it claims nothing.
#[test]
fn a_history_arrives_bit_for_bit() {
    for how in ["well", "own-field", "carriage-returns"] {
        let answer = tolerant(how).answer(&case(0.9));
        let history = answer.told().unwrap();
        assert_eq!(history.ending, Ending::LimitReached(Limit::Impacts));
        assert_eq!(history.impacts.len(), 4);
        let (mut time, mut interval) = (0.0, 0.625);
        for impact in &history.impacts {
            time += interval;
            assert_eq!((impact.time, impact.interval, impact.velocity.abs()), (time, interval, interval / 3.0));
            interval *= 0.9 * 0.9;
            let granted = impact.uncertainty;
            assert_eq!([granted.time, granted.interval, granted.velocity], [1e-9, 1e-8, 1e-7]);
        }
        assert_eq!((answer.claimed, answer.intervals_from_times, answer.ns), (Claimed::default(), false, Some(1500.0)));
    }
}

#[test]
fn a_claim_stands_before_the_tolerance() {
    let answer = tolerant("claims").answer(&case(0.9));
    let history = answer.told().unwrap();
    assert_eq!(answer.claimed, Claimed { time: true, interval: true, velocity: false, tau_ch: true });
    assert_eq!(history.chattering_time, Some(Estimate { value: 2.5, uncertainty: 1e-8 }));
    for impact in &history.impacts {
        let claimed = impact.uncertainty;
        assert_eq!([claimed.time, claimed.interval, claimed.velocity], [impact.interval, 1e-12, 1e-7]);
    }
}

/// Intervals that are differences of times carry the rounding of these.
#[test]
fn differences_of_times_say_what_they_cost() {
    let answer = tolerant("no-interval").answer(&case(0.5).with_max_impacts(26).unwrap());
    assert!(answer.intervals_from_times);
    let impacts = answer.told().unwrap().impacts;
    assert_eq!(impacts[0].interval, impacts[0].time);
    let [.., before, last] = impacts.as_slice() else { panic!() };
    assert_eq!(last.interval, last.time - before.time);
    // The last interval is 0.625/4^25 = 5.55e-16: it has no digit left, and says so.
    let lost = f64::EPSILON * last.time / last.interval;
    let cost = last.uncertainty.interval;
    assert!(cost > 0.1 && (cost - 1e-8 - lost).abs() < 0.01 * lost, "{cost} {lost}");
}

#[test]
fn hexadecimal_numbers_are_read() {
    let case = Case::from_epsilon(0.0, 2.0, 0.5).unwrap().with_max_impacts(2).unwrap();
    assert_eq!(engine("hexadecimal").history(&case).unwrap().impacts[0].time, 0.5);
}

/// Wrong numbers are a wrong answer, for the gate to judge, and no broken line.
#[test]
fn wrong_numbers_are_passed_on() {
    assert!(engine("quoted-nan").history(&case(0.9)).unwrap().impacts[0].time.is_nan());
    let falling = engine("falling-times").history(&case(0.9)).unwrap().impacts;
    assert!(falling[1].time < falling[0].time);
    assert!(engine("negative-interval").history(&case(0.9)).unwrap().impacts[1].interval < 0.0);
}

#[test]
fn a_refusal_is_no_breakdown() {
    let decline = engine("declines").history(&case(0.9)).unwrap_err();
    assert_eq!((decline.reason(), decline.is_breakdown()), ("eta too large", false));
    assert_eq!(decline.to_string(), "eta too large: eta = 0.9");
}

/// A case that the engine has no words for is not even asked.
#[test]
fn what_is_not_offered_is_not_asked() {
    let mut nonlinear = launch("silent");
    nonlinear.model = Model::Nonlinear;
    let engine = Engine::start(nonlinear, None).unwrap();
    assert_eq!(engine.history(&case(0.9)), Err(Decline::NeedsSlenderness));
    let slender = case(0.9).with_slenderness(Slenderness::new(0.2, Normalisation::Slender).unwrap());
    assert_eq!(engine.history(&slender).unwrap_err().reason(), "unsupported");
    engine.ask_all(&[slender]);
    assert!(matches!(engine.answer(&slender).outcome, Outcome::Declined(_)));
    assert_eq!(engine.breaks(), 0);
}

/// An engine should look at which model it is asked; whoever does is asked what it does not offer, and declines.
#[test]
fn the_other_model_can_be_asked() {
    let decline = engine("declines").answer_to_the_other_model(&case(0.9)).told().unwrap_err();
    assert!(!decline.is_breakdown());
    // This one answers whatever it is asked.
    assert!(engine("well").answer_to_the_other_model(&case(0.9)).told().is_ok());
}
