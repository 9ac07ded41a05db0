//! The candidates, from nothing at all to proven bounds: what each would get wrong, what it would cost, and why it may not be asked.

use std::fmt;

use contract::{Decline, FlightSolver, Model, Oracle};

use super::{Question, Refusal, estimate::Errors};
use crate::{
    motion::linearisation,
    panel::{self, Settings},
};

/// A way to answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// The ground never reaches the threshold: there is nothing to compute.
    Nothing,
    /// The amplitude is above the critical one: the chattering is incomplete.
    CriticalAmplitude,
    /// Flights by the closed form of Eq. 4, and the sum closed.
    Linear,
    /// The closed form with the first-order effect of the slenderness put back into each flight.
    Corrected,
    /// Eq. 65.
    PaperSeries,
    /// So many terms of the series.
    Series(usize),
    /// Flights by Taylor series of Eq. 2, and the sum closed.
    Nonlinear,
    /// The generic solver on Eq. 2.
    Ode,
    /// The series, summed with its singularity.
    Resummed,
    /// Proven bounds on the equation that is asked for.
    Enclosure,
}

/// The candidates.
pub(super) const ALL: [Way; 12] = [
    Way::Nothing,
    Way::CriticalAmplitude,
    Way::Linear,
    Way::Corrected,
    Way::PaperSeries,
    Way::Series(1),
    Way::Series(4),
    Way::Series(16),
    Way::Nonlinear,
    Way::Ode,
    Way::Resummed,
    Way::Enclosure,
];

/// What a sum that is closed may leave, as a share of the tolerance.
pub(super) const CLOSING_SHARE: f64 = 0.1;
/// What rounding leaves of a chattering time that is stepped in doubles, where nothing amplifies it.
const STEPPING: f64 = 1e-14;
/// The same for the generic solver at its finest.
const SOLVER: f64 = 1e-11;

impl Way {
    /// The oracle that it is, if it is one.
    pub fn oracle(self, question: &Question) -> Option<Box<dyn Oracle>> {
        let equation = if question.case.slenderness().is_some() { "nonlinear" } else { "linear" };
        panel::one(&self.to_string(), &Settings::default(), equation).ok()
    }

    /// The solver of its flights, if it goes from flight to flight.
    ///
    /// # Errors
    /// When that declines the case.
    pub(super) fn flights(self, question: &Question) -> Result<Option<Box<dyn FlightSolver>>, Decline> {
        let case = &question.case;
        Ok(Some(match self {
            Self::Linear => panel::stepper().flights(case)?,
            Self::Corrected => Box::new(linearisation::Flights::new(panel::stepper().as_ref(), case)?),
            Self::Nonlinear => panel::stepper_of(Model::Nonlinear).flights(case)?,
            _ => return Ok(None),
        }))
    }

