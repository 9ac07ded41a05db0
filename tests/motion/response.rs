//! Whole responses: the laws that they obey, and what the command makes of scenes.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use assert_cmd::Command;
use chattercheck::{
    motion::{
        response::{BoutEnd, Request, Response, Sample, State, Termination, Window},
        scene::Scene,
    },
    panel::{self, Settings},
    studies::chattering_threshold::{Condition, chattering_threshold},
};
use contract::{Arrival, Case, Ground, Horizon, Normalisation, Oracle, Slenderness};
use proptest::{prelude::*, test_runner::RngSeed};

fn oracle(name: &str) -> Box<dyn Oracle> {
    panel::one(name, &Settings::default(), "nonlinear").unwrap()
}

fn both() -> [Box<dyn Oracle>; 2] {
    [oracle("closed-form"), oracle("taylor")]
}

fn case(epsilon: f64, omega: f64, eta: f64) -> Case {
    let slenderness = Slenderness::new(0.2, Normalisation::Threshold).unwrap();
    Case::from_epsilon(epsilon, omega, eta).unwrap().with_slenderness(slenderness)
}

/// A motion of `cycles` that starts at the threshold.
fn request(epsilon: f64, omega: f64, eta: f64, cycles: f64) -> Request {
    Request::new(case(epsilon, omega, eta), Some(cycles * TAU / omega), f64::INFINITY).unwrap()
}

fn respond(oracle: &dyn Oracle, request: &Request) -> Response {
    Response::new(oracle, request).unwrap()
}

fn rows(oracle: &dyn Oracle, request: &Request, response: &Response, steps: usize) -> Vec<Sample> {
    response.samples(oracle, request, &Window { from: 0.0, to: response.end, steps }).unwrap()
}

/// The first bout is the history of the case, and its end the chattering time, which the enclosure proves.
#[test]
fn the_first_bout_is_the_history_of_the_case() {
    for (oracle, judge) in both().iter().zip(panel::judges()) {
        for (epsilon, omega, eta) in [(0.03, 2.0, 0.92), (0.01, 5.0, 0.92), (0.06, 1.3, 0.8)] {
            let request = request(epsilon, omega, eta, 2.5);
            let bout = &respond(oracle.as_ref(), &request).bouts[0];
            let history = oracle.history(&request.case.with_max_impacts(400).unwrap()).unwrap();
            assert!(bout.impacts() > 30 && bout.impacts() <= history.impacts.len());
            for (time, expected) in bout.impact_times().zip(&history.impacts) {
                assert_relative_eq!(time, expected.time, max_relative = 1e-13);
            }
            let BoutEnd::Complete { uncertainty } = bout.outcome else { panic!("{:?}", bout.outcome) };
            let proven = judge.history(&request.case.with_max_impacts(60).unwrap()).unwrap().chattering_time.unwrap();
            // The linear stepper's own rounding is not in the estimate for the closed sum: 1e-14 is ample for it.
            let off = (bout.end() - proven.value).abs();
            assert!(off <= uncertainty + proven.uncertainty + 1e-14, "{}: {off}", oracle.name());
        }
    }
}

/// Incomplete chattering goes on over `T/2` and beyond, as an independent method says: diffsol.
#[test]
fn incomplete_chattering_goes_on_as_the_ode_solvers_say() {
    for (oracle, ode) in both().iter().zip(["ode/linear/tsit45", "ode/nonlinear/tsit45"]) {
        let request = request(0.05, 2.0, 0.92, 2.5);
        let response = respond(oracle.as_ref(), &request);
        assert_eq!(response.bouts.len(), 1, "it never rests while the ground moves");
        let until = 2.4 * PI;
        let case = request.case.with_horizon(Horizon::Until(until)).unwrap().with_max_impacts(1000).unwrap();
        let history = panel::one(ode, &Settings::default(), "linear").unwrap().history(&case).unwrap();
        let times: Vec<f64> = response.bouts[0].impact_times().collect();
        let before = times.iter().filter(|time| **time < until).count();
        assert_eq!(before, history.impacts.len());
        for (time, expected) in times.iter().zip(&history.impacts) {
            assert!((time - expected.time).abs() < 1e-7, "{}: {time} {}", oracle.name(), expected.time);
        }
        // After the ground has come to rest the block rocks freely, and its own infinite sequence ends in rest.
        assert!(matches!(response.bouts[0].outcome, BoutEnd::Complete { .. }));
        assert!(response.bouts[0].flights.iter().any(|flight| flight.departure.ground == Ground::Still));
    }
}

