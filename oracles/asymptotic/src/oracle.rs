use std::f64::consts::PI;

use contract::{Case, Decline, Ending, Estimate, History, Horizon, Impact, Limit, Loss, Model, Oracle};

use crate::claim::Claim;
use crate::coefficients::{Coefficients, coefficients};
use crate::flights::{Flight, Flights, Interval};

/// The asymptotic series of the paper's section 3, to the order of Eq. 65.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Asymptotic;

/// Beyond this claimed relative error of the chattering time the next order may be half of what was kept: no approximation is left.
const MOST_CLAIMED: f64 = 0.5;
/// The claims were calibrated up to here.
const MOST_ETA: f64 = 0.995;

impl Oracle for Asymptotic {
    fn name(&self) -> &str {
        "asymptotic"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        if case.epsilon() <= 0.0 {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        let sums = coefficients(case.eta()).filter(|_| case.eta() <= MOST_ETA).ok_or(Decline::OutOfRange {
            field: "eta",
            value: case.eta(),
            allowed: "eta <= 0.995, up to which the claims were calibrated",
        })?;
        for (field, value, range, allowed) in [
            ("eta", case.eta(), 1e-3..=1.0, "eta >= 1e-3"),
            ("omega", case.omega(), 1e-3..=1e6, "1e-3 <= omega <= 1e6"),
            ("epsilon", case.epsilon(), 1e-60..=1e9, "1e-60 <= epsilon"),
        ] {
            if !range.contains(&value) {
                return Err(Decline::OutOfRange { field, value, allowed });
            }
        }
        let chattering_time = chattering_time(case, sums)?;
        let (impacts, ending) = impacts(case, chattering_time);
        Ok(History { impacts, ending, chattering_time: Some(chattering_time) })
    }
}

/// Eq. 65 to infinity, or the reason why the series does not stand by it.
fn chattering_time(case: &Case, sums: Coefficients) -> Result<Estimate, Decline> {
    let (epsilon, omega) = (case.epsilon(), case.omega());
    let value = (sums.x + sums.u * epsilon) * epsilon.sqrt() / omega;
    let claim = Claim::new(epsilon, omega, sums.x, sums.u, 0);
    let half_period = PI / omega;
    let uncertainty = claim.time() * value;
    // The negation declines NaN as well.
    if !(claim.holds() && claim.time() < MOST_CLAIMED && value + uncertainty < half_period) {
        return Err(Decline::NotConvergent {
            why: format!(
                "the series to the order of Eq. 65 gives tau_ch = {:.4} T/2 with a relative error of up to {:.2e} at epsilon = {epsilon:.4e}: \
                 too near the critical amplitude, or past it",
                value / half_period,
                claim.time(),
            ),
        });
    }
    Ok(Estimate { value, uncertainty })
}

/// The impacts that the case asks for, and why there are no more.
fn impacts(case: &Case, chattering_time: Estimate) -> (Vec<Impact>, Ending) {
    let horizon = match case.horizon() {
        Horizon::HalfPeriod => f64::INFINITY,
        Horizon::Until(time) => time,
    };
    let mut impacts = Vec::new();
    for (n, flight) in Flights::new(case.eta()).take(case.max_impacts()).enumerate() {
        let impact = impact(case, &flight, n + 1);
        if impact.time > horizon {
            return (impacts, Ending::LimitReached(Limit::Time));
        }
        if !(impact.interval.is_normal() && impact.velocity.is_normal()) {
            return (impacts, Ending::Lost(Loss::NotFinite));
        }
        impacts.push(impact);
    }
    let ending = if chattering_time.value > horizon { Ending::LimitReached(Limit::Time) } else { Ending::AtRest };
    (impacts, ending)
}

/// Impact `n` in the scaling of the contract: `τ_n` and `Δτ_{n-1}` of Eqs 47 and 43, `φ'_n` of Eq. 56.
fn impact(case: &Case, flight: &Flight, n: usize) -> Impact {
    let (epsilon, omega) = (case.epsilon(), case.omega());
    let step = epsilon.sqrt() / omega;
    let time = (flight.x + flight.u * epsilon) * step;
    let interval = match flight.interval {
        Interval::Even(duration) => duration * step,
        Interval::Odd(duration) => duration * epsilon * step,
    };
    let velocity = flight.v * epsilon * step;
    Impact {
        time,
        interval,
        velocity,
        uncertainty: Claim::new(epsilon, omega, flight.x, flight.u, n).uncertainty(time),
    }
}
