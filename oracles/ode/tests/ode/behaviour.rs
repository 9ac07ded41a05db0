//! How histories end, what is declined, and that nothing is lost or made up.

use crate::common::{Random, case, impacts, linear};
use crate::effort::pick;
use contract::{Case, Decline, Ending, Horizon, Impact, Limit, Loss, Model, Normalisation, Oracle, Slenderness};
use ode::{Equation, Flights, Ode, Restart, Solver};

#[test]
fn nothing_is_lost() {
    for (method, cases) in [(Solver::Tsit45, 1000), (Solver::Esdirk34, 200), (Solver::Bdf, 200), (Solver::TrBdf2, 100)]
    {
        let ode = linear(method);
        let mut random = Random(1);
        for _ in 0..pick("random cases", cases / 2, cases) {
            let case = random.case();
            let history = impacts(&ode, &case);
            match history.ending {
                Ending::AtRest | Ending::LimitReached(Limit::Impacts) => assert_eq!(history.impacts.len(), 60),
                Ending::Incomplete => assert!(case.amplitude() > 1.02 && case.eta() > 0.9, "{case:?}"),
                other => panic!("{method}, {case:?}: {other}"),
            }
            let mut sign = 1.0;
            for impact in &history.impacts {
                assert!(impact.interval > 0.0 && impact.velocity * sign > 0.0, "{method} {case:?} {impact:?}");
                sign = -sign;
            }
        }
    }
}

#[test]
fn the_methods_agree_on_the_endings_of_odd_cases() {
    let mut random = Random(2);
    for _ in 0..100 {
        let epsilon = 10_f64.powf(random.between(-30.0, 6.0));
        let omega = 10_f64.powf(random.between(-5.9, 5.9));
        let slenderness = Slenderness::new(random.between(0.01, 1.5), Normalisation::Threshold).unwrap();
        let case =
            Case::from_epsilon(epsilon, omega, random.between(0.05, 0.99)).unwrap().with_slenderness(slenderness);
        let case = case.with_horizon(Horizon::Until(10_f64.powf(random.between(-1.0, 1.5)) / omega)).unwrap();
        for equation in [Equation::Linear, Equation::Nonlinear] {
            let [first, rest @ ..] = Solver::ALL.map(|method| impacts(&Ode::new(equation, method), &case));
            assert!(!matches!(first.ending, Ending::Lost(_)), "{case:?}: {}", first.ending);
            for other in rest {
                assert_eq!((first.ending, first.impacts.len()), (other.ending, other.impacts.len()), "{case:?}");
            }
        }
    }
}

#[test]
fn never_rocks_at_or_below_the_threshold() {
    for a in [0.0, 0.5, 1.0] {
        let history = linear(Solver::Tsit45).history(&case(a, 2.0, 0.92)).unwrap();
        assert_eq!((history.ending, history.impacts.len()), (Ending::NeverRocks, 0));
    }
    // tan(0.2)/0.2 = 1.0136: above the threshold of one normalisation, below that of the other.
    let block = |normalisation| Slenderness::new(0.2, normalisation).unwrap();
    let ode = Ode::new(Equation::Nonlinear, Solver::Tsit45);
    let slender = impacts(&ode, &case(1.01, 2.0, 0.92).with_slenderness(block(Normalisation::Slender)));
    assert_eq!(slender.ending, Ending::NeverRocks);
    let threshold = impacts(&ode, &case(1.01, 2.0, 0.92).with_slenderness(block(Normalisation::Threshold)));
    assert_eq!((threshold.ending, threshold.impacts.len()), (Ending::AtRest, 60));
}

#[test]
fn declines_what_it_cannot_do() {
    let nonlinear = Ode::new(Equation::Nonlinear, Solver::Tsit45);
    assert_eq!(nonlinear.history(&case(1.03, 2.0, 0.92)), Err(Decline::NeedsSlenderness));
    for case in [case(1.03, 1e-7, 0.92), case(1.03, 1e7, 0.92), Case::from_epsilon(1e-70, 2.0, 0.92).unwrap()] {
        assert!(matches!(linear(Solver::Bdf).history(&case), Err(Decline::OutOfRange { .. })), "{case:?}");
    }
}

#[test]
fn refuses_tolerances_and_names_outside_the_range() {
    for rtol in [0.0, -1e-9, 1e-14, 0.1, f64::NAN, f64::INFINITY] {
        assert!(linear(Solver::Tsit45).with_rtol(rtol).is_err(), "{rtol}");
    }
    for rtol in [1e-13, 1e-2] {
        let ode = linear(Solver::Tsit45).with_rtol(rtol).unwrap();
        assert_eq!(ode.rtol(), rtol);
        assert!(!matches!(impacts(&ode, &case(1.01, 2.0, 0.9)).ending, Ending::Lost(_)));
    }
    for method in Solver::ALL {
        assert_eq!(method.name().parse::<Solver>(), Ok(method));
    }
    assert!("rk4".parse::<Solver>().is_err());
}