proptest! {
    // Always the same cases: a test that fails by chance defends nothing.
    #![proptest_config(ProptestConfig { cases: 40, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    /// Shifting the phase by half a turn mirrors the response, by a whole turn changes nothing.
    #[test]
    fn phases_a_turn_apart_are_the_same_and_half_a_turn_the_mirror_image(
        epsilon in 0.005..0.05f64, omega in 0.5..6.0f64, phase in 0.0..TAU,
    ) {
        for oracle in both() {
            let of = |phase: f64| {
                let request = Request { phase: Some(phase), ..request(epsilon, omega, 0.8, 1.5) };
                let response = respond(oracle.as_ref(), &request);
                (rows(oracle.as_ref(), &request, &response, 50), response)
            };
            let ((here, response), (half, mirrored), (whole, again)) = (of(phase), of(phase + PI), of(phase + TAU));
            prop_assert_eq!(response.bouts.len(), mirrored.bouts.len());
            prop_assert_eq!(response.bouts.len(), again.bouts.len());
            // Times of the same rows differ by rounding of the phase, amplified by the case.
            for (one, other) in here.iter().zip(&whole) {
                prop_assert!((one.phi - other.phi).abs() < 1e-8 && (one.tau - other.tau).abs() < 1e-8);
            }
            for (one, other) in here.iter().zip(&half) {
                prop_assert!((one.phi + other.phi).abs() < 1e-8 && (one.tau - other.tau).abs() < 1e-8);
            }
        }
    }

    /// Each flight starts where the last one ended, with η times its speed, on the other side; and no impact adds energy.
    #[test]
    fn impacts_join_flights_and_take_energy(epsilon in 0.005..0.6f64, omega in 0.5..6.0f64, eta in 0.5..0.97f64, phase in 0.0..TAU) {
        for oracle in both() {
            let request = Request { phase: Some(phase), ..request(epsilon, omega, eta, 2.0) };
            for bout in &respond(oracle.as_ref(), &request).bouts {
                for two in bout.flights.windows(2) {
                    prop_assert!((two[0].start + two[0].duration - two[1].start).abs() < 1e-12);
                    let departure = two[1].departure;
                    match two[0].arrival {
                        Arrival::Impact { speed, .. } => {
                            prop_assert_eq!(departure.side, -two[0].departure.side);
                            prop_assert_eq!(departure.velocity, eta * speed);
                            prop_assert!(departure.velocity < speed && departure.rotation == 0.0);
                        }
                        Arrival::Aloft { rotation, velocity } => {
                            prop_assert_eq!((departure.rotation, departure.velocity), (rotation, velocity));
                        }
                        // It falls on, on ground that has come to rest.
                        Arrival::Overturned { .. } => {
                            prop_assert!(departure.rotation > 0.0 && departure.side == two[0].departure.side);
                            prop_assert_eq!(departure.ground, Ground::Still);
                        }
                        other @ Arrival::Lost(_) => prop_assert!(false, "a flight after {other:?}"),
                    }
                }
            }
        }
    }

    /// Rest ends where the ground acceleration reaches the threshold again, with the block turning against it.
    #[test]
    fn rocking_starts_at_the_threshold_against_the_ground(epsilon in 0.005..0.3f64, omega in 0.5..6.0f64, phase in 0.0..TAU) {
        let request = Request { phase: Some(phase), ..request(epsilon, omega, 0.8, 3.0) };
        let oracle = oracle("closed-form");
        let response = respond(oracle.as_ref(), &request);
        for bout in &response.bouts {
            let f = response.ground.acceleration(bout.begin());
            let first = bout.flights[0];
            prop_assert!(f.abs() >= 1.0 - 1e-10 && (f.abs() <= 1.0 + 1e-10 || bout.begin() == 0.0), "{f}");
            prop_assert_eq!(bout.lobe.mirror * first.departure.side, -f.signum());
        }
        for (from, to) in response.rests() {
            let moving = to.min(request.lasts.unwrap());
            for part in 1..20 {
                let tau = from + (moving - from) * f64::from(part) / 20.0;
                prop_assert!(tau >= moving || response.ground.acceleration(tau).abs() <= 1.0 + 1e-10);
            }
        }
    }

    /// Rows are as dense as asked for, and not many more.
    #[test]
    fn rows_are_dense_but_not_many(epsilon in 0.005..0.06f64, steps in 20..600usize, eta in 0.6..0.96f64) {
        let request = request(epsilon, 2.0, eta, 2.5);
        let oracle = oracle("closed-form");
        let response = respond(oracle.as_ref(), &request);
        let rows = rows(oracle.as_ref(), &request, &response, steps);
        let step = response.end / steps as f64;
        prop_assert!(rows.len() < 40 * steps + 1000, "{}", rows.len());
        for two in rows.windows(2) {
            let gap = two[1].tau - two[0].tau;
            prop_assert!(gap > -1e-12 && gap < 1.3 * step, "{gap} {step} at {}", two[0].tau);
        }
    }
}

