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

#[cfg(test)]
mod tests {
    use super::*;

    const BITS_A_DECIMAL: f64 = 1.0 / LOG10_2;

    fn bits_of(epsilon: f64, omega: f64, eta: f64, digits: usize, impacts: usize) -> Result<f64, Decline> {
        bits(&Case::from_epsilon(epsilon, omega, eta).unwrap(), digits, impacts).map(|bits| bits as f64)
    }

    /// Each thing that takes bits takes as many as it cancels.
    #[test]
    fn what_cancels_is_paid_for() {
        let of = |epsilon, omega, eta, digits, impacts| bits_of(epsilon, omega, eta, digits, impacts).unwrap();
        let base = of(1e-3, 4.0, 0.5, 30, 20);
        for (found, decimals) in [
            (of(1e-3, 4.0, 0.5, 1030, 20), 1000.0),
            // v falls by η each impact, and the rotation is v².
            (of(1e-3, 4.0, 0.5, 30, 220), 400.0 * 2_f64.log10()),
            // v is of the order ε^(3/2)/ω, up to ε = 1 and from ω = 1.
            (of(1e-53, 4.0, 0.5, 30, 20), 150.0),
            (of(1e3, 4.0, 0.5, 30, 20), -9.0),
            (of(1e-3, 4e50, 0.5, 30, 20), 100.0 - LOG10_E * PI / 4.0),
            // The growing mode magnifies errors by e^(T/2).
            (of(1e-3, 0.01, 0.5, 30, 20), LOG10_E * (PI / 0.01 - PI / 4.0) - 2.0 * 4_f64.log10()),
        ] {
            let expected = decimals * BITS_A_DECIMAL;
            assert!((found - base - expected).abs() <= 1.0, "{} for {expected} bits", found - base);
        }
        // Beside the digits and the 12 decimals that cancel: a double next to the critical amplitude is 1e-16 of it away, where errors grow to
        // (1e-16)^(-2/5) of themselves, and a thousand impacts are summed.
        let least = of(1.0, 1e6, 0.999_999, 10, 1);
        assert!(least >= (10.0 + 12.0 + 6.4 + 3.0) * BITS_A_DECIMAL, "{least}");
    }

    #[test]
    fn what_is_too_deep_or_too_slow_is_declined() {
        assert!(bits_of(1.0, 1.0, 0.1, 20, 290).is_ok());
        let field = |bits| match bits {
            Err(Decline::OutOfRange { field, value, .. }) => Some((field, value)),
            _ => None,
        };
        assert_eq!(field(bits_of(1.0, 1.0, 0.1, 20, 291)), Some(("impacts", 291.0)));
        assert!(bits_of(0.03, 3e-4, 0.9, 20, 1).is_ok());
        assert_eq!(field(bits_of(0.03, 2e-4, 0.9, 20, 1)), Some(("omega", 2e-4)));
    }
}
