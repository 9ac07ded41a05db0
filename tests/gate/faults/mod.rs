//! The gate is tested by planting faults in one oracle: each must turn it red, and the report must name the oracle, the observable and the
//! first impact at which it shows.

mod in_a_case;
mod in_the_run;

use std::sync::OnceLock;

use chattercheck::{
    cases::generate::{Generator, Named},
    faults::remember::Remembering,
    gate::{
        finding::Finding,
        judge::Judges,
        ladder::{self, Ladder},
        laws::Law,
        report::Report,
        run,
        shortfall::Shortfall,
    },
    measure::observables::Observable,
    panel,
};
use contract::{Case, Decline, Ending, Estimate, History, Loss, Model, Normalisation, Oracle, Slenderness};

/// An oracle with something wrong: what it is asked or what it answers is tampered with.
struct Faulty<'a> {
    inner: &'a dyn Oracle,
    ask: fn(&Case) -> Case,
    answer: fn(&Case, &mut History),
}

impl Oracle for Faulty<'_> {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn model(&self) -> Model {
        self.inner.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let mut history = self.inner.history(&(self.ask)(case))?;
        (self.answer)(case, &mut history);
        Ok(history)
    }
}

const CLOSED: &str = "closed-form";
const ODE: &str = "ode/linear/tsit45";
const NONLINEAR: &str = "ode/nonlinear/tsit45";
const TAYLOR: &str = "taylor";
const SERIES: &str = "asymptotic/paper";

fn same(case: &Case) -> Case {
    *case
}

fn untouched(_: &Case, _: &mut History) {}

fn with(case: &Case, epsilon: f64, omega: f64, eta: f64) -> Case {
    let new = Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(case.max_impacts()).unwrap();
    let new = new.with_horizon(case.horizon()).unwrap();
    case.slenderness().map_or(new, |slenderness| new.with_slenderness(slenderness))
}

/// The cases that faults are looked for in: few, of every kind.
fn cases() -> &'static [Named] {
    static CASES: OnceLock<Vec<Named>> = OnceLock::new();
    CASES.get_or_init(|| {
        let stepper = panel::stepper();
        let of = |generator: Generator, every: usize| {
            generator.cases(11, 60, stepper.as_ref()).into_iter().step_by(every).collect::<Vec<_>>()
        };
        [of(Generator::List, 1), of(Generator::Spaced, 5), of(Generator::Random, 1)].concat()
    })
}

/// The panel that faults are planted in: one oracle of each kind. What the honest ones answered is kept from test to test.
fn honest() -> &'static [Remembering] {
    static HONEST: OnceLock<Vec<Remembering>> = OnceLock::new();
    HONEST.get_or_init(|| {
        let panel = panel::select(&[CLOSED, ODE, NONLINEAR, TAYLOR, SERIES].join(",")).unwrap();
        panel.into_iter().map(Remembering::new).collect()
    })
}

fn run(panel: &[&dyn Oracle]) -> Report {
    let ladders = ladder::descend(panel, panel::SERIES).unwrap();
    Report::new(&run::run(panel, &Judges::default(), cases(), 11, Some(ladders), &()), &panel::roles())
}

fn planted(name: &str, ask: fn(&Case) -> Case, answer: fn(&Case, &mut History)) -> Report {
    let place = honest().iter().position(|oracle| oracle.name() == name).unwrap();
    let faulty = Faulty { inner: &honest()[place], ask, answer };
    let mut panel: Vec<&dyn Oracle> = honest().iter().map(|oracle| oracle as &dyn Oracle).collect();
    panel[place] = &faulty;
    run(&panel)
}

/// The findings reported for one listed case.
fn findings_in<'a>(report: &'a Report, case: &str) -> Vec<&'a Finding> {
    let failed = report.failures.iter().filter(|failure| failure.name == case);
    failed.flat_map(|failure| &failure.findings).collect()
}

#[test]
fn without_a_fault_the_gate_is_green() {
    let report = run(&honest().iter().map(|oracle| oracle as &dyn Oracle).collect::<Vec<_>>());
    assert!(report.passes(), "{}", chattercheck::gate::report::text(&report));
}
