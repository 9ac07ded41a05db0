//! What a failing case is shrunk to: smaller, and failing in the very same way.

use chattercheck::{
    cases::generate::Generator,
    faults::plant::{Plant, Planted},
    gate::{
        examine::{examine, examine_and_judge},
        finding::Finding,
        judge::Judges,
        shrink::shrink,
    },
    panel,
};
use contract::{Case, Ending, History, Horizon, Oracle};

/// How many digits a number is written with.
fn digits(value: f64) -> usize {
    format!("{value:e}").bytes().take_while(|byte| *byte != b'e').filter(u8::is_ascii_digit).count()
}

/// Plants a change in the closed form and shrinks what it does to a random case.
fn shrunk(change: fn(&Case, f64, &mut History), judged: bool) -> (Case, chattercheck::gate::shrink::Shrunk) {
    let honest = panel::select("closed-form,ode/linear/tsit45,taylor").unwrap();
    let planted = Planted { honest: honest[0].as_ref(), plant: Plant::Answer(change), size: 1.0 };
    let oracles: [&dyn Oracle; 3] = [&planted, honest[1].as_ref(), honest[2].as_ref()];
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    for named in Generator::Random.cases(8, 40, honest[0].as_ref()) {
        let findings = if judged {
            examine_and_judge(&oracles, &judges, &named.case, true)
        } else {
            examine(&oracles, &named.case)
        }
        .findings();
        let Some(finding) = findings.first() else { continue };
        let shrunk = shrink(&oracles, &judges, &named.case, finding);
        // The oracles that it names are enough to see it again, and what is seen is what it says.
        let enough: Vec<&dyn Oracle> =
            oracles.into_iter().filter(|oracle| shrunk.oracles.iter().any(|name| name == oracle.name())).collect();
        let again = if judged {
            examine_and_judge(&enough, &judges, &shrunk.case, true)
        } else {
            examine(&enough, &shrunk.case)
        };
        assert!(again.findings().contains(&shrunk.finding), "{shrunk:?}");
        assert!(shrunk.finding.resembles(finding));
        assert!(shrunk.tried > 0 && shrunk.tried <= 120, "{} tried", shrunk.tried);
        return (named.case, shrunk);
    }
    panic!("nothing was found")
}

#[test]
fn a_case_is_shrunk_to_the_impact_and_to_few_digits() {
    let change: fn(&Case, f64, &mut History) = |case, _, history| {
        if case.omega() > 1.0
            && let Some(impact) = history.impacts.get_mut(4)
        {
            impact.velocity *= 1.001;
        }
    };
    let (case, small) = shrunk(change, false);
    assert!(matches!(&small.finding, Finding::Pair { .. }) && small.finding.impact() == 5, "{small:?}");
    assert_eq!(small.case.max_impacts(), 5);
    assert!(small.case.slenderness().is_none() && case.slenderness().is_some());
    assert!(small.case.omega() > 1.0, "what makes it fail is kept");
    for of in [Case::epsilon, Case::omega, Case::eta] {
        assert!(digits(of(&small.case)) <= 2 && digits(of(&case)) > 10, "{small:?}");
    }
    assert_eq!(small.oracles, ["closed-form", "ode/linear/tsit45"]);
}

/// What shows only past half a period of the excitation takes a horizon that reaches there, and everything else gets small.
#[test]
fn what_needs_the_horizon_keeps_it() {
    let change: fn(&Case, f64, &mut History) = |case, _, history| {
        let half_period = std::f64::consts::PI / case.omega();
        if let Some(late) = history.impacts.iter_mut().find(|impact| impact.time > half_period) {
            late.velocity *= 1.001;
        }
    };
    let honest = panel::select("closed-form,ode/linear/tsit45").unwrap();
    let planted = Planted { honest: honest[0].as_ref(), plant: Plant::Answer(change), size: 1.0 };
    let oracles: [&dyn Oracle; 2] = [&planted, honest[1].as_ref()];
    let case = Case::from_epsilon(0.512345678912, 2.01234567891, 0.921234567891).unwrap();
    let case = case.with_horizon(Horizon::Until(3.5)).unwrap();
    let findings = examine(&oracles, &case).findings();
    let small = shrink(&oracles, &Judges::default(), &case, &findings[0]);
    assert!(small.finding.resembles(&findings[0]) && small.case.horizon() == case.horizon(), "{small:?}");
    for of in [Case::epsilon, Case::omega, Case::eta] {
        assert!(digits(of(&small.case)) <= 2, "{small:?}");
    }
    // One that needs none loses it: at this amplitude there are impacts at once.
    let case = Case::from_epsilon(0.0312345678912, 2.01234567891, 0.921234567891).unwrap();
    let case = case.with_horizon(Horizon::Until(3.5)).unwrap();
    let change: fn(&Case, f64, &mut History) =
        |_, _, history| history.impacts.iter_mut().for_each(|impact| impact.velocity *= 1.001);
    let planted = Planted { honest: honest[0].as_ref(), plant: Plant::Answer(change), size: 1.0 };
    let oracles: [&dyn Oracle; 2] = [&planted, honest[1].as_ref()];
    let small = shrink(&oracles, &Judges::default(), &case, &examine(&oracles, &case).findings()[0]);
    assert_eq!(small.case.horizon(), Horizon::HalfPeriod);
}

#[test]
fn a_law_that_takes_another_oracle_to_be_seen_broken_keeps_it() {
    let change: fn(&Case, f64, &mut History) = |_, _, history| {
        if history.ending == Ending::Incomplete {
            history.ending = Ending::Overturned;
        }
    };
    let (_, small) = shrunk(change, false);
    assert!(matches!(&small.finding, Finding::Law { .. }), "{small:?}");
}

#[test]
fn what_the_judge_refutes_is_shrunk_with_the_judge() {
    let change: fn(&Case, f64, &mut History) = |_, _, history| {
        if let Some(impact) = history.impacts.get_mut(2) {
            impact.velocity *= 1.0 + 1e-13;
        }
    };
    let (_, small) = shrunk(change, true);
    assert!(matches!(&small.finding, Finding::Refuted { oracle, .. } if oracle == "closed-form"), "{small:?}");
    assert!(small.case.max_impacts() <= 3);
}
