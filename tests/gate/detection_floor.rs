//! Every planted fault is seen, and the steppers that faults are planted with are honest without one.

use std::sync::OnceLock;

use chattercheck::{
    faults::{
        Fault, Size,
        catalogue::catalogue,
        floor::{self, Smallest},
        plant::Plant,
        recursion::Lost,
        stepper::Wrong,
        trial::Trial,
    },
    panel,
};

/// One oracle of each kind; built once, and what the honest ones answered is kept from test to test.
fn trial() -> &'static Trial {
    static TRIAL: OnceLock<Trial> = OnceLock::new();
    TRIAL.get_or_init(|| {
        let names = "closed-form,ode/linear/tsit45,ode/nonlinear/tsit45,taylor,asymptotic/paper";
        Trial::new(panel::select(names).unwrap(), 1)
    })
}

/// What an error of `eta`, `omega` or `a` in the closed form may be at the most without being seen, relative.
const FINEST: f64 = 2e-14;

#[test]
fn without_a_mistake_the_steppers_pass() {
    let trial = trial();
    let honest = |oracle: &str, plant: Plant| {
        let oracle = oracle.to_owned();
        Fault { name: "none", as_if: "", oracle, size: Size::Whole, plant }
    };
    for fault in [
        honest("closed-form", Plant::Stepper(|_| Wrong::default())),
        honest("asymptotic/paper", Plant::Series(|_| Lost::default())),
    ] {
        let found = trial.detects(&fault, 0.0, None).unwrap();
        assert!(found.is_none(), "{} is not honest: {found:?}", fault.oracle);
    }
}

#[test]
fn no_fault_escapes_at_its_natural_size() {
    let trial = trial();
    let faults = catalogue(trial.oracles());
    assert!(faults.len() >= 80, "{} faults", faults.len());
    for fault in &faults {
        let sizes = match fault.size {
            Size::Amount { natural, .. } => vec![natural],
            Size::Depth(_) => [1, 2, 7, 30, 59, 60, 300, 519].map(f64::from).to_vec(),
            Size::Whole => vec![1.0],
        };
        for size in sizes {
            let found = trial.detects(fault, size, None).unwrap();
            assert!(found.is_some(), "\"{}\" of size {size} in {} escapes", fault.name, fault.oracle);
        }
    }
}

#[test]
fn the_finest_errors_of_the_parameters_are_seen() {
    let trial = trial();
    let mut faults = catalogue(trial.oracles());
    faults.retain(|fault| fault.oracle == "closed-form" && fault.name.contains("is off"));
    faults.retain(|fault| ["eta", "omega", "a "].iter().any(|name| fault.name.starts_with(name)));
    let rows = floor::table(trial, &faults, || ()).unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        assert!(matches!(row.smallest, Smallest::Amount(size) if size <= FINEST), "{row:?}");
    }
}
