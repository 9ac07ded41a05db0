//! Wrong parameters.

use contract::{Case, Invalid};

use super::{Fault, amount, within};
use crate::faults::plant::Plant;

/// The case with other numbers.
pub(super) fn with(case: &Case, epsilon: f64, omega: f64, eta: f64) -> Result<Case, Invalid> {
    let new = Case::from_epsilon(epsilon, omega, eta)?.with_max_impacts(case.max_impacts())?;
    let new = new.with_horizon(case.horizon())?;
    Ok(case.slenderness().map_or(new, |slenderness| new.with_slenderness(slenderness)))
}

/// What has to be seen in every oracle.
pub(super) fn everywhere(oracle: &str) -> Vec<Fault> {
    const RELATIVE: &str = "relative error";
    let all = [
        amount(
            "eta is off",
            "the coefficient of restitution were rounded or mistyped",
            RELATIVE,
            1e-3,
            Plant::Question(eta_off),
        ),
        amount(
            "omega is off",
            "the frequency of the shaking were rounded or mistyped",
            RELATIVE,
            1e-3,
            Plant::Question(omega_off),
        ),
        amount(
            "a is off, not near the threshold",
            "the amplitude were rounded or mistyped, in the cases with a - 1 > 1e-3 only",
            RELATIVE,
            1e-3,
            Plant::Question(amplitude_off_where_strong),
        ),
        amount("a is off", "the amplitude were rounded or mistyped", RELATIVE, 1e-3, Plant::Question(amplitude_off)),
    ];
    all.into_iter().map(|fault| within(oracle, fault)).collect()
}

fn eta_off(case: &Case, size: f64) -> Result<Case, Invalid> {
    with(case, case.epsilon(), case.omega(), case.eta() * (1.0 + size))
}

fn omega_off(case: &Case, size: f64) -> Result<Case, Invalid> {
    with(case, case.epsilon(), case.omega() * (1.0 + size), case.eta())
}

fn amplitude_off(case: &Case, size: f64) -> Result<Case, Invalid> {
    with(case, case.epsilon() + case.amplitude() * size, case.omega(), case.eta())
}

fn amplitude_off_where_strong(case: &Case, size: f64) -> Result<Case, Invalid> {
    if case.epsilon() > 1e-3 { amplitude_off(case, size) } else { Ok(*case) }
}

pub(super) fn all() -> Vec<Fault> {
    vec![
        amount(
            "restitution twice",
            "restitution were applied twice at each impact, eta^2 in place of eta",
            "excess of its exponent",
            1.0,
            Plant::Question(|case, size| with(case, case.epsilon(), case.omega(), case.eta().powf(1.0 + size))),
        ),
        amount(
            "restitution of energy",
            "eta were a ratio of energies, its square root being applied to the velocity",
            "share missing of its exponent",
            0.5,
            Plant::Question(|case, size| with(case, case.epsilon(), case.omega(), case.eta().powf(1.0 - size))),
        ),
        amount(
            "hardly any restitution",
            "impacts took next to nothing of the velocity, with eta nearly 1",
            "share of 1 - eta that is missing",
            0.999,
            Plant::Question(|case, size| {
                with(case, case.epsilon(), case.omega(), case.eta() + size * (1.0 - case.eta()))
            }),
        ),
        amount(
            "frequency in hertz",
            "the frequency were multiplied by 2 pi once too often, omega being an angular frequency already",
            "excess of the factor 2 pi, as an exponent",
            1.0,
            Plant::Question(|case, size| {
                with(case, case.epsilon(), case.omega() * std::f64::consts::TAU.powf(size), case.eta())
            }),
        ),
        amount(
            "a for a - 1",
            "the amplitude a stood where a - 1, its distance from the threshold, belongs",
            "share of the 1 that is not subtracted",
            1.0,
            Plant::Question(|case, size| with(case, case.epsilon() + size, case.omega(), case.eta())),
        ),
        amount(
            "a in single precision",
            "a - 1 were computed from an amplitude in single precision",
            "unit round-off of a",
            f64::from(f32::EPSILON) / 2.0,
            Plant::Question(|case, size| {
                let grain = 2.0 * size;
                with(case, (case.epsilon() / grain).round() * grain, case.omega(), case.eta())
            }),
        ),
    ]
}