#[test]
fn names_say_what_is_solved() {
    let ode = Ode::new(Equation::Nonlinear, Solver::TrBdf2);
    assert_eq!((ode.name(), ode.model()), ("ode/nonlinear/tr-bdf2", Model::Nonlinear));
    let ode = linear(Solver::Tsit45).with_flights(Flights::Naive);
    assert_eq!((ode.name(), ode.model()), ("ode/linear/tsit45/naive", Model::Linear));
    assert_eq!(ode.with_flights(Flights::Rescaled).name(), "ode/linear/tsit45");
}

#[test]
fn incomplete_chattering_lists_the_impacts_before_half_a_period() {
    for method in Solver::ALL {
        let history = linear(method).history(&case(1.05, 2.0, 0.92)).unwrap();
        assert_eq!((history.ending, history.impacts.len()), (Ending::Incomplete, 15), "{method}");
        assert!(history.impacts.last().is_some_and(|last| last.time < core::f64::consts::FRAC_PI_2));
    }
}

#[test]
fn the_horizon_can_lie_before_and_past_half_a_period() {
    let half = core::f64::consts::FRAC_PI_2;
    let until = |tau| {
        let case = case(1.05, 2.0, 0.92).with_horizon(Horizon::Until(tau)).unwrap().with_max_impacts(500).unwrap();
        impacts(&linear(Solver::Tsit45), &case)
    };
    let short = until(0.65);
    assert_eq!((short.ending, short.impacts.len()), (Ending::LimitReached(Limit::Time), 1));
    let (at_half, past) = (until(half), until(4.0 * half));
    assert_eq!((at_half.ending, at_half.impacts.len()), (Ending::LimitReached(Limit::Time), 15));
    assert_eq!(past.ending, Ending::LimitReached(Limit::Time));
    assert_eq!(at_half.impacts[..], past.impacts[..15]);
    assert!(past.impacts.iter().filter(|impact| impact.time > half).count() > 10, "{}", past.impacts.len());
}

#[test]
fn large_amplitudes_overturn_the_block() {
    let block = Slenderness::new(0.2, Normalisation::Threshold).unwrap();
    for equation in [Equation::Linear, Equation::Nonlinear] {
        for method in Solver::ALL {
            let case = case(20.0, 0.5, 0.9).with_slenderness(block);
            assert_eq!(impacts(&Ode::new(equation, method), &case).ending, Ending::Overturned, "{method}");
        }
    }
}

#[test]
fn at_rest_needs_certainty() {
    let after = |n| impacts(&linear(Solver::Tsit45), &case(1.03, 2.0, 0.92).with_max_impacts(n).unwrap()).ending;
    assert_eq!(after(1), Ending::LimitReached(Limit::Impacts));
    assert_eq!(after(10), Ending::LimitReached(Limit::Impacts));
    assert_eq!(after(200), Ending::AtRest);
}

#[test]
fn claims_grow_towards_the_critical_amplitude() {
    // a_cr = 1.0380155387 at omega = 2, eta = 0.92.
    let worst = |a| {
        let history = linear(Solver::Tsit45).history(&case(a, 2.0, 0.92).with_max_impacts(400).unwrap()).unwrap();
        history.impacts.iter().map(|impact| impact.uncertainty.interval).fold(0.0, f64::max)
    };
    let claims = [1.03, 1.038, 1.038_015_5].map(worst);
    assert!(claims.is_sorted() && claims[2] > 100.0 * claims[0], "{claims:?}");
}

#[test]
fn on_the_global_clock_the_sequence_is_lost_at_depth() {
    let deep = case(1.03, 2.0, 0.92).with_max_impacts(450).unwrap();
    let truth = impacts(&linear(Solver::Tsit45), &deep);
    for method in Solver::ALL {
        let naive = linear(method).with_flights(Flights::Naive).history(&deep).unwrap();
        assert!(naive.impacts.len() > 10, "{method} does the first impacts");
        let lost = matches!(naive.ending, Ending::Lost(_));
        let wrong =
            naive.impacts.iter().zip(&truth.impacts).rposition(|(n, t)| (n.interval / t.interval - 1.0).abs() > 0.5);
        assert!(lost || wrong.is_some(), "{method}: {} after {}", naive.ending, naive.impacts.len());
        // Where it is wrong without knowing, its own claim gives it away.
        for (found, truth) in naive.impacts.iter().zip(&truth.impacts) {
            let error = (found.interval / truth.interval - 1.0).abs();
            assert!(error < 0.5 || found.uncertainty.interval > 0.5, "{method} {found:?} {truth:?}");
        }
    }
}

