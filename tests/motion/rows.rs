//! What is true of the rows of every response, whatever the scene.

use std::f64::consts::{PI, TAU};

use chattercheck::{
    motion::response::{Bout, BoutEnd, Request, Response, Sample, State, Window},
    panel,
};
use contract::{Case, Model, Normalisation, Oracle, Slenderness};
use proptest::{prelude::*, test_runner::RngSeed};

const ALPHA: f64 = 0.3;

/// A motion of any strength, from below the threshold to where the block falls, that starts and ends anywhere.
fn requests() -> impl Strategy<Value = Request> {
    let amplitudes = prop_oneof![0.0..1.0f64, 1.0..1.06f64, 1.0..4.0f64];
    (amplitudes, 0.4..6.0f64, 0.4..0.97f64, 0.0..TAU, 0.1..3.0f64, any::<bool>()).prop_map(
        |(a, omega, eta, phase, cycles, shifted)| {
            let slenderness = Slenderness::new(ALPHA, Normalisation::Threshold).unwrap();
            let case = Case::from_amplitude(a, omega, eta).unwrap().with_slenderness(slenderness);
            let request = Request::new(case, Some(cycles * TAU / omega), f64::INFINITY).unwrap();
            Request { phase: shifted.then_some(phase), ..request }
        },
    )
}

fn steppers() -> [Box<dyn Oracle>; 2] {
    [Model::Linear, Model::Nonlinear].map(panel::stepper_of)
}

fn rows(oracle: &dyn Oracle, request: &Request, steps: usize) -> (Response, Vec<Sample>) {
    let response = Response::new(oracle, request).unwrap();
    let window = Window { from: 0.0, to: response.end, steps };
    let rows = response.samples(oracle, request, &window).unwrap();
    (response, rows)
}

/// `φ'²/2` and what lifting the block takes.
fn energy(model: Model, row: &Sample) -> f64 {
    let u = row.phi.abs();
    let lifted = match model {
        Model::Linear => u * (1.0 - 0.5 * u),
        Model::Nonlinear => ((ALPHA * (1.0 - u)).cos() - ALPHA.cos()) / (ALPHA * ALPHA),
    };
    0.5 * row.phi_velocity * row.phi_velocity + lifted
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    /// Time never decreases, an impact has one time, and it is the one that the impacts are listed with.
    #[test]
    fn time_never_decreases_and_an_impact_has_one(request in requests(), steps in 50..2000usize) {
        for oracle in steppers() {
            let (response, rows) = rows(oracle.as_ref(), &request, steps);
            prop_assert!(rows.windows(2).all(|two| two[0].tau <= two[1].tau));
            prop_assert!(rows.iter().all(|row| (0.0..=response.end).contains(&row.tau)));
            let impacts: Vec<f64> = response.bouts.iter().flat_map(Bout::impact_times).collect();
            prop_assert!(impacts.windows(2).all(|two| two[0] <= two[1]));
            for two in rows.windows(2) {
                // Just before an impact the block moves to its base and just after it away from it.
                let [before, after] = two else { continue };
                let is_impact = before.phi == 0.0 && before.state == State::Rocking && before.phi_velocity != 0.0
                    && after.state == State::Rocking;
                if is_impact && before.phi_velocity * after.phi_velocity > 0.0 && after.phi == 0.0 {
                    prop_assert!(before.tau == after.tau || after.tau - before.tau > 0.0);
                    prop_assert!(impacts.binary_search_by(|time| time.total_cmp(&before.tau)).is_ok(), "{}", before.tau);
                }
            }
        }
    }

    /// Rests and times of rocking follow each other without a gap, from the start of the motion to the end of the response.
    #[test]
    fn rests_and_rocking_tile_the_time(request in requests()) {
        for oracle in steppers() {
            let (response, rows) = rows(oracle.as_ref(), &request, 100);
            let rocking = response.bouts.iter().map(|bout| (bout.begin(), bout.end()));
            let mut parts: Vec<(f64, f64)> = rocking.chain(response.rests()).collect();
            parts.sort_by(|one, other| one.0.total_cmp(&other.0));
            let mut now = 0.0;
            for (from, to) in parts {
                prop_assert_eq!(from, now);
                prop_assert!(to > from);
                now = to;
            }
            prop_assert_eq!(now, response.end);
            prop_assert!(response.end == 0.0 || rows.last().unwrap().tau > response.end * (1.0 - 1e-6));
        }
    }

    /// The ground does what the request says while it lasts, and nothing after it; and the block never turns through the ground.
    #[test]
    fn the_ground_is_the_sinusoid_and_is_not_entered(request in requests()) {
        let (a, omega) = (request.case.amplitude(), request.case.omega());
        let phase = request.phase.unwrap_or_else(|| if a > 1.0 { (1.0 / a).asin() } else { PI / 2.0 });
        let lasts = request.lasts.unwrap();
        for oracle in steppers() {
            for row in rows(oracle.as_ref(), &request, 200).1 {
                let moving = a * (omega * row.tau + phase).sin();
                // The two rows of the time at which it stops are of before and after.
                let is = |ground: f64| (row.ground_acceleration - ground).abs() < 1e-12 * (1.0 + a);
                let near = (row.tau - lasts).abs() < 1e-12 * lasts;
                prop_assert!(if near { is(moving) || is(0.0) } else { is(if row.tau < lasts { moving } else { 0.0 }) }, "{row:?}");
                prop_assert!(row.phi.abs() <= request.lies_at.unwrap() * (1.0 + 1e-12));
                prop_assert!(row.state != State::Rest || (row.phi == 0.0 && row.phi_velocity == 0.0));
            }
        }
    }

    /// Ground at rest gives a block no energy.
    #[test]
    fn energy_on_still_ground_never_grows(request in requests()) {
        for oracle in steppers() {
            let lasts = request.lasts.unwrap();
            let (_, rows) = rows(oracle.as_ref(), &request, 300);
            let still: Vec<f64> =
                rows.iter().filter(|row| row.tau > lasts).map(|row| energy(oracle.model(), row)).collect();
            prop_assert!(still.windows(2).all(|two| two[1] <= two[0] + 1e-11), "{still:?}");
        }
    }

    /// Half a turn of the phase is the mirror image: the same times, and every rotation with the other sign.
    #[test]
    fn half_a_turn_of_the_phase_is_the_mirror_image(request in requests()) {
        let phase = request.phase.unwrap_or(0.7);
        for oracle in steppers() {
            let (here, _) = rows(oracle.as_ref(), &Request { phase: Some(phase), ..request }, 50);
            let (there, _) = rows(oracle.as_ref(), &Request { phase: Some(phase + PI), ..request }, 50);
            prop_assert_eq!(here.lying.map(|rotation| -rotation), there.lying);
            prop_assert_eq!(here.bouts.len(), there.bouts.len());
            for (one, other) in here.bouts.iter().zip(&there.bouts) {
                if one.is_unsure() || other.is_unsure() {
                    break;
                }
                prop_assert_eq!(one.outcome.name(), other.outcome.name());
                // A phase of half a turn more is rounded once more.
                let allowed = 100.0 * (one.uncertainty() + other.uncertainty()) + 1e-9;
                prop_assert!((one.end() - other.end()).abs() <= allowed, "{} {}", one.end(), other.end());
                let sides = |bout: &Bout| bout.flights.first().map(|flight| bout.lobe.mirror * flight.departure.side);
                prop_assert_eq!(sides(one).map(|side| -side), sides(other));
            }
        }
    }
}

