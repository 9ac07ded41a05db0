//! The processes of an engine side by side, and what is done when one breaks.

use std::sync::{
    Arc, Mutex, MutexGuard, PoisonError,
    atomic::{AtomicUsize, Ordering},
};

use contract::{Case, Model};

use crate::{
    answer::{Answer, Outcome},
    launch::Launch,
    record::{Recorder, Sink},
    talk::{Replies, Talk},
    verdict::{Breakdown, Verdict},
    welcome::Welcome,
};

/// The processes of one engine.
pub struct Pool {
    launch: Arc<Launch>,
    sink: Option<Arc<dyn Sink>>,
    welcome: Welcome,
    slots: Vec<Mutex<Slot>>,
    turn: AtomicUsize,
}

/// A place for a process.
pub struct Slot {
    place: usize,
    talk: Option<Talk>,
    stderr: String,
    /// Cases that were answered again after their answer had been taken.
    pub again: Vec<Case>,
}

/// An answer, and how often a process broke over it.
pub struct Told {
    /// The answer.
    pub answer: Answer,
    /// How often a process broke.
    pub breaks: usize,
}

impl Pool {
    /// Starts the first process; the others are started when they are needed.
    ///
    /// # Errors
    /// How the first one broke.
    pub fn start(launch: Launch, sink: Option<Arc<dyn Sink>>) -> Result<Self, Breakdown> {
        launch.check().map_err(|invalid| Breakdown::new(Verdict::BadSetting, invalid.to_string()))?;
        let launch = Arc::new(launch);
        let talk = Talk::start(&launch, recorder(&launch, sink.clone(), 0))?;
        let welcome = talk.welcome().clone();
        let mut first = Some(talk);
        let slots = (0..launch.processes)
            .map(|place| Mutex::new(Slot { place, talk: first.take(), stderr: String::new(), again: Vec::new() }))
            .collect();
        Ok(Self { launch, sink, welcome, slots, turn: AtomicUsize::new(0) })
    }

    /// How it was started.
    pub fn launch(&self) -> &Launch {
        &self.launch
    }

    /// What the engine said of itself.
    pub fn welcome(&self) -> &Welcome {
        &self.welcome
    }

