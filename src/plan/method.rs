//! The candidates, from nothing at all to proven bounds: what each would get wrong, what it would cost, and why it may not be asked.

use std::fmt;

use contract::{Model, Oracle};

use super::{
    Question,
    estimate::{Errors, MEASURED},
};
use crate::panel::{self, Settings};

/// A way to answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The ground never reaches the threshold: there is nothing to compute.
    Nothing,
    /// The amplitude is above the critical one: the chattering is incomplete.
    CriticalAmplitude,
    /// Flights by the closed form of Eq. 4, and the sum closed.
    Linear,
    /// The closed form with the first-order effect of the slenderness put back.
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
pub(super) const ALL: [Method; 12] = [
    Method::Nothing,
    Method::CriticalAmplitude,
    Method::Linear,
    Method::Corrected,
    Method::PaperSeries,
    Method::Series(1),
    Method::Series(4),
    Method::Series(16),
    Method::Nonlinear,
    Method::Ode,
    Method::Resummed,
    Method::Enclosure,
];

/// What a sum that is closed may leave, as a share of the tolerance.
pub(super) const CLOSING_SHARE: f64 = 0.1;
/// What rounding leaves of a chattering time that is stepped in doubles, where nothing amplifies it.
const STEPPING: f64 = 1e-14;
/// The same for the generic solver at its finest.
const SOLVER: f64 = 1e-11;

impl Method {
    /// The oracle that it is, if it is one.
    pub fn oracle(self, question: &Question) -> Option<Box<dyn Oracle>> {
        let equation = if question.case.slenderness().is_some() { "nonlinear" } else { "linear" };
        panel::one(&self.to_string(), &Settings::default(), equation).ok()
    }

    /// Whether it finds impacts, and not the chattering time alone or nothing but that there is none.
    pub(super) fn finds_impacts(self) -> bool {
        matches!(self, Self::Linear | Self::Corrected | Self::Nonlinear | Self::Ode | Self::Enclosure)
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
    pub(super) fn predict(self, question: &Question) -> Result<Errors, String> {
        let Question { case, tolerance, place, .. } = question;
        let rocks = case.epsilon() > 0.0;
        if (self == Self::Nothing) == rocks {
            let threshold = format!("the ground acceleration is {} of the threshold", case.amplitude());
            return Err(if rocks {
                format!("the block rocks: {threshold}")
            } else {
                format!("not needed: {threshold}")
            });
        }
        if self == Self::Nothing {
            return Ok(Errors::default());
        }
        let alpha = question.alpha();
        if self.model() == Some(Model::Nonlinear) && alpha == 0.0 {
            return Err("the linear model is asked for".to_owned());
        }
        let steps = matches!(self, Self::Linear | Self::Nonlinear);
        if question.request.is_some() && !(steps && (self.model() == Some(Model::Nonlinear)) == (alpha > 0.0)) {
            return Err(
                "not for a motion that starts above the threshold, or may end before the block rests".to_owned()
            );
        }
        let Some(place) = place else { return self.predict_anywhere(alpha) };
        let model = if self.model() == Some(Model::Linear) { place.linearisation(alpha) } else { 0.0 };
        let conditioning = place.conditioning(question.rounding);
        let stepping = STEPPING * place.amplification;
        let closing = CLOSING_SHARE * tolerance;
        let beyond = place.share > 1.0;
        let (way, near) = (100.0 * place.share, place.is_near(alpha));
        if self == Self::CriticalAmplitude && (!beyond || near) {
            return Err(format!("a is {way:.4} % of the way to a_cr, not clearly beyond it"));
        }
        if near && alpha > 0.0 && (self.model() == Some(Model::Linear) || self == Self::Corrected) {
            return Err(format!(
                "a is {way:.4} % of the way to a_cr of the slender block, too near to tell on which side of its own the block is"
            ));
        }
        if beyond && matches!(self, Self::PaperSeries | Self::Series(_) | Self::Resummed) {
            return Err("the series does not converge beyond a_cr".to_owned());
        }
        if beyond {
            // Whether a block that does not come to rest still rocks at T/2 is no question of digits.
            return Ok(Errors::default());
        }
        let (truncation, discretisation) = match self {
            Self::Nothing | Self::CriticalAmplitude => (0.0, 0.0),
            Self::Linear | Self::Nonlinear => (closing, stepping),
            Self::Corrected => (place.second_order(alpha), stepping),
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
    fn predict_anywhere(self, alpha: f64) -> Result<Errors, String> {
        let right = match self.model() {
            Some(Model::Linear) => alpha == 0.0,
            _ => true,
        };
        match self {
            Self::Linear | Self::Nonlinear | Self::Enclosure if right => Ok(Errors::default()),
            _ => {
                let [omegas, etas] = MEASURED;
                Err(format!(
                    "its error is known for omega from {} to {} and eta from {} to {} only",
                    omegas.start(),
                    omegas.end(),
                    etas.start(),
                    etas.end()
                ))
            }
        }
    }

    /// About what it would take in microseconds: rough, only the order of the methods is meant. `cargo bench --bench plan` measures it.
    pub(super) fn cost(self, question: &Question) -> f64 {
        let impacts = impacts(question.case.eta(), question.tolerance);
        let squared = |terms: usize| (terms as f64).powi(2);
        match self {
            Self::Nothing => 0.0,
            Self::CriticalAmplitude => 0.5,
            Self::Linear => 0.5 + 0.1 * impacts,
            Self::Corrected => 5.0 + 0.6 * impacts,
            Self::PaperSeries => 10.0,
            Self::Series(terms) => 100.0 + 7.0 * squared(terms + 4),
            Self::Nonlinear => 2.0 * impacts,
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

impl fmt::Display for Method {
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
