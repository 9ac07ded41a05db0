//! Whether a mistake is named by what would explain it: every fault of the catalogue that an engine can make is planted in one, and the gate is asked what
//! explains its answers. A confusion matrix, a row a fault.

use contract::Oracle;
use serde::Serialize;

use super::{Fault, Size, explain::explain, remember::Remembering};
use crate::{
    cases::generate::{Generator, Named},
    gate::{
        explanation::Explanation,
        guests::Guests,
        judge::Judges,
        report::{Engine, EngineReport, Granted, Report},
        run::{self, Placed},
    },
    panel,
};

/// Where a fault at one impact is planted, unless told otherwise.
pub const PLANTED_AT: usize = 7;

/// The oracle that a fault is planted in.
pub fn honest(fault: &Fault) -> Box<dyn Oracle> {
    let found = panel::all().into_iter().find(|oracle| oracle.name() == fault.oracle);
    found.unwrap_or_else(panel::stepper)
}

/// The size of a fault unless told otherwise: that of the real mistake.
pub fn size(fault: &Fault) -> f64 {
    match fault.size {
        Size::Amount { natural, .. } => natural,
        Size::Depth(_) => PLANTED_AT as f64,
        Size::Whole => 1.0,
    }
}

/// The gate that the engines are put under, with what the others answer kept.
pub struct Bench {
    cases: Vec<Named>,
    steppers: Vec<Remembering>,
    judges: Vec<Remembering>,
}

/// What became of an engine with a fault.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The fault's name.
    pub fault: &'static str,
    /// The oracle that it is planted in.
    pub oracle: String,
    /// Over how many cases the engine broke: the way in which it did says what is wrong.
    pub broke: usize,
    /// How many cases it declined.
    pub declined: usize,
    /// In how many its answer is wrong.
    pub wrong: usize,
    /// Of how many cases.
    pub cases: usize,
    /// What would explain that, and does so equally well.
    pub found: Vec<Explanation>,
    /// Whether it is named.
    pub outcome: Outcome,
}

/// Whether a fault is named.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// It alone is.
    Named,
    /// It is among several that explain equally well, which is said.
    AmongEquals,
    /// It is not, and nothing else is without doubt.
    Missed,
    /// Something else is, without doubt.
    Misnamed,
    /// No answer is wrong: what the engine declined or broke over says what is the matter.
    NothingWrong,
}

impl Row {
    /// Whether nothing shows that the engine has the fault: no answer is wrong, and it neither refuses, nor breaks, nor leaves open how the block ends.
    pub fn is_unnoticed(&self) -> bool {
        let leaves_open = ["never at rest", "overturned at phi = 1"].contains(&self.fault);
        self.outcome == Outcome::NothingWrong && self.declined == 0 && self.broke == 0 && !leaves_open
    }
}

/// Whether the faults are named as they have to be: of those that make an answer wrong nine in ten, none of them as another, and none goes unnoticed.
pub fn are_named(rows: &[Row]) -> bool {
    let count = |outcome: Outcome| rows.iter().filter(|row| row.outcome == outcome).count();
    let named = count(Outcome::Named) + count(Outcome::AmongEquals);
    9 * count(Outcome::Missed) <= named && count(Outcome::Misnamed) == 0 && !rows.iter().any(Row::is_unnoticed)
}

impl Outcome {
    fn of(fault: &str, wrong: usize, found: &[Explanation]) -> Self {
        match found {
            _ if wrong == 0 => Self::NothingWrong,
            [only] if only.fault == fault => Self::Named,
            _ if found.iter().any(|found| found.fault == fault) => Self::AmongEquals,
            [first, ..] if first.is_sure() => Self::Misnamed,
            _ => Self::Missed,
        }
    }

    /// In words.
    pub fn says(self) -> &'static str {
        match self {
            Self::Named => "named",
            Self::AmongEquals => "among equals",
            Self::Missed => "MISSED",
            Self::Misnamed => "MISNAMED",
            Self::NothingWrong => "no answer wrong",
        }
    }
}

impl Bench {
    /// Cases of every generator, as an engine is asked for in a short run.
    pub fn new(seed: u64) -> Self {
        let stepper = panel::stepper();
        let of = |(generator, every): (Generator, usize)| {
            generator.cases(seed, 24, stepper.as_ref()).into_iter().step_by(every).collect::<Vec<_>>()
        };
        let cases = [(Generator::Spaced, 12), (Generator::Random, 1), (Generator::Edge, 9), (Generator::List, 6)];
        // Blocks that never rock, which are few.
        let edge = Generator::Edge.cases(seed, 0, stepper.as_ref()).into_iter();
        let still = edge.filter(|named| named.case.epsilon() <= 0.0);
        let remembering = |panel: panel::Panel| panel.into_iter().map(Remembering::new).collect();
        Self {
            cases: cases.into_iter().flat_map(of).chain(still).collect(),
            steppers: remembering(panel::with_role(panel::Role::Stepper)),
            judges: remembering(panel::judges()),
        }
    }

    /// What becomes of an engine with this fault.
    pub fn row(&self, fault: &Fault, engine: &dyn Oracle) -> Row {
        let steppers = self.steppers.iter().filter(|one| one.model() == engine.model());
        let panel: Vec<&dyn Oracle> = steppers.map(|one| one as &dyn Oracle).chain([engine]).collect();
        let judges = Judges {
            oracles: self.judges.iter().map(|judge| judge as &dyn Oracle).collect(),
            every: 10,
            closing: None,
        };
        let guests = Guests { is_guest: &|name| name == engine.name(), ..Guests::default() };
        let run = run::with_guests(&panel, &guests, &judges, &Placed::all(&self.cases), 0, None, &());
        let report = Report::new(&run, &panel::roles()).with_engines(vec![described(engine.name())], &run);
        let of_engine = |count: fn(&EngineReport) -> usize| report.engines.iter().map(count).sum();
        let samples = run.tally.samples(engine.name()).filter(|samples| samples.has_wrong());
        let found = samples.map(|samples| explain(&samples.all().cloned().collect::<Vec<_>>(), engine.model()));
        let found = found.unwrap_or_default();
        let wrong = of_engine(|engine| engine.wrong);
        Row {
            fault: fault.name,
            oracle: fault.oracle.clone(),
            broke: of_engine(|engine| engine.broke),
            declined: of_engine(|engine| engine.declined),
            wrong,
            cases: self.cases.len(),
            outcome: Outcome::of(fault.name, wrong, &found),
            found,
        }
    }
}

/// What a report says of an engine that claims its errors itself.
fn described(name: &str) -> Engine {
    let granted = Granted { time: 0.0, interval: 0.0, velocity: 0.0, tau_ch: 0.0, reason: String::new() };
    Engine { name: name.to_owned(), says: String::new(), receipt: String::new(), claims: true, granted }
}
