//! The sum of a sequence from one of its impacts: what [`zeno`](super::zeno) does with a list of them.

use contract::{Body, Case, Closure, Decline, Departure, Estimate, Ground, Impact, Model, Normalisation, Oracle};

use crate::measure::excitation::Excitation;

/// What closes the sequences of a case under the equation of `model`, where `oracle` does. Times are counted from the initiation.
///
/// # Errors
/// When it declines, or the case is not one that it can be asked.
pub fn of_case(oracle: &dyn Oracle, case: &Case, model: Model) -> Result<Box<dyn Closure>, Decline> {
    let alpha = match (model, case.slenderness()) {
        (Model::Linear, _) => None,
        (Model::Nonlinear, None) => return Err(Decline::NeedsSlenderness),
        (Model::Nonlinear, Some(of)) if of.normalisation() == Normalisation::Threshold => Some(of.alpha()),
        (Model::Nonlinear, Some(_)) => return Err(Decline::Unsupported { what: "the slender normalisation" }),
    };
    let refused = |_| Decline::Unsupported { what: "cases at the border of what is allowed" };
    let body = Body::new(case.eta(), alpha).map_err(refused)?;
    oracle.closure_on(&body, &Excitation::new(case).motion().map_err(refused)?)
}

/// When infinitely many impacts have accumulated, from one of them alone: with what the closure claims, and what the claims on the impact come to.
///
/// # Errors
/// Where the closure declines.
pub fn chattering_time(closure: &dyn Closure, impact: &Impact, eta: f64) -> Result<Estimate, Decline> {
    let Impact { time, uncertainty, .. } = *impact;
    let departure = departure(impact);
    let left = closure.time_left(&departure)?;
    // The clock is a double, and so are the numbers of the case, which a method rounds once more.
    let late = uncertainty.time + ROUNDINGS * f64::EPSILON * time;
    let later = closure.time_left(&Departure { time: time + late, ..departure })?;
    let by_eta = f64::EPSILON * eta * eta / (1.0 - eta * eta);
    let relative = FASTER * uncertainty.velocity + by_eta + f64::EPSILON;
    Ok(Estimate {
        value: time + left.value,
        uncertainty: late + left.uncertainty + relative * left.value + (later.value - left.value).abs(),
    })
}

/// How the block leaves its base after an impact.
pub fn departure(impact: &Impact) -> Departure {
    let Impact { time, velocity, .. } = *impact;
    Departure { ground: Ground::Shaking, time, side: velocity.signum(), rotation: 0.0, velocity: velocity.abs() }
}

/// How many roundings the time of an impact may be off by, beside what is claimed for it.
const ROUNDINGS: f64 = 4.0;
/// How much of a change of the speed is in what is left, relative: that of terms each of which is less than a tenth of the one before.
const FASTER: f64 = 1.3;