#[test]
fn on_the_global_clock_every_way_to_start_a_flight_fails_in_its_own_way() {
    let case = case(1.03, 2.0, 0.92).with_max_impacts(400).unwrap();
    let truth = linear(Solver::Tsit45).impacts(&case).unwrap().impacts;
    let naive =
        |restart| linear(Solver::Tsit45).with_flights(Flights::Naive).with_restart(restart).impacts(&case).unwrap();
    let resolved = |impacts: &[Impact]| {
        let pairs = impacts.iter().zip(&truth);
        pairs.take_while(|(found, truth)| (found.interval / truth.interval - 1.0).abs() < 0.01).count()
    };
    let [zero, lifted, old] = [Restart::Zero, Restart::Lifted(1e-12), Restart::OldStep].map(naive);
    assert!((200..300).contains(&resolved(&zero.impacts)), "{}", resolved(&zero.impacts));
    // Lifted, it rattles on without an error, at intervals that no longer shrink.
    assert!((50..150).contains(&resolved(&lifted.impacts)), "{}", resolved(&lifted.impacts));
    assert!(
        matches!(lifted.impacts[..], [.., a, _, b] if lifted.impacts.len() > 200 && (a.interval / b.interval - 1.0).abs() < 0.01)
    );
    // With the step from before the impact it soon steps over a whole flight.
    assert!(resolved(&old.impacts) < 50, "{}", resolved(&old.impacts));
    assert_eq!(old.ending, Ending::Lost(Loss::FellThrough));
}

#[test]
fn what_a_history_costs_is_counted() {
    let case = case(1.03, 2.0, 0.92);
    for method in Solver::ALL {
        let (fine, coarse) = (linear(method), linear(method).with_rtol(1e-4).unwrap());
        let [counted, cheap] = [&fine, &coarse].map(|ode| ode.counted(&case).unwrap());
        assert_eq!(counted.history, fine.impacts(&case).unwrap(), "{method}: counting changes nothing");
        assert!(counted.evaluations > cheap.evaluations && cheap.evaluations >= 60, "{method}");
    }
}

#[test]
fn on_the_global_clock_odd_cases_neither_panic_nor_hang() {
    let mut random = Random(3);
    for _ in 0..60 {
        let epsilon = 10_f64.powf(random.between(-40.0, 4.0));
        let omega = 10_f64.powf(random.between(-3.0, 3.0));
        let case = Case::from_epsilon(epsilon, omega, random.between(0.05, 0.99)).unwrap();
        for method in Solver::ALL {
            let ode = linear(method).with_flights(Flights::Naive);
            for impact in impacts(&ode, &case).impacts {
                assert!(impact.interval > 0.0 && impact.time.is_finite() && impact.velocity != 0.0);
            }
        }
    }
}

/// Rotations, of the order of the square of an interval, would come near the smallest double.
#[test]
fn impacts_end_where_the_intervals_have_nothing_left_to_resolve() {
    for eta in [0.5, 0.2] {
        let case = case(1.01, 2.0, eta).with_max_impacts(3000).unwrap();
        let history = impacts(&linear(Solver::Tsit45), &case);
        let [before @ .., last] = &history.impacts[..] else { panic!("no impacts") };
        assert_eq!(history.ending, Ending::AtRest);
        assert!(last.interval < 1e-140 && before.iter().all(|impact| impact.interval >= 1e-140), "{last:?}");
    }
}

#[test]
fn what_was_asked_for_is_told() {
    let ode = Ode::new(Equation::Nonlinear, Solver::Bdf).with_rtol(1e-7).unwrap().with_flights(Flights::Naive);
    assert_eq!((ode.equation(), ode.method(), ode.flights()), (Equation::Nonlinear, Solver::Bdf, Flights::Naive));
    assert_eq!((ode.rtol(), Solver::TrBdf2.to_string().as_str()), (1e-7, "tr-bdf2"));
}

/// While the clock still shows the flights it does the same as their own units do, and it ends as they do.
#[test]
fn on_the_global_clock_the_first_impacts_and_the_endings_are_right() {
    let half = core::f64::consts::FRAC_PI_2;
    let until = |tau| case(1.05, 2.0, 0.92).with_horizon(Horizon::Until(tau)).unwrap();
    let blocks = [case(1.03, 2.0, 0.92).with_max_impacts(8).unwrap(), case(1.05, 2.0, 0.92), until(0.65), until(half)];
    for case in blocks.into_iter().chain([case(20.0, 0.5, 0.9), case(1.02, 6.0, 0.8).with_max_impacts(6).unwrap()]) {
        let truth = impacts(&linear(Solver::Tsit45), &case);
        for (method, error) in
            [(Solver::Tsit45, 1e-6), (Solver::Bdf, 1e-2), (Solver::TrBdf2, 3e-2), (Solver::Esdirk34, 1e-4)]
        {
            let naive = impacts(&linear(method).with_flights(Flights::Naive), &case);
            assert_eq!((naive.ending, naive.impacts.len()), (truth.ending, truth.impacts.len()), "{method} {case:?}");
            for (found, truth) in naive.impacts.iter().zip(&truth.impacts) {
                let off = |found: f64, truth: f64| (found / truth - 1.0).abs();
                let worst = off(found.interval, truth.interval).max(off(found.velocity, truth.velocity));
                assert!(worst < error, "{method} {case:?}: {found:?} {truth:?}");
            }
        }
    }
}
