//! Faults that are seen in single cases: the report names the oracle, the observable or the law, and the first impact.

use super::*;

/// The gate is red, every finding in the reference case is about `name`, and the pair with `other` shows `observable` first at `impact`.
fn caught(report: &Report, name: &str, other: &str, observable: Observable, impact: usize) {
    assert!(!report.passes(), "the gate stayed green");
    let findings = findings_in(report, "list/fig-2");
    assert!(!findings.is_empty(), "nothing was found in list/fig-2");
    assert!(findings.iter().all(|finding| finding.oracles().contains(&name)), "{findings:#?}");
    let found = findings.iter().any(|finding| match finding {
        Finding::Pair { oracles, disagreement } => {
            oracles.contains(&other.to_owned())
                && disagreement.observable == observable
                && disagreement.figure.impact == impact
        }
        Finding::Law { .. } | Finding::Refuted { .. } | Finding::Broke { .. } => false,
    });
    assert!(found, "no {observable} at impact {impact} against {other}: {findings:#?}");
}

fn breaks(report: &Report, name: &str, law: Law, impact: usize) {
    assert!(!report.passes(), "the gate stayed green");
    let findings = findings_in(report, "list/fig-2");
    let found = findings.iter().any(|finding| {
        matches!(finding, Finding::Law { oracle, breach } if oracle == name && breach.law == law && breach.impact == impact)
    });
    assert!(found, "{law:?} at impact {impact} is not named: {findings:#?}");
}

#[test]
fn restitution_off_by_1e_9() {
    let ask = |case: &Case| with(case, case.epsilon(), case.omega(), case.eta() * (1.0 + 1e-9));
    caught(&planted(CLOSED, ask, untouched), CLOSED, ODE, Observable::Velocity, 1);
    caught(&planted(ODE, ask, untouched), ODE, CLOSED, Observable::Velocity, 1);
}

#[test]
fn frequency_off_by_1e_9() {
    let ask = |case: &Case| with(case, case.epsilon(), case.omega() * (1.0 + 1e-9), case.eta());
    caught(&planted(CLOSED, ask, untouched), CLOSED, ODE, Observable::Interval, 1);
}

#[test]
fn amplitude_off_by_1e_9() {
    let ask = |case: &Case| with(case, case.epsilon() + (1.0 + case.epsilon()) * 1e-9, case.omega(), case.eta());
    caught(&planted(ODE, ask, untouched), ODE, CLOSED, Observable::Interval, 1);
}

#[test]
fn restitution_squared() {
    let ask = |case: &Case| with(case, case.epsilon(), case.omega(), case.eta() * case.eta());
    caught(&planted(NONLINEAR, ask, untouched), NONLINEAR, CLOSED, Observable::Velocity, 1);
}

#[test]
fn slenderness_taken_with_the_wrong_normalisation() {
    let ask = |case: &Case| match case.slenderness() {
        Some(s) => case.with_slenderness(Slenderness::new(s.alpha(), Normalisation::Slender).unwrap()),
        None => *case,
    };
    caught(&planted(NONLINEAR, ask, untouched), NONLINEAR, CLOSED, Observable::Interval, 1);
}

#[test]
fn slenderness_off_by_1e_4() {
    // Far within the gap between the models: it takes a second nonlinear method to see it.
    let ask = |case: &Case| match case.slenderness() {
        Some(s) => case.with_slenderness(Slenderness::new(s.alpha() * (1.0 + 1e-4), s.normalisation()).unwrap()),
        None => *case,
    };
    let report = planted(NONLINEAR, ask, untouched);
    caught(&report, NONLINEAR, TAYLOR, Observable::Interval, 1);
    assert!(
        report
            .failures
            .iter()
            .flat_map(|failure| &failure.findings)
            .all(|finding| finding.oracles().contains(&NONLINEAR))
    );
}

