//! The table says what is so: its rows are held to what their oracles do.

use std::collections::BTreeSet;

use contract::{Case, Model, Normalisation, Slenderness, conformance};

use super::*;

/// A case that every oracle can do.
fn case() -> Case {
    let slenderness = Slenderness::new(0.05, Normalisation::Threshold).unwrap();
    Case::from_amplitude(1.003, 2.0, 0.85).unwrap().with_max_impacts(10).unwrap().with_slenderness(slenderness)
}

fn rows() -> impl Iterator<Item = (&'static Method, Box<dyn Oracle>)> {
    methods().flat_map(|method| {
        let names = method.by_default.iter().chain(method.by_name);
        names.map(move |name| (method, one(name, &Settings::default(), "linear").unwrap()))
    })
}

#[test]
fn every_oracle_of_the_table_is_made_under_its_name_and_solves_what_its_row_says() {
    for method in methods() {
        assert!(!method.models.is_empty(), "{}", method.name);
        for name in method.by_default.iter().chain(method.by_name) {
            let oracle = one(name, &Settings::default(), "linear").unwrap();
            assert_eq!(oracle.name(), *name);
            assert!(method.models.contains(&oracle.model()), "{name}");
            assert_eq!(super::method(name).unwrap().name, method.name);
        }
    }
    let names: BTreeSet<String> = all().iter().map(|oracle| oracle.name().to_owned()).collect();
    assert_eq!((names.len(), all().len()), (rows().count(), rows().count()), "a name that is there twice");
    assert_eq!(default().len(), 9);
}

#[test]
fn roles_are_what_the_oracles_can_do() {
    for (method, oracle) in rows() {
        let has = |role| method.roles.contains(&role);
        let name = oracle.name();
        assert_eq!(oracle.sensitivities(&case()).is_some(), has(Role::Sensitivities), "{name}");
        assert_eq!(oracle.slenderness_shifts(&case()).is_some(), has(Role::SlendernessShifts), "{name}");
        assert_eq!(oracle.history(&case()).unwrap().chattering_time.is_some(), has(Role::OwnSum), "{name}");
        assert!(!has(Role::Stepper) || oracle.flights(&case()).is_ok(), "{name}");
    }
}

#[test]
fn there_is_a_stepper_and_a_judge_for_each_equation() {
    for model in [Model::Linear, Model::Nonlinear] {
        let of_model = |panel: Panel| panel.iter().filter(|oracle| oracle.model() == model).count();
        assert_eq!(stepper_of(model).model(), model);
        assert_eq!((of_model(with_role(Role::Stepper)), of_model(judges())), (1, 1), "{model:?}");
    }
}

#[test]
fn every_setting_is_used_by_a_method_or_refused_by_name() {
    let given = |setting| {
        let none = Settings::default();
        match setting {
            Setting::Model => Settings { equation: Some("linear"), ..none },
            Setting::Method => Settings { method: Some("bdf"), ..none },
            Setting::Flights => Settings { flights: Some("naive"), ..none },
            Setting::Rtol => Settings { rtol: Some(1e-6), ..none },
            Setting::Order => Settings { order: Some("3"), ..none },
            Setting::Tolerance => Settings { tolerance: Some(1e-3), ..none },
            Setting::Digits => Settings { digits: Some(30), ..none },
        }
    };
    for setting in Setting::ALL {
        let mut used = false;
        for method in methods() {
            let name = method.name;
            match one(name, &given(setting), "linear") {
                Ok(_) => {
                    assert!(method.uses(setting), "{name} ignores {}", setting.name());
                    used = true;
                }
                Err(refused) => {
                    let told = refused.to_string();
                    assert!(
                        told.contains(setting.name()) && told.contains(name) && told.contains("only with"),
                        "{told}"
                    );
                }
            }
        }
        assert!(used, "{} is used by none", setting.name());
    }
}

#[test]
fn what_the_name_of_an_oracle_says_is_not_said_otherwise() {
    let bdf = Settings { method: Some("bdf"), ..Settings::default() };
    assert_eq!(one("ode/linear/bdf", &bdf, "linear").unwrap().name(), "ode/linear/bdf");
    let told = one("ode/linear/tsit45", &bdf, "linear").err().unwrap().to_string();
    assert!(told.contains("method = bdf") && told.contains("ode/linear/tsit45"), "{told}");
    let order = Settings { order: Some("5"), ..Settings::default() };
    assert_eq!(one("asymptotic", &order, "linear").unwrap().name(), "asymptotic/order-5");
    assert_eq!(one("asymptotic/order-5", &order, "linear").unwrap().name(), "asymptotic/order-5");
    assert!(one("asymptotic/order-4", &order, "linear").is_err());
    for unknown in ["od", "odes", "ode/", "ode/linear/tsit45/naive/more", "taylor/x", "", "enclosure/cubic"] {
        assert!(one(unknown, &Settings::default(), "linear").is_err(), "{unknown}");
    }
}

/// What the contract asks of every oracle; each for itself, before they are compared.
#[test]
fn every_oracle_keeps_the_contract() {
    let bare = Case::from_epsilon(3e-3, 2.0, 0.85).unwrap();
    let strong = Case::from_amplitude(1.5, 0.7, 0.6).unwrap().with_max_impacts(10).unwrap();
    for oracle in all() {
        let found = conformance::check(oracle.as_ref(), &[case(), bare.with_max_impacts(9).unwrap(), strong]);
        assert_eq!(found, Ok(()), "{}", oracle.name());
    }
}
