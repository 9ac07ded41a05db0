//! The exact solution in lanes: the series of `flow`, and the turn of half the phase, at one local time `s` of each lane's flight.
//!
//! Sine and cosine of half the phase are not computed anew from the time of each impact but turned by `δ = ωs/2`:
//!
//! ```text
//! sin(x + δ) - sin x = cos x sin δ - sin x (1 - cos δ)     cos x - cos(x + δ) = sin x sin δ + cos x (1 - cos δ)
//! ```
//!
//! A turn is as small as the flight is short, and is wrong by its own rounding errors only, so that all turns together are wrong by no more than
//! the time is, if the sums are twofold.

use super::{
    lanes::{Lanes, Twofold},
    state::{Blocks, Step, TERMS},
};

/// Up to which `max(1, ω) s` all terms of the series are enough; see `flow`.
pub(super) const REACH: f64 = 2.3;

/// The same for fewer terms.
pub(super) const SHORT: (usize, f64) = (3, 0.012);
pub(super) const FEW: (usize, f64) = (5, 0.157);
pub(super) const SOME: (usize, f64) = (6, 0.32);

/// `1/(2m+1)!` and `1/(2m+2)!`, of `z^(m-1)`, from `m = 1`.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler
const SERIES: [[f64; 2]; TERMS] = {
    let mut rows = [[0.0; 2]; TERMS];
    let (mut index, mut inverse_factorial) = (0, 0.5);
    while index < TERMS {
        let n = (2 * index + 3) as f64;
        rows[index] = [inverse_factorial / n, inverse_factorial / (n * (n + 1.0))];
        inverse_factorial = rows[index][1];
        index += 1;
    }
    rows
};

/// `±1/(2m+1)!` and `±1/(2m+2)!`: the coefficients of `δ^2m` in `sin δ/δ` and in `(1 - cos δ)/δ²`, from `m = 0`.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler
const TURN: [[f64; 2]; TERMS] = {
    let mut rows = [[0.0; 2]; TERMS];
    let (mut index, mut inverse_factorial) = (0, 1.0);
    while index < TERMS {
        let n = (2 * index + 2) as f64;
        rows[index] = [inverse_factorial, inverse_factorial / n];
        inverse_factorial = -inverse_factorial / (n * (n + 1.0));
        index += 1;
    }
    rows
};

/// The coefficients of `z^m` of the odd and of the even series.
#[inline(always)]
fn coefficients<L: Lanes>(blocks: &Blocks<L>, m: usize) -> [L; 2] {
    let Blocks { departure: speed, acceleration, jerk, snap, .. } = *blocks;
    let (Some(q), Some([odd, even])) = (blocks.series.get(m), SERIES.get(m)) else {
        return [speed; 2];
    };
    // q = 1 for m = 0
    let [o, e] = if m == 0 {
        [speed + jerk, acceleration + snap]
    } else {
        [q.mul_add(jerk, speed), q.mul_add(snap, acceleration)]
    };
    [o.by(*odd), e.by(*even)]
}

