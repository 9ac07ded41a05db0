//! Many cases, in batches, over all processes side by side. What comes out does not depend on how many these are.

use std::{
    iter,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};

use contract::Case;

use crate::{
    answer::{Answer, Outcome},
    pool::{Pool, Slot, Told},
};

/// How many cases are asked at once, of an engine that allows as many.
pub const MOST_IN_BATCH: usize = 64;

/// The answers of a round.
pub struct Round {
    /// In the order of the cases.
    pub answers: Vec<Answer>,
    /// How often processes broke, in this round and before.
    pub spent: usize,
}

/// How many cases this engine is asked at once.
pub fn batch_size(pool: &Pool) -> usize {
    pool.welcome().max_batch.clamp(1, MOST_IN_BATCH)
}

/// Asks these cases, when processes have broken `spent` times before.
pub fn ask(pool: &Pool, cases: &[Case], spent: usize) -> Round {
    let batches: Vec<&[Case]> = cases.chunks(batch_size(pool)).collect();
    let deal = Deal { batches: &batches, next: AtomicUsize::new(0), spent: AtomicUsize::new(spent) };
    let told: Vec<Mutex<Vec<Told>>> = batches.iter().map(|_| Mutex::new(Vec::new())).collect();
    let allowed = pool.launch().restarts.saturating_sub(spent);
    std::thread::scope(|threads| {
        for place in 0..pool.size().min(batches.len()) {
            let (deal, told) = (&deal, &told);
            threads.spawn(move || {
                let Some(mut slot) = pool.slot(place) else { return };
                work(pool, &mut slot, deal, told, allowed);
            });
        }
    });
    let told = told.into_iter().map(|told| told.into_inner().unwrap_or_else(PoisonError::into_inner));
    in_order(pool, cases.len(), told.flatten(), spent)
}

/// Batches are dealt in order: those that were dealt are always the first ones.
struct Deal<'a> {
    batches: &'a [&'a [Case]],
    next: AtomicUsize,
    spent: AtomicUsize,
}

fn work(pool: &Pool, slot: &mut Slot, deal: &Deal<'_>, told: &[Mutex<Vec<Told>>], allowed: usize) {
    let mut last = None;
    while deal.spent.load(Ordering::SeqCst) <= pool.launch().restarts {
        let at = deal.next.fetch_add(1, Ordering::SeqCst);
        let (Some(batch), Some(place)) = (deal.batches.get(at), told.get(at)) else { break };
        let answers = pool.batch(slot, batch, allowed);
        let breaks: usize = answers.iter().map(|told| told.breaks).sum();
        deal.spent.fetch_add(breaks, Ordering::SeqCst);
        let answered = batch.iter().zip(&answers).rfind(|(_, told)| told.answer.breakdown().is_none());
        last = answered.map(|(case, _)| *case).or(last);
        *place.lock().unwrap_or_else(PoisonError::into_inner) = answers;
    }
    if let Some(last) = last {
        slot.hear_the_rest(&last, pool.launch().model);
    }
}

/// The answers as one process alone would have given them: after the case over which the restarts are exhausted, none is asked any more.
fn in_order(pool: &Pool, count: usize, told: impl Iterator<Item = Told>, mut spent: usize) -> Round {
    let allowed = pool.launch().restarts;
    let none = iter::repeat_with(|| Told { answer: pool.exhausted(), breaks: 0 });
    let mut answers = Vec::with_capacity(count);
    for told in told.chain(none).take(count) {
        if spent > allowed {
            answers.push(pool.exhausted());
        } else {
            spent += told.breaks;
            answers.push(told.answer);
        }
    }
    Round { answers, spent }
}

/// Whether there is something to compare an answer with.
pub fn is_answer(answer: &Answer) -> bool {
    !matches!(answer.outcome, Outcome::Broke(_))
}