    /// The places.
    pub fn slots(&self) -> impl Iterator<Item = MutexGuard<'_, Slot>> {
        self.slots.iter().map(locked)
    }

    /// How many places there are.
    pub fn size(&self) -> usize {
        self.slots.len()
    }

    /// A place that is free, or the next that becomes so.
    pub fn free(&self) -> Option<MutexGuard<'_, Slot>> {
        let free = self.slots.iter().find_map(|slot| slot.try_lock().ok());
        free.or_else(|| {
            let turn = self.turn.fetch_add(1, Ordering::Relaxed);
            self.slots.get(turn % self.slots.len().max(1)).map(locked)
        })
    }

    /// The place with this number.
    pub fn slot(&self, place: usize) -> Option<MutexGuard<'_, Slot>> {
        self.slots.get(place).map(locked)
    }

    /// Asks one case alone; once more of a new process if what broke may be chance.
    pub fn alone(&self, slot: &mut Slot, case: &Case) -> Told {
        self.alone_as(slot, case, self.launch.model)
    }

    /// The same, as a case of this model.
    pub fn alone_as(&self, slot: &mut Slot, case: &Case, model: Model) -> Told {
        let first = self.once(slot, case, model);
        match first.answer.breakdown() {
            Some(broke) if broke.verdict.may_be_chance() => {
                let second = self.once(slot, case, model);
                Told { answer: second.answer, breaks: first.breaks + second.breaks }
            }
            _ => first,
        }
    }

    fn once(&self, slot: &mut Slot, case: &Case, model: Model) -> Told {
        let mut replies = self.ask(slot, std::slice::from_ref(case), model);
        match (replies.answers.pop().flatten(), replies.broke) {
            (_, Some(broke)) => Told { answer: Answer::without(Outcome::Broke(broke)), breaks: 1 },
            (Some(answer), None) => Told { answer, breaks: 0 },
            (None, None) => Told { answer: Answer::broke(Verdict::TimedOut, "no answer"), breaks: 0 },
        }
    }

    /// Asks a batch. If it breaks, what was not answered is asked alone, as long as processes break no more often than allowed.
    pub fn batch(&self, slot: &mut Slot, cases: &[Case], allowed: usize) -> Vec<Told> {
        if let [only] = cases {
            return vec![self.alone(slot, only)];
        }
        let model = self.launch.model;
        let replies = self.ask(slot, cases, model);
        let mut breaks = usize::from(replies.broke.is_some());
        let mut spent = breaks;
        let mut told = Vec::with_capacity(cases.len());
        for (case, answer) in cases.iter().zip(replies.answers) {
            told.push(match answer {
                Some(answer) => Told { answer, breaks: 0 },
                None if spent > allowed => Told { answer: self.exhausted(), breaks: 0 },
                None => {
                    // What broke the batch counts for the first that it left without an answer.
                    let mut alone = self.once(slot, case, model);
                    spent += alone.breaks;
                    alone.breaks += std::mem::take(&mut breaks);
                    alone
                }
            });
        }
        told
    }

    /// Asks the process of this place, a new one if the last one broke.
    fn ask(&self, slot: &mut Slot, cases: &[Case], model: Model) -> Replies {
        let broken =
            |broke| Replies { answers: cases.iter().map(|_| None).collect(), again: Vec::new(), broke: Some(broke) };
        let mut talk = match slot.talk.take() {
            Some(talk) => talk,
            None => match self.restart(slot.place) {
                Ok(talk) => talk,
                Err(broke) => return broken(broke),
            },
        };
        let replies = talk.ask(cases, model);
        slot.again.extend(&replies.again);
        if replies.broke.is_some() {
            slot.stderr = talk.stderr();
        } else {
            slot.talk = Some(talk);
        }
        replies
    }

    /// The answer to a case that is not asked any more.
    pub fn exhausted(&self) -> Answer {
        let allowed = self.launch.restarts;
        Answer::broke(Verdict::RestartsExhausted, format!("processes of the engine broke more than {allowed} times"))
    }

    fn restart(&self, place: usize) -> Result<Talk, Breakdown> {
        let talk = Talk::start(&self.launch, recorder(&self.launch, self.sink.clone(), place))?;
        if *talk.welcome() == self.welcome {
            return Ok(talk);
        }
        let happened = format!("first it said {:?}, then {:?}", self.welcome, talk.welcome());
        Err(Breakdown::new(Verdict::AnotherEngine, happened))
    }
}

impl Slot {
    /// Asks the last case that was answered again, only to hear what comes before the answer. The answer is not used.
    pub fn hear_the_rest(&mut self, last: &Case, model: Model) {
        let Some(mut talk) = self.talk.take() else { return };
        let replies = talk.ask(std::slice::from_ref(last), model);
        self.again.extend(&replies.again);
        if replies.broke.is_none() {
            self.talk = Some(talk);
        }
    }

    /// Stops the process; how that failed, if it did.
    pub fn stop(&mut self) -> Option<Breakdown> {
        let talk = self.talk.take()?;
        self.stderr = talk.stderr();
        talk.stop()
    }

    /// The end of the error output of the process, or of the last that was here.
    pub fn stderr(&self) -> String {
        self.talk.as_ref().map_or_else(|| self.stderr.clone(), Talk::stderr)
    }
}

fn recorder(launch: &Launch, sink: Option<Arc<dyn Sink>>, process: usize) -> Recorder {
    Recorder { sink, engine: launch.name.as_str().into(), process }
}

/// A place is whole after a panic too: its talk is taken out while it is used.
fn locked(slot: &Mutex<Slot>) -> MutexGuard<'_, Slot> {
    slot.lock().unwrap_or_else(PoisonError::into_inner)
}