/// One step from `s` towards the impact, by `N` terms of each series; and where it is the last. Newton's step, with Halley's correction but for
/// `N = SHORT.0`.
#[inline(always)]
pub(super) fn step<L: Lanes, const N: usize>(blocks: &Blocks<L>, s: L) -> (Step<L>, L::Mask) {
    let z = s * s;
    // O, E, their derivatives and half their second derivatives by z.
    let [odd, even] = coefficients(blocks, N - 1);
    let [odd_next, even_next] = coefficients(blocks, N - 2);
    let (mut o, mut o1, mut o2) = (odd.mul_add(z, odd_next), odd, odd);
    let (mut e, mut e1, mut e2) = (even.mul_add(z, even_next), even, even);
    let mut m = N - 2;
    while m > 0 {
        m -= 1;
        let [odd, even] = coefficients(blocks, m);
        if m + 3 < N {
            (o2, e2) = (o2.mul_add(z, o1), e2.mul_add(z, e1));
        }
        (o1, e1) = (o1.mul_add(z, o), e1.mul_add(z, e));
        (o, e) = (o.mul_add(z, odd), e.mul_add(z, even));
    }
    // h = u/s, the loss, and how that grows along s: the formulas of `flow`.
    let (speed, acceleration) = (blocks.departure, blocks.acceleration);
    let twice = s + s;
    let deflated = z.mul_add(s.mul_add(e, o), (s * acceleration).by(0.5)) + speed;
    let loss = z * twice.mul_add(z.mul_add(e1, e), (z + z).mul_add(o1, o));
    let slope = (deflated - speed) + loss;
    let inverse = s.splat(-1.0) / slope;
    let newton = deflated * inverse;
    let (step, loss, exact) = if N == SHORT.0 {
        let bend = (loss + loss) + z * s.mul_add(e + e, (z * o1).by(6.0));
        let loss = newton.mul_add(bend, loss);
        // What is left out of the step and of the loss is newton² bend, in relation to the speed.
        let small = newton.abs().below(s.splat(2e-8));
        (newton, loss, small & (newton * newton * bend.abs()).below((speed - loss).abs().by(1e-16)))
    } else {
        let eight_z = z.by(8.0);
        let odd = z.mul_add(eight_z.mul_add(o2, o1.by(10.0)), o + o);
        let even = z.mul_add(eight_z.mul_add(e2, e1.by(14.0)), e.by(6.0));
        let bend = z * s.mul_add(even, odd);
        let step = (newton * newton).by(0.5).mul_add(bend * inverse, newton);
        // The loss at the end of the step. Its second derivative along s is 4 bend - 6 loss up to the fourth order of u.
        let curved = step.mul_add((bend + bend) - loss.by(3.0), bend);
        let loss = step.mul_add(curved, loss);
        // What that leaves out is of order x² bend step² and step³.
        let leap = blocks.rate * s * step;
        let small = step.abs().below(s.splat(1e-5));
        (step, loss, small & (leap * leap * bend.abs()).below((speed - loss).abs().by(2.5e-16)))
    };
    let interval = s.mul_add(step, s);
    // A root is crossed downwards.
    let last = exact & slope.below(s.splat(0.0));
    (Step { interval, loss, turn: turn::<L, N>(blocks, interval) }, last)
}

/// By how much the sine of half the phase has grown after a local time, and its cosine shrunk, by `N` terms of each series.
#[inline(always)]
fn turn<L: Lanes, const N: usize>(blocks: &Blocks<L>, interval: L) -> [L; 2] {
    let half = (blocks.omega * interval).by(0.5);
    let square = half * half;
    let (mut sine, mut versine) = (half, half);
    let turns = if N < 10 { N } else { 10 };
    let mut m = turns;
    while m > 0 {
        m -= 1;
        #[allow(clippy::indexing_slicing)] // m < turns <= TERMS; `get` costs the scalar path a third
        let [odd, even] = [half.splat(TURN[m][0]), half.splat(TURN[m][1])];
        (sine, versine) =
            if m + 1 == turns { (odd, even) } else { (sine.mul_add(square, odd), versine.mul_add(square, even)) };
    }
    let (sine, versine) = (half * sine, square * versine);
    let Blocks { sin: Twofold { high: sin, .. }, cos: Twofold { high: cos, .. }, .. } = *blocks;
    [cos.mul_add(sine, -(sin * versine)), sin.mul_add(sine, cos * versine)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Every coefficient by itself: `1/(2m+1)!` and `1/(2m+2)!` of the motion; of the turn with alternating signs, and from `m = 0`.
    #[test]
    fn every_coefficient_is_right_to_its_last_digits() {
        let inverse_factorial = |n: usize| 1.0 / (1..=n as u128).product::<u128>() as f64;
        for (index, (series, turn)) in SERIES.into_iter().zip(TURN).enumerate() {
            let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
            for (which, (series, turn)) in series.into_iter().zip(turn).enumerate() {
                assert_relative_eq!(series, inverse_factorial(2 * index + 3 + which), max_relative = 4e-15);
                assert_relative_eq!(turn, sign * inverse_factorial(2 * index + 1 + which), max_relative = 4e-15);
            }
        }
    }
}
