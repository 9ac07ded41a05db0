//! The gate in one call, for simulators that are written in Rust and are no part of this repository: what `chattercheck verify --engines` does for those in
//! other languages. `data/examples/simulator` is a crate that uses it.

use contract::{Case, Decline, History, Invalid, Model, Oracle, Uncertainty, conformance::Times};

use crate::{
    faults::explain,
    gate::{
        guests::Guests,
        judge::Judges,
        ladder,
        report::{Engine, Granted, Report},
        roles::Roles,
        run::{self, Placed, Selection},
    },
    measure::conditioning::Conditioning,
    panel,
};

/// A run over listed, edge, spaced and random cases.
#[derive(Debug, Clone, PartialEq)]
pub struct Verify {
    /// How many random cases, beside those of the other generators; at most [`Selection::MOST_CASES`].
    pub cases: usize,
    /// What the random cases are made from.
    pub seed: u64,
    /// Of how many cases one is judged by proven enclosures; listed ones and those with something wrong are judged anyway.
    pub judge_every: usize,
    /// The largest share of the cases that a simulator may decline, 0 to 1.
    pub may_decline: f64,
    /// Errors that are granted to the simulators on top of what they claim, times `1 + κ` with `κ` the conditioning of each observable
    /// ([`Conditioning`]): next to the critical amplitude nobody who computes in doubles can keep a fixed number of digits. Without, what they claim has to hold.
    pub granted: Option<Granted>,
}

impl Default for Verify {
    /// 200 random cases of seed 1, every tenth judged, hardly any declined, nothing granted.
    fn default() -> Self {
        Self { cases: 200, seed: 1, judge_every: 10, may_decline: 0.01, granted: None }
    }
}

/// A simulator with what is granted to it.
struct WithGranted<'a> {
    simulator: &'a dyn Oracle,
    granted: &'a Granted,
    /// It knows how the impacts answer to the parameters.
    sensitive: Box<dyn Oracle>,
}

impl Verify {
    /// Runs these simulators beside the oracle of the panel that steps fastest on their equation, and under the judge. The report says what is wrong, and
    /// `Report::passes` whether nothing is.
    ///
    /// # Errors
    /// When there is none, two have one name or that of an oracle of the panel, or a field is out of its range.
    pub fn run(&self, simulators: &[&dyn Oracle]) -> Result<Report, Invalid> {
        self.check(simulators)?;
        let models: Vec<Model> = simulators.iter().map(|simulator| simulator.model()).collect();
        let beside = panel::beside(&models);
        let beside: Vec<&dyn Oracle> = beside.iter().map(AsRef::as_ref).collect();
        let with_granted: Vec<WithGranted<'_>> = self
            .granted
            .iter()
            .flat_map(|granted| {
                simulators.iter().map(move |&simulator| WithGranted { simulator, granted, sensitive: panel::stepper() })
            })
            .collect();
        let all: Vec<&dyn Oracle> = match self.granted {
            Some(_) => beside.iter().copied().chain(with_granted.iter().map(|with| with as &dyn Oracle)).collect(),
            None => beside.iter().chain(simulators).copied().collect(),
        };
        let judges = panel::judges();
        let judges =
            Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: self.judge_every, closing: None };
        let selection = Selection { cases: self.cases, seed: self.seed };
        let cases = run::cases(&selection, panel::stepper().as_ref());
        // The ladders are a test of the panel itself.
        let ladders = ladder::descend(&beside, panel::SERIES)?;
        let is_theirs = |name: &str| simulators.iter().any(|simulator| simulator.name() == name);
        let guests = Guests { is_guest: &is_theirs, ..Guests::default() };
        let run = run::with_guests(&all, &guests, &judges, &Placed::all(&cases), self.seed, Some(ladders), &());
        let may_decline = |name: &str| if is_theirs(name) { self.may_decline } else { panel::may_decline(name) };
        let granted = |name: &str| self.granted.is_some() && is_theirs(name);
        let shown_by = |name: &str, flags: &str| {
            if is_theirs(name) { format!("ask {name}: {flags}") } else { panel::shown_by(name, flags) }
        };
        let roles = Roles { may_decline: &may_decline, granted: &granted, shown_by: &shown_by, ..panel::roles() };
        let described = simulators.iter().map(|simulator| self.described(simulator.name())).collect();
        let model_of = |name: &str| simulators.iter().find(|simulator| simulator.name() == name).map(|one| one.model());
        let report = Report::new(&run, &roles).with_engines(described, &run);
        Ok(report.explained(|name| explain::for_guest(name, model_of(name)?, &run.tally)))
    }

    fn described(&self, name: &str) -> Engine {
        let nothing = || Granted { time: 0.0, interval: 0.0, velocity: 0.0, tau_ch: 0.0, reason: String::new() };
        Engine {
            name: name.to_owned(),
            says: "in Rust".to_owned(),
            receipt: String::new(),
            claims: self.granted.is_none(),
            granted: self.granted.clone().unwrap_or_else(nothing),
        }
    }

    fn check(&self, simulators: &[&dyn Oracle]) -> Result<(), Invalid> {
        if self.cases > Selection::MOST_CASES {
            return Err(Invalid::new("cases", self.cases, "at most 1000000"));
        }
        if self.judge_every == 0 {
            return Err(Invalid::new("judge_every", 0, "at least 1"));
        }
        if !(0.0..=1.0).contains(&self.may_decline) {
            return Err(Invalid::new("may_decline", format!("{:?}", self.may_decline), "0 to 1"));
        }
        if let Some(Granted { time, interval, velocity, tau_ch, .. }) = self.granted {
            for (field, value) in [("time", time), ("interval", interval), ("velocity", velocity), ("tau_ch", tau_ch)] {
                if !(value >= 0.0 && value.is_finite()) {
                    return Err(Invalid::new(field, format!("{value:?}"), "0 or above, and finite, to be granted"));
                }
            }
        }
        if simulators.is_empty() {
            return Err(Invalid::new("simulators", "none", "one at least"));
        }
        for (place, name) in simulators.iter().map(|simulator| simulator.name()).enumerate() {
            if panel::method(name).is_some() {
                return Err(Invalid::new("name", name, "another name than those of the panel's oracles"));
            }
            if simulators.iter().take(place).any(|other| other.name() == name) {
                return Err(Invalid::new("name", name, "each name once"));
            }
        }
        Ok(())
    }
}

impl Oracle for WithGranted<'_> {
    fn name(&self) -> &str {
        self.simulator.name()
    }

    fn model(&self) -> Model {
        self.simulator.model()
    }

    fn times(&self) -> Times {
        Times::AreClaimed
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let mut history = self.simulator.history(case)?;
        let Granted { time, interval, velocity, tau_ch, .. } = *self.granted;
        let conditioning = Conditioning::by_other(self.sensitive.as_ref(), case);
        conditioning.widen(&mut history, 1.0, Uncertainty { time, interval, velocity }, tau_ch);
        Ok(history)
    }

    fn prepare(&self, cases: &[Case]) {
        self.simulator.prepare(cases);
    }
}
