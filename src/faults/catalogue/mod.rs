//! The faults, by kind.

mod bookkeeping;
mod claims;
mod endings;
mod events;
mod formulas;
mod parameters;
mod series;
mod slenderness;
mod strangers;
mod tail;

use contract::Model;

use super::{Fault, Size, plant::Plant};
use crate::panel::SERIES;

/// The oracle that the stepper stands in for, and in which most faults are planted: it claims the least error, so that it is the others
/// that have to be good enough to see them.
const STEPPER: &str = "closed-form";

/// The oracle for faults in what only the nonlinear model has.
const NONLINEAR: &str = "taylor";

/// Every fault, for a gate with these oracles: those that have to be seen in each oracle, once for each; the rest where their oracle is
/// among them.
pub fn catalogue<'a>(oracles: impl Iterator<Item = (&'a str, Model)>) -> Vec<Fault> {
    let oracles: Vec<(&str, Model)> = oracles.collect();
    let names = || oracles.iter().map(|(name, _)| *name);
    let everywhere = names().flat_map(|name| [parameters::everywhere(name), events::everywhere(name)]).flatten();
    let once = [
        parameters::all(),
        formulas::all(),
        events::all(),
        bookkeeping::all(),
        tail::all(),
        endings::all(),
        claims::all(),
        slenderness::all(),
        series::all(),
    ];
    let mut faults: Vec<Fault> = everywhere.chain(once.into_iter().flatten()).collect();
    faults.retain(|fault| names().any(|name| name == fault.oracle));
    faults
}

/// The mistakes that an engine can make: the faults of a stepper of each equation and of the series, and what only a stranger gets wrong.
pub fn of_engines() -> Vec<Fault> {
    let oracles = [(STEPPER, Model::Linear), (SERIES, Model::Linear), (NONLINEAR, Model::Nonlinear)];
    catalogue(oracles.into_iter()).into_iter().chain(strangers::all()).collect()
}

fn amount(name: &'static str, as_if: &'static str, meaning: &'static str, natural: f64, plant: Plant) -> Fault {
    Fault { name, as_if, oracle: STEPPER.to_owned(), size: Size::Amount { meaning, natural }, plant }
}

fn at_depth(name: &'static str, as_if: &'static str, plant: Plant) -> Fault {
    Fault { name, as_if, oracle: STEPPER.to_owned(), size: Size::Depth(0), plant }
}

/// A fault that is only one if another impact follows.
fn between(name: &'static str, as_if: &'static str, plant: Plant) -> Fault {
    Fault { size: Size::Depth(1), ..at_depth(name, as_if, plant) }
}

fn whole(name: &'static str, as_if: &'static str, plant: Plant) -> Fault {
    Fault { name, as_if, oracle: STEPPER.to_owned(), size: Size::Whole, plant }
}

/// The same fault in another oracle.
fn within(oracle: &str, fault: Fault) -> Fault {
    Fault { oracle: oracle.to_owned(), ..fault }
}
