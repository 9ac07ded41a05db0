//! What the equation of motion says by itself, beside every method: the derivatives of a flight, and limits of small amplitude.

use super::Error;

/// The derivatives of the solution of `φ'' = φ - i - a sin(ωτ + ψ)` (Eq. 4) at one time, each from the last but one.
pub(super) struct Derivatives {
    sign: f64,
    start: [f64; 2],
    a: f64,
    omega: f64,
    angle: f64,
}

impl Derivatives {
    /// Of the flight of sign `i` that has this rotation and velocity where the phase `ωτ + ψ` is `angle`.
    pub fn of(sign: f64, start: [f64; 2], a: f64, omega: f64, angle: f64) -> Self {
        Self { sign, start, a, omega, angle }
    }

    /// The derivatives from the 0th on.
    pub fn first<const N: usize>(&self) -> [f64; N] {
        let [mut even, mut odd] = self.start;
        let (mut sin, mut cos) = (self.a * self.angle.sin(), self.a * self.omega * self.angle.cos());
        // The constant is in the second derivative only.
        let mut constant = self.sign;
        std::array::from_fn(|k| {
            if k % 2 == 0 {
                let value = even;
                even += -constant - sin;
                constant = 0.0;
                sin *= -self.omega * self.omega;
                value
            } else {
                let value = odd;
                odd -= cos;
                cos *= -self.omega * self.omega;
                value
            }
        })
    }
}

/// What `f` tends to as its argument goes to 0, to which it is linear near there.
pub(super) fn at_zero(f: impl Fn(f64) -> Result<f64, Error>, step: f64) -> Result<f64, Error> {
    Ok(2.0 * f(0.5 * step)? - f(step)?)
}

/// The power of its argument with which `f` goes to 0, at an argument of about `step`.
pub(super) fn order(f: impl Fn(f64) -> Result<f64, Error>, step: f64) -> Result<f64, Error> {
    Ok((f(step)? / f(0.5 * step)?).abs().log2())
}
