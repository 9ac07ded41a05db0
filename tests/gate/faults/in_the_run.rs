//! Faults of which no single case has to be wrong: the run as a whole falls short of what it has to prove.

use super::*;

/// The run as a whole is red, and the reason is `of_this_kind`.
fn falls_short(report: &Report, of_this_kind: impl Fn(&Shortfall) -> bool) {
    assert!(!report.passes() && report.shortfalls.iter().any(of_this_kind), "{:?}", report.shortfalls);
}

#[test]
fn a_claim_of_nothing() {
    let answer = |_: &Case, history: &mut History| {
        for impact in &mut history.impacts {
            impact.uncertainty.interval = f64::INFINITY;
            impact.uncertainty.velocity = f64::INFINITY;
            impact.uncertainty.time = f64::INFINITY;
        }
    };
    let report = planted(ODE, same, answer);
    assert!(!report.passes());
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::InNameOnly { times: false, .. }));
}

#[test]
fn a_claim_of_nothing_for_the_velocity_alone() {
    let answer = |_: &Case, history: &mut History| {
        for impact in &mut history.impacts {
            impact.velocity *= 1.5;
            impact.uncertainty.velocity = f64::INFINITY;
        }
    };
    let report = planted(ODE, same, answer);
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::InNameOnly { times: false, .. }));
}

#[test]
fn a_chattering_time_that_claims_nothing() {
    let answer = |_: &Case, history: &mut History| {
        history.chattering_time = Some(Estimate { value: 42.0, uncertainty: f64::INFINITY });
    };
    let report = planted(ODE, same, answer);
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::InNameOnly { times: true, .. }));
}

#[test]
fn never_saying_that_the_block_comes_to_rest() {
    let answer = |_: &Case, history: &mut History| {
        if history.ending == Ending::AtRest {
            history.ending = Ending::LimitReached(contract::Limit::Impacts);
        }
    };
    let report = planted(ODE, same, answer);
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::NoChatteringTime { .. }));
}

#[test]
fn declining_a_fifth_of_the_cases() {
    let ask = |case: &Case| if case.eta() > 0.9 { with(case, 1e-70, case.omega(), case.eta()) } else { *case };
    let report = planted(CLOSED, ask, untouched);
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::Declined { oracle, .. } if oracle == CLOSED));
}

#[test]
fn an_oracle_that_declines_everything_is_red() {
    struct Idle;
    impl Oracle for Idle {
        fn name(&self) -> &str {
            "idle"
        }
        fn model(&self) -> Model {
            Model::Linear
        }
        fn history(&self, _: &Case) -> Result<History, Decline> {
            Err(Decline::Unsupported { what: "anything" })
        }
    }
    let mut panel: Vec<&dyn Oracle> = honest().iter().map(|oracle| oracle as &dyn Oracle).collect();
    panel.push(&Idle);
    let report = run(&panel);
    assert!(report.failures.is_empty() && !report.passes());
    falls_short(&report, |shortfall| matches!(shortfall, Shortfall::Silent { oracle } if oracle == "idle"));
}

#[test]
fn the_order_in_alpha_is_checked() {
    // A nonlinear oracle whose slenderness is off by a part in ten at small angles still stays within the gap, but not on the ladder.
    let ask = |case: &Case| match case.slenderness() {
        Some(s) if s.alpha() < 0.03 => {
            case.with_slenderness(Slenderness::new(s.alpha() * 1.2, Normalisation::Threshold).unwrap())
        }
        _ => *case,
    };
    let report = planted(NONLINEAR, ask, untouched);
    falls_short(
        &report,
        |shortfall| matches!(shortfall, Shortfall::Crooked { descent } if descent.ladder == Ladder::Alpha),
    );
}
