use std::f64::consts::{LOG10_2, LOG10_E, PI};

use contract::{Case, Decline};

/// The longest numbers used, in bits.
const MOST_BITS: f64 = 16_384.0;
/// Velocities smaller than this leave the range of a double, in which the search takes its bearings.
const SMALLEST_VELOCITY: f64 = -290.0;
/// Decimals for what rounding does to the sums of a history, and for its conditioning near the critical amplitude.
const GUARD: f64 = 20.0;

/// How many bits Eq. 6 in absolute time needs to give `digits` significant decimals of each of the first `impacts` impacts.
///
/// The last velocity is about `v ≈ η^N (16√2/3) ε^(3/2)/ω` (Eq. 35, and `η` for each impact), and the last interval about the same. The
/// rotation there is about `v²`, made up from terms of order 1: so `2 log10(1/v)` decimals cancel. A slow excitation leaves the growing mode
/// up to `T/2` to magnify errors: `log10 e^(T/2)` more.
pub(crate) fn bits(case: &Case, digits: usize, impacts: usize) -> Result<usize, Decline> {
    let log_velocity =
        impacts as f64 * case.eta().log10() + 1.5 * case.epsilon().log10().min(0.0) - case.omega().log10().max(0.0);
    if log_velocity < SMALLEST_VELOCITY {
        return Err(Decline::OutOfRange {
            field: "impacts",
            value: impacts as f64,
            allowed: "few enough for the last velocity, of the order of eta^impacts epsilon^(3/2)/omega, to stay above 1e-290",
        });
    }
    let slow = LOG10_E * PI / case.omega();
    let bits = (digits as f64 + GUARD - 2.0 * log_velocity + slow) / LOG10_2;
    if bits > MOST_BITS {
        return Err(Decline::OutOfRange {
            field: "omega",
            value: case.omega(),
            allowed: "fast enough for the growing mode not to need more than 16384 bits by half a period",
        });
    }
    Ok(bits.ceil() as usize)
}
