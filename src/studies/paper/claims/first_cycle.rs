//! Section 3.1: the first cycle of rocking motion.

use std::f64::consts::SQRT_2;

use contract::{Case, Impact, Model, Oracle as _};

use super::{Measured, Measurement};
use crate::studies::paper::{
    Error,
    limits::{Derivatives, at_zero, order},
    missing, phase,
};

pub(super) const ALL: &[Measurement] = &[
    ("eqs-22-27", derivatives),
    ("eq-25", cosine),
    ("eq-31-first", first_order_of_time),
    ("eq-31-third", third_order_of_time),
    ("eq-34-third", third_order_of_velocity),
    ("eq-34-fifth", fifth_order_of_velocity),
];

const OMEGAS: [f64; 5] = [0.5, 2.0, 3.0, 5.0, 8.0];
const ETA: f64 = 0.92;
/// Amplitudes so far above the threshold that two of them give a limit to 8 digits.
const EPSILON: f64 = 1e-5;

/// The first impact, proven.
fn first_impact(epsilon: f64, omega: f64) -> Result<Impact, Error> {
    let case = Case::from_epsilon(epsilon, omega, ETA)?.with_max_impacts(1)?;
    let history = enclosure::Enclosure::new(Model::Linear).history(&case)?;
    history.impacts.first().copied().ok_or_else(|| missing("the first impact"))
}

/// The largest relative difference between a coefficient and what is printed, over all frequencies.
fn worst(exact: impl Fn(f64) -> Result<f64, Error>, printed: impl Fn(f64) -> f64) -> Result<f64, Error> {
    OMEGAS.into_iter().try_fold(0.0_f64, |worst, omega| Ok(worst.max((printed(omega) / exact(omega)? - 1.0).abs())))
}

fn derivatives() -> Result<Measured, Error> {
    let i0 = -1.0;
    let mut worst: f64 = 0.0;
    for omega in OMEGAS {
        for epsilon in [1e-3, 1e-2] {
            let a = 1.0 + epsilon;
            let exact: [f64; 6] = Derivatives::of(i0, [0.0, 0.0], a, omega, phase(a)).first();
            let root = SQRT_2 * (epsilon.sqrt() + epsilon.powf(1.5) / 4.0 - epsilon.powf(2.5) / 32.0);
            let printed = [0.0, 0.0, 0.0, -omega * root, -omega.powi(2) * i0, omega * (omega * omega - 1.0) * root];
            for (printed, exact) in printed.iter().zip(exact) {
                // What Eq. 27 leaves out is ε^(7/2).
                worst = worst.max((printed - exact).abs() / (omega.powi(5).max(1.0) * epsilon.powf(3.5)).max(1e-13));
            }
        }
    }
    let found =
        format!("Eq. 4 gives the same six coefficients; what is left out is below {worst:.2} max(1, ω⁵) ε^(7/2)");
    Ok(Measured::new(worst, found))
}

fn cosine() -> Result<Measured, Error> {
    let off = |epsilon: f64| {
        let printed = SQRT_2 * (epsilon.sqrt() + epsilon.powf(1.5) / 4.0 - epsilon.powf(2.5) / 32.0);
        Ok((2.0 * epsilon + epsilon * epsilon).sqrt() - printed)
    };
    let order = at_zero(|step| order(off, step), 0.02)?;
    Ok(Measured::new((order - 3.5).abs(), format!("the error of the three terms falls as ε^{order:.3}")))
}

fn first_order_of_time() -> Result<Measured, Error> {
    let exact = |omega| at_zero(|epsilon| Ok(first_impact(epsilon, omega)?.time / epsilon.sqrt()), EPSILON);
    let off = worst(exact, |omega| 4.0 * SQRT_2 / omega)?;
    Ok(Measured::to_digits(off, 8, "proven first impacts give 4√2/ω for ω from 0.5 to 8"))
}

/// The coefficient of `ε^(3/2)` in the time of the first impact, for `i_0 = -1`, with the denominator 5 or another.
fn third_coefficient(omega: f64, denominator: f64) -> f64 {
    -SQRT_2 / omega * (-1.0 + 32.0 * (omega * omega - 1.0) / (denominator * omega * omega))
}

fn third_order_of_time() -> Result<Measured, Error> {
    let exact = |omega: f64| {
        let rest = |epsilon: f64| {
            let first = 4.0 * SQRT_2 / omega * epsilon.sqrt();
            Ok((first_impact(epsilon, omega)?.time - first) / epsilon.powf(1.5))
        };
        at_zero(rest, EPSILON)
    };
    let off = worst(exact, |omega| third_coefficient(omega, 5.0))?;
    let corrected = worst(exact, |omega| third_coefficient(omega, 15.0))?;
    let found = format!(
        "at ω = 2 the coefficient is {:.5}, as printed it would be {:.5}; with 15 for the 5, as in Eq. 34, {}",
        exact(2.0)?,
        third_coefficient(2.0, 5.0),
        if corrected < 1e-7 { "it is right, to 7 digits for ω from 0.5 to 8" } else { "it is not right either" },
    );
    Ok(Measured::new(off, found))
}

/// The velocity before the first impact over `ε^(3/2)`.
fn scaled_velocity(epsilon: f64, omega: f64) -> Result<f64, Error> {
    Ok(first_impact(epsilon, omega)?.velocity / ETA / epsilon.powf(1.5))
}

fn third_order_of_velocity() -> Result<Measured, Error> {
    let exact = |omega| at_zero(|epsilon| scaled_velocity(epsilon, omega), EPSILON);
    let off = worst(exact, |omega| 16.0 * SQRT_2 / (3.0 * omega))?;
    Ok(Measured::to_digits(off, 8, "proven first impacts give 16√2/(3ω) for ω from 0.5 to 8"))
}

fn fifth_order_of_velocity() -> Result<Measured, Error> {
    let exact = |omega: f64| {
        let first = 16.0 * SQRT_2 / (3.0 * omega);
        at_zero(|epsilon| Ok((scaled_velocity(epsilon, omega)? - first) / epsilon), EPSILON)
    };
    let printed = |omega: f64| 4.0 * SQRT_2 / omega * (1.0 - 32.0 * (omega * omega - 1.0) / (15.0 * omega * omega));
    Ok(Measured::to_digits(worst(exact, printed)?, 7, "proven first impacts give the same for ω from 0.5 to 8"))
}