    /// What it does, for someone who does not know its name.
    pub fn description(self) -> &'static str {
        match self {
            Self::Nothing => "no computation at all",
            Self::CriticalAmplitude => "the table of the largest amplitude at which a block comes to rest",
            Self::Linear => {
                "exact flights of the slender block from impact to impact, and a formula for the infinitely many that are left"
            }
            Self::Corrected => {
                "flights of the slender block, each corrected for how stocky the block is, and a formula for the infinitely many that are left"
            }
            Self::PaperSeries => "the approximation of the paper for weak shaking, Eq. 65",
            Self::Series(_) => "the approximation for weak shaking with more terms",
            Self::Nonlinear => {
                "flights of the block as it is, each by a power series, and a formula for the infinitely many that are left"
            }
            Self::Ode => "a general solver of differential equations on the block as it is",
            Self::Resummed => {
                "the approximation for weak shaking summed up to the largest amplitude at which a block comes to rest"
            }
            Self::Enclosure => "bounds that are proven",
        }
    }

    /// The equation that it solves, if it solves one.
    fn model(self) -> Option<Model> {
        match self {
            Self::Nothing | Self::CriticalAmplitude | Self::Enclosure => None,
            Self::Linear | Self::PaperSeries | Self::Series(_) | Self::Resummed => Some(Model::Linear),
            Self::Corrected | Self::Nonlinear | Self::Ode => Some(Model::Nonlinear),
        }
    }

    /// The parts of the relative error that it would make of the chattering time, or why it can't answer.
    pub(super) fn predict(self, question: &Question) -> Result<Errors, Refusal> {
        let Question { case, tolerance, place, .. } = question;
        let rocks = case.epsilon() > 0.0;
        if (self == Self::Nothing) == rocks {
            let amplitude = case.amplitude();
            return Err(if rocks { Refusal::Rocks(amplitude) } else { Refusal::NeverRocks(amplitude) });
        }
        if self == Self::Nothing {
            return Ok(Errors::default());
        }
        let alpha = question.alpha();
        if self.model() == Some(Model::Nonlinear) && alpha == 0.0 {
            return Err(Refusal::LinearAsked);
        }
        let steps = matches!(self, Self::Linear | Self::Nonlinear);
        if question.request.is_some() && !(steps && (self.model() == Some(Model::Nonlinear)) == (alpha > 0.0)) {
            return Err(Refusal::Motion);
        }
        let Some(place) = place else { return self.predict_anywhere(alpha) };
        let model = match self {
            Self::Corrected => place.second_order(alpha),
            _ if self.model() == Some(Model::Linear) => place.linearisation(alpha),
            _ => 0.0,
        };
        let conditioning = place.conditioning(question.rounding);
        let stepping = STEPPING * place.amplification;
        let closing = CLOSING_SHARE * tolerance;
        let beyond = place.share > 1.0;
        let near = place.is_near(alpha);
        if self == Self::CriticalAmplitude && (!beyond || near) {
            return Err(Refusal::NotBeyond(place.share));
        }
        if near && alpha > 0.0 && (self.model() == Some(Model::Linear) || self == Self::Corrected) {
            return Err(Refusal::TooNear(place.share));
        }
        if beyond && matches!(self, Self::PaperSeries | Self::Series(_) | Self::Resummed) {
            return Err(Refusal::Diverges);
        }
        if beyond {
            // Whether a block that does not come to rest still rocks at T/2 is no question of digits.
            return Ok(Errors::default());
        }
        let (truncation, discretisation) = match self {
            Self::Nothing | Self::CriticalAmplitude => (0.0, 0.0),
            Self::Linear | Self::Corrected | Self::Nonlinear => (closing, stepping),
            // One term and part of the next, which takes off about half of the error of one term.
            Self::PaperSeries => (0.5 * place.series(1), stepping),
            Self::Series(terms) => (place.series(terms), stepping),
            Self::Ode => (closing, SOLVER * place.amplification),
            Self::Resummed => (1e-9 * place.amplification, stepping),
            Self::Enclosure => (0.0, 1e-16),
        };
        Ok(Errors { model, truncation, discretisation, conditioning })
    }

    /// The same outside of the range in which the errors were measured: only what solves the equation that is asked for, and says itself how far it is off.
    fn predict_anywhere(self, alpha: f64) -> Result<Errors, Refusal> {
        let right = match self.model() {
            Some(Model::Linear) => alpha == 0.0,
            _ => true,
        };
        match self {
            Self::Linear | Self::Nonlinear | Self::Enclosure if right => Ok(Errors::default()),
            _ => Err(Refusal::NotMeasured),
        }
    }

    /// About what it would take in microseconds: rough, only the order of the methods is meant. `cargo bench --bench plan` measures it.
    pub(super) fn cost(self, question: &Question) -> f64 {
        let impacts = impacts(question.case.eta(), question.tolerance);
        let squared = |terms: usize| (terms as f64).powi(2);
        match self {
            Self::Nothing => 0.0,
            Self::CriticalAmplitude => 0.5,
            Self::Linear => 0.5 + 0.15 * impacts,
            Self::Corrected => 1.0 + 0.4 * impacts,
            Self::PaperSeries => 10.0,
            Self::Series(terms) => 100.0 + 7.0 * squared(terms + 4),
            Self::Nonlinear => 1.0 + 0.62 * impacts,
            Self::Ode => 5.0 * impacts,
            Self::Resummed => 70_000.0,
            Self::Enclosure => 5_000.0,
        }
    }
}

/// About how many impacts it takes until the sum can be closed to a relative error: some for each digit, more the less energy an impact takes.
fn impacts(eta: f64, tolerance: f64) -> f64 {
    let digits = -(CLOSING_SHARE * tolerance).log10();
    8.0 + digits.max(1.0) * (1.0 + 0.5 / (1.0 - eta * eta))
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Nothing => "nothing",
            Self::CriticalAmplitude => "critical-amplitude",
            Self::Linear => "closed-form",
            Self::Corrected => "closed-form/corrected",
            Self::PaperSeries => "asymptotic/paper",
            Self::Series(terms) => return f.pad(&format!("asymptotic/order-{terms}")),
            Self::Nonlinear => "taylor",
            Self::Ode => "ode/nonlinear/tsit45",
            Self::Resummed => "asymptotic/resummed",
            Self::Enclosure => "enclosure",
        };
        f.pad(name)
    }
}
