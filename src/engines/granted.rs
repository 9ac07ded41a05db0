//! An engine with the errors that its user grants it.

use contract::{Case, Decline, History, Model, Oracle, Uncertainty, conformance::Times};
use process::{Claimed, Engine, Outcome, Tolerance};

use crate::measure::conditioning::Conditioning;

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
}

/// Grants what is not claimed: by the conditioning, as the tolerance itself is there already.
fn grant(history: &mut History, claimed: Claimed, tolerance: Tolerance, conditioning: &Conditioning) {
    let unless = |is_claimed, granted| if is_claimed { 0.0 } else { granted };
    let errors = Uncertainty {
        time: unless(claimed.time, tolerance.time),
        interval: unless(claimed.interval, tolerance.interval),
        velocity: unless(claimed.velocity, tolerance.velocity),
    };
    conditioning.widen(history, 0.0, errors, unless(claimed.tau_ch, tolerance.tau_ch));
}

impl Oracle for Granted {
    fn name(&self) -> &str {
        self.engine.name()
    }

    fn model(&self) -> Model {
        self.engine.model()
    }

    fn times(&self) -> Times {
        self.engine.times()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let answer = self.engine.answer(case);
        let tolerance = self.engine.launch().tolerance;
        let claimed = answer.claimed;
        let all = Claimed { time: true, interval: true, velocity: true, tau_ch: true };
        match answer.outcome {
            Outcome::History(mut history) => {
                if claimed != all && tolerance != Tolerance::default() {
                    let conditioning = Conditioning::by_other(self.sensitive.as_ref(), case);
                    grant(&mut history, claimed, tolerance, &conditioning);
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
