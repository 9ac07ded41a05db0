//! An oracle that is asked each case once: what it answered is kept, so that the honest methods cost nothing while faults are planted in
//! one of them.

use std::{
    collections::HashMap,
    sync::{Mutex, PoisonError},
};

use contract::{Case, Decline, History, Horizon, Model, Normalisation, Oracle, Sensitivity};

/// A case as what can be looked up: every number by its bits.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    numbers: [u64; 3],
    slenderness: Option<(u64, Normalisation)>,
    max_impacts: usize,
    until: Option<u64>,
}

impl Key {
    fn new(case: &Case) -> Self {
        let until = match case.horizon() {
            Horizon::HalfPeriod => None,
            Horizon::Until(time) => Some(time.to_bits()),
        };
        Self {
            numbers: [case.epsilon(), case.omega(), case.eta()].map(f64::to_bits),
            slenderness: case.slenderness().map(|s| (s.alpha().to_bits(), s.normalisation())),
            max_impacts: case.max_impacts(),
            until,
        }
    }
}

/// An oracle and everything that it has answered.
pub struct Remembering {
    /// The oracle itself, for questions that are not worth keeping.
    pub(in crate::faults) oracle: Box<dyn Oracle>,
    answers: Mutex<HashMap<Key, Result<History, Decline>>>,
    sensitivities: Mutex<HashMap<Key, Option<Vec<Sensitivity>>>>,
}

impl Remembering {
    /// Asked nothing yet.
    pub fn new(oracle: Box<dyn Oracle>) -> Self {
        Self { oracle, answers: Mutex::default(), sensitivities: Mutex::default() }
    }
}

impl Oracle for Remembering {
    fn name(&self) -> &str {
        self.oracle.name()
    }

    fn model(&self) -> Model {
        self.oracle.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let key = Key::new(case);
        // A map is whole between any two of its operations, so one that a panic left behind can be read.
        if let Some(known) = self.answers.lock().unwrap_or_else(PoisonError::into_inner).get(&key) {
            return known.clone();
        }
        let answer = self.oracle.history(case);
        self.answers.lock().unwrap_or_else(PoisonError::into_inner).insert(key, answer.clone());
        answer
    }

    fn sensitivities(&self, case: &Case) -> Option<Vec<Sensitivity>> {
        let key = Key::new(case);
        if let Some(known) = self.sensitivities.lock().unwrap_or_else(PoisonError::into_inner).get(&key) {
            return known.clone();
        }
        let sensitivities = self.oracle.sensitivities(case);
        self.sensitivities.lock().unwrap_or_else(PoisonError::into_inner).insert(key, sensitivities.clone());
        sensitivities
    }
}
