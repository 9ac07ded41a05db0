//! The gate that faults are planted in: that of `verify`, on fewer cases, with what the honest oracles answer kept.

use contract::{Invalid, Model, Oracle};
use rayon::prelude::*;

use super::{Fault, plant::Planted, remember::Remembering};
use crate::{
    cases::generate::{Generator, Named},
    gate::{
        examine::{Examination, examine_answers},
        finding::Finding,
        identity::Identity,
        judge::Judges,
        ladder,
        run::{self, Run, Selection},
        shortfall::{Shortfall, shortfalls},
        tally::Tally,
    },
    measure::asking::{Answer, ask},
    panel::{self, Panel, SERIES},
};

/// A panel, cases, and what the honest oracles answer to them.
pub struct Trial {
    oracles: Vec<Remembering>,
    judges: Vec<Remembering>,
    cases: Vec<Named>,
    answers: Vec<Vec<Answer>>,
    seed: u64,
}

/// What gave a planted fault away.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// The place of the case in the gate, if it was a case and not the run as a whole.
    pub case: Option<usize>,
    /// The place of the other oracle in the panel; that of the planted one itself if it breaks a law.
    pub other: Option<usize>,
    /// The observable or law, and the other oracle; or what the run as a whole fell short of.
    pub by: String,
}

/// How many random cases there are, and of which share of the other generators.
const RANDOM: usize = 48;
const EVERY: [(Generator, usize); 4] =
    [(Generator::List, 1), (Generator::Spaced, 5), (Generator::Random, 1), (Generator::Edge, 7)];

impl Trial {
    /// The gate for a panel: all listed cases, every fifth spaced one, every seventh edge, and 48 random ones.
    pub fn new(panel: Panel, seed: u64) -> Self {
        let all = run::cases(&Selection { cases: RANDOM, seed }, panel::stepper().as_ref());
        let of = |(generator, every)| {
            all.iter().filter(move |named| named.generator == generator).step_by(every).cloned().collect::<Vec<_>>()
        };
        Self::with_cases(panel, EVERY.into_iter().flat_map(of).collect(), seed)
    }

    /// The gate for a panel and chosen cases.
    pub fn with_cases(panel: Panel, cases: Vec<Named>, seed: u64) -> Self {
        let oracles: Vec<Remembering> = panel.into_iter().map(Remembering::new).collect();
        let answers =
            cases.par_iter().map(|named| oracles.iter().map(|oracle| ask(oracle, &named.case)).collect()).collect();
        let judges = panel::judges().into_iter().map(Remembering::new).collect();
        Self { oracles, judges, cases, answers, seed }
    }

    /// The names and models of the oracles.
    pub fn oracles(&self) -> impl Iterator<Item = (&str, Model)> {
        self.oracles.iter().map(|oracle| (oracle.name(), oracle.model()))
    }

    /// The cases.
    pub fn cases(&self) -> &[Named] {
        &self.cases
    }

    /// The most impacts that the oracle of that name lists in a case: how deep a fault can be planted in it.
    pub fn depth(&self, oracle: &str) -> usize {
        let lists = self.answers.iter().flatten().filter(|answer| answer.oracle == oracle);
        lists.filter_map(|answer| Some(answer.observed()?.history.impacts.len())).max().unwrap_or(0)
    }

    /// Whether the gate is red with a fault of this size, and what made it so. What the `hint` says gave it away before is tried first; with
    /// one, it is not said which of several cases it is.
    ///
    /// # Errors
    /// When there is no oracle of the fault's name.
    pub fn detects(&self, fault: &Fault, size: f64, hint: Option<&Evidence>) -> Result<Option<Evidence>, Invalid> {
        let names = || Invalid::new("oracle", &fault.oracle, "the name of an oracle of the panel");
        let (place, honest) =
            self.oracles.iter().enumerate().find(|(_, oracle)| oracle.name() == fault.oracle).ok_or_else(names)?;
        let inner: &dyn Oracle = if fault.plant.keeps_the_question() { honest } else { honest.oracle.as_ref() };
        let planted = Planted { honest: inner, plant: fault.plant, size };
        let panel: Vec<&dyn Oracle> = self
            .oracles
            .iter()
            .enumerate()
            .map(|(other, oracle)| if other == place { &planted as &dyn Oracle } else { oracle })
            .collect();
        // What it was before is enough to see it again, and quicker than all pairs.
        if let Some(Evidence { case: Some(case), other, .. }) = hint
            && let Some(found) = self.examine(&panel, place, *case, *other).and_then(|seen| seen.evidence())
        {
            return Ok(Some(found));
        }
        let all = (0..self.cases.len()).into_par_iter();
        let seen = |case: usize| self.examine(&panel, place, case, None);
        if hint.is_none()
            && let Some(found) = all.clone().find_map_first(|case| seen(case)?.evidence())
        {
            return Ok(Some(found));
        }
        // The first red case that any thread meets ends this.
        let tallies: Result<Vec<Tally>, Evidence> = all
            .filter_map(seen)
            .map(|seen| seen.evidence().map_or_else(|| Ok(Tally::of(seen.named, &seen.examination)), Err))
            .collect();
        match tallies {
            Err(found) => Ok(Some(found)),
            Ok(tallies) => self.falls_short(&panel, place, tallies),
        }
    }

