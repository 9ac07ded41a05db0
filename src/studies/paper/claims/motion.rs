//! Section 2: the closed form of a flight, Eqs 6-12.

use contract::Oracle as _;

use super::{Measured, Measurement};
use crate::studies::paper::{Error, limits::Derivatives, phase};
use contract::{Case, Model};

pub(super) const ALL: &[Measurement] =
    &[("eq-6", closed_form), ("eqs-8-9", particular_solution), ("eqs-10-12", initiation)];

/// The cases of Figs 2 and 3.
const CASES: [(f64, f64, f64); 3] = [(1.03, 2.0, 0.92), (1.01, 5.0, 0.92), (1.03, 2.0, 0.86)];
/// How many impacts are compared.
const IMPACTS: usize = 40;

fn closed_form() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for (a, omega, eta) in CASES {
        let case = Case::from_amplitude(a, omega, eta)?.with_max_impacts(IMPACTS)?;
        let printed = printed::Printed::default().history(&case)?.impacts;
        let proven = enclosure::Enclosure::new(Model::Linear).history(&case)?.impacts;
        for (printed, proven) in printed.iter().zip(&proven) {
            worst = worst.max((printed.interval / proven.interval - 1.0).abs());
        }
    }
    Ok(Measured::to_digits(
        worst,
        15,
        &format!("the first {IMPACTS} intervals of Figs 2, 3a and 3b are the proven ones"),
    ))
}

/// `Ξ^(k)` as Eqs 8 and 9 print it, for `k` from 0 to 5.
pub(super) fn particular(a: f64, omega: f64, angle: f64) -> [f64; 6] {
    let over = 1.0 / (omega * omega + 1.0);
    let (sin, cos) = (a * angle.sin(), a * angle.cos());
    [
        over * sin,
        omega * over * cos,
        -omega.powi(2) * over * sin,
        -omega.powi(3) * over * cos,
        omega.powi(4) * over * sin,
        omega.powi(5) * over * cos,
    ]
}

fn particular_solution() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for (a, omega) in [(1.03, 2.0), (1.01, 5.0), (1.02, 0.5), (1.05, 8.0)] {
        for angle in [0.0, 0.7, 1.33, 2.0, 3.5, 5.9] {
            let xi = particular(a, omega, angle);
            let scale = xi.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            // The motion with the rotation and velocity of Ξ and no constant force is Ξ: its derivatives follow from Eq. 4 alone.
            let derivatives = Derivatives::of(0.0, [xi[0], xi[1]], a, omega, angle);
            let off = xi.iter().zip(derivatives.first::<6>()).map(|(printed, exact)| (printed - exact).abs() / scale);
            worst = off.fold(worst, f64::max);
        }
    }
    Ok(Measured::to_digits(worst, 14, "Eq. 4 gives the same derivatives up to the fifth"))
}

fn initiation() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for (a, omega) in [(1.03, 2.0), (1.01, 5.0), (1.02, 0.5), (1.05, 8.0)] {
        let i0 = -1.0;
        let psi = phase(a);
        let xi = particular(a, omega, psi);
        let (a0, b0) = (-0.5 * (xi[0] - xi[1] + i0), -0.5 * (xi[0] + xi[1] + i0));
        // Eqs 6 and 7 at τ = 0, and Eq. 4's jerk, which is that of the forcing alone.
        let motion = [b0 + a0 + i0 + xi[0], b0 - a0 + xi[1], b0 + a0 + xi[2]];
        let jerk = b0 - a0 + xi[3] + a * omega * psi.cos();
        worst = motion.into_iter().chain([jerk]).fold(worst, |worst, value| worst.max(value.abs()));
    }
    Ok(Measured::to_digits(
        worst,
        14,
        "rotation, velocity and acceleration vanish at τ = 0, and the jerk is that of Eq. 4",
    ))
}
