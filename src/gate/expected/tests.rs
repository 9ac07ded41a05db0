//! The entries can be read, name what there is, and are strict.

use super::*;
use crate::{gate::tolerance, panel};

#[test]
fn the_table_can_be_read_and_names_oracles_or_models() {
    let read = read(include_str!("../../../data/expected.toml")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(read, table());
    assert!(!read.is_empty());
    let all: Vec<String> = panel::all().iter().map(|oracle| oracle.name().to_owned()).collect();
    for entry in table() {
        for name in &entry.pair {
            assert!(["linear", "nonlinear"].contains(&name.as_str()) || all.contains(name), "nobody is called {name}");
        }
        assert!(entry.reason.len() > 40, "{}: no reason", entry.says());
        let of_ladder = entry.regime == Regime::LadderOfAlpha;
        assert_eq!(of_ladder, entry.observable == Differs::Order, "{}", entry.says());
        assert!(entry.observable != Differs::ChatteringTime || entry.at_least > 0.0, "{}", entry.says());
    }
    assert!(super::read("[[divergence]]\npair = [\"a\", \"b\"]\ncolour = 3").is_err());
}

/// Seen seldom it says nothing; seen often it has to be as large as it says.
#[test]
fn an_entry_that_no_longer_shows_is_out_of_date() {
    let entry = Divergence { within: 10, at_least: 0.1, ..table()[0].clone() };
    let out = |cases: usize, largest: f64| entry.is_out_of_date(Met { cases, largest });
    assert_eq!(
        [out(9, 0.0), out(10, 0.0), out(10, 0.09), out(10, 0.1), out(10, f64::NAN)],
        [false, true, true, false, true]
    );
    let any = Divergence { at_least: 0.0, ..entry };
    assert!(
        any.is_out_of_date(Met { cases: 10, largest: 0.0 }) && !any.is_out_of_date(Met { cases: 10, largest: 1.0 })
    );
}

/// A ladder that is known not to hold is excused, between these two oracles and no others.
#[test]
fn only_the_ladders_of_the_entries_are_excused() {
    let descent = |oracles: [&str; 2], order: Option<f64>| Descent {
        ladder: Ladder::Alpha,
        oracles: oracles.map(str::to_owned),
        omega: 2.0,
        eta: 0.92,
        rungs: Vec::new(),
        order,
        expected: (2.0, tolerance::ALPHA_LADDER.value),
    };
    let excused = |oracles| table().iter().any(|entry| entry.excuses(&descent(oracles, None)));
    assert!(excused(["closed-form", "ode/nonlinear/bdf"]) && excused(["closed-form", "ode/nonlinear/tr-bdf2"]));
    assert!(!excused(["closed-form", "taylor"]) && !excused(["closed-form", "ode/nonlinear/tsit45"]));
}