    /// One case with the planted oracle asked again, and the pairs that it is in, or only that with the `other`.
    fn examine(&self, panel: &[&dyn Oracle], place: usize, case: usize, other: Option<usize>) -> Option<Seen<'_>> {
        let (named, honest) = (self.cases.get(case)?, self.answers.get(case)?);
        let planted = panel.get(place)?;
        let answers = honest
            .iter()
            .enumerate()
            .map(|(other, answer)| if other == place { ask(*planted, &named.case) } else { answer.clone() })
            .collect();
        let wanted = |one: usize, two: usize| {
            (one == place || two == place) && other.is_none_or(|other| one == two || one == other || two == other)
        };
        // The place of the planted oracle as the other stands for a law: no pair is needed.
        let wanted = |one, two| wanted(one, two) && (other != Some(place) || one == two);
        let mut examination = examine_answers(panel, &named.case, answers, wanted);
        // The hint that names the planted oracle may stand for the judge as well as for a law.
        if other.is_none_or(|other| other == place) {
            let judges = Judges {
                oracles: self.judges.iter().map(|judge| judge as &dyn Oracle).collect(),
                every: 1,
                closing: None,
            };
            examination.judgements = judges.judge(&named.case, &examination.answers, |judged| judged == place);
        }
        Some(Seen { place, case, named, examination })
    }

    /// Whether the run as a whole is red where no case is: the ladders that the planted oracle is on, and what the report finds missing.
    fn falls_short(
        &self,
        panel: &[&dyn Oracle],
        place: usize,
        tallies: Vec<Tally>,
    ) -> Result<Option<Evidence>, Invalid> {
        let stepper = panel.iter().position(|oracle| ladder::is_stepper(*oracle, SERIES));
        let on_ladders: Vec<&dyn Oracle> = panel
            .iter()
            .enumerate()
            .filter(|(other, _)| stepper == Some(place) || stepper == Some(*other) || *other == place)
            .map(|(_, oracle)| *oracle)
            .collect();
        let ladders = ladder::descend(&on_ladders, SERIES)?;
        let mut tally = Tally::default();
        tallies.into_iter().for_each(|of_case| tally.add(of_case));
        let names = panel.iter().map(|oracle| oracle.name().to_owned()).collect();
        let run = Run::of(names, self.seed, Identity::of_all(&self.cases), tally, Some(ladders), Vec::new());
        let (shortfalls, _) = shortfalls(&run, &panel::roles());
        let by = |shortfall: Shortfall| format!("the run: {}", shortfall.in_short());
        Ok(shortfalls.into_iter().next().map(|shortfall| Evidence { case: None, other: None, by: by(shortfall) }))
    }
}

/// A case with the planted oracle in it.
struct Seen<'a> {
    place: usize,
    case: usize,
    named: &'a Named,
    examination: Examination,
}

impl Seen<'_> {
    /// The first thing that is wrong: the observable or law, and the other oracle.
    fn evidence(&self) -> Option<Evidence> {
        let name = |place: usize| self.examination.answers.get(place).map(|answer| answer.oracle.as_str());
        let finding = self.examination.findings().into_iter().next()?;
        let (other, by) = match &finding {
            Finding::Law { breach, .. } => (Some(self.place), format!("law: {}", breach.law.says())),
            Finding::Broke { breakdown, .. } => (Some(self.place), breakdown.clone()),
            Finding::Pair { oracles: [one, two], disagreement } => {
                let other = if name(self.place) == Some(one) { two } else { one };
                let place = self.examination.answers.iter().position(|answer| &answer.oracle == other);
                (place, format!("{} against {other}", disagreement.observable))
            }
            Finding::Refuted { disagreement, .. } => {
                (Some(self.place), format!("{} by the judge", disagreement.observable))
            }
        };
        Some(Evidence { case: Some(self.case), other, by })
    }
}
