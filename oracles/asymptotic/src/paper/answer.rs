use std::f64::consts::PI;

use contract::{Case, Decline, Estimate, Impact};

use super::claim::Claim;
use super::coefficients::{Coefficients, coefficients};
use super::flights::{Flight, Flights, Interval};

/// The claims were calibrated up to here.
const MOST_ETA: f64 = 0.995;

/// The chattering time by Eq. 65, and the impacts on the way to it, infinitely many.
///
/// # Errors
/// Out of the range in which the claims were calibrated, and where they do not hold.
pub(crate) fn answer(case: &Case) -> Result<(Estimate, impl Iterator<Item = Impact>), Decline> {
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
    let impacts = (1..).zip(Flights::new(case.eta())).map(|(n, flight)| impact(case, &flight, n));
    Ok((chattering_time, impacts))
}

/// Eq. 65 to infinity, or the reason why the series does not stand by it.
fn chattering_time(case: &Case, sums: Coefficients) -> Result<Estimate, Decline> {
    let (epsilon, omega) = (case.epsilon(), case.omega());
    let value = sums.chattering_time(epsilon, omega);
    let claim = Claim::new(epsilon, omega, sums.x, sums.u, 0);
    let half_period = PI / omega;
    let uncertainty = claim.time() * value;
    // The negation declines NaN as well.
    if !claim.holds() {
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
