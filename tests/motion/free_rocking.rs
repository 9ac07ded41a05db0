//! Free rocking after the ground has come to rest: its infinite sum, however slowly it falls; and what is not known of it is not said.

use approx::assert_relative_eq;
use chattercheck::{
    motion::{
        response::{BoutEnd, Request, Response, Termination},
        scene::Scene,
    },
    panel::{self, Settings},
};
use contract::{Case, Model, Normalisation, Slenderness};

const SCENE: &str = include_str!("../../data/scenes/found/hardly_damped.toml");

/// One cycle of `1.5 sin(4 τ)`, and free rocking that loses a ten thousandth of its speed at an impact: calculated once with 30 digits.
const RESTS_AT: f64 = 20_075.896_946_342_1;

fn request() -> Request {
    Scene::parse(SCENE).unwrap().response(None, Termination::Exact).unwrap()
}

#[test]
fn hardly_damped_rocking_ends_when_its_sum_does() {
    let response = Response::new(panel::stepper().as_ref(), &request()).unwrap();
    let bout = &response.bouts[0];
    let off = (bout.end() - RESTS_AT).abs();
    assert!(off <= bout.uncertainty() && off < 1e-9, "{off} {}", bout.uncertainty());
    assert!(bout.uncertainty() < 1e-6);
    assert!(!bout.is_unsure() && bout.ending() == "complete");
    // It is followed as well, until nothing is left to be seen, and not past its end.
    assert!(bout.impacts() > 200_000);
    assert!(bout.flights.last().unwrap().end <= bout.duration);
}

/// Eq. 2 on ground at rest is summed in its own way; a slender block is Eq. 4.
#[test]
fn the_block_as_it_is_rocks_as_long_as_a_slender_one_if_it_is_slender() {
    let Request { case, .. } = request();
    let slenderness = Slenderness::new(1e-3, Normalisation::Threshold).unwrap();
    let request = Request { case: case.with_slenderness(slenderness), ..request() };
    let response = Response::new(panel::stepper_of(Model::Nonlinear).as_ref(), &request).unwrap();
    assert_relative_eq!(response.bouts[0].end(), RESTS_AT, max_relative = 2e-6);
    assert!(response.bouts[0].uncertainty() < 1e-5);
}

/// A solver that only flies can't know the end of such a sum from some impacts, and that is said.
#[test]
fn what_is_not_known_is_called_unsure() {
    let ode = panel::one("ode/linear/tsit45", &Settings::default(), "linear").unwrap();
    let request = Request { case: Case::from_amplitude(1.5, 4.0, 0.999).unwrap(), ..request() };
    let by_flights = Response::new(ode.as_ref(), &request).unwrap();
    let known = Response::new(panel::stepper().as_ref(), &request).unwrap();
    let (bout, known) = (&by_flights.bouts[0], &known.bouts[0]);
    assert!(matches!(bout.outcome, BoutEnd::Complete { .. }));
    let off = (bout.end() - known.end()).abs();
    assert!(off <= bout.uncertainty(), "{off} {}", bout.uncertainty());
    assert_eq!(bout.ending(), if bout.uncertainty() > 1e-3 * bout.duration { "unsure" } else { "complete" });
}
