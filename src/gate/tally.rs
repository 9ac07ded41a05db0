//! What a run exercised and found, counted case by case.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::{Generator, Named},
    gate::{
        calibration::Calibration,
        compare::Agreement,
        counting::{WorstFigure, add_counts, ending_name, keep_worst, smaller, wider},
        examine::{Examination, Pairing},
        expected::Met,
        finding::Finding,
        guests::Guests,
        identity::Identity,
        pair::Pair,
        profile::Profile,
        samples::Samples,
    },
};

/// What is gathered case by case.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tally {
    pub(super) reach: Reach,
    pub(super) declines: BTreeMap<String, BTreeMap<String, usize>>,
    pub(super) broke: BTreeMap<String, BTreeMap<String, usize>>,
    pub(super) answered: BTreeMap<String, usize>,
    /// By the places of the two in the panel, until the tally is that of a run.
    #[serde(skip)]
    pub(super) pairs: BTreeMap<(usize, usize), Pair>,
    pub(super) ratio_law: BTreeMap<String, WorstFigure>,
    #[serde(default)]
    pub(super) time_left: BTreeMap<String, WorstFigure>,
    pub(super) judged: usize,
    pub(super) to_judge: usize,
    pub(super) claims: BTreeMap<String, Calibration>,
    pub(super) examined: Identity,
    pub(super) known: BTreeMap<usize, Met>,
    pub(super) profiles: BTreeMap<String, Profile>,
    pub(super) samples: BTreeMap<String, Samples>,
}

/// What a run exercised.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Reach {
    /// How many cases.
    pub cases: usize,
    /// Of them, from each generator.
    pub by_generator: BTreeMap<Generator, usize>,
    /// Histories of all oracles, by how they ended.
    pub endings: BTreeMap<String, usize>,
    /// Impacts in the histories of all oracles.
    pub impacts: usize,
    /// The shortest interval that two oracles agreed on.
    pub deepest_interval: Option<f64>,
    /// The smallest and largest of each parameter.
    pub epsilon: Option<(f64, f64)>,
    /// See `epsilon`.
    pub omega: Option<(f64, f64)>,
    /// See `epsilon`.
    pub eta: Option<(f64, f64)>,
}

impl Tally {
    /// An empty tally of a run in which so many cases are to be judged.
    pub fn expecting(to_judge: usize) -> Self {
        Self { to_judge, ..Self::default() }
    }

    /// The tally of one case.
    pub fn of(named: &Named, examination: &Examination) -> Self {
        let mut tally = Self { examined: Identity::of(named), ..Self::default() };
        let case = &named.case;
        let reach = &mut tally.reach;
        reach.cases = 1;
        reach.by_generator.insert(named.generator, 1);
        reach.epsilon = Some((case.epsilon(), case.epsilon()));
        reach.omega = Some((case.omega(), case.omega()));
        reach.eta = Some((case.eta(), case.eta()));
        for answer in &examination.answers {
            let Some(observed) = answer.observed() else { continue };
            *tally.answered.entry(answer.oracle.clone()).or_default() += 1;
            *reach.endings.entry(ending_name(observed.history.ending)).or_default() += 1;
            reach.impacts += observed.history.impacts.len();
        }
        for (oracle, decline) in examination.declines() {
            *tally.declines.entry(oracle.to_owned()).or_default().entry(decline.reason().to_owned()).or_default() += 1;
        }
        for (oracle, how) in examination.breakdowns() {
            *tally.broke.entry(oracle.to_owned()).or_default().entry(how.reason().to_owned()).or_default() += 1;
        }
        for (answer, checked) in examination.answers.iter().zip(&examination.checked) {
            if let Some(figure) = checked.ratio {
                tally.ratio_law.insert(answer.oracle.clone(), WorstFigure::new(named, figure));
            }
            if let Some(figure) = checked.left {
                tally.time_left.insert(answer.oracle.clone(), WorstFigure::new(named, figure));
            }
        }
        tally.judged = usize::from(examination.is_judged());
        for judgement in &examination.judgements {
            if let Some(answer) = examination.answers.get(judgement.place) {
                tally.claims.insert(answer.oracle.clone(), judgement.calibration.clone());
            }
        }
        for &(entry, difference) in &examination.known {
            tally.known.entry(entry).or_default().add(Met { cases: 1, largest: difference });
        }
        for (i, j, pairing) in &examination.pairs {
            let interval = |place: usize, n: usize| {
                let impacts = &examination.answers.get(place)?.observed()?.history.impacts;
                Some(impacts.get(n.checked_sub(1)?)?.interval)
            };
            let pair = tally.pairs.entry((*i, *j)).or_default();
            match pairing {
                Pairing::Absent => pair.absent = 1,
                Pairing::Incomparable(why) => {
                    pair.incomparable.insert((*why).to_owned(), 1);
                }
                Pairing::Compared(comparison) => {
                    pair.add_comparison(named, comparison);
                    let deepest = interval(*i, comparison.impacts);
                    if comparison.agreement == Agreement::Agree && comparison.vacuous == 0 {
                        tally.reach.deepest_interval = smaller(tally.reach.deepest_interval, deepest);
                    }
                }
            }
        }
        tally
    }