#[test]
fn a_missed_impact() {
    let answer = |_: &Case, history: &mut History| {
        if history.impacts.len() > 24 {
            let missed = history.impacts.remove(20);
            history.impacts[20].interval += missed.interval;
        }
    };
    // The method falls through the base and lands one impact later: impact 21 is in fact 22.
    breaks(&planted(CLOSED, same, answer), CLOSED, Law::SignAlternates, 21);
    // Even if it hid that.
    let answer = |_: &Case, history: &mut History| {
        if history.impacts.len() > 24 {
            let missed = history.impacts.remove(20);
            history.impacts[20].interval += missed.interval;
            history.impacts.iter_mut().skip(20).for_each(|impact| impact.velocity = -impact.velocity);
        }
    };
    caught(&planted(CLOSED, same, answer), CLOSED, ODE, Observable::Interval, 21);
}

#[test]
fn a_missed_pair_of_impacts_at_depth() {
    let answer = |_: &Case, history: &mut History| {
        if history.impacts.len() > 55 {
            let missed: f64 = history.impacts.drain(50..52).map(|impact| impact.interval).sum();
            history.impacts[50].interval += missed;
        }
    };
    caught(&planted(ODE, same, answer), ODE, CLOSED, Observable::Interval, 51);
}

#[test]
fn an_impact_too_many() {
    let answer = |_: &Case, history: &mut History| {
        if history.impacts.len() > 12 {
            let mut extra = history.impacts[10];
            extra.interval *= 1e-3;
            extra.velocity = -extra.velocity;
            history.impacts.insert(11, extra);
            history.impacts.pop();
        }
    };
    caught(&planted(ODE, same, answer), ODE, CLOSED, Observable::Interval, 12);
}

#[test]
fn a_flipped_sign() {
    let answer = |_: &Case, history: &mut History| {
        if let Some(impact) = history.impacts.get_mut(9) {
            impact.velocity = -impact.velocity;
        }
    };
    breaks(&planted(CLOSED, same, answer), CLOSED, Law::SignAlternates, 10);
}

#[test]
fn a_restart_lifted_off_the_base() {
    // Flights never get shorter than the lift allows: the block rattles for ever.
    let answer = |_: &Case, history: &mut History| {
        let mut time = 0.0;
        for impact in &mut history.impacts {
            impact.interval = impact.interval.hypot(2e-5);
            time += impact.interval;
            impact.time = time;
        }
    };
    let report = planted(ODE, same, answer);
    caught(&report, ODE, CLOSED, Observable::Interval, 1);
}

#[test]
fn rest_declared_below_a_velocity_threshold() {
    let answer = |_: &Case, history: &mut History| {
        if let Some(n) = history.impacts.iter().position(|impact| impact.velocity.abs() < 5e-4) {
            history.impacts.truncate(n);
            history.ending = Ending::AtRest;
        }
    };
    let report = planted(CLOSED, same, answer);
    assert!(!report.passes());
    let findings = findings_in(&report, "list/fig-2");
    assert!(findings.iter().any(|finding| matches!(
        finding,
        Finding::Pair { disagreement, .. } if disagreement.observable == Observable::Ending
    )));
}

#[test]
fn incomplete_chattering_called_complete() {
    let answer = |_: &Case, history: &mut History| {
        if history.ending == Ending::Incomplete {
            history.ending = Ending::AtRest;
        }
    };
    let report = planted(CLOSED, same, answer);
    let findings = findings_in(&report, "list/fig-11");
    assert!(
        findings.iter().any(|finding| matches!(
            finding,
            Finding::Pair { oracles, disagreement } if oracles.contains(&ODE.to_owned()) && disagreement.observable == Observable::Ending
        )),
        "{findings:#?}"
    );
}

#[test]
fn a_clock_that_slips() {
    let answer = |_: &Case, history: &mut History| {
        history.impacts.iter_mut().skip(30).for_each(|impact| impact.time += 1e-9);
    };
    breaks(&planted(CLOSED, same, answer), CLOSED, Law::TimeIsSum, 31);
}

