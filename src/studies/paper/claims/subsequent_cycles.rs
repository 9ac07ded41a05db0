//! Section 3.2, and what Section 3.3 needs for it: the Taylor coefficients after an impact.

use std::f64::consts::SQRT_2;

use contract::{Case, Model, Oracle as _};

use super::{Measured, Measurement, motion::particular, series::scaled_flights};
use crate::studies::paper::{
    Error,
    limits::{Derivatives, at_zero},
    missing, phase,
};

pub(super) const ALL: &[Measurement] = &[
    ("eq-40", any_derivative),
    ("eq-41", any_derivative_as_printed_for_any_impact),
    ("eq-51", sine_and_cosine),
    ("eq-51-c3", third_order_of_cosine),
    ("eqs-45-60", coefficients),
    ("eq-58", velocity_of_the_first_flight),
];

const FACTORIALS: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];

/// Impacts of all kinds: sign, velocity, amplitude, frequency and phase.
fn impacts() -> impl Iterator<Item = (f64, f64, f64, f64, f64)> {
    let excitations = [(1.03, 2.0), (1.01, 5.0), (1.02, 0.5), (1.05, 8.0)];
    let phases = [1.4, 1.8, 2.5, 3.1, 4.2];
    let starts = [(1.0, 0.1), (-1.0, -0.02), (1.0, 1e-4)];
    excitations.into_iter().flat_map(move |(a, omega)| {
        phases.into_iter().flat_map(move |angle| starts.map(|(sign, velocity)| (sign, velocity, a, omega, angle)))
    })
}

/// The largest difference from the derivatives by Eq. 4, from the first to the fifth, of what `printed` gives for them from the sign, the
/// velocity and `Ξ` with its derivatives; relative to the largest derivative.
fn worst(printed: impl Fn(f64, f64, [f64; 6]) -> [f64; 6]) -> f64 {
    impacts().fold(0.0, |worst, (sign, velocity, a, omega, angle)| {
        let exact: [f64; 6] = Derivatives::of(sign, [0.0, velocity], a, omega, angle).first();
        let scale = exact.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let printed = printed(sign, velocity, particular(a, omega, angle));
        let off = printed.iter().zip(exact).skip(1).map(|(printed, exact)| (printed - exact).abs() / scale);
        off.fold(worst, f64::max)
    })
}

fn any_derivative() -> Result<Measured, Error> {
    let off = worst(|sign, velocity, xi| {
        let [x0, x1, x2, x3, x4, x5] = xi;
        [0.0, velocity - x1 + x1, -sign - x0 + x2, velocity - x1 + x3, -sign - x0 + x4, velocity - x1 + x5]
    });
    Ok(Measured::to_digits(off, 14, "Eq. 4 gives the same derivatives from the first to the fifth"))
}

fn any_derivative_as_printed_for_any_impact() -> Result<Measured, Error> {
    let off = worst(|sign, velocity, xi| {
        let [x0, x1, x2, _, x4, _] = xi;
        [0.0, velocity - x1, -sign - x0 + x2, velocity - x1, -sign - x0 + x4, velocity - x1]
    });
    Ok(Measured::new(off, "the first line lacks its last term, Ξ^(2m+1)(τ_n), which Eq. 40 has; with it, it is Eq. 40"))
}

/// `ω` of the cases of the limits, and `η`.
const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
const EPSILON: f64 = 1e-5;

/// `a sin` and `a cos` of `ωτ_n + ψ` at impact `n`, with the proven time.
fn forcing(epsilon: f64, n: usize) -> Result<(f64, f64), Error> {
    let case = Case::from_epsilon(epsilon, OMEGA, ETA)?.with_max_impacts(n)?;
    let history = enclosure::Enclosure::new(Model::Linear).history(&case)?;
    let time = history.impacts.last().ok_or_else(|| missing(format!("impact {n}")))?.time;
    let a = 1.0 + epsilon;
    let (sin, cos) = (OMEGA * time + phase(a)).sin_cos();
    Ok((a * sin, a * cos))
}

