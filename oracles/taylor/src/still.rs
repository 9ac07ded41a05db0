//! The sum of free rocking on still ground, which is the pendulum turned upside down.
//!
//! On still ground Eq. 2 keeps the energy, so a flight that leaves with the speed `v` lands with it, and the next one leaves with `ηv`. With
//! `A = sin(α/2)`, `C = cos(α/2)`, `V = αv/2` and the angle `θ` from the balance, `sin²(θ/2) = A² - V² + x²` goes from `x = V` to `x = 0` and back:
//!
//! ```text
//! T(V) = 2 ∫ dx / sqrt((C² + V² - x²)(A² - V² + x²))   from 0 to V
//!      = 2V R_F(p q, C² q, A² p)                        p = C² + V², q = A² - V²
//!      = 2 Σ b_j g_j V^(2j+1)                           b_j = 4^j (j!)²/(2j+1)!
//! ```
//!
//! with Carlson's `R_F`, and with `g_j` the coefficients of `((C² + w)(A² - w))^(-1/2)`. The speeds fall as `η^k`, so that the series for all flights together has
//! `1 - η^(2j+1)` below each term.

use contract::Estimate;

/// How many flights are summed one by one at the most, and how many terms of the series are.
const MOST_FLIGHTS: f64 = 1e5;
const MOST_TERMS: u32 = 1_000_000;
/// Up to which share of the speed that reaches the balance the series is short.
const SLOW: f64 = 0.5;
/// What rounding leaves of the sum, relative.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Free rocking of a block of one slenderness.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Still {
    alpha: f64,
    /// `A` and `C`.
    sin: f64,
    cos: f64,
}

impl Still {
    pub fn new(alpha: f64) -> Self {
        let (sin, cos) = (0.5 * alpha).sin_cos();
        Self { alpha, sin, cos }
    }

    /// The speed that just reaches the balance.
    pub fn fastest(self) -> f64 {
        2.0 * self.sin / self.alpha
    }

    /// How long the flight lasts that leaves with `speed`, which is below the fastest.
    fn interval(self, speed: f64) -> f64 {
        let v = 0.5 * self.alpha * speed;
        let (p, q) = (self.cos * self.cos + v * v, (self.sin - v) * (self.sin + v));
        2.0 * v * r_f(p * q, self.cos * self.cos * q, self.sin * self.sin * p)
    }

    /// What the rounding of a speed does to the flight that leaves with it: next to the balance that is much.
    fn first(self, speed: f64) -> f64 {
        let fastest = self.fastest();
        2.0 * f64::EPSILON * speed * fastest / ((fastest - speed) * (fastest + speed))
    }

    /// How long infinitely many flights take that start with the speeds `v, ηv, η²v, ...`; `None` where the block would pass the balance, or where there is no
    /// short way: next to the balance with hardly any loss.
    pub fn time_to_rest(self, speed: f64, eta: f64) -> Option<Estimate> {
        if !(speed >= 0.0 && speed < self.fastest()) {
            return None;
        }
        let rate = eta.ln();
        let (mut flight, mut sum, mut slow) = (0.0, 0.0, speed);
        while slow > SLOW * self.fastest() && flight < MOST_FLIGHTS {
            sum += self.interval(slow);
            flight += 1.0;
            slow = speed * (rate * flight).exp();
        }
        let v = 0.5 * self.alpha * slow;
        let square = v * v;
        let ratio = square / (self.sin * self.sin);
        // ((C² + w)(A² - w))^(-1/2) = (1 + b w + c w²)^(-1/2)/(AC), whose coefficients obey j g_j = -(b (j - 1/2) g_(j-1) + c (j - 1) g_(j-2)).
        let b = square / (self.cos * self.cos) - ratio;
        let c = -ratio * square / (self.cos * self.cos);
        let scale = 2.0 * v / (self.sin * self.cos);
        let (mut before, mut g, mut factor, mut j) = (0.0, 1.0, 1.0, 0.0);
        for _ in 0..MOST_TERMS {
            let term = scale * factor * g / -((2.0 * j + 1.0) * rate).exp_m1();
            sum += term;
            if term.abs() <= 0.5 * f64::EPSILON * (1.0 - ratio) * sum {
                let uncertainty = (ROUNDING + 0.5 * f64::EPSILON * flight.sqrt()) * sum + self.first(speed);
                return Some(Estimate { value: sum, uncertainty });
            }
            j += 1.0;
            (before, g) = (g, -(b * (j - 0.5) * g + c * (j - 1.0) * before) / j);
            factor *= 2.0 * j / (2.0 * j + 1.0);
        }
        None
    }
}