/// A block that does not rock is told about for as long as the ground moves, and not longer.
#[test]
fn below_the_threshold_there_is_the_motion_of_the_ground() {
    for a in [0.0, 0.3, 0.99, 1.0] {
        let case = Case::from_amplitude(a, 2.0, 0.9).unwrap();
        let request = Request { phase: Some(0.4), ..Request::new(case, Some(7.0), f64::INFINITY).unwrap() };
        for (request, end) in
            [(request, 7.0), (Request { until: 3.0, ..request }, 3.0), (Request { until: 30.0, ..request }, 7.0)]
        {
            let (response, rows) = rows(panel::stepper().as_ref(), &request, 40);
            assert_eq!((response.end, response.bouts.len(), rows[0].tau), (end, 0, 0.0));
            assert_eq!(rows[0].ground_acceleration, case.amplitude() * 0.4_f64.sin());
            assert_eq!(rows.last().unwrap().tau, end);
            assert!(rows.iter().all(|row| row.state == State::Rest));
        }
    }
}

/// Fig. 9, where time ran backwards 17 times.
#[test]
fn the_rows_of_fig_9_are_in_order() {
    let scene = chattercheck::motion::scene::Scene::parse(include_str!("../../data/scenes/paper_fig_9.toml")).unwrap();
    let request = scene.response(None, chattercheck::motion::response::Termination::Exact).unwrap();
    for steps in [200, 1000, 20_000] {
        let (response, rows) = rows(panel::stepper_of(scene.ask.model).as_ref(), &request, steps);
        assert!(rows.windows(2).all(|two| two[0].tau <= two[1].tau));
        assert!(response.bouts.iter().all(|bout| matches!(bout.outcome, BoutEnd::Complete { .. })));
        let times: Vec<f64> = response.bouts.iter().flat_map(Bout::impact_times).collect();
        let ends = rows.iter().filter(|row| row.phi == 0.0 && row.phi_velocity != 0.0);
        assert!(ends.clone().count() > 100);
        let known = |tau: &f64| times.binary_search_by(|time| time.total_cmp(tau)).is_ok();
        assert!(ends.map(|row| row.tau).all(|tau| known(&tau)), "rows of impacts at other times than the impacts");
    }
}
