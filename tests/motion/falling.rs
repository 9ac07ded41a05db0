//! Overturning: decided by the ground as it moves and stops, and ended where the side of the block lies.

use std::f64::consts::{FRAC_PI_2, TAU};

use approx::assert_relative_eq;
use chattercheck::{
    motion::{
        response::{BoutEnd, Request, Response, Sample, State, Termination, Window},
        scene::Scene,
    },
    panel::{self, Settings},
};
use contract::{Case, Model, Normalisation, Oracle, Slenderness};

/// A motion with phase 0 that lasts so many cycles, of a block of slenderness `alpha`, or a slender one.
fn request(a: f64, omega: f64, alpha: Option<f64>, cycles: f64) -> Request {
    let case = Case::from_amplitude(a, omega, 0.9).unwrap();
    let case =
        alpha.map_or(case, |alpha| case.with_slenderness(Slenderness::new(alpha, Normalisation::Threshold).unwrap()));
    let request = Request::new(case, Some(cycles * TAU / omega), f64::INFINITY).unwrap();
    Request { phase: Some(0.0), ..request }
}

fn rows(oracle: &dyn Oracle, request: &Request) -> (Response, Vec<Sample>) {
    let response = Response::new(oracle, request).unwrap();
    let window = Window { from: 0.0, to: response.end, steps: 500 };
    let rows = response.samples(oracle, request, &window).unwrap();
    (response, rows)
}

fn overturns(oracle: &dyn Oracle, request: &Request) -> bool {
    let response = Response::new(oracle, request).unwrap();
    response.bouts.last().is_some_and(|bout| bout.outcome == BoutEnd::Overturned)
}

