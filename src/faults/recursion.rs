//! The paper's iterative procedure (Eqs 31, 57, 60, 62, 64, 65) with terms that can be lost. With none lost it is the series of the
//! `asymptotic` oracle, written apart from it, and it passes the gate in its place with the same claims.
//!
//! With `i_0 = -1`, `x = ω σ_{n;1}`, `y = ω T_{n;1}` and `v = ω Φ_{n;3}^{(1)}`, Eqs 51 and 60 make the cubic of Eq. 62
//! `c₃ y³ + c₂ y² + c₁ y + v = 0` with `c₁ = -(√2 x - x²/2)/2`, `c₂ = -(√2 - x)/6`, `c₃ = (1 + (ω² - 1))/(24 ω²)`.

use std::f64::consts::SQRT_2;

use contract::{Case, Ending, Estimate, History, Impact};

/// Shares lost of the terms of the procedure. All zero is nothing; 1 is a term left out, 2 a wrong sign.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Lost {
    /// Of `T_{0;1}` (Eq. 31).
    pub first: f64,
    /// Of `2 Φ_{;2}^{(2)} T_{;1}` (Eq. 57).
    pub bend: f64,
    /// Of `3 Φ_{;1}^{(3)} T_{;1}²` (Eq. 57).
    pub jerk: f64,
    /// Of `4 Φ_{;0}^{(4)} T_{;1}³` (Eq. 57).
    pub snap: f64,
    /// Of `Φ_{n-1;3}^{(1)}` (Eq. 57).
    pub speed: f64,
    /// Of `2 Φ_{;0}^{(2)} T_{;3}` (Eq. 57).
    pub pull: f64,
    /// Of `a d_{n;0}` in `Φ_{n;0}^{(2)}` (Eq. 60).
    pub pull_forcing: f64,
    /// Of the square in `d_{n;2}`, in `Φ_{n;2}^{(2)}` (Eqs 51 and 60).
    pub bend_square: f64,
    /// Of `ω σ` in `c_{n;1}`, in `Φ_{n;1}^{(3)}` (Eqs 51 and 60).
    pub jerk_phase: f64,
    /// Of `-i_n` in `Φ_{n;0}^{(4)}` (Eq. 60).
    pub snap_side: f64,
    /// Of `Φ_{;0}^{(4)} T³` in the cubic (Eq. 62).
    pub cubic: f64,
    /// Of the second sum of Eq. 65.
    pub odd: f64,
    /// Of the factor `η` of Eq. 57, as a share of its exponent.
    pub restitution: f64,
}

/// How many flights are followed at the most.
const MOST_FLIGHTS: usize = 100_000;

/// The history by a procedure that has `lost` something; its claims, and its ending, are those of the `honest` series.
pub fn history(case: &Case, lost: &Lost, honest: &History) -> History {
    let (epsilon, omega) = (case.epsilon(), case.omega());
    let eta = case.eta().powf(1.0 - lost.restitution);
    let step = epsilon.sqrt() / omega;
    let (mut x, mut u, mut v) = (0.0, 0.0, 0.0);
    let mut impacts = Vec::with_capacity(honest.impacts.len());
    let mut even = 0.0;
    // For the chattering time the flights after the listed ones are followed as well, until they add nothing.
    let followed = if honest.chattering_time.is_some() { MOST_FLIGHTS } else { honest.impacts.len() };
    for n in 0..followed {
        let interval = if n % 2 == 0 {
            even = if n == 0 { 4.0 * SQRT_2 * (1.0 - lost.first) } else { even_flight(x, v, omega, lost) };
            v = eta * landing(x, even, v, omega, lost);
            x += even;
            even * step
        } else {
            // Eq. 64 with Φ_{n;0}^{(2)} = -(1 + 1)/2
            let pull = 1.0 - 0.5 * lost.pull_forcing;
            let odd = v / pull;
            v = eta * ((1.0 - lost.speed) * v - 2.0 * (1.0 - lost.pull) * pull * odd);
            u += (1.0 - lost.odd) * odd;
            odd * epsilon * step
        };
        match honest.impacts.get(n) {
            Some(theirs) => impacts.push(Impact {
                time: (x + u * epsilon) * step,
                interval,
                velocity: v * epsilon * step,
                ..*theirs
            }),
            None if even < 1e-20 * x => break,
            None => {}
        }
    }
    let chattering_time = honest.chattering_time.map(|theirs| {
        let value = (x + u * epsilon) * step;
        Estimate { value, uncertainty: theirs.uncertainty + 1e-14 * value }
    });
    let ending = if impacts.is_empty() { Ending::NeverRocks } else { honest.ending };
    History { impacts, ending, chattering_time }
}

/// `c₁`, `c₂`, `c₃`.
fn coefficients(x: f64, omega: f64, lost: &Lost) -> [f64; 3] {
    let c1 = -0.5 * (SQRT_2 * x - 0.5 * (1.0 - lost.bend_square) * x * x);
    let c2 = -(SQRT_2 - (1.0 - lost.jerk_phase) * x) / 6.0;
    let c3 = (1.0 - lost.snap_side / (omega * omega)) / 24.0;
    [c1, c2, c3]
}

/// The positive root of the cubic: marched up to in growing steps, then bisected.
fn even_flight(x: f64, v: f64, omega: f64, lost: &Lost) -> f64 {
    let [c1, c2, c3] = coefficients(x, omega, lost);
    let value = |y: f64| v + y * (c1 + y * (c2 + y * c3 * (1.0 - lost.cubic)));
    let (mut low, mut high) = (0.0, v.abs());
    while value(high) < 0.0 && high < 1e12 {
        (low, high) = (high, 1.5 * high);
    }
    loop {
        let middle = 0.5 * (low + high);
        // So written that what is not a number ends it too.
        if !(middle > low && middle < high) {
            return middle;
        }
        if value(middle) < 0.0 { low = middle } else { high = middle }
    }
}

/// The velocity at the end of an even flight (Eqs 57 and 58), less the cubic, which is zero there: so it does not cancel late.
fn landing(x: f64, y: f64, v: f64, omega: f64, lost: &Lost) -> f64 {
    let [c1, c2, c3] = coefficients(x, omega, lost);
    let [bend, jerk, snap] = [c1 * y, c2 * y * y, c3 * y * y * y];
    let cubic = (1.0 - lost.cubic) * snap;
    bend + 2.0 * jerk + 4.0 * snap
        - cubic
        - lost.speed * v
        - 2.0 * lost.bend * bend
        - 3.0 * lost.jerk * jerk
        - 4.0 * lost.snap * snap
}