    /// The same with the profiles of the guests, and samples of what they answer.
    #[must_use]
    pub fn with_guests(mut self, named: &Named, examination: &Examination, guests: &Guests) -> Self {
        for (place, answer) in examination.answers.iter().enumerate() {
            let Some(observed) = answer.observed().filter(|_| (guests.is_guest)(&answer.oracle)) else { continue };
            let findings = guests.against(examination, place);
            if findings.is_empty() {
                (guests.was_right)(&answer.oracle, &named.case);
            }
            if let Some(profile) = Profile::of(named, examination, place, &findings, guests) {
                self.profiles.insert(answer.oracle.clone(), profile);
            }
            let is_known = |finding: &Finding| guests.known.iter().any(|known| known.excuses(&named.case, finding));
            // What is known to be wrong says nothing about what else is.
            if findings.is_empty() || !findings.iter().all(is_known) {
                let samples = Samples::of(named, &observed.history, &findings);
                self.samples.insert(answer.oracle.clone(), samples);
            }
        }
        self
    }

    /// Some of what a guest answered.
    pub fn samples(&self, guest: &str) -> Option<&Samples> {
        self.samples.get(guest)
    }

    /// Of how many cases every history was judged.
    pub fn judged(&self) -> usize {
        self.judged
    }

    /// Adds the tally of other cases, in whatever order they come.
    pub fn add(&mut self, other: Self) {
        let (mine, theirs) = (&mut self.reach, other.reach);
        mine.cases += theirs.cases;
        mine.impacts += theirs.impacts;
        add_counts(&mut mine.by_generator, theirs.by_generator);
        add_counts(&mut mine.endings, theirs.endings);
        mine.deepest_interval = smaller(mine.deepest_interval, theirs.deepest_interval);
        mine.epsilon = wider(mine.epsilon, theirs.epsilon);
        mine.omega = wider(mine.omega, theirs.omega);
        mine.eta = wider(mine.eta, theirs.eta);
        add_counts(&mut self.answered, other.answered);
        for (oracle, reasons) in other.declines {
            add_counts(self.declines.entry(oracle).or_default(), reasons);
        }
        for (oracle, ways) in other.broke {
            add_counts(self.broke.entry(oracle).or_default(), ways);
        }
        for (oracle, worst) in other.ratio_law {
            keep_worst(&mut self.ratio_law, oracle, worst);
        }
        for (oracle, worst) in other.time_left {
            keep_worst(&mut self.time_left, oracle, worst);
        }
        self.judged += other.judged;
        self.to_judge += other.to_judge;
        for (oracle, calibration) in other.claims {
            self.claims.entry(oracle).or_default().add_all(calibration);
        }
        self.examined.add(other.examined);
        for (entry, met) in other.known {
            self.known.entry(entry).or_default().add(met);
        }
        for (guest, profile) in other.profiles {
            self.profiles.entry(guest).or_default().add(profile);
        }
        for (guest, samples) in other.samples {
            self.samples.entry(guest).or_default().add(samples);
        }
        for (places, pair) in other.pairs {
            self.pairs.entry(places).or_default().add(pair);
        }
    }
}
