//! An engine as an oracle.

use std::{
    collections::{HashMap, HashSet},
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};

use contract::{Case, Decline, History, Model, Oracle, conformance::Times};

use crate::{
    answer::{Answer, Outcome},
    key::Key,
    launch::Launch,
    pool::Pool,
    record::Sink,
    round, sample,
    verdict::{Breakdown, Verdict},
    welcome::Welcome,
    words,
};

/// An engine of somebody else: its processes, and a memory of its answers.
pub struct Engine {
    pool: Pool,
    memory: Mutex<HashMap<Key, Answer>>,
    /// How often processes broke over cases that were asked together. It decides which of them are not asked any more.
    spent: AtomicUsize,
    /// How often over those that were asked by the way, in no order that is always the same.
    by_the_way: AtomicUsize,
}

impl Engine {
    /// Starts an engine and shakes hands. Every line of the talk goes to the sink, if there is one.
    ///
    /// # Errors
    /// How it broke.
    pub fn start(launch: Launch, sink: Option<Arc<dyn Sink>>) -> Result<Self, Breakdown> {
        Ok(Self {
            pool: Pool::start(launch, sink)?,
            memory: Mutex::default(),
            spent: AtomicUsize::new(0),
            by_the_way: AtomicUsize::new(0),
        })
    }

    /// How it was started.
    pub fn launch(&self) -> &Launch {
        self.pool.launch()
    }

    /// What it said of itself.
    pub fn welcome(&self) -> &Welcome {
        self.pool.welcome()
    }

    /// Asks these cases in batches, over all processes side by side, and remembers the answers for [`Engine::answer`]. The answers are the same for any
    /// number of processes. What is remembered already is not asked again; what was remembered before stays until [`Engine::forget`].
    pub fn ask_all(&self, cases: &[Case]) {
        let known: HashSet<Key> = self.memory().keys().copied().collect();
        let mut seen = known;
        let cases: Vec<Case> = cases
            .iter()
            .filter(|case| self.refusal(case).is_none() && seen.insert(Key::from(*case)))
            .copied()
            .collect();
        let mut round = round::ask(&self.pool, &cases, self.spent.load(Ordering::SeqCst));
        if round::batch_size(&self.pool) > 1 && cases.len() > 1 {
            sample::check(&self.pool, &cases, &mut round);
        }
        self.spent.store(round.spent, Ordering::SeqCst);
        let mut memory = self.memory();
        memory.extend(cases.iter().map(Key::from).zip(round.answers));
        for mut slot in self.pool.slots() {
            note_again(&mut memory, slot.again.drain(..));
        }
    }

    /// The answer to a case: from memory, or asked alone.
    pub fn answer(&self, case: &Case) -> Answer {
        if let Some(decline) = self.refusal(case) {
            return Answer::without(Outcome::Declined(decline));
        }
        if let Some(answer) = self.memory().get(&Key::from(case)) {
            return answer.clone();
        }
        let broke = |count: &AtomicUsize| count.load(Ordering::SeqCst) > self.launch().restarts;
        if broke(&self.spent) || broke(&self.by_the_way) {
            return self.pool.exhausted();
        }
        let Some(mut slot) = self.pool.free() else { return self.pool.exhausted() };
        let told = self.pool.alone(&mut slot, case);
        self.by_the_way.fetch_add(told.breaks, Ordering::SeqCst);
        note_again(&mut self.memory(), slot.again.drain(..));
        told.answer
    }

    /// The answer to a case, if it was asked with others and is remembered.
    pub fn remembered(&self, case: &Case) -> Option<Answer> {
        self.memory().get(&Key::from(case)).cloned()
    }

    /// Asks a case as one of the other model, which the engine does not offer: it should decline. What it answers is not remembered.
    pub fn answer_to_the_other_model(&self, case: &Case) -> Answer {
        let Some(mut slot) = self.pool.free() else { return self.pool.exhausted() };
        self.pool.alone_as(&mut slot, case, other(self.launch().model)).answer
    }

    /// Drops what is remembered.
    pub fn forget(&self) {
        self.memory().clear();
    }

    /// How often processes of it broke so far.
    pub fn breaks(&self) -> usize {
        self.spent.load(Ordering::SeqCst) + self.by_the_way.load(Ordering::SeqCst)
    }

    /// The end of the error output, at most 64 KiB, of each process that wrote some.
    pub fn stderr(&self) -> Vec<String> {
        self.pool.slots().map(|slot| slot.stderr()).filter(|text| !text.is_empty()).collect()
    }

    /// Stops all processes, and says which of them did not want to.
    pub fn stop(self) -> Vec<Breakdown> {
        self.stop_all()
    }

    fn stop_all(&self) -> Vec<Breakdown> {
        self.pool.slots().filter_map(|mut slot| slot.stop()).collect()
    }

    /// Why this case is not even asked.
    fn refusal(&self, case: &Case) -> Option<Decline> {
        if self.launch().model == Model::Linear {
            return None;
        }
        let Some(slenderness) = case.slenderness() else { return Some(Decline::NeedsSlenderness) };
        let wanted = words::normalisation(slenderness.normalisation());
        let offered = self.welcome().normalisations.iter().any(|offer| offer == wanted);
        (!offered).then_some(Decline::Unsupported { what: "this normalisation of the amplitude" })
    }

    fn memory(&self) -> MutexGuard<'_, HashMap<Key, Answer>> {
        self.memory.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A case that was answered again, later, has two answers: none of them is used any more.
fn note_again(memory: &mut HashMap<Key, Answer>, again: impl Iterator<Item = Case>) {
    for case in again {
        memory.insert(Key::from(&case), Answer::broke(Verdict::TwoAnswers, "a second answer came later"));
    }
}

fn other(model: Model) -> Model {
    match model {
        Model::Linear => Model::Nonlinear,
        Model::Nonlinear => Model::Linear,
    }
}

impl Drop for Engine {
    fn drop(&mut self) {
        self.stop_all();
    }
}

impl Oracle for Engine {
    fn name(&self) -> &str {
        &self.launch().name
    }

    fn model(&self) -> Model {
        self.launch().model
    }

    /// One that claims errors is taken at its word as any oracle is. Of another, what its user grants it for a time is all that is said of it: it may have a
    /// clock of its own, or print few digits.
    fn times(&self) -> Times {
        if self.welcome().claims { Times::AreSums } else { Times::AreClaimed }
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        self.answer(case).told()
    }

    fn prepare(&self, cases: &[Case]) {
        self.forget();
        self.ask_all(cases);
    }
}
