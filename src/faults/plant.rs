//! How a fault gets into an oracle.

use contract::{Case, Decline, History, Invalid, Model, Oracle, Sensitivity};

use super::{
    recursion::{self, Lost},
    stepper::{self, Wrong},
};

/// One way to plant a fault of a given size.
#[derive(Debug, Clone, Copy)]
pub enum Plant {
    /// The oracle is asked another case: a wrong parameter.
    Question(fn(&Case, f64) -> Result<Case, Invalid>),
    /// The oracle's answer is changed: wrong bookkeeping, wrong claims, a wrong ending. Where the size is a depth, it is the number of an impact.
    Answer(fn(&Case, f64, &mut History)),
    /// The oracle declines some cases.
    Refusal(fn(&Case) -> bool),
    /// A [`stepper`] that makes the fault takes the place of the closed form.
    Stepper(fn(f64) -> Wrong),
    /// A [`recursion`] that makes the fault takes the place of the series.
    Series(fn(f64) -> Lost),
    /// Another oracle answers in its place, with its claims.
    Instead(fn() -> Box<dyn Oracle>),
}

impl Plant {
    /// Whether the honest oracle is asked the very cases that the gate asks.
    pub(in crate::faults) fn keeps_the_question(self) -> bool {
        !matches!(self, Self::Question(_))
    }
}

/// An oracle with a fault in it. It goes by the name of the honest one.
pub struct Planted<'a> {
    /// The honest oracle.
    pub honest: &'a dyn Oracle,
    /// How the fault is planted.
    pub plant: Plant,
    /// How large it is.
    pub size: f64,
}

impl Oracle for Planted<'_> {
    fn name(&self) -> &str {
        self.honest.name()
    }

    fn model(&self) -> Model {
        self.honest.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        match self.plant {
            Plant::Question(ask) => {
                // A parameter that the fault pushes out of its range is refused, as the honest oracle would.
                let asked = ask(case, self.size).map_err(|_| Decline::Unsupported { what: "a case out of range" })?;
                self.honest.history(&asked)
            }
            Plant::Answer(change) => {
                let mut history = self.honest.history(case)?;
                change(case, self.size, &mut history);
                Ok(history)
            }
            Plant::Refusal(refuses) => match refuses(case) {
                true => Err(Decline::Unsupported { what: "this case" }),
                false => self.honest.history(case),
            },
            Plant::Stepper(wrong) => Ok(stepper::history(case, &wrong(self.size), &self.honest.history(case)?)),
            Plant::Instead(other) => Ok(claimed(other().history(case)?, &self.honest.history(case)?)),
            Plant::Series(lost) => Ok(recursion::history(case, &lost(self.size), &self.honest.history(case)?)),
        }
    }

    fn sensitivities(&self, case: &Case) -> Option<Vec<Sensitivity>> {
        self.honest.sensitivities(case)
    }
}

/// A history with the claims of the honest one; of impacts that this lacks, those of its last.
fn claimed(mut history: History, honest: &History) -> History {
    for (n, impact) in history.impacts.iter_mut().enumerate() {
        if let Some(theirs) = honest.impacts.get(n).or(honest.impacts.last()) {
            impact.uncertainty = theirs.uncertainty;
        }
    }
    if let Some(time) = &mut history.chattering_time {
        // As an honest oracle claims it in doubles: some tens of roundings.
        time.uncertainty = 1e-14 * time.value;
    }
    history
}