#[test]
fn intervals_taken_as_differences_of_times() {
    let answer = |_: &Case, history: &mut History| {
        let mut before = 0.0;
        for impact in &mut history.impacts {
            impact.interval = impact.time - before;
            before = impact.time;
        }
    };
    let report = planted(CLOSED, same, answer);
    assert!(!report.passes());
    // It shows where the intervals are some 1e-5 of the time and the claims of both are 1e-11: deep down, from impact 99 on.
    let findings = findings_in(&report, "list/fig-2-deep");
    assert!(!findings.is_empty());
    assert!(
        findings.iter().all(|finding| finding.oracles().contains(&CLOSED) && finding.impact() > 80),
        "{findings:#?}"
    );
}

#[test]
fn a_value_that_is_not_a_number() {
    let answer = |_: &Case, history: &mut History| {
        if let Some(impact) = history.impacts.get_mut(4) {
            impact.interval = f64::NAN;
        }
    };
    breaks(&planted(ODE, same, answer), ODE, Law::Form, 5);
}

#[test]
fn a_series_summed_with_the_wrong_tail() {
    let answer = |_: &Case, history: &mut History| {
        if let Some(Estimate { value, .. }) = &mut history.chattering_time {
            *value *= 1.5;
        }
    };
    let report = planted(SERIES, same, answer);
    assert!(!report.failures.is_empty());
    assert!(
        report.failures.iter().flat_map(|failure| &failure.findings).all(|finding| finding.oracles().contains(&SERIES))
    );
}

#[test]
fn a_claim_that_is_too_small() {
    let answer = |_: &Case, history: &mut History| {
        for impact in &mut history.impacts {
            impact.uncertainty.velocity *= 1e-4;
        }
    };
    let report = planted(ODE, same, answer);
    assert!(!report.failures.is_empty());
    assert!(
        report.failures.iter().flat_map(|failure| &failure.findings).all(|finding| finding.oracles().contains(&ODE))
    );
}

#[test]
fn rest_declared_wherever_the_list_ends() {
    // Short lists of incomplete cases: the others do not know yet.
    let ask = |case: &Case| *case;
    let answer = |_: &Case, history: &mut History| {
        if history.ending == Ending::LimitReached(contract::Limit::Impacts) {
            history.ending = Ending::AtRest;
        }
    };
    let inner = panel::stepper();
    let faulty = Faulty { inner: inner.as_ref(), ask, answer };
    let case = Case::from_amplitude(1.05, 2.0, 0.92).unwrap().with_max_impacts(8).unwrap();
    let ode = panel::select(ODE).unwrap().swap_remove(0);
    let cases = [Named { generator: Generator::List, name: "short".to_owned(), case }];
    let run = run::run(&[&faulty, ode.as_ref()], &Judges::default(), &cases, 0, None, &());
    let report = Report::new(&run, &panel::roles());
    let finding = &report.failures[0].findings[0];
    assert!(
        matches!(finding, Finding::Law { oracle, breach } if oracle == CLOSED && breach.law == Law::RestStays),
        "{finding:?}"
    );
}

#[test]
fn incomplete_chattering_called_overturned() {
    let answer = |_: &Case, history: &mut History| {
        if history.ending == Ending::Incomplete {
            history.ending = Ending::Overturned;
        }
    };
    let report = planted(CLOSED, same, answer);
    let findings = findings_in(&report, "list/fig-11");
    let found = findings.iter().any(|finding| {
        matches!(finding, Finding::Law { oracle, breach } if oracle == CLOSED && breach.law == Law::OverturnedStays)
    });
    assert!(found, "{findings:#?}");
}

#[test]
fn a_loss_is_red() {
    let answer = |_: &Case, history: &mut History| {
        if history.impacts.len() > 30 {
            history.impacts.truncate(30);
            history.ending = Ending::Lost(Loss::FellThrough);
        }
    };
    breaks(&planted(ODE, same, answer), ODE, Law::NotLost, 31);
}

#[test]
fn a_panic_is_red_and_does_not_take_the_run_with_it() {
    let answer = |case: &Case, _: &mut History| assert!(case.omega() > 1e-9 && case.epsilon() < 0.02, "planted panic");
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| ()));
    let report = planted(ODE, same, answer);
    std::panic::set_hook(hook);
    breaks(&report, ODE, Law::Answers, 0);
}