/// The response goes on until the block rests after the motion of the ground, and every part of it is in the rows.
#[test]
fn a_response_ends_with_rest_after_the_motion() {
    for oracle in both() {
        // Ends while the block rocks, and while it rests.
        for (cycles, rocks) in [(1.1, true), (1.45, false)] {
            let request = request(0.03, 2.0, 0.92, cycles);
            let lasts = request.lasts.unwrap();
            let response = respond(oracle.as_ref(), &request);
            let last = response.bouts.last().unwrap();
            assert_eq!(last.end() > lasts, rocks);
            assert_eq!(response.end, if rocks { last.end() } else { lasts });
            let rows = rows(oracle.as_ref(), &request, &response, 300);
            let end = rows.last().unwrap();
            assert!((end.tau - response.end).abs() < 1e-3 && end.phi.abs() < 1e-6, "{end:?}");
            assert_eq!(rows.iter().any(|row| row.tau > lasts + 0.1 && row.phi != 0.0), rocks);
            assert!(rows.iter().all(|row| row.tau <= lasts || row.ground_acceleration == 0.0));
            let short = Request { until: 1.0, ..request };
            assert_eq!(respond(oracle.as_ref(), &short).end, 1.0);
        }
    }
}

/// Eq. 4 by Runge and Kutta in steps of fixed size, from rest to rest, with nothing in common with the program: impacts where the rotation changes its sign,
/// rest where it is tiny and the ground holds the block down. Rows of τ, φ.
fn naive(epsilon: f64, omega: f64, eta: f64, lasts: f64, phase: f64, end: f64) -> Vec<(f64, f64)> {
    let step = 2e-5;
    let f = |tau: f64| if tau < lasts { (1.0 + epsilon) * (omega * tau + phase).sin() } else { 0.0 };
    let (mut phi, mut velocity, mut sign, mut tau) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    let mut rows = Vec::new();
    while tau < end {
        if sign == 0.0 && f(tau).abs() > 1.0 {
            sign = -f(tau).signum();
        }
        if sign != 0.0 {
            let acceleration = |t: f64, phi: f64| phi - sign - f(t);
            let (k1, l1) = (velocity, acceleration(tau, phi));
            let (k2, l2) = (velocity + 0.5 * step * l1, acceleration(tau + 0.5 * step, phi + 0.5 * step * k1));
            let (k3, l3) = (velocity + 0.5 * step * l2, acceleration(tau + 0.5 * step, phi + 0.5 * step * k2));
            let (k4, l4) = (velocity + step * l3, acceleration(tau + step, phi + step * k3));
            phi += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            velocity += step / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
            if phi * sign < 0.0 {
                velocity *= eta;
                sign = -sign;
                if velocity.abs() < 3e-5 && f(tau).abs() < 1.0 {
                    (phi, velocity, sign) = (0.0, 0.0, 0.0);
                }
            }
        }
        tau += step;
        rows.push((tau, phi));
    }
    rows
}