/// `ω σ_{n;1}` by the series.
fn first_order_of_time(n: usize) -> Result<f64, Error> {
    let flights = scaled_flights(ETA, n + 1)?;
    flights.get(n).map(|flight| flight.start).ok_or_else(|| missing(format!("flight {n} of the series")))
}

fn sine_and_cosine() -> Result<Measured, Error> {
    let i0 = -1.0;
    let mut worst: f64 = 0.0;
    for n in [1, 2, 3, 5, 9] {
        let x = first_order_of_time(n)?;
        // The coefficients times a.
        let (d0, d2, c1) = (-i0, SQRT_2 * x + i0 / 2.0 * x * x, SQRT_2 + i0 * x);
        let sine = at_zero(|epsilon| Ok((forcing(epsilon, n)?.0 - d0) / epsilon), EPSILON)?;
        let cosine = at_zero(|epsilon| Ok(forcing(epsilon, n)?.1 / epsilon.sqrt()), EPSILON)?;
        worst = worst.max((d2 / sine - 1.0).abs()).max((c1 / cosine - 1.0).abs());
    }
    Ok(Measured::to_digits(worst, 8, "proven times of impacts 1 to 9 give d_{n;0}, d_{n;2} and c_{n;1}"))
}

fn third_order_of_cosine() -> Result<Measured, Error> {
    let i0 = -1.0;
    let x = first_order_of_time(1)?;
    let first = SQRT_2 + i0 * x;
    let exact = at_zero(|epsilon| Ok((forcing(epsilon, 1)?.1 - first * epsilon.sqrt()) / epsilon.powf(1.5)), EPSILON)?;
    let printed = SQRT_2 / 4.0 - SQRT_2 / 2.0 * x * x - i0 / 6.0 * x.powi(3);
    // ω σ_{1;3} is ω T_{0;3}, Eq. 31 with its misprint mended.
    let sigma = -SQRT_2 * (-1.0 + 32.0 * (OMEGA * OMEGA - 1.0) / (15.0 * OMEGA * OMEGA));
    let found = format!(
        "at the first impact (ω = 2) a c_{{1;3}} is {exact:.5}, as printed {printed:.5}: the line lacks (i_0/a) ω σ_{{n;3}}, with which it is {:.5}; \
         Eq. 65 does not use it",
        printed + i0 * sigma
    );
    Ok(Measured::new((printed / exact - 1.0).abs(), found))
}

fn coefficients() -> Result<Measured, Error> {
    let worst = impacts().fold(0.0_f64, |worst, (sign, velocity, a, omega, angle)| {
        let exact: [f64; 5] = Derivatives::of(sign, [0.0, velocity], a, omega, angle).first();
        let (sin, cos) = (a * angle.sin(), a * angle.cos());
        let printed = [
            velocity,
            -(sign + sin) / 2.0,
            velocity / 6.0 - omega * cos / 6.0,
            (-sign + (omega * omega - 1.0) * sin) / 24.0,
        ];
        let exact = exact.iter().zip(FACTORIALS).skip(1).map(|(derivative, factorial)| derivative / factorial);
        let off = printed.iter().zip(exact).map(|(printed, exact)| (printed - exact).abs() / (omega * omega).max(1.0));
        off.fold(worst, f64::max)
    });
    Ok(Measured::to_digits(
        worst,
        14,
        "Eq. 4 gives the same coefficients, with sine and cosine whole in place of their series",
    ))
}

fn velocity_of_the_first_flight() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for omega in [0.5, 2.0, 3.0, 8.0] {
        let i0 = -1.0;
        let t = -4.0 * SQRT_2 / (omega * i0);
        // Eqs 60 and 51 at n = 0, where σ = 0 and the velocity is 0.
        let (third, fourth) = (-omega * SQRT_2 / 6.0, (-i0 - (omega * omega - 1.0) * i0) / 24.0);
        let velocity = 3.0 * third * t * t + 4.0 * fourth * t.powi(3);
        worst = worst.max((velocity / (16.0 * SQRT_2 / (3.0 * omega)) - 1.0).abs());
    }
    Ok(Measured::to_digits(worst, 14, "with Eqs 31, 51 and 60 it gives 16√2/(3ω)"))
}
