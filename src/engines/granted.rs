//! An engine with the errors that its user grants it.

use contract::{Case, Decline, Estimate, History, Impact, Model, Oracle};
use process::{Claimed, Engine, Outcome, Tolerance};

use crate::measure::{
    conditioning::Conditioning,
    observables::{Observable, Observed},
};

/// An engine as an oracle whose errors, where it claims none, are what its user grants it: the tolerance of the manifest times `1 + κ`, with `κ` how much of
/// the observable one unit of relative change in the parameters makes ([`Conditioning`]). Next to the critical amplitude nobody who computes in doubles can
/// keep a fixed number of digits; what can be kept is the error of the parameters for which the answer would be right.
pub struct Granted {
    engine: Engine,
    /// It knows how the impacts answer to the parameters.
    sensitive: Box<dyn Oracle>,
}

impl Granted {
    /// An engine; `sensitive` is an oracle that has derivatives.
    pub fn new(engine: Engine, sensitive: Box<dyn Oracle>) -> Self {
        Self { engine, sensitive }
    }

    /// The engine itself.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Ends it.
    pub fn into_engine(self) -> Engine {
        self.engine
    }

    fn conditioning(&self, case: &Case) -> Conditioning {
        let history = self.sensitive.history(case).ok();
        let by = |history| Conditioning::by(self.sensitive.as_ref(), case, &Observed::new(case, history));
        history.and_then(by).unwrap_or_default()
    }
}

/// Grants what is not claimed.
fn grant(history: &mut History, claimed: Claimed, tolerance: Tolerance, conditioning: &Conditioning) {
    for (n, Impact { uncertainty, .. }) in (1..).zip(&mut history.impacts) {
        for (is_claimed, error, granted, observable) in [
            (claimed.time, &mut uncertainty.time, tolerance.time, Observable::ImpactTime),
            (claimed.interval, &mut uncertainty.interval, tolerance.interval, Observable::Interval),
            (claimed.velocity, &mut uncertainty.velocity, tolerance.velocity, Observable::Velocity),
        ] {
            // The tolerance itself is there already.
            if !is_claimed && granted > 0.0 {
                *error += granted * conditioning.at(observable, n);
            }
        }
    }
    if let Some(Estimate { uncertainty, .. }) = &mut history.chattering_time
        && !claimed.tau_ch
        && tolerance.tau_ch > 0.0
    {
        *uncertainty += tolerance.tau_ch * conditioning.at(Observable::ChatteringTime, 0);
    }
}

impl Oracle for Granted {
    fn name(&self) -> &str {
        self.engine.name()
    }

    fn model(&self) -> Model {
        self.engine.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let answer = self.engine.answer(case);
        let tolerance = self.engine.launch().tolerance;
        let claimed = answer.claimed;
        let all = Claimed { time: true, interval: true, velocity: true, tau_ch: true };
        match answer.outcome {
            Outcome::History(mut history) => {
                if claimed != all && tolerance != Tolerance::default() {
                    grant(&mut history, claimed, tolerance, &self.conditioning(case));
                }
                Ok(history)
            }
            Outcome::Declined(decline) => Err(decline),
            Outcome::Broke(broke) => Err(broke.into()),
        }
    }

    fn prepare(&self, cases: &[Case]) {
        self.engine.prepare(cases);
    }
}