/// Complete chattering, rest and rocking to the other side, twice and a half, as a simulation has it that knows of no lobes, mirrors or sums; with a phase
/// below and above the threshold, and an end in the middle of a flight.
#[test]
fn whole_responses_are_those_of_a_naive_simulation() {
    let oracle = oracle("closed-form");
    let mut bouts = 0;
    for (epsilon, omega, eta, cycles, phase) in [
        (0.03, 2.0, 0.8, 2.5, 0.2),
        (0.05, 2.0, 0.7, 1.3, 1.4),
        (0.2, 3.0, 0.8, 1.77, -2.0),
        (0.06, 1.5, 0.75, 1.02, 4.5),
    ] {
        let request = Request { phase: Some(phase), ..request(epsilon, omega, eta, cycles) };
        let response = respond(oracle.as_ref(), &request);
        let naive = naive(epsilon, omega, eta, request.lasts.unwrap(), phase, response.end);
        let rows = rows(oracle.as_ref(), &request, &response, 500);
        let largest = rows.iter().fold(0.0, |most: f64, row| most.max(row.phi.abs()));
        for row in &rows {
            let place = naive.partition_point(|(tau, _)| *tau < row.tau).min(naive.len() - 1);
            let off = (naive[place].1 - row.phi).abs();
            assert!(off < 0.05 * largest, "{epsilon} {phase}: {} and {} at {}", naive[place].1, row.phi, row.tau);
        }
        bouts += response.bouts.len();
    }
    assert!(bouts >= 8, "complete and incomplete chattering: {bouts} times from rest to rest");
}

/// The uncertainty of a rest that comes after long incomplete chattering is that of all that went before: as moving the frequency by a rounding shows.
#[test]
fn the_uncertainty_of_a_rest_is_that_of_all_that_went_before() {
    let oracle = oracle("closed-form");
    let of = |omega: f64| {
        let case = case(0.06, omega, 0.9);
        let request = Request::new(case, Some(20.0 * TAU / 3.674), f64::INFINITY).unwrap();
        respond(oracle.as_ref(), &Request { phase: Some(0.3), ..request })
    };
    let (here, moved) = (of(3.674), of(3.674_f64.next_up()));
    let last = here.bouts.last().unwrap();
    let BoutEnd::Complete { uncertainty } = last.outcome else { panic!("{:?}", last.outcome) };
    assert!(last.flights.iter().any(|flight| flight.departure.ground == Ground::Still));
    let change = (last.end() - moved.bouts.last().unwrap().end()).abs();
    assert!(change > 1e-13, "not sensitive: {change}");
    assert!(uncertainty > change && uncertainty < 1e-6, "{uncertainty} {change}");
}

/// However often the same half period comes again it costs nothing, and no limit cuts it off.
#[test]
fn a_motion_of_thousands_of_cycles_is_followed_to_its_end() {
    let oracle = oracle("closed-form");
    let request = request(0.02, 3.0, 0.9, 9_999.5);
    let response = respond(oracle.as_ref(), &request);
    assert_eq!(response.bouts.len(), 19_999);
    assert_eq!(response.end, request.lasts.unwrap());
    assert!(response.bouts.iter().all(|bout| bout.outcome.is_rest()));
    let few = respond(oracle.as_ref(), &Request { most_impacts: 10, ..request });
    assert_eq!((few.bouts.len(), few.bouts[0].outcome), (1, BoutEnd::TooManyImpacts));
}