/// The smallest amplitude for which it holds, which it does at the upper end and not at the lower.
fn critical(mut low: f64, mut high: f64, tolerance: f64, holds: impl Fn(f64) -> bool) -> f64 {
    assert!(!holds(low) && holds(high));
    while high - low > tolerance {
        let middle = 0.5 * (low + high);
        if holds(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// `u + u'` at the end of a quarter of a cycle is 1 at a = 1.97010957, by Eq. 6.
#[test]
fn a_slender_block_overturns_from_the_amplitude_on_at_which_it_reaches_the_corner() {
    let stepper = panel::stepper();
    let found = critical(1.5, 2.5, 1e-10, |a| overturns(stepper.as_ref(), &request(a, 1.0, None, 0.25)));
    assert!((found - 1.970_109_57).abs() < 5e-9, "{found}");
    for oracle in [stepper, panel::one("ode/linear/tsit45", &Settings::default(), "linear").unwrap()] {
        let response = Response::new(oracle.as_ref(), &request(1.9, 1.0, None, 0.25)).unwrap();
        let bout = &response.bouts[0];
        assert_relative_eq!(bout.impact_times().next().unwrap(), 4.534_790_41, max_relative = 2e-9);
        assert!(matches!(bout.outcome, BoutEnd::Complete { .. }), "{:?}", bout.outcome);
    }
}

/// Eq. 2 from rest at the threshold to the end of the ground motion, by Runge and Kutta; `None` if the block is back before. Then whether its energy takes it over the
/// balance, where `φ'²/2 = (1 - cos(α(1 - u)))/α²` just does.
fn falls(a: f64, omega: f64, alpha: f64, cycles: f64) -> Option<bool> {
    let acceleration = |tau: f64, u: f64| {
        // The block turns to the negative side: i = -1, u = -φ.
        let angle = alpha * (1.0 - u);
        -(angle.sin() - alpha.tan() * a * (omega * tau).sin() * angle.cos()) / alpha
    };
    let (start, end) = ((1.0 / a).asin() / omega, cycles * TAU / omega);
    let steps = 4000;
    let h = (end - start) / f64::from(steps);
    let (mut u, mut w) = (0.0, 0.0);
    for step in 0..steps {
        let tau = start + f64::from(step) * h;
        let (k1, l1) = (w, acceleration(tau, u));
        let (k2, l2) = (w + 0.5 * h * l1, acceleration(tau + 0.5 * h, u + 0.5 * h * k1));
        let (k3, l3) = (w + 0.5 * h * l2, acceleration(tau + 0.5 * h, u + 0.5 * h * k2));
        let (k4, l4) = (w + h * l3, acceleration(tau + h, u + h * k3));
        u += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        w += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
        if step > 10 && u <= 0.0 {
            return None;
        }
    }
    let over = 0.5 * w * w > (1.0 - (alpha * (1.0 - u)).cos()) / (alpha * alpha);
    Some(if w > 0.0 { over || u > 1.0 } else { u > 1.0 && !over })
}

#[test]
fn the_block_as_it_is_overturns_from_the_amplitude_on_at_which_its_energy_takes_it_over() {
    for (omega, alpha, cycles) in [(1.0, 0.2, 0.25), (2.0, 0.5, 0.4), (0.7, 1.1, 0.3), (3.0, 0.1, 0.45)] {
        let oracle = panel::stepper_of(Model::Nonlinear);
        // What is back on its base before the ground stops loses energy there, and does not fall any more.
        let falls = |a: f64| falls(a, omega, alpha, cycles).unwrap_or(false);
        let high = (1..400).map(|k| 1.05 + 0.05 * f64::from(k)).find(|a| falls(*a)).unwrap();
        let expected = critical(1.05, high, 1e-9, falls);
        for (a, over) in [(expected - 1e-6, false), (expected + 1e-6, true)] {
            assert_eq!(
                overturns(oracle.as_ref(), &request(a, omega, Some(alpha), cycles)),
                over,
                "{omega} {alpha} {a}"
            );
        }
    }
}

/// Nothing turns further than its side lets it; there the response ends, at rest, whichever model and however strong the ground.
#[test]
fn a_block_that_overturns_ends_on_its_side() {
    let text = include_str!("../../data/scenes/found/lies_on_its_side.toml");
    for g in [0.9, 2.0, 4.0, 9.0] {
        for model in [Model::Linear, Model::Nonlinear] {
            let mut scene = Scene::parse(&text.replace("g = 2", &format!("g = {g}"))).unwrap();
            scene.ask.model = model;
            let request = scene.response(None, Termination::Exact).unwrap();
            let (response, rows) = rows(panel::stepper_of(scene.ask.model).as_ref(), &request);
            let flat = FRAC_PI_2 / scene.block.slenderness;
            assert!(rows.iter().all(|row| row.phi.abs() <= flat * (1.0 + 1e-12)), "{g} {model:?}");
            let [.., before, last] = &rows[..] else { panic!() };
            assert_eq!((last.state, last.tau, last.phi_velocity), (State::Lying, response.end, 0.0));
            assert_relative_eq!(last.phi.abs(), flat, max_relative = 1e-15);
            assert_eq!((before.state, before.tau), (State::Overturned, last.tau));
            assert_relative_eq!(before.phi, last.phi, max_relative = 1e-12);
            assert!(before.phi_velocity * last.phi > 0.0);
            assert_eq!(response.lying, Some(last.phi));
            assert_eq!(response.bouts.last().unwrap().outcome, BoutEnd::Overturned);
        }
    }
}

/// Without a slenderness the linear model does not know the side: it ends where the block passes its corner for good.
#[test]
fn a_slender_block_that_overturns_ends_at_its_corner() {
    let stepper = panel::stepper();
    // Before and after the ground has stopped, and in another lobe than the first.
    for (a, omega, cycles) in [(6.0, 1.0, 2.0), (1.9702, 1.0, 0.25), (8.0, 2.0, 0.5), (4.0, 0.6, 3.0), (2.2, 0.9, 5.0)]
    {
        let (response, rows) = rows(stepper.as_ref(), &request(a, omega, None, cycles));
        assert_eq!(response.bouts.last().unwrap().outcome, BoutEnd::Overturned, "{a}");
        let last = rows.last().unwrap();
        assert_eq!((last.state, response.lying), (State::Overturned, None));
        assert!((last.phi.abs() - 1.0).abs() < 1e-9 && last.phi * last.phi_velocity > 0.0, "{a}: {last:?}");
        assert_eq!(last.tau, response.end);
    }
}

/// What happens after the end of a response is not told, nor is the response ended later than that.
#[test]
fn a_response_that_is_cut_while_a_block_falls_ends_there() {
    for oracle in [panel::stepper(), panel::stepper_of(Model::Nonlinear)] {
        let whole = request(6.0, 1.0, Some(0.3), 2.0);
        let fall = Response::new(oracle.as_ref(), &whole).unwrap();
        assert_eq!(fall.bouts[0].outcome, BoutEnd::Overturned);
        let begin = fall.bouts[0].begin();
        for share in [0.1, 0.5, 0.9, 0.99, 0.9999] {
            let until = begin + share * (fall.end - begin);
            let (cut, rows) = rows(oracle.as_ref(), &Request { until, ..whole });
            assert_relative_eq!(cut.end, until, max_relative = 1e-15);
            assert!(rows.iter().all(|row| row.tau <= cut.end && row.state != State::Lying));
            assert!(matches!(cut.bouts[0].outcome, BoutEnd::Cut | BoutEnd::Overturned));
            assert_eq!(cut.lying, None);
        }
    }
}
