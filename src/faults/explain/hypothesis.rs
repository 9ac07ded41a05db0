//! The hypotheses: the faults of the catalogue, planted in honest oracles that answer each case once.

use contract::{Case, History, Model, Oracle};

use crate::{
    faults::{
        Fault, Size,
        catalogue::of_engines,
        plant::{Plant, Planted},
        remember::Remembering,
    },
    panel,
};

/// A fault, and the honest oracle that it is planted in.
pub(super) struct Hypothesis {
    /// The fault.
    pub fault: Fault,
    honest: Remembering,
}

/// The hypotheses about an engine for this equation.
pub(super) fn all(model: Model) -> Vec<Hypothesis> {
    let stepper = panel::stepper_of(model);
    let faults = of_engines();
    let hypothesis = |fault: Fault| {
        let is_inside = matches!(fault.plant, Plant::Stepper(_) | Plant::Series(_));
        let planted_in =
            if fault.oracle == panel::SERIES || is_inside { fault.oracle.clone() } else { stepper.name().to_owned() };
        let honest = panel::all().into_iter().find(|oracle| oracle.name() == planted_in && oracle.model() == model)?;
        Some(Hypothesis { fault, honest: Remembering::new(honest) })
    };
    let mut seen = Vec::new();
    let once = |fault: &Fault| {
        let key = (fault.name, fault.oracle == panel::SERIES);
        let is_new = !seen.contains(&key);
        seen.push(key);
        is_new
    };
    faults.into_iter().filter(once).filter_map(hypothesis).collect()
}

impl Hypothesis {
    /// What the case would be answered without the fault.
    pub fn truth(&self, case: &Case) -> Option<History> {
        self.honest.history(case).ok()
    }

    /// What it would be answered with the fault of this size.
    pub fn at(&self, size: f64, case: &Case) -> Option<History> {
        // Other questions than the case itself are not worth keeping.
        let honest: &dyn Oracle =
            if self.fault.plant.keeps_the_question() { &self.honest } else { self.honest.oracle.as_ref() };
        Planted { honest, plant: self.fault.plant, size }.history(case).ok()
    }

    /// The size of the real mistake; 1 where that means nothing.
    pub fn natural(&self) -> f64 {
        match self.fault.size {
            Size::Amount { natural, .. } => natural,
            Size::Depth(_) | Size::Whole => 1.0,
        }
    }

    /// Whether a fault of this size is one that somebody makes: a term of an equation is left out or it is not, and what is next to nothing is no mistake.
    pub fn is_plausible(&self, size: f64) -> bool {
        const TERM: f64 = 0.1;
        const NOTHING: f64 = 1e-9;
        match self.fault.size {
            Size::Amount { natural, .. } if natural >= TERM => (0.5..2.0).contains(&(size / natural)),
            Size::Amount { natural, .. } => (size / natural).abs() > NOTHING,
            Size::Depth(_) | Size::Whole => true,
        }
    }

    /// Whether the answer jumps as the size grows, as where a list ends below a threshold.
    pub fn is_stepwise(&self) -> bool {
        matches!((self.fault.plant, self.fault.size), (Plant::Answer(_), Size::Amount { .. }))
    }
}