/// In physical units the response depends on nothing but the dimensionless numbers.
#[test]
fn size_and_gravity_cancel() {
    let scene = |radius: f64, gravity: f64| {
        let text = format!(
            "[block]\nradius = {radius}\nslenderness = 0.2\nrestitution = 0.9\ngravity = {gravity}\n[ground]\namplitude = {{ over-threshold = 1.02 \
             }}\nfrequency = {{ omega = 3 }}\nduration = {{ cycles = 1.5 }}\nphase = 0.3\n"
        );
        Scene::parse(&text).unwrap().response(None, Termination::Exact).unwrap()
    };
    let (here, moon) = (scene(7.3575, 9.81), scene(0.5, 1.62));
    let oracle = oracle("taylor");
    let (one, other) = (respond(oracle.as_ref(), &here), respond(oracle.as_ref(), &moon));
    assert_relative_eq!(one.end, other.end, max_relative = 1e-14);
    assert_eq!(one.bouts.len(), 3);
    for (one, other) in one.bouts.iter().zip(&other.bouts) {
        assert_relative_eq!(one.end(), other.end(), max_relative = 1e-13);
    }
}

/// Figs 10 and 11: below the critical amplitude all schemes rest; above it a velocity threshold that is too large stops what does not stop.
#[test]
fn the_schemes_of_section_5_2() {
    let oracle = oracle("closed-form");
    let of = |epsilon: f64, termination| {
        respond(oracle.as_ref(), &Request { termination, ..request(epsilon, 2.0, 0.92, 2.5) })
    };
    let chattering = |epsilon| chattering_threshold(&request(epsilon, 2.0, 0.92, 2.5).case, Condition::Eq76);
    // Fig. 10
    let (exact, slow, series) =
        (of(0.03, Termination::Exact), of(0.03, Termination::VelocityThreshold(5e-10)), of(0.03, chattering(0.03)));
    for response in [&exact, &slow, &series] {
        assert_eq!(response.bouts.len(), 5);
    }
    assert_eq!(slow.bouts[0].outcome, BoutEnd::VelocityThreshold);
    assert!(slow.bouts[0].end() < exact.bouts[0].end() && exact.bouts[0].end() - slow.bouts[0].end() < 1e-6);
    assert_eq!(series.bouts[0].outcome, BoutEnd::ChatteringThreshold);
    // Eq. 65 gives 0.70298 of the half period, the truth is 0.71680; the first impact after it ends the motion.
    let share = series.bouts[0].end() / (PI / 2.0);
    assert!((0.70298..0.7168).contains(&share), "{share}");
    // Fig. 11
    let (exact, slow, fast, series) = (
        of(0.05, Termination::Exact),
        of(0.05, Termination::VelocityThreshold(5e-10)),
        of(0.05, Termination::VelocityThreshold(5e-2)),
        of(0.05, chattering(0.05)),
    );
    assert_eq!(exact.bouts.len(), 1);
    assert_eq!(exact.bouts, series.bouts, "the chattering threshold does not apply above a_cr");
    let shaken = |response: &Response| response.bouts.iter().filter(|bout| bout.end() < 2.4 * PI).count();
    assert_eq!((shaken(&exact), shaken(&slow)), (0, 0));
    assert!(shaken(&fast) >= 4, "the large threshold stops it in each half period");
}

/// A sequence that accumulates before the time of Eq. 65 has passed is closed, and does not go on for ever.
#[test]
fn a_chattering_threshold_that_comes_too_late_does_not_stall() {
    let oracle = oracle("closed-form");
    // Near the threshold Eq. 65 is too late.
    let request = request(0.005, 2.0, 0.92, 1.0);
    let termination = chattering_threshold(&request.case, Condition::Eq77);
    let response = respond(oracle.as_ref(), &Request { termination, ..request });
    assert!(
        response.bouts.iter().all(|bout| matches!(bout.outcome, BoutEnd::Complete { .. })),
        "{:?}",
        response.bouts[0].outcome
    );
}

