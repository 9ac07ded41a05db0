use super::flights::{Flights, Interval};

/// The whole of the paper's Eq. 65 for one coefficient of restitution: `ω τ_ch ~ x ε^(1/2) + u ε^(3/2)`, for every `ω` and `ε`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// `X(η) = ω Σ T_{n;1}` over the even flights, `n = 0, 2, 4, ...` (first sum of Eq. 65).
    pub x: f64,
    /// `U(η) = ω Σ T_{n;3}` over the odd flights, `n = 1, 3, 5, ...` (second sum of Eq. 65).
    pub u: f64,
}

impl Coefficients {
    /// The chattering time of Eq. 65 at `epsilon`, whatever it is worth there.
    pub fn chattering_time(&self, epsilon: f64, omega: f64) -> f64 {
        (self.x + self.u * epsilon) * epsilon.sqrt() / omega
    }
}

/// The two sums of Eq. 65, to infinity, for the coefficient of restitution `eta` inside (0, 1).
///
/// The durations of the flights fall by `η²` a pair in the end, so the rest of a sum is its last term times `η²/(1 - η²)`. The relative
/// error of that rest is of the order of the rest itself, so that closing is exact in a double once the rest is below 1e-9 of the sum.
/// `None` when that takes more than a million pairs of flights (`1 - η` below some 2e-5).
pub fn coefficients(eta: f64) -> Option<Coefficients> {
    // 1 - η² without cancellation.
    let closing = eta * eta / ((1.0 - eta) * (1.0 + eta));
    let mut rest_of_x = f64::INFINITY;
    for flight in Flights::new(eta).take(MOST_FLIGHTS) {
        match flight.interval {
            Interval::Even(y) => rest_of_x = y * closing,
            Interval::Odd(duration) => {
                let rest_of_u = duration * closing;
                if rest_of_x < REST_TO_CLOSE * flight.x && rest_of_u < REST_TO_CLOSE * flight.u {
                    return Some(Coefficients { x: flight.x + rest_of_x, u: flight.u + rest_of_u });
                }
            }
        }
    }
    None
}

const REST_TO_CLOSE: f64 = 1e-9;
const MOST_FLIGHTS: usize = 2_000_000;
