//! What an oracle answered to a case.

use std::panic::{AssertUnwindSafe, catch_unwind};

use contract::{Case, Decline, Model, Oracle};

use crate::measure::observables::Observed;

/// One oracle's answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The oracle's name.
    pub oracle: String,
    /// The equation that it solves.
    pub model: Model,
    /// What it said.
    pub reply: Reply,
}

/// What an oracle said.
#[derive(Debug, Clone, PartialEq)]
pub enum Reply {
    /// A history.
    Observed(Observed),
    /// That it can't do the case.
    Declined(Decline),
    /// Nothing: the engine of somebody else behind it broke, in this way. Never a refusal.
    Broke(Decline),
    /// Nothing: it panicked, with this message. Always a failure.
    Panicked(String),
}

/// Asks an oracle. A panic inside a method must not take the run with it.
pub fn ask(oracle: &dyn Oracle, case: &Case) -> Answer {
    let reply = match catch_unwind(AssertUnwindSafe(|| oracle.history(case))) {
        Ok(Ok(history)) => Reply::Observed(Observed::new(case, history)),
        Ok(Err(decline)) if decline.is_breakdown() => Reply::Broke(decline),
        Ok(Err(decline)) => Reply::Declined(decline),
        Err(payload) => {
            let text = payload.downcast_ref::<String>().map(String::as_str);
            let message = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("no message");
            Reply::Panicked(message.to_owned())
        }
    };
    Answer { oracle: oracle.name().to_owned(), model: oracle.model(), reply }
}

impl Answer {
    /// The history and what follows from it, if there is one.
    pub fn into_observed(self) -> Option<Observed> {
        match self.reply {
            Reply::Observed(observed) => Some(observed),
            Reply::Declined(_) | Reply::Broke(_) | Reply::Panicked(_) => None,
        }
    }

    /// The history and what follows from it, if there is one.
    pub fn observed(&self) -> Option<&Observed> {
        match &self.reply {
            Reply::Observed(observed) => Some(observed),
            _ => None,
        }
    }
}
