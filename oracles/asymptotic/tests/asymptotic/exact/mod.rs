//! Exact stepping of Eq. 4 in doubles, by local time in each flight: what the claims of the series are measured against.
//! It shares nothing with the crate under test.
#![allow(dead_code)]

use std::f64::consts::PI;

/// One impact of the exact solution.
#[derive(Debug, Clone, Copy)]
pub struct Impact {
    pub time: f64,
    pub interval: f64,
    pub velocity: f64,
}

/// The impacts before `T/2`, `most` of them at the most, and whether there were that many.
pub fn impacts(epsilon: f64, omega: f64, eta: f64, most: usize) -> (Vec<Impact>, bool) {
    let mut list = Vec::new();
    let (mut time, mut lost, mut velocity, mut sign) = (0.0_f64, 0.0_f64, 0.0_f64, -1.0_f64);
    for n in 0..most {
        let flight = Flight::new(epsilon, omega, time + lost, velocity, sign, n == 0);
        let Some(interval) = flight.duration(PI / omega - time) else { return (list, false) };
        velocity = eta * flight.velocity(interval);
        sign = -sign;
        let sum = time + interval;
        lost += if time >= interval { (time - sum) + interval } else { (interval - sum) + time };
        time = sum;
        list.push(Impact { time: time + lost, interval, velocity });
    }
    (list, true)
}

/// `τ_ch`: the impacts until their velocities have fallen by e^36, closed geometrically (Eq. 75). `None` when incomplete.
pub fn chattering_time(epsilon: f64, omega: f64, eta: f64) -> Option<f64> {
    let most = 60 + (36.0 / -eta.ln()) as usize;
    let (list, complete) = impacts(epsilon, omega, eta, most);
    if !complete {
        return None;
    }
    let [.., a, b] = list[..] else { return None };
    Some(b.time + (a.interval + b.interval) * eta * eta / (1.0 - eta * eta)).filter(|tau| *tau < PI / omega)
}

/// The critical `ε`, where chattering stops being complete, from below to 1e-7, by bisection.
/// A slow excitation cannot have one above about `ω²/2`: there the first flight does not return.
pub fn critical(omega: f64, eta: f64) -> f64 {
    let (mut low, mut high) = (0.0, (omega * omega).min(0.5));
    for _ in 0..23 {
        let middle = 0.5 * (low + high);
        if chattering_time(middle, omega, eta).is_some() { low = middle } else { high = middle }
    }
    low
}

/// `φ(s)/s^d = Σ φ^(k+d) s^k/(k+d)!`, with `d = 3` in the first flight and 1 in the others: the exact solution of Eq. 4 in local time.
struct Flight {
    derivatives: Vec<f64>,
    first: bool,
    scale: f64,
    sign: f64,
    omega: f64,
}

impl Flight {
    fn new(epsilon: f64, omega: f64, time: f64, velocity: f64, sign: f64, first: bool) -> Self {
        let cosine = (epsilon * (2.0 + epsilon)).sqrt();
        let (s, c) = (omega * time).sin_cos();
        let half = (0.5 * omega * time).sin();
        // f - 1, without the cancellation near the threshold.
        let excess = cosine * s - 2.0 * half * half;
        let (f, g) = (1.0 + excess, cosine * c - s);
        // φ'' = φ - i - f, and φ^(k+2) = φ^(k) - f^(k).
        let acceleration = if sign < 0.0 { -excess } else { -(2.0 + excess) };
        let mut derivatives = vec![0.0, velocity, acceleration];
        let (mut even, mut odd) = (-omega * omega * f, omega * g);
        for k in 1..150 {
            let forced = if k % 2 == 1 { odd } else { even };
            derivatives.push(derivatives[k] - forced);
            if k % 2 == 1 { odd *= -omega * omega } else { even *= -omega * omega }
        }
        let scale = if first { epsilon.sqrt() / omega.max(1.0) } else { velocity.abs() / 2.5 };
        Self { derivatives, first, scale, sign, omega }
    }

    fn deflated(&self, s: f64) -> f64 {
        let d = if self.first { 3 } else { 1 };
        let (mut sum, mut size, mut power) = (0.0, 0.0_f64, 1.0 / if self.first { 6.0 } else { 1.0 });
        // The derivatives grow no faster than the powers of this.
        let rate = self.omega.max(1.0);
        let mut bound = power * rate.powi(d as i32);
        for (k, derivative) in self.derivatives.iter().enumerate().skip(d) {
            let term = derivative * power;
            sum += term;
            size = size.max(term.abs());
            power *= s / (k + 1) as f64;
            bound *= rate * s / (k + 1) as f64;
            if bound < 1e-20 * size {
                break;
            }
        }
        sum
    }

    fn velocity(&self, s: f64) -> f64 {
        let (mut sum, mut power) = (0.0, 1.0);
        for (k, derivative) in self.derivatives.iter().enumerate().skip(1) {
            sum += derivative * power;
            power *= s / k as f64;
        }
        sum
    }

    /// First root, by growing `s` from below the shortest possible flight until the sign of `φ` turns, then by regula falsi (Illinois).
    fn duration(&self, left: f64) -> Option<f64> {
        let at = |s: f64| self.deflated(s) * self.sign;
        let (mut low, mut high) = (0.0, self.scale);
        let (mut above, mut below) = (at(low), at(high));
        while below > 0.0 {
            (low, above) = (high, below);
            high *= 1.03;
            below = at(high);
            if low > left {
                return None;
            }
        }
        let (mut last, mut root) = (0, high);
        for _ in 0..100 {
            let s = (low * below - high * above) / (below - above);
            // Where rounding leads out of the bracket there is nothing more to find.
            if !(s > low && s < high) || (s - root).abs() <= 1e-16 * s {
                break;
            }
            root = s;
            let value = at(s);
            let side = if value > 0.0 { 1 } else { -1 };
            // Halving the value at an end that stays keeps the other one moving.
            let stays = if side == last { 0.5 } else { 1.0 };
            if value > 0.0 {
                (low, above, below) = (s, value, below * stays)
            } else {
                (high, below, above) = (s, value, above * stays)
            }
            last = side;
        }
        Some(root).filter(|s| *s < left)
    }
}

/// Uniform numbers in [0, 1), xorshift.
pub fn uniform(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}