/// Carlson's integral `1/2 ∫ dt/sqrt((t + x)(t + y)(t + z))` from 0 to infinity, by duplication: each round brings the three four times closer together, and what is
/// left of their differences is a series (Carlson 1979; DLMF 19.36.1).
fn r_f(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    const ROUNDS: u32 = 40;
    for _ in 0..ROUNDS {
        let mean = (x + y + z) / 3.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy);
        if dx.abs().max(dy.abs()).max(dz.abs()) < 2e-3 {
            let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
            let series =
                1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0 - 5.0 * e2 * e2 * e2 / 208.0
                    + 3.0 * e3 * e3 / 104.0;
            return series / mean.sqrt();
        }
        let (sx, sy, sz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = sx * sy + sy * sz + sz * sx;
        (x, y, z) = (0.25 * (x + lambda), 0.25 * (y + lambda), 0.25 * (z + lambda));
    }
    f64::NAN
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{equation::Block, flight::Landing, flight::fly};

    /// A flight by its series in time, which knows nothing of elliptic integrals.
    fn flown(alpha: f64, speed: f64) -> f64 {
        let block = Block::new(0.5, 1.0, 0.9, alpha).on_still_ground();
        match fly(&block, 1.0, 0.0, speed, f64::INFINITY) {
            Landing::Impact { interval, speed: arrival, .. } => {
                assert!((arrival / speed - 1.0).abs() < 1e-13, "the energy is kept");
                interval
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_free_flight_is_an_elliptic_integral() {
        for alpha in [1e-3, 0.2, 0.8, 1.5] {
            let still = Still::new(alpha);
            for share in [1e-12, 1e-3, 0.3, 0.9, 0.999] {
                let speed = share * still.fastest();
                let (integral, flown) = (still.interval(speed), flown(alpha, speed));
                assert!((integral / flown - 1.0).abs() < 1e-12, "{alpha} {share}: {integral} {flown}");
            }
        }
    }

    #[test]
    fn the_sum_of_free_rocking_is_that_of_its_flights() {
        for (alpha, share, eta) in [(0.2, 0.3, 0.9), (1.0, 0.99, 0.8), (0.01, 0.999_999, 0.95), (1.4, 0.7, 0.999)] {
            let still = Still::new(alpha);
            let (mut speed, mut sum) = (share * still.fastest(), 0.0);
            let closed = still.time_to_rest(speed, eta).unwrap();
            while speed > 1e-18 {
                sum += still.interval(speed);
                speed *= eta;
            }
            assert!((closed.value / sum - 1.0).abs() < 1e-12, "{alpha} {share} {eta}: {closed:?} {sum}");
            // The rounding of the first speed counts next to the balance.
            assert!(closed.uncertainty < 1e-13 * sum + 1e-15 / (1.0 - share));
        }
        let still = Still::new(0.3);
        assert!(still.time_to_rest(still.fastest(), 0.9).is_none() && still.time_to_rest(f64::NAN, 0.9).is_none());
        assert!(still.time_to_rest(still.fastest() * (1.0 - 1e-9), 1.0 - 1e-12).is_none());
        assert_eq!(still.time_to_rest(0.0, 0.9).unwrap().value, 0.0);
    }

    /// Calculated once with 40 digits from the integral itself.
    #[test]
    fn hardly_damped_rocking_is_summed_to_the_last_digits() {
        for (alpha, speed, eta, expected) in REFERENCES {
            let closed = Still::new(alpha).time_to_rest(speed, eta).unwrap();
            assert!((closed.value - expected).abs() <= closed.uncertainty, "{alpha} {speed} {eta}: {closed:?}");
            assert!(closed.uncertainty < 1e-12 * expected);
        }
    }

    #[allow(clippy::excessive_precision)] // as they came
    const REFERENCES: [(f64, f64, f64, f64); 3] = [
        (0.3, 0.9, 0.9999, 20813.924479765204234),
        (1.2, 0.5, 0.999, 1313.2805244943606768),
        (0.05, 0.01, 0.999999, 20008.557994309939962),
    ];
}