#[test]
fn strong_shaking_overturns_and_weak_shaking_does_nothing() {
    for oracle in both() {
        let strong = respond(oracle.as_ref(), &request(4.0, 0.6, 0.9, 2.0));
        assert_eq!(strong.bouts.last().unwrap().outcome, BoutEnd::Overturned);
        let weak = request(-0.1, 2.0, 0.9, 2.0);
        let response = respond(oracle.as_ref(), &weak);
        assert!(response.bouts.is_empty());
        assert_eq!(response.rests(), [(0.0, TAU)]);
        assert!(
            rows(oracle.as_ref(), &weak, &response, 50).iter().all(|row| row.state == State::Rest && row.phi == 0.0)
        );
    }
}

fn command(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn the_command_prints_the_history_or_what_happens() {
    let scene = "data/scenes/paper_fig_9.toml";
    let (status, csv, _) = command(&["response", scene]);
    assert_eq!(status, 0);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("tau,t,phi,theta,phi_velocity,ground_acceleration,state"));
    assert!(csv.len() < 400_000, "{} bytes", csv.len());
    assert!(lines.all(|line| line.ends_with("rest") || line.ends_with("rocking")));
    let (status, json, _) = command(&["response", scene, "--format", "json", "--model", "nonlinear"]);
    assert_eq!(status, 0);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    // Over the slender threshold 1.03 is 1.016 over g tan α: other numbers, the same five times of rocking.
    assert_eq!((json["bouts"].as_array().unwrap().len(), json["model"].as_str()), (5, Some("nonlinear")));
    assert!(json["a"].as_f64().unwrap() < 1.02);
}

#[test]
fn what_is_wrong_with_a_request_is_said_in_one_line() {
    let scene = "data/scenes/paper_fig_9.toml";
    for (arguments, expected) in [
        (vec!["response", "no.toml"], "no.toml"),
        (vec!["response", scene, "--termination", "velocity"], "velocity-threshold"),
        (vec!["response", scene, "--termination", "velocity", "--velocity-threshold", "-1"], "velocity-threshold"),
        (vec!["response", scene, "--termination", "velocity", "--velocity-threshold", "nan"], "velocity-threshold"),
        (vec!["response", scene, "--velocity-threshold", "1e-3"], "velocity-threshold"),
        (vec!["response", scene, "--until", "0"], "until"),
        (vec!["response", scene, "--until", "nan"], "until"),
        (vec!["response", scene, "--steps", "0"], "steps"),
        (vec!["response", scene, "--steps", "-4"], "steps"),
        (vec!["response", scene, "--from", "99"], "from"),
        (vec!["response", scene, "--from", "2", "--to", "1"], "to"),
        (vec!["response", scene, "--condition", "eq77"], "condition"),
        (vec!["response", scene, "--format", "json", "--from", "1"], "from"),
        (vec!["response", scene, "--until", "inf"], "until = inf"),
        (vec!["response", "/dev/zero"], "up to 1 MiB"),
    ] {
        let (status, stdout, stderr) = command(&arguments);
        assert_eq!((status, stdout.as_str()), (2, ""), "{arguments:?}");
        assert!(stderr.contains(expected) && stderr.lines().count() == 1, "{arguments:?}: {stderr}");
    }
}

/// Part of a response is the same response, seen more closely.
#[test]
fn a_window_shows_the_final_cycles() {
    let scene = "data/scenes/paper_fig_9.toml";
    let (status, csv, _) = command(&["response", scene, "--from", "1.12", "--to", "1.1259", "--steps", "300"]);
    assert_eq!(status, 0);
    let taus: Vec<f64> = csv.lines().skip(1).map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    assert!(taus.iter().all(|tau| (1.12..=1.1259).contains(tau)));
    assert!(taus.len() > 300 && taus.len() < 12_000, "{}", taus.len());
}
