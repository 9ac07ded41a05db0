//! The simulator under the gate: `cargo test -p simulator`.
#![allow(clippy::unwrap_used)] // Test code fails by panicking.

use chattercheck::{
    gate::report::{self, Granted},
    verify::Verify,
};
use contract::{Case, Decline, Ending, History, Horizon, Impact, Limit, Model, Oracle, Uncertainty, conformance};
use simulator::{Block, End, Hit};

/// As good as never: a larger one, 1e-2 say, is seen by the gate.
const REST_BELOW: f64 = 1e-250;

/// The simulator in the words of the contract.
struct Mine;

impl Oracle for Mine {
    fn name(&self) -> &str {
        "mine"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        if case.epsilon() <= 0.0 {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        if case.horizon() != Horizon::HalfPeriod {
            return Err(Decline::Unsupported { what: "other times than half a period" });
        }
        let block = Block { excess: case.epsilon(), omega: case.omega(), eta: case.eta(), rest_below: REST_BELOW };
        let (hits, end) = block.rock(case.max_impacts());
        // It claims nothing itself: what is granted to it is below.
        let uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        let impact = |Hit { time, interval, velocity }| Impact { time, interval, velocity, uncertainty };
        let ending = match end {
            End::Rest => Ending::AtRest,
            End::Rocking => Ending::Incomplete,
            End::Enough => Ending::LimitReached(Limit::Impacts),
        };
        Ok(History { impacts: hits.into_iter().map(impact).collect(), ending, chattering_time: None })
    }
}

/// 200 random cases and those that hurt others, with 1e-10 granted, in times and relative in intervals and velocities, and more where a case is badly conditioned.
fn gate() -> Verify {
    let reason = "series of 26 terms, roots by bisection".to_owned();
    let granted = Granted { time: 1e-10, interval: 1e-10, velocity: 1e-10, tau_ch: 1e-10, reason };
    Verify { cases: 200, granted: Some(granted), ..Verify::default() }
}

#[test]
fn it_keeps_the_contract() {
    let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
    let stout = Case::from_amplitude(1.3, 0.7, 0.6).unwrap();
    assert_eq!(conformance::check(&Mine, &[case, stout]), Ok(()));
}

#[test]
fn the_gate_is_green() {
    let report = gate().run(&[&Mine]).unwrap();
    assert!(report.passes(), "{}", report::text(&report));
}
